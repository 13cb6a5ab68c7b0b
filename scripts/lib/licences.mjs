/** The licences of everything that the page carries: crates compiled into the module, and packages bundled by Vite. */
import { execFile } from "node:child_process";
import { readFile, readdir } from "node:fs/promises";
import { dirname, join, normalize } from "node:path";
import { promisify } from "node:util";
import { origins } from "./copies.mjs";
import { root } from "./paths.mjs";

/**
 * @typedef {object} Part
 * @property {string} name
 * @property {string} version
 * @property {string} licence an SPDX expression
 * @property {string} text of its licence files
 *
 * @typedef {{name: string, version: string, license: string | null, manifest_path: string}} CratePackage
 */

/** Names of files that hold a licence or the notices it asks for. */
const LICENCE_FILE = /^(licen[cs]e|copying|notice|unlicense|ofl)/i;
const TARGET = "wasm32-unknown-unknown";

/**
 * The crates that are compiled into the modules: dependencies of ordinary kind, for the target of the modules, without
 * those that only run while compiling. It reads what cargo has on this machine and asks nobody.
 *
 * @returns {Promise<Part[]>}
 */
export async function crates() {
  const tree = await cargo([
    ...["tree", "--package", "directrix", "--all-features", "--target", TARGET, "--edges", "normal,no-proc-macro"],
    ...["--prefix", "none", "--no-dedupe", "--format", "{p}"],
  ]);
  const shipped = new Set(tree.split("\n").map((line) => line.split(" ", 2).join(" ")));
  const metadata = JSON.parse(await cargo(["metadata", "--format-version", "1", "--all-features"]));
  return Promise.all(
    /** @type {CratePackage[]} */ (metadata.packages)
      .filter(({ name, version }) => name !== "directrix" && shipped.has(`${name} v${version}`))
      .map(({ name, version, license, manifest_path }) => partOf(name, version, license, dirname(manifest_path))),
  );
}

/** @param {string[]} options */
async function cargo(options) {
  const limits = { cwd: root, maxBuffer: 64 * 1024 * 1024 };
  const { stdout } = await promisify(execFile)("cargo", [...options, "--locked", "--offline"], limits);
  return stdout;
}

/**
 * The npm packages that files of a bundle come from.
 *
 * @param {Iterable<string>} files paths, of which those below `node_modules` and their copies in the API count
 * @returns {Promise<Part[]>}
 */
export async function npmPackages(files) {
  const folders = new Set([...files].map(packageFolder).filter((folder) => folder !== null));
  return Promise.all(
    [...folders].map(async (folder) => {
      const { name, version, license } = JSON.parse(await readFile(join(folder, "package.json"), "utf8"));
      return partOf(name, version, license ?? null, folder);
    }),
  );
}

/** @param {string} file */
function packageFolder(file) {
  const origin = origins.get(normalize(file));
  if (origin !== undefined) return origin;
  const found = /^(.*[\\/]node_modules[\\/](?:@[^\\/]+[\\/])?[^\\/]+)[\\/]/.exec(file);
  return found ? found[1] : null;
}

/**
 * @param {string} name
 * @param {string} version
 * @param {string | null} licence
 * @param {string} folder
 * @returns {Promise<Part>}
 */
async function partOf(name, version, licence, folder) {
  const files = (await readdir(folder)).filter((file) => LICENCE_FILE.test(file)).sort();
  const texts = await Promise.all(files.map(async (file) => (await readFile(join(folder, file), "utf8")).trim()));
  if (licence === null && texts.length === 0) throw new Error(`${name} ${version} comes with no licence`);
  return { name, version, licence: licence ?? "see below", text: texts.join("\n\n") };
}

/**
 * Parts with each text once: one that has the text of an earlier part names the place of that in the list.
 *
 * @param {readonly Part[]} parts
 * @returns {(Part | (Omit<Part, "text"> & {textOf: number}))[]}
 */
export function withoutRepeats(parts) {
  return parts.map(({ text, ...part }) => {
    const first = parts.findIndex((other) => other.text === text);
    return parts[first].name === part.name && parts[first].version === part.version ? { ...part, text } : { ...part, textOf: first };
  });
}

/**
 * A Vite plugin that writes `licences.json` beside the built page: a list of parts by name.
 *
 * @returns {import("vite").Plugin}
 */
export function licences() {
  return {
    name: "licences",
    apply: "build",
    async generateBundle(_, bundle) {
      const files = Object.values(bundle).flatMap((each) =>
        each.type === "chunk" ? each.moduleIds : each.originalFileNames.map((name) => join(root, "www", name)),
      );
      const all = [...(await crates()), ...(await npmPackages(files))];
      all.sort((a, b) => a.name.localeCompare(b.name, "en") || a.version.localeCompare(b.version, "en"));
      this.emitFile({ type: "asset", fileName: "licences.json", source: `${JSON.stringify(withoutRepeats(all), null, 1)}\n` });
    },
  };
}
