/** `npm run size`: what a browser transfers, after `gzip -9`, next to the budgets. Fails above one. */
import { readFile, readdir } from "node:fs/promises";
import { join } from "node:path";
import { gzipSync } from "node:zlib";
import { moduleSteps } from "./lib/modules.mjs";
import { pageSteps } from "./lib/page.mjs";
import { dist, pkg } from "./lib/paths.mjs";
import { build } from "./lib/steps.mjs";

/**
 * @typedef {object} Row
 * @property {string} name
 * @property {number} bytes after compression
 * @property {number} [budget] in kilobytes of 1000
 */

/** @param {Uint8Array | string} content */
const gzipped = (content) => gzipSync(content, { level: 9 }).length;

/** @param {number[]} numbers */
const sum = (numbers) => numbers.reduce((total, each) => total + each, 0);

/** @param {string} file of the built page */
const gzippedFile = async (file) => gzipped(await readFile(join(dist, file)));

/** What a figure of curves never asks for: the other module, what shows bodies, parts and boundary value problems, and the page for iframes. */
const others = /full|embed|body|part|problem|sentence|no-matching/;

/**
 * What a figure of curves on somebody's page may transfer, its preset included, whichever way it runs.
 *
 * @returns {Promise<{ name: string, bytes: number }[]>}
 */
async function figureFiles() {
  const names = (await readdir(dist)).filter((name) => /^element|\.wasm$/.test(name) && !others.test(name));
  return Promise.all([...names, "presets/amoeba.json"].map(async (name) => ({ name, bytes: await gzippedFile(name) })));
}

/**
 * A chunk of the page with all that it imports statically: scripts and style sheets.
 *
 * @param {string} name in Vite's manifest
 * @returns {Promise<string[]>}
 */
async function filesOf(name) {
  /** @type {import("vite").Manifest} */
  const manifest = JSON.parse(await readFile(join(dist, ".vite/manifest.json"), "utf8"));
  const files = new Set();
  const chunks = new Set([name]);
  for (const each of chunks) {
    const chunk = manifest[each];
    for (const file of [chunk.file, ...(chunk.css ?? [])]) files.add(file);
    for (const other of chunk.imports ?? []) chunks.add(other);
  }
  return [...files];
}

/** What the page loads before it can paint. */
const firstPaintFiles = async () => ["index.html", ...(await filesOf("index.html"))];

/** @returns {Promise<string[]>} */
async function distFiles() {
  const entries = await readdir(dist, { recursive: true, withFileTypes: true });
  return entries.filter((entry) => entry.isFile()).map((entry) => join(entry.parentPath, entry.name).slice(dist.length + 1));
}

/** @returns {Promise<Row[]>} */
async function measured() {
  const figure = await figureFiles();
  const [first, space, all] = await Promise.all([firstPaintFiles(), filesOf("src/solid/solid.js"), distFiles()]);
  const later = space.filter((file) => !first.includes(file));
  const module = gzipped(await readFile(join(pkg, "directrix_bg.wasm")));
  return [
    { name: "module figure", bytes: module, budget: 240 },
    { name: "module full", bytes: gzipped(await readFile(join(pkg, "directrix_full_bg.wasm"))) },
    { name: "embedded figure of curves", bytes: sum(figure.map((file) => file.bytes)), budget: 350 },
    ...figure.map((file) => ({ name: `  ${file.name}`, bytes: file.bytes })),
    { name: "page to its first paint", bytes: sum(await Promise.all(first.map(gzippedFile))), budget: 60 },
    ...(await Promise.all(first.map(async (file) => ({ name: `  ${file}`, bytes: await gzippedFile(file) })))),
    { name: "picture in three dimensions, when asked for", bytes: sum(await Promise.all(later.map(gzippedFile))), budget: 170 },
    { name: "whole page", bytes: sum(await Promise.all(all.map(gzippedFile))) },
  ];
}

/** @param {Row} row */
const isOver = ({ bytes, budget }) => budget !== undefined && bytes > budget * 1000;

async function size() {
  console.log("kB of 1000 bytes after gzip -9");
  for (const row of await measured()) {
    const limit = row.budget === undefined ? "" : `of ${row.budget}${isOver(row) ? "  OVER" : ""}`;
    console.log(`${row.name.padEnd(48)}${(row.bytes / 1000).toFixed(1).padStart(8)}  ${limit}`.trimEnd());
    if (isOver(row)) process.exitCode = 1;
  }
}

if (await build([...moduleSteps({ optimised: true }), ...pageSteps])) await size();
else process.exitCode = 1;
