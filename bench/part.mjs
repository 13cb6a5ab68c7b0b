/** Parts: sections of presets, as a page asks for them while dragging, and the longest call of a question. */
import { readFile } from "node:fs/promises";
import { load } from "../js/node.js";

/** @param {string} name */
const preset = async (name) => JSON.parse(await readFile(new URL(`../www/presets/part/${name}.json`, import.meta.url), "utf8"));

/**
 * The colours of a section after an edit, which nothing is remembered of.
 *
 * @param {string} name
 * @param {[number, number]} size
 * @param {string} [rule]
 */
const section = (name, size, rule = "repaired") => async () => {
  const [dx, document] = await Promise.all([load({ module: "full" }), preset(name)]);
  let edit = 0;
  return () => {
    const [body, ...others] = document.bodies;
    const [first, ...rest] = body.features;
    const features = [{ ...first, to: first.to + (++edit % 1000) * 1e-4 }, ...rest];
    return dx.part({ ...document, bodies: [{ ...body, rule, features }, ...others] }).evaluate({ size, colors: true });
  };
};

/**
 * The longest call of a question, as the worker asks it.
 *
 * @param {string} name
 * @param {"evaluate" | "violations" | "file"} question
 * @param {object} options
 * @param {string} [rule]
 */
const longest = (name, question, options, rule = "repaired") => async () => {
  const [dx, document] = await Promise.all([load({ module: "full" }), preset(name)]);
  let edit = 0;
  return function* () {
    const bodies = document.bodies.map((/** @type {object} */ body) => ({ ...body, rule }));
    const text = JSON.stringify({ ...document, bodies, title: `${++edit}` });
    const job = dx.job(text, { part: { question, rest: { options } } });
    while (!job.step(12).done) yield;
  };
};

/** @type {import("../scripts/lib/bench.mjs").Case[]} */
export default [
  { name: "part, section 512 x 512 with two profiles", budget: 16, prepare: section("rectangle", [512, 512]) },
  { name: "part, section 512 x 512 of a tool with channels", budget: 50, prepare: section("tool", [512, 512]) },
  { name: "part, section 256 x 256 with two profiles by Eq. 2 as printed", budget: 100, prepare: section("rectangle", [256, 256], "printed") },
  { name: "longest call of a part, 1024 x 1024 with colours", budget: 50, prepare: longest("tool", "evaluate", { size: [1024, 1024], colors: true }) },
  { name: "longest call of a part by Eq. 2 as printed, 512 x 512", budget: 50, prepare: longest("rectangle", "evaluate", { size: [512, 512] }, "printed") },
  { name: "longest call of design rules, 1024 x 1024", budget: 50, prepare: longest("scaffold", "violations", { size: [1024, 1024] }) },
];
