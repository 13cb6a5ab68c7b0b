/** Harmonic blends of nested curves, from the document to the picture, and the longest turn of one over a connection. */
import { readFileSync } from "node:fs";
import { load } from "../js/node.js";

/** @param {string} name @returns {import("../js/directrix.js").CurvesDocument} */
const preset = (name) => JSON.parse(readFileSync(new URL(`../www/presets/${name}.json`, import.meta.url), "utf8"));

/** Every run has a document of its own, so that nothing is remembered. */
let runs = 0;

/** @param {string} name @param {Partial<import("../js/directrix.js").PictureOptions>} [options] */
const painted = (name, options) => async () => {
  const dx = await load({ module: "full" });
  const document = preset(name);
  return () => dx.paint({ ...document, title: `Run ${runs++}` }, { width: 512, height: 512, ...options });
};

/** @param {string} name @param {Partial<import("../js/directrix.js").PictureOptions>} [options] */
const turns = (name, options) => async () => {
  const dx = await load({ module: "full" });
  const document = preset(name);
  return function* () {
    const job = dx.job({ ...document, title: `Run ${runs++}` }, { paint: { width: 512, height: 512, ...options } });
    while (!job.step(12).done) yield;
  };
};

/** @type {import("../scripts/lib/bench.mjs").Case[]} */
export default [
  { name: "harmonic blend of 200 + 200 segments, painted 512 x 512", budget: 100, prepare: painted("warm-band") },
  { name: "harmonic blend, coarse, painted 512 x 512", prepare: painted("warm-band", { coarse: true }) },
  { name: "harmonic blend with three inner curves, painted 512 x 512", prepare: painted("three-cores") },
  { name: "harmonic blend with three inner curves, longest call", budget: 50, prepare: turns("three-cores") },
  { name: "harmonic blend beside the ruled one, longest call", budget: 50, prepare: turns("warm-band", { layers: ["difference"] }) },
];
