/** Running other programs. */
import { spawn } from "node:child_process";
import { createInterface } from "node:readline";
import { root } from "./paths.mjs";

/** The program could not be started, ran past its limit, or ended with a code other than 0. */
export class CommandError extends Error {}

/**
 * @typedef {object} Options
 * @property {(line: string) => void} [log] takes each line of output; without it the output goes to this terminal as it is
 * @property {Record<string, string | undefined>} [env] added to the environment; `undefined` removes a variable
 * @property {number} [limit] seconds after which the program is ended
 */

/**
 * Runs a program in the checkout, without a shell and without input, to its end.
 *
 * @param {string} program
 * @param {string[]} options
 * @param {Options} [how]
 * @returns {Promise<void>} rejected with a `CommandError`
 */
export function run(program, options, { log, env, limit } = {}) {
  const shown = [program, ...options].join(" ");
  return new Promise((done, fail) => {
    const child = spawn(program, options, {
      cwd: root,
      env: { ...process.env, CARGO_TERM_PROGRESS_WHEN: "never", ...env },
      stdio: log ? ["ignore", "pipe", "pipe"] : ["ignore", "inherit", "inherit"],
    });
    const late = () => {
      child.kill("SIGKILL");
      fail(new CommandError(`${shown}: not finished after ${limit} s`));
    };
    const timer = limit ? setTimeout(late, limit * 1000) : undefined;
    if (log) {
      for (const stream of [child.stdout, child.stderr]) {
        if (stream) createInterface({ input: stream }).on("line", log);
      }
    }
    child.on("error", (error) => fail(new CommandError(`${shown}: ${error.message}`)));
    child.on("close", (code, signal) => {
      clearTimeout(timer);
      if (code === 0) done();
      else fail(new CommandError(`${shown}: ended with ${signal ?? `code ${code}`}`));
    });
  });
}

/**
 * Runs a program and returns what it printed, without the last line break; `null` when it cannot be started or fails.
 *
 * @param {string} program
 * @param {string[]} options
 * @param {Record<string, string | undefined>} [env]
 * @returns {Promise<string | null>}
 */
export async function ask(program, options, env) {
  /** @type {string[]} */
  const lines = [];
  try {
    await run(program, options, { log: (line) => lines.push(line), env });
  } catch {
    return null;
  }
  return lines.join("\n");
}
