/**
 * `npm run hosts`: tries the snippets of docs/embedding.md. Builds the site of every folder in `tests/hosts` with its generator,
 * serves it on one port and the application on another, and looks in a browser whether the figures paint and open in the
 * application. Not part of `npm test`, as it takes minutes and programs that are not the project's: mdbook, mkdocs and
 * sphinx-build are taken from the PATH, and npm installs the others. `npm run hosts -- NAME ...` tries only these.
 */
import assert from "node:assert/strict";
import { cp, readFile, readdir, writeFile } from "node:fs/promises";
import { join } from "node:path";
import { launch, withPage } from "../tests/browser/support/browser.js";
import { screenshot } from "../tests/browser/support/screenshot.js";
import { vitepress } from "./lib/documentation.mjs";
import { moduleSteps } from "./lib/modules.mjs";
import { npm } from "./lib/npm.mjs";
import { versionOf } from "./lib/packages.mjs";
import { pageSteps } from "./lib/page.mjs";
import { dist, root, work } from "./lib/paths.mjs";
import { ask, run } from "./lib/run.mjs";
import { serve } from "./lib/serve.mjs";
import { build } from "./lib/steps.mjs";

/**
 * @typedef {import("playwright-core").Page} Page
 *
 * @typedef {object} Host
 * @property {string} name of its folder
 * @property {string} [site] the folder of the built site in it
 * @property {(folder: string) => Promise<string | null>} version of the generator, `null` where it is not installed
 * @property {(folder: string) => [string, ...string[]][]} [commands] that build the site, one after the other
 * @property {(page: Page) => Promise<void>} [turn] leads from the element to the iframe where they are not on one page
 */

/** The address of the application in the snippets. */
const address = "https://directrix.example/";

/** More colours than an empty canvas or a message has. */
const fewestColors = 50;

/** Seconds that a command may take. */
const limit = 600;

/** @param {string} folder */
const npmInstall = (folder) => /** @type {[string, ...string[]]} */ ([...npm(), "install", "--prefix", folder]);

/** @param {string} folder @param {string} name */
async function npmVersion(folder, name) {
  const manifest = await readFile(join(folder, "package.json"), "utf8");
  return JSON.parse(manifest).dependencies[name];
}

/** The first number with dots that a program says of itself. @param {string} program @param {string} option */
async function ownVersion(program, option = "--version") {
  return /\d+(\.\d+)+/.exec((await ask(program, [option])) ?? "")?.[0] ?? null;
}

/** @type {Host[]} */
const hosts = [
  { name: "plain", version: async () => "no generator" },
  {
    name: "vitepress",
    site: ".vitepress/dist",
    version: () => versionOf("vitepress"),
    commands: (folder) => [[process.execPath, vitepress, "build", folder]],
  },
  {
    name: "docusaurus",
    site: "build",
    version: (folder) => npmVersion(folder, "@docusaurus/core"),
    commands: (folder) => [
      npmInstall(folder),
      [process.execPath, join(folder, "node_modules/@docusaurus/core/bin/docusaurus.mjs"), "build", folder],
    ],
  },
  { name: "mdbook", site: "book", version: () => ownVersion("mdbook"), commands: (folder) => [["mdbook", "build", folder]] },
  {
    name: "mkdocs",
    site: "site",
    version: () => ownVersion("mkdocs"),
    commands: (folder) => [["mkdocs", "build", "--config-file", join(folder, "mkdocs.yml")]],
  },
  {
    name: "sphinx",
    site: "site",
    version: () => ownVersion("sphinx-build"),
    commands: (folder) => [["sphinx-build", "-q", folder, join(folder, "site")]],
  },
  {
    name: "reveal",
    version: (folder) => npmVersion(folder, "reveal.js"),
    commands: (folder) => [npmInstall(folder)],
    async turn(page) {
      const figure = page.locator("directrix-figure");
      await figure.locator("input[type=range]").press("ArrowRight");
      assert.equal(await figure.evaluate((element) => /** @type {any} */ (element).s), 0.41, "the slides take the keys of the figure");
      await page.locator(".navigate-right").click();
    },
  },
];

