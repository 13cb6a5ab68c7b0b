/**
 * What lets a built page work without a network and be installed: a service worker with the list of all files of this build and their
 * hashes, the changes that the changelog names, and a web manifest with its icon.
 */
import { createHash } from "node:crypto";
import { readFile, readdir, writeFile } from "node:fs/promises";
import { join, relative, sep } from "node:path";
import { root } from "./paths.mjs";

/** Files of the build that no page asks for. */
const ASIDE = /^(\.vite\/|sw\.js$)/;

/** Bytes that a browser may be asked to keep. */
const MOST = 12e6;

/** Share of an icon inside which nothing is ever cut off. */
const SAFE = 0.6;

/**
 * Writes `sw.js` and the files beside it into the folder of a built page.
 *
 * @param {string} folder
 * @param {string} [changelog] its text
 * @returns {Promise<{id: string, files: {[path: string]: string}}>} the build, with the integrity of every file by its path
 */
export async function writeOffline(folder, changelog) {
  const text = changelog ?? (await readFile(join(root, "CHANGELOG.md"), "utf8"));
  const mark = await readFile(join(root, "www/mark.svg"), "utf8");
  await writeFile(join(folder, "changes.json"), `${JSON.stringify({ changes: changesIn(text) }, null, 1)}\n`);
  await writeFile(join(folder, "icon.svg"), icon(mark));
  await writeFile(join(folder, "manifest.webmanifest"), `${JSON.stringify(manifest, null, 1)}\n`);
  const build = await buildIn(folder);
  const worker = await readFile(join(root, "www/src/offline/service-worker.js"), "utf8");
  await writeFile(join(folder, "sw.js"), `globalThis.BUILD = ${JSON.stringify(build, null, 1)};\n${worker}`);
  return build;
}

/** @param {string} folder */
async function buildIn(folder) {
  const entries = await readdir(folder, { recursive: true, withFileTypes: true });
  const paths = entries
    .filter((entry) => entry.isFile())
    .map((entry) => relative(folder, join(entry.parentPath, entry.name)).replaceAll(sep, "/"))
    .filter((path) => !ASIDE.test(path))
    .sort();
  /** @type {{[path: string]: string}} */
  const files = {};
  const whole = createHash("sha256");
  let bytes = 0;
  for (const path of paths) {
    const content = await readFile(join(folder, path));
    bytes += content.length;
    const hash = createHash("sha256").update(content).digest("base64");
    // The page is asked for by the name of its folder.
    files[path === "index.html" ? "" : path] = `sha256-${hash}`;
    whole.update(`${path} ${hash}\n`);
  }
  if (bytes > MOST) throw new Error(`the page has ${bytes} bytes, and a browser is asked to keep at most ${MOST}`);
  return { id: whole.digest("hex").slice(0, 16), files };
}

/**
 * The entries of a changelog from the newest on, as plain text.
 *
 * @param {string} text after Keep a Changelog
 * @returns {string[]}
 */
export function changesIn(text) {
  /** @type {string[]} */
  const changes = [];
  for (const line of text.split("\n")) {
    if (line.startsWith("- ")) changes.push(line.slice(2));
    else if (line.startsWith("  ") && changes.length > 0) changes.push(`${changes.pop()} ${line.trim()}`);
  }
  return changes.map((change) => change.replace(/\[([^\]]*)\]\([^)]*\)/g, "$1").replaceAll("`", ""));
}

/** What an installed page is called and looks like. */
const manifest = {
  name: "Directrix",
  short_name: "Directrix",
  description: "Curves that match, shapes that morph, materials that blend",
  id: "./",
  start_url: "./",
  scope: "./",
  display: "standalone",
  background_color: "#ffffff",
  theme_color: "#f6f6f7",
  icons: [
    { src: "./icon.svg", sizes: "any", type: "image/svg+xml", purpose: "any" },
    { src: "./icon.svg", sizes: "any", type: "image/svg+xml", purpose: "maskable" },
  ],
};

/**
 * The mark on a white ground with room round it, for launchers that cut icons to a shape of theirs.
 *
 * @param {string} mark an SVG with a view box of 20 by 20
 */
function icon(mark) {
  const inner = /<svg[^>]*>(.*)<\/svg>/s.exec(mark)?.[1];
  if (!inner || !mark.includes('viewBox="0 0 20 20"')) throw new Error("www/mark.svg is no mark in a view box of 20 by 20");
  const light = inner.replace(/@media[^{]*\{(?:[^{}]*\{[^{}]*\})*\}/, "");
  const offset = 10 * (1 - SAFE);
  return (
    '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 20 20" fill="none" stroke-linecap="round">' +
    `<rect width="20" height="20" fill="#fff"/><g transform="translate(${offset} ${offset}) scale(${SAFE})">${light}</g></svg>\n`
  );
}
