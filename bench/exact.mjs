/** The exact method: between samples, refined on the curves, and with a pin that is being dragged. Every run edits the document. */
import { readFile } from "node:fs/promises";

const amoeba = JSON.parse(await readFile(new URL("../www/presets/amoeba.json", import.meta.url), "utf8"));

/**
 * Returns ever new documents: a control point moves by a thousandth each time.
 *
 * @param {[number, number]} counts
 * @param {object} [matching]
 */
function edits(counts, matching) {
  let run = 0;
  return () => {
    const document = structuredClone(amoeba);
    document.sampling = { scheme: "arc-length", counts };
    document.matching = { method: "exact", ...matching };
    document.curves[1].points[2][0] += ++run * 1e-3;
    return document;
  };
}

/**
 * @param {any} dx
 * @param {object} document
 */
function solved(dx, document) {
  const match = dx.match(document);
  if (!match.ok) throw new Error("the document is not matched");
  return match;
}

/** @type {import("../scripts/lib/bench.mjs").Case[]} */
export default [
  {
    name: "exact lattice matching with visibility, 44 x 44",
    budget: 8,
    prepare(dx) {
      const next = edits([44, 44]);
      return () => solved(dx, next());
    },
  },
  {
    name: "exact lattice matching with visibility, 200 x 200",
    budget: 50,
    prepare(dx) {
      const next = edits([200, 200]);
      return () => solved(dx, next());
    },
  },
  {
    name: "exact lattice matching with visibility, 1000 x 1000",
    prepare(dx) {
      const next = edits([1000, 1000]);
      return () => solved(dx, next());
    },
  },
  {
    name: "exact sum with visibility, 200 x 200",
    prepare(dx) {
      const next = edits([200, 200], { objective: "sum" });
      return () => solved(dx, next());
    },
  },
  {
    name: "exact, refined on the curves to 1e-4, 44 lines",
    budget: 500,
    prepare(dx) {
      const next = edits([44, 44], { oneToOne: true });
      return () => {
        const { optimumChange } = solved(dx, next());
        if (optimumChange === null || optimumChange > 1e-4) throw new Error("it is not refined");
      };
    },
  },
  {
    name: "exact, refined on the curves to 1e-4, 200 lines",
    budget: 500,
    prepare(dx) {
      const next = edits([200, 200], { oneToOne: true });
      return () => solved(dx, next());
    },
  },
  {
    // As a line is dragged: the document stays, the end of its pin moves.
    name: "exact with a pin that is dragged, one to one, 64 lines",
    budget: 16,
    prepare(dx) {
      const free = solved(dx, edits([64, 64], { oneToOne: true })());
      const { u, v } = free.pairs[10];
      let run = 0;
      return () => {
        const pins = [{ u, v: v + 0.02 * Math.sin(++run / 7) }];
        return solved(dx, { ...edits([64, 64], { oneToOne: true, pins })(), title: `Pin ${run}` });
      };
    },
  },
  {
    name: "exact with a pin that is dragged, lattice alone, 64 x 64",
    budget: 16,
    prepare(dx) {
      const { u, v } = solved(dx, edits([64, 64], { oneToOne: true })()).pairs[10];
      let run = 0;
      return () => {
        const pins = [{ u, v: v + 0.02 * Math.sin(++run / 7) }];
        return solved(dx, edits([64, 64], { pins })());
      };
    },
  },
];