/**
 * Copies the sources of a site, with the application at another address.
 *
 * @param {string} name
 * @param {string} application
 */
async function copySources(name, application) {
  const folder = join(work, "hosts", name);
  await cp(join(root, "tests/hosts", name), folder, { recursive: true });
  const entries = await readdir(join(root, "tests/hosts", name), { recursive: true, withFileTypes: true });
  for (const entry of entries.filter((each) => each.isFile())) {
    const file = join(entry.parentPath, entry.name).replace(join(root, "tests/hosts", name), folder);
    await writeFile(file, (await readFile(file, "utf8")).replaceAll(address, application));
  }
  return folder;
}

/**
 * Waits until a figure shows its picture, and follows its link.
 *
 * @param {Page} page
 * @param {import("playwright-core").Locator | import("playwright-core").FrameLocator} place of the parts of the figure
 * @param {string} title of the document
 */
async function follow(page, place, title) {
  const canvas = place.locator('.frame[data-state="shown"] canvas');
  await canvas.scrollIntoViewIfNeeded();
  for (const end = Date.now() + 10_000; ; ) {
    if ((await screenshot(canvas, "host")).colors() >= fewestColors) break;
    assert.ok(Date.now() < end, "the figure paints nothing");
  }
  // By its key: of places in scaled iframes the driver of the browser knows nothing.
  const [application] = await Promise.all([page.waitForEvent("popup"), place.locator("a.open[href]").press("Enter")]);
  await application.waitForSelector("html[data-ready=true]");
  await application.waitForFunction((expected) => document.title.includes(expected), title);
  await application.close();
}

/**
 * Tries a host.
 *
 * @param {Host} host
 * @param {string} application its address
 * @param {import("playwright-core").Browser} browser
 * @returns {Promise<string>} what is to be said of it
 */
async function attempt({ name, site = "", version, commands, turn }, application, browser) {
  const folder = await copySources(name, application);
  const found = await version(folder);
  if (found === null) return "not tried: its generator is not installed";
  for (const [program, ...options] of commands?.(folder) ?? []) {
    await run(program, options, { log: (line) => console.log(`[${name}] ${line}`), limit });
  }
  const served = await serve(join(folder, site));
  try {
    await withPage(browser, { viewport: { width: 1280, height: 900 }, allow: /favicon\.ico/ }, async (page) => {
      await page.goto(served.url);
      await follow(page, page.locator("directrix-figure"), "Amoeba");
      await turn?.(page);
      await page.locator("iframe").scrollIntoViewIfNeeded();
      await follow(page, page.frameLocator("iframe"), "Kidney");
    });
  } finally {
    await served.close();
  }
  return `${found}: element and iframe paint, and open in the application`;
}

const wanted = process.argv.slice(2);
const unknown = wanted.filter((name) => !hosts.some((host) => host.name === name));
if (unknown.length > 0) {
  console.error(`no host "${unknown.join('", "')}"; there are: ${hosts.map(({ name }) => name).join(", ")}`);
  process.exitCode = 1;
} else if (await build([...moduleSteps(), ...pageSteps])) {
  const application = await serve(dist, { headers: { "access-control-allow-origin": "*" } });
  const browser = await launch();
  for (const host of hosts.filter(({ name }) => wanted.length === 0 || wanted.includes(name))) {
    try {
      console.log(`${host.name} ${await attempt(host, application.url, browser)}`);
    } catch (error) {
      console.error(`${host.name} FAILED: ${error instanceof Error ? error.message : error}`);
      process.exitCode = 1;
    }
  }
  await Promise.all([browser.close(), application.close()]);
} else {
  process.exitCode = 1;
}
