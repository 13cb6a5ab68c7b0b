/** Paints every preset in both themes into a folder, which is emptied before: `node scripts/paint-thumbnails.mjs FOLDER`. */
import { mkdir, readFile, rm, writeFile } from "node:fs/promises";
import { join } from "node:path";
import { load } from "../js/node.js";
import { root } from "./lib/paths.mjs";
import { paintThumbnail, themes } from "./lib/thumbnail.mjs";

const [folder] = process.argv.slice(2);
if (!folder) throw new Error("usage: node scripts/paint-thumbnails.mjs FOLDER");
const presets = join(root, "www/presets");
/** @type {(file: string) => Promise<any>} */
const read = async (file) => JSON.parse(await readFile(join(presets, file), "utf8"));

const dx = await load();
await rm(folder, { recursive: true, force: true });
await mkdir(folder, { recursive: true });
for (const { id } of await read("index.json")) {
  const document = await read(`${id}.json`);
  for (const theme of themes) await writeFile(join(folder, `${id}-${theme}.png`), paintThumbnail(dx, document, theme));
}
