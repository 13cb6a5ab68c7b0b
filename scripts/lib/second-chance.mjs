/**
 * Test files, each run by a process of its own, so that it is known which of them failed. Those that failed while others ran beside them are run once
 * more, alone: on a machine that is busy a browser may take longer for a thing than a test waits. What passes only then is said, so that it is seen and
 * mended; what fails twice has failed.
 */
import { CommandError } from "./run.mjs";

/** @typedef {import("./steps.mjs").Log} Log */

/** Test files that run at once: much of a browser test is waiting. */
const filesAtOnce = 2;

/** How a line begins that names a file which passed only the second time. */
export const PASSED_LATER = "passed only when run again, alone: ";

/**
 * @param {Log} log takes what each file's last run printed, file by file
 * @param {number} most files that are run again; with more failures something is broken
 * @param {(file: string, log: Log) => Promise<void>} runner rejected when a test failed
 * @param {string[]} files
 */
export async function secondChance(log, most, runner, files) {
  /** @type {Map<string, string[]>} what was printed by the files that failed */
  const failed = new Map();
  const waiting = [...files];
  const worker = async () => {
    for (let file = waiting.shift(); file !== undefined; file = waiting.shift()) {
      const { lines, isPassed } = await once(runner, file);
      if (isPassed) lines.forEach((line) => log(line));
      else failed.set(file, lines);
    }
  };
  await Promise.all(Array.from({ length: filesAtOnce }, worker));

  /** @type {string[]} */
  const broken = [];
  for (const [file, first] of failed) {
    const { lines, isPassed } = failed.size > most ? { lines: first, isPassed: false } : await once(runner, file);
    lines.forEach((line) => log(line));
    if (isPassed) log(`${PASSED_LATER}${[file, ...failures(first)].join("  ")}`);
    else broken.push(file);
  }
  if (broken.length > 0) throw new CommandError(`tests failed in ${broken.join(", ")}`);
}

/** @param {(file: string, log: Log) => Promise<void>} runner @param {string} file */
async function once(runner, file) {
  /** @type {string[]} */
  const lines = [];
  try {
    await runner(file, (line) => lines.push(line));
    return { lines, isPassed: true };
  } catch (error) {
    if (!(error instanceof CommandError)) throw error;
    return { lines: [...lines, error.message], isPassed: false };
  }
}

/** The name and the first line of the error of each failed test, as the reporter lists them below the results. @param {string[]} lines */
const failures = (lines) =>
  lines.flatMap((line, k) => (line.startsWith("test at ") ? lines.slice(k + 1, k + 3).map((each) => each.trim()) : []));
