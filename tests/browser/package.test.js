/**
 * The package as others get it: packed, installed into an empty project, and used there in Node, with a bundler, with a plain
 * script, and by the checker of types.
 */
import assert from "node:assert/strict";
import { execFile } from "node:child_process";
import { mkdir, mkdtemp, readFile, rm, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { promisify } from "node:util";
import { npm } from "../../scripts/lib/npm.mjs";
import { root } from "../../scripts/lib/paths.mjs";
import { launch, withPage } from "./support/browser.js";
import { serve } from "./support/server.js";

/** Milliseconds that a program may take on a busy machine. */
const limit = 120_000;

/** The code of every user: it matches two rings and says how many lines there are. */
const use = `
const ring = (radius) => ({ degree: 3, form: "periodic", points: [[radius, 0], [0, radius], [-radius, 0], [0, -radius]] });
export const rings = { directrix: 1, kind: "curves", matching: { method: "greedy" }, curves: [ring(10), ring(30)] };
export const told = (match) => match.ok + " " + match.lines.length;
`;
const expected = "true 44";

/** @type {string} */
let project;
/** @type {{path: string, size: number}[]} */
let packed;
/** @type {import("playwright-core").Browser} */
let browser;

/** @param {[string, ...string[]]} command @param {string} cwd */
async function run([program, ...options], cwd) {
  // Names of this checkout must not lead the way: the project is on its own.
  const env = { ...process.env, npm_config_local_prefix: undefined, NODE_PATH: undefined };
  const { stdout } = await promisify(execFile)(program, options, { cwd, env, timeout: limit, maxBuffer: 1 << 24 });
  return stdout;
}

/** @param {Record<string, string>} files @param {string} [folder] */
async function write(files, folder = project) {
  await mkdir(folder, { recursive: true });
  for (const [name, text] of Object.entries(files)) await writeFile(join(folder, name), text);
}

before(async () => {
  project = await mkdtemp(join(tmpdir(), "directrix-package-"));
  await write({ "package.json": JSON.stringify({ name: "project", private: true, type: "module" }), "use.js": use });
  const [description] = JSON.parse(await run([...npm(), "pack", "--json", "--pack-destination", project], root));
  packed = description.files;
  const install = ["install", "--offline", "--no-audit", "--no-fund", `./${description.filename}`];
  await run([...npm(), ...install], project);
  browser = await launch();
});

after(async () => {
  await browser?.close();
  await rm(project, { recursive: true, force: true });
});

test("it holds modules, types and licences, and nothing of the page or of the crate", () => {
  const paths = packed.map(({ path }) => path);
  for (const path of ["js/index.js", "js/node.js", "js/worker.js", "js/directrix.d.ts", "LICENSE-MIT", "LICENSE-APACHE"]) {
    assert.ok(paths.includes(path), path);
  }
  const strays = paths.filter((path) => !/^(js\/.*\.(js|ts|wasm|txt)|js\/presets\/((hyperpatch|laplace|part)\/)?[a-z-]+\.json|js\/pkg\/fflate\.LICENSE|README\.md|package\.json|LICENSE-(MIT|APACHE))$/.test(path));
  assert.deepEqual(strays, []);
});

test("every entry resolves to a file in it", async () => {
  const folder = join(project, "node_modules/directrix");
  const { exports, types, sideEffects } = JSON.parse(await readFile(join(folder, "package.json"), "utf8"));
  /** @param {string | Record<string, any>} entry @returns {string[]} */
  const files = (entry) => (typeof entry === "string" ? [entry] : Object.values(entry).flatMap(files));
  for (const file of [...files(exports), types, ...sideEffects]) await readFile(join(folder, file));
});

test("Node loads it by its name", async () => {
  await write({
    "node.js": `import { load } from "directrix";
import { rings, told } from "./use.js";
console.log(told((await load()).match(rings)), told((await load({ module: "figure" })).match(rings)));`,
  });
  assert.equal((await run([process.execPath, "node.js"], project)).trim(), `${expected} ${expected}`);
});

test("Node finds the modules by their addresses", async () => {
  await write({
    "bytes.js": `import { readFile } from "node:fs/promises";
import { load } from "directrix";
import { rings, told } from "./use.js";
const wasm = await readFile(new URL(import.meta.resolve("directrix/directrix_bg.wasm")));
console.log(told((await load({ module: "figure", wasm })).match(rings)));`,
  });
  assert.equal((await run([process.execPath, "bytes.js"], project)).trim(), expected);
});

/** What a page does with the package, in the thread of the page and in a worker. */
const page = (/** @type {string} */ name) => `import { connect, load } from ${JSON.stringify(name)};
import { rings, told } from "./use.js";
const here = told((await load({ module: "figure" })).match(rings));
const there = told(await (await connect({ module: "figure" })).match(rings));
document.title = here + " " + there;`;

/** @param {string} folder that is served */
async function titleOf(folder) {
  const served = await serve(folder);
  try {
    return await withPage(browser, {}, async (tab) => {
      await tab.goto(served.url);
      await tab.waitForFunction(() => document.title !== "", undefined, { timeout: 30_000 });
      return tab.title();
    });
  } finally {
    await served.close();
  }
}

test("a page uses it with a plain script and no bundler", async () => {
  await write({
    "plain.js": page("./node_modules/directrix/js/index.js"),
    "index.html": '<!doctype html><title></title><link rel="icon" href="data:,"><script type="module" src="./plain.js"></script>',
  });
  assert.equal(await titleOf(project), `${expected} ${expected}`);
});

test("Vite builds a page with it, without settings for it", async () => {
  const folder = join(project, "vite");
  await write(
    {
      "use.js": use,
      "main.js": page("directrix"),
      "index.html": '<!doctype html><title></title><link rel="icon" href="data:,"><script type="module" src="./main.js"></script>',
    },
    folder,
  );
  const { build } = await import("vite");
  await build({ root: folder, configFile: false, logLevel: "error", build: { target: "es2022" }, worker: { format: "es" } });
  assert.equal(await titleOf(join(folder, "dist")), `${expected} ${expected}`);
});

/** What a page does with the element, once with a preset beside the package and once with a document. */
const figurePage = (/** @type {string} */ name) => `import { DirectrixFigure } from ${JSON.stringify(name)};
import { rings } from "./use.js";
DirectrixFigure.presets = "/presets/";
const [first, second] = document.querySelectorAll("directrix-figure");
second.document = rings;
const loaded = (figure) => new Promise((done) => figure.addEventListener("load", done));
await Promise.all([first, second].map(loaded));
document.title = [first.result.lines, second.result.lines, first.runsIn].join(" ");`;
const figures = '<directrix-figure preset="amoeba" style="height: 200px"></directrix-figure><directrix-figure style="height: 200px"></directrix-figure>';

test("a page uses the element with a plain script, and one built by Vite does", async () => {
  const index = (/** @type {string} */ script) =>
    `<!doctype html><title></title><link rel="icon" href="data:,">${figures}<script type="module" src="./${script}"></script>`;
  const folder = join(project, "element");
  const presets = { "amoeba.json": await readFile(join(project, "node_modules/directrix/js/presets/amoeba.json"), "utf8") };
  await write({ "element.js": figurePage("./node_modules/directrix/js/element.js"), "index.html": index("element.js") });
  await write(presets, join(project, "presets"));
  assert.equal(await titleOf(project), "44 44 worker");
  await write({ "use.js": use, "main.js": figurePage("directrix/element"), "index.html": index("main.js") }, folder);
  await write(presets, join(folder, "public/presets"));
  const { build } = await import("vite");
  await build({ root: folder, configFile: false, logLevel: "error", build: { target: "es2022" }, worker: { format: "es" } });
  assert.equal(await titleOf(join(folder, "dist")), "44 44 worker");
});

test("its types are found, and know a document from another object", async () => {
  await write({
    "good.ts": `import "directrix/element";
import { load, type CurvesDocument, DirectrixError } from "directrix";
const rings: CurvesDocument = { directrix: 1, kind: "curves", curves: [], matching: { method: "exact" } };
const figure = document.createElement("directrix-figure");
figure.document = rings;
try { const { ok, totals } = (await load()).match(rings); console.log(ok, totals.lines?.eta); }
catch (error) { if (error instanceof DirectrixError) console.log(error.path); }`,
    "bad.ts": `import type { CurvesDocument } from "directrix";
export const document: CurvesDocument = { directrix: 1, kind: "curves", curves: [], matching: { method: "best" } };`,
  });
  const tsc = join(root, "node_modules/typescript/bin/tsc");
  const check = (/** @type {string} */ file, /** @type {string} */ resolution) =>
    run(
      [
        process.execPath,
        ...[tsc, "--noEmit", "--strict", "--target", "es2022", "--types", "", "--lib", "es2022,dom"],
        ...["--module", resolution === "bundler" ? "es2022" : resolution, "--moduleResolution", resolution, file],
      ],
      project,
    );
  for (const resolution of ["bundler", "nodenext"]) await check("good.ts", resolution);
  await assert.rejects(check("bad.ts", "bundler"), (/** @type {any} */ error) => /"best"/.test(error.stdout));
});
