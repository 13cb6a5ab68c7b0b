/** Files from elsewhere that the API carries as they are, so that it works in a page without a bundler. */
import { copyFile, cp, mkdir, readFile, rm, writeFile } from "node:fs/promises";
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

/** Puts the presets where the element looks for them. */
async function presets() {
  const folder = join(root, "js/presets");
  await rm(folder, { recursive: true, force: true });
  await cp(join(root, "www/presets"), folder, { recursive: true });
}

/**
 * Puts the presets, and the compression with its declarations and its licence, where the API has them.
 *
 * @type {import("./steps.mjs").Step}
 */
export const copies = {
  name: "copies",
  needs: ["packages"],
  async run() {
    await presets();
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
