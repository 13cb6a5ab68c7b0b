/** The npm packages of the lock file. */
import { existsSync } from "node:fs";
import { readFile } from "node:fs/promises";
import { join } from "node:path";
import { root } from "./paths.mjs";
import { run } from "./run.mjs";

/**
 * Installs the packages when one of them is missing or has another version than the lock file says. Looks only at files, so
 * that it needs no network when nothing is to be done.
 *
 * @type {import("./steps.mjs").Step}
 */
export const packages = {
  name: "packages",
  async run(log) {
    if (await installed()) return "fresh";
    const options = ["ci", "--include=dev", "--no-audit", "--no-fund"];
    const npm = process.env.npm_execpath;
    if (npm?.endsWith("js")) await run(process.execPath, [npm, ...options], { log });
    else await run(process.platform === "win32" ? "npm.cmd" : "npm", options, { log });
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
    if (!present[path]) return entry.optional === true;
    return present[path].version === entry.version && existsSync(join(root, path));
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
