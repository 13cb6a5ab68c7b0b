/** A curves document from an edit to its picture. Every run edits the document, so that nothing comes from the cache. */
import { readFile } from "node:fs/promises";
import { load } from "../js/node.js";

const preset = async (/** @type {string} */ file) =>
  JSON.parse(await readFile(new URL(`../www/presets/${file}.json`, import.meta.url), "utf8"));
const amoeba = await preset("amoeba");
amoeba.matching = { ...amoeba.matching, method: "greedy", oneToOne: false };
/** @type {any[]} */
const presets = await Promise.all((await preset("index")).map((/** @type {{id: string}} */ { id }) => preset(id)));

/** Returns ever new documents: a control point moves by a thousandth each time. */
function edits(/** @type {[number, number]} */ counts, oneToOne = false) {
  let run = 0;
  return () => {
    const document = structuredClone(amoeba);
    document.sampling = { scheme: "arc-length", counts };
    document.matching.oneToOne = oneToOne;
    document.curves[1].points[2][0] += ++run * 1e-3;
    return document;
  };
}

const frame = { width: 800, height: 600, s: 0.4 };

/** Paints a large picture in steps of the length that the worker asks for. */
function* paintInSteps(/** @type {any} */ dx, /** @type {object} */ document) {
  const job = dx.job(document, { paint: { width: 2200, height: 1600, pixelRatio: 2, s: 0.4 } });
  while (!job.step(12).done) yield;
}

/** @type {import("../scripts/lib/bench.mjs").Case[]} */
export default [
  {
    name: "edit to painted 800 x 600 picture, 44 x 44",
    budget: 16,
    prepare(dx) {
      const next = edits([44, 44]);
      return () => dx.paint(next(), frame);
    },
  },
  {
    name: "edit to painted 800 x 600 picture, one to one, 44 x 44",
    budget: 16,
    prepare(dx) {
      const next = edits([44, 44], true);
      return () => dx.paint(next(), frame);
    },
  },
  {
    name: "greedy matching and insertion, 44 x 44",
    budget: 8,
    prepare(dx) {
      const next = edits([44, 44], true);
      return () => dx.match(next());
    },
  },
  {
    name: "greedy matching and insertion, 200 x 200",
    budget: 50,
    prepare(dx) {
      const next = edits([200, 200], true);
      return () => dx.match(next());
    },
  },
  {
    name: "greedy matching and insertion, 1000 x 1000",
    prepare(dx) {
      const next = edits([1000, 1000], true);
      return () => dx.match(next());
    },
  },
  {
    name: "greedy matching with visibility, 44 x 44",
    budget: 8,
    prepare(dx) {
      const next = edits([44, 44]);
      return () => dx.match(next());
    },
  },
  {
    name: "greedy matching with visibility, 200 x 200",
    budget: 40,
    prepare(dx) {
      const next = edits([200, 200]);
      return () => dx.match(next());
    },
  },
  {
    name: "greedy matching with visibility, 1000 x 1000",
    prepare(dx) {
      const next = edits([1000, 1000]);
      return () => dx.match(next());
    },
  },
  {
    // As the page does it; there are more presets than the cache remembers.
    name: "open a preset: defaults, fit, matching, picture 1136 x 820",
    budget: 100,
    async prepare() {
      const dx = await load({ module: "full" });
      const size = { width: 1136, height: 820 };
      let run = 0;
      return () => {
        const { view: _, ...document } = dx.defaults(presets[run++ % presets.length]);
        const view = dx.fit(document, size);
        dx.match(document);
        return dx.paint(document, { ...size, view, s: 0.4 });
      };
    },
  },
  {
    name: "picture alone 800 x 600",
    prepare: (dx) => () => dx.paint(amoeba, frame),
  },
  {
    name: "picture alone 2200 x 1600, pixel ratio 2",
    prepare: (dx) => () => dx.paint(amoeba, { width: 2200, height: 1600, pixelRatio: 2, s: 0.4 }),
  },
  {
    name: "picture alone 800 x 600, patterns",
    budget: 16,
    prepare: (dx) => () => dx.paint(amoeba, { ...frame, patterns: true }),
  },
  {
    name: "longest call while painting 2200 x 1600, pixel ratio 2",
    budget: 50,
    prepare: (dx) => () => paintInSteps(dx, amoeba),
  },
  {
    name: "longest call from an edit to a picture, 1000 x 1000",
    budget: 50,
    prepare(dx) {
      const next = edits([1000, 1000]);
      return () => paintInSteps(dx, next());
    },
  },
  {
    name: "picture as SVG",
    async prepare() {
      const dx = await load({ module: "full" });
      return () => dx.svg(amoeba, frame);
    },
  },
  {
    // A frame of the morph as the page asks for it: 60 of them a second.
    name: "in-between frame at 200 lines, painted 800 x 600",
    budget: 16.6,
    prepare(dx) {
      const document = edits([200, 200])();
      let s = 0;
      return () => dx.paint(document, { ...frame, s: (s += 0.01) % 1 });
    },
  },
  {
    name: "in-between curves at 200 lines, 5 stages",
    budget: 4,
    prepare(dx) {
      const document = edits([200, 200])();
      return () => dx.stages(document);
    },
  },
  {
    name: "one stage at 200 lines",
    budget: 4,
    prepare(dx) {
      const document = edits([200, 200])();
      document.blend = { kind: "ruled", stages: 2 };
      return () => dx.stages(document);
    },
  },
  {
    name: "unit cells at 200 lines, 5 stages",
    budget: 50,
    async prepare() {
      const dx = await load({ module: "full" });
      const document = edits([200, 200])();
      return () => dx.cells(document);
    },
  },
  {
    name: "amounts of materials at 200 lines",
    budget: 50,
    async prepare() {
      const dx = await load({ module: "full" });
      const document = edits([200, 200])();
      return () => dx.amounts(document);
    },
  },
  {
    name: "probe",
    prepare: (dx) => () => dx.probe(amoeba, [45, 0]),
  },
];
