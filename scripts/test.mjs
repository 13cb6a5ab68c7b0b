/**
 * `npm test`: builds what `npm start` builds, finds or installs a browser, and runs every check. `npm test -- NAME ...` runs only
 * the steps named and what they need. The last line holds the sums of all suites, a failed check without tests counting as one.
 */
import { browser } from "./lib/browser.mjs";
import { countTests } from "./lib/counts.mjs";
import { moduleSteps } from "./lib/modules.mjs";
import { pageSteps } from "./lib/page.mjs";
import { PASSED_LATER } from "./lib/second-chance.mjs";
import { runSteps } from "./lib/steps.mjs";
import { suites } from "./lib/suites.mjs";

/** @typedef {import("./lib/steps.mjs").Result} Result */

const steps = [...moduleSteps(), ...pageSteps, browser, ...suites];
const width = Math.max(...steps.map((step) => step.name.length));
const marks = { done: "ok", fresh: "ok", failed: "FAILED", "not run": "NOT RUN" };

/**
 * The steps of these names and, all the way down, those that they need.
 *
 * @param {string[]} names
 * @returns {typeof steps}
 */
function chosen(names) {
  const wanted = new Set(names);
  for (const name of wanted) {
    const step = steps.find((each) => each.name === name);
    if (!step) throw new Error(`no step "${name}"; there are: ${steps.map((each) => each.name).join(", ")}`);
    for (const need of step.needs ?? []) wanted.add(need);
  }
  return steps.filter((step) => wanted.has(step.name));
}

/** @param {Result} result */
function print(result) {
  const counts = countTests(result.output);
  const note = counts ? `${counts.passed} passed` : result.state === "fresh" ? "nothing to do" : "";
  const seconds = result.seconds.toFixed(1).padStart(6);
  console.log(`${marks[result.state].padEnd(8)}${result.name.padEnd(width)}${seconds} s  ${note}`.trimEnd());
  for (const line of result.output.filter((each) => each.startsWith(PASSED_LATER))) console.log(`        ${line}`);
  if (result.state === "failed" || result.state === "not run") console.log(`${result.output.join("\n")}\n`);
}

/** @param {Result} result */
function counted(result) {
  const counts = countTests(result.output) ?? { passed: 0, failed: 0 };
  const broken = result.state === "failed" || result.state === "not run";
  return broken ? { ...counts, failed: Math.max(1, counts.failed) } : counts;
}

const names = process.argv.slice(2);
const begin = performance.now();
const results = await runSteps(names.length > 0 ? chosen(names) : steps, { end: print });
const counts = results.map(counted);
const passed = counts.reduce((sum, each) => sum + each.passed, 0);
const failed = counts.reduce((sum, each) => sum + each.failed, 0);
console.log(`${((performance.now() - begin) / 1000).toFixed(0)} s`);
console.log(`${passed} passed, ${failed} failed`);
if (failed > 0) process.exitCode = 1;
