/** Files of npm packages that the API carries as they are, so that it works in a page without a bundler. */
import { copyFile, mkdir, readFile, writeFile } from "node:fs/promises";
import { join } from "node:path";
import { pkg, root } from "./paths.mjs";

/** The package that packs and unpacks the documents of links. */
const folder = join(root, "node_modules/fflate");

/**
 * The folder of the package that each copy comes from.
 *
 * @type {ReadonlyMap<string, string>}
 */
export const origins = new Map([[join(pkg, "fflate.js"), folder]]);

/**
 * Puts the compression, its declarations and its licence beside the modules.
 *
 * @type {import("./steps.mjs").Step}
 */
export const copies = {
  name: "copies",
  needs: ["packages"],
  async run() {
    const { version, license } = JSON.parse(await readFile(join(folder, "package.json"), "utf8"));
    const source = await readFile(join(folder, "esm/browser.js"), "utf8");
    const text = `/*! fflate ${version}, ${license}; its licence stands in fflate.LICENSE */\n${source}`;
    const file = join(pkg, "fflate.js");
    if ((await readFile(file, "utf8").catch(() => null)) === text) return "fresh";
    await mkdir(pkg, { recursive: true });
    await copyFile(join(folder, "esm/browser.d.ts"), join(pkg, "fflate.d.ts"));
    await copyFile(join(folder, "LICENSE"), join(pkg, "fflate.LICENSE"));
    await writeFile(file, text);
  },
};
