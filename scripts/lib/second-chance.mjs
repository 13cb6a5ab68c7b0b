/**
 * Test files that failed while others ran beside them are run once more, alone: on a machine that is busy a browser may take longer for a thing than a
 * test waits. What passes only then is said, so that it is seen and mended; what fails twice has failed.
 */
import { CommandError } from "./run.mjs";

/** @typedef {import("./steps.mjs").Log} Log */

/** Test files that run at once: much of a browser test is waiting. */
const filesAtOnce = 2;

/** How a line begins that names a file which passed only the second time. */
export const PASSED_LATER = "passed only when run again, alone: ";

/**
 * @param {Log} log
 * @param {number} most files that are run again; with more failures something is broken
 * @param {(files: string[], atOnce: number, log: Log) => Promise<void>} runner rejected when a test failed
 * @param {string[]} files
 */
export async function secondChance(log, most, runner, files) {
  /** The file of each failure. @type {string[]} */
  const failed = [];
  /** What the report says of them: the name and the first line of the error. @type {string[][]} */
  const told = [];
  /** @type {string[]} */
  const sums = [];
  try {
    await runner(files, filesAtOnce, (line) => {
      const file = fileOf(line);
      if (file) {
        failed.push(file);
        told.push([]);
      } else if (told.length > 0 && (told.at(-1)?.length ?? 2) < 2) told.at(-1)?.push(line.trim());
      if (isSumOfFailures(line)) sums.push(line);
      else log(line);
    });
    sums.forEach(log);
  } catch (error) {
    const again = files.filter((file) => failed.includes(file));
    // A failure that is in no file known by its name would pass unseen.
    const isAllNamed = failed.every((file) => files.includes(file)) && failed.length === sum(sums);
    if (!isAllNamed || again.length === 0 || again.length > most || !(error instanceof CommandError)) {
      sums.forEach(log);
      throw error;
    }
    log(`again, alone: ${again.join(", ")}`);
    await runner(again, 1, (line) => log(isSumOfPasses(line) ? `(${line} of these)` : line));
    failed.forEach((file, n) => log(`${PASSED_LATER}${[file, ...told[n]].join("  ")}`));
  }
}

/** The file of a failed test, as the reporter names it below the results. @param {string} line */
const fileOf = (line) => /^\s*test at (.+?\.test\.js):\d+:\d+$/.exec(line)?.[1] ?? null;

/** @param {string[]} lines that end with a number */
const sum = (lines) => lines.reduce((all, line) => all + Number(line.split(" ").at(-1)), 0);

/** @param {string} line */
const isSumOfFailures = (line) => /^\S (fail|cancelled) \d+$/.test(line);

/** @param {string} line */
const isSumOfPasses = (line) => /^\S pass \d+$/.test(line);
