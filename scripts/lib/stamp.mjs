/** Stamps: what a step was made from and what it made, by content, so that it is done again only when one of them changed. */
import { createHash } from "node:crypto";
import { mkdir, readFile, readdir, rm, writeFile } from "node:fs/promises";
import { join, relative } from "node:path";
import { root, work } from "./paths.mjs";

/**
 * @typedef {object} Made
 * @property {string[]} from files and folders that the step reads; those that do not exist count as empty
 * @property {string[]} to files and folders that it writes
 * @property {unknown[]} [with] whatever else decides the result: versions, options
 */

/**
 * Whether what the step wrote is still there, made from what is there now.
 *
 * @param {string} name
 * @param {Made} made
 * @returns {Promise<boolean>}
 */
export async function isFresh(name, made) {
  const stamp = await readFile(file(name), "utf8").catch(() => null);
  return stamp !== null && stamp === content(await inputs(made), await digest(made.to));
}

/**
 * The state of what the step reads, to be taken before it starts: an edit while it runs then makes it stale again.
 *
 * @param {Made} made
 * @returns {Promise<string>}
 */
export function inputs(made) {
  return digest(made.from, made.with);
}

/**
 * Notes that the step has been done.
 *
 * @param {string} name
 * @param {Made} made
 * @param {string} before its inputs when it started
 */
export async function mark(name, made, before) {
  await mkdir(join(work, "stamps"), { recursive: true });
  await writeFile(file(name), content(before, await digest(made.to)));
}

/**
 * Forgets that the step has been done: to be called before its output is touched.
 *
 * @param {string} name
 */
export async function unmark(name) {
  await rm(file(name), { force: true });
}

/** @param {string} name */
const file = (name) => join(work, "stamps", name);

/**
 * @param {string} from
 * @param {string} to
 */
const content = (from, to) => `${from}\n${to}\n`;

/**
 * @param {string[]} paths
 * @param {unknown} [extra]
 */
async function digest(paths, extra) {
  const hash = createHash("sha256");
  hash.update(JSON.stringify(extra ?? null));
  for (const path of paths) {
    for (const each of await filesOf(path)) {
      hash.update(`\0${relative(root, each)}\0`);
      hash.update(await readFile(each));
    }
  }
  return hash.digest("hex");
}

/**
 * The files at or below a path in a fixed order.
 *
 * @param {string} path
 * @returns {Promise<string[]>}
 */
async function filesOf(path) {
  const entries = await readdir(path, { recursive: true, withFileTypes: true }).catch((error) => {
    if (error.code === "ENOTDIR") return null;
    if (error.code === "ENOENT") return [];
    throw error;
  });
  if (entries === null) return [path];
  return entries
    .filter((entry) => entry.isFile())
    .map((entry) => join(entry.parentPath, entry.name))
    .sort();
}
