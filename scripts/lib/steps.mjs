/** Steps that depend on each other, run side by side where they may. */
import { availableParallelism } from "node:os";

/**
 * @typedef {(line: string) => void} Log
 *
 * @typedef {object} Step
 * @property {string} name
 * @property {string[]} [needs] the steps that must have succeeded before; names that are no step of this run are no condition
 * @property {string} [lane] of the steps of one lane only one runs at a time: they would wait for the same lock
 * @property {(log: Log) => Promise<"fresh" | void>} run "fresh" when there was nothing to do
 *
 * @typedef {object} Result
 * @property {string} name
 * @property {"done" | "fresh" | "failed" | "not run"} state
 * @property {number} seconds
 * @property {string[]} output every line the step printed, and the message of its error
 */

/**
 * Runs the steps, in the order given as far as their needs and lanes allow, as many side by side as there are cores (two at
 * least). After a failure the steps that need the failed one are not run; the others are.
 *
 * @param {Step[]} steps
 * @param {{ line?: (step: Step, line: string) => void, end?: (result: Result) => void }} [report]
 * @returns {Promise<Result[]>} in the order of their ends
 */
export async function runSteps(steps, report = {}) {
  const width = Math.max(2, availableParallelism());
  const names = new Set(steps.map((step) => step.name));
  const waiting = [...steps];
  /** @type {Map<Step, Promise<void>>} */
  const busy = new Map();
  /** @type {Map<string, Result>} */
  const ended = new Map();

  /** @param {Result} result */
  const end = (result) => {
    ended.set(result.name, result);
    report.end?.(result);
  };

  /** @param {Step} step */
  const start = async (step) => {
    const begin = performance.now();
    /** @type {string[]} */
    const output = [];
    /** @type {Result["state"]} */
    let state;
    try {
      const said = await step.run((line) => {
        output.push(line);
        report.line?.(step, line);
      });
      state = said ?? "done";
    } catch (error) {
      output.push(error instanceof Error ? error.message : String(error));
      state = "failed";
    }
    busy.delete(step);
    end({ name: step.name, state, seconds: (performance.now() - begin) / 1000, output });
  };

  while (waiting.length > 0 || busy.size > 0) {
    let moved = false;
    for (const step of [...waiting]) {
      const needs = (step.needs ?? []).filter((name) => names.has(name)).map((name) => ended.get(name));
      const broken = needs.find((result) => result?.state === "failed" || result?.state === "not run");
      const laneTaken = step.lane !== undefined && [...busy.keys()].some((other) => other.lane === step.lane);
      if (broken) end({ name: step.name, state: "not run", seconds: 0, output: [`needs "${broken.name}"`] });
      else if (busy.size >= width || laneTaken || needs.includes(undefined)) continue;
      else busy.set(step, start(step));
      waiting.splice(waiting.indexOf(step), 1);
      moved = true;
    }
    if (busy.size > 0) await Promise.race(busy.values());
    else if (!moved) throw new Error(`steps that wait for each other: ${waiting.map((step) => step.name).join(", ")}`);
  }
  return [...ended.values()];
}

/**
 * Runs steps that build something, with their output on the terminal, each line behind the name of its step.
 *
 * @param {Step[]} steps
 * @returns {Promise<boolean>} whether all succeeded; the failures have been printed
 */
export async function build(steps) {
  const results = await runSteps(steps, {
    line: (step, line) => console.log(`[${step.name}] ${line}`),
    end: (result) => {
      if (result.state === "done") console.log(`[${result.name}] ${result.seconds.toFixed(1)} s`);
      if (result.state === "failed") console.error(`[${result.name}] FAILED: ${result.output.at(-1)}`);
      if (result.state === "not run") console.error(`[${result.name}] not run: ${result.output[0]}`);
    },
  });
  return results.every((result) => result.state === "done" || result.state === "fresh");
}
