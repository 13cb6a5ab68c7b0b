/** The npm packages of the lock file. */
import { existsSync } from "node:fs";
import { readFile } from "node:fs/promises";
import { join } from "node:path";
import { npm } from "./npm.mjs";
import { root } from "./paths.mjs";
import { run } from "./run.mjs";

/** The package that the page can be built without. */
const dispensable = "node_modules/binaryen";

/**
 * Installs the packages when one of them is missing or has another version than the lock file says. Looks only at files, so
 * that it needs no network when nothing is to be done. The optimiser, by far the largest of them, may have been left out.
 *
 * @type {import("./steps.mjs").Step}
 */
export const packages = {
  name: "packages",
  async run(log) {
    if (await installed()) return "fresh";
    const [program, ...before] = npm();
    await run(program, [...before, "ci", "--include=dev", "--no-audit", "--no-fund"], { log });
  },
};

/**
 * The version of an installed package, `null` when it is not there.
 *
 * @param {string} name
 * @returns {Promise<string | null>}
 */
export async function versionOf(name) {
  const manifest = await readFile(join(root, "node_modules", name, "package.json"), "utf8").catch(() => null);
  return manifest === null ? null : JSON.parse(manifest).version;
}

async function installed() {
  const [wanted, present] = await Promise.all([lock("package-lock.json"), lock("node_modules/.package-lock.json")]);
  return Object.entries(wanted).every(([path, entry]) => {
    if (path === "") return true;
    const there = present[path] !== undefined && existsSync(join(root, path));
    if (!there) return entry.optional === true || path === dispensable;
    return present[path].version === entry.version;
  });
}

/**
 * @param {string} file
 * @returns {Promise<Record<string, { version: string, optional?: boolean }>>}
 */
async function lock(file) {
  const text = await readFile(join(root, file), "utf8").catch(() => "{}");
  return JSON.parse(text).packages ?? {};
}
