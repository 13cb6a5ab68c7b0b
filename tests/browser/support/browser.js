/** A browser for a test file, and pages in it that fail when the browser complains. */
import { chromium } from "playwright-core";
import { findBrowser } from "../../../scripts/lib/browser.mjs";

/**
 * @typedef {import("playwright-core").Browser} Browser
 * @typedef {import("playwright-core").Page} Page
 * @typedef {import("playwright-core").BrowserContextOptions} PageOptions
 */

/**
 * What the browser does not need here. A second list of features takes the place of the first, so that those of Playwright for Chromium stand here
 * again. The others are the suggestions below the address bar: a page of the browser's own in every new window, which costs as much time as a page of ours.
 */
const unneeded = [
  ...["AvoidUnnecessaryBeforeUnloadCheckSync", "DestroyProfileOnBrowserClose", "HttpsUpgrades", "HttpsFirstBalancedModeAutoEnable", "LensOverlay"],
  ...["MediaRouter", "PaintHolding", "ThirdPartyStoragePartitioning", "AvoidCorsURLLoaderRestartOnRedirect", "OptimizationHints"],
  ...["NetworkTimeServiceQuerying", "AimEnabled", "PreconnectToSearch"],
  ...["WebUIOmniboxPopup", "WebUIOmniboxAimPopup", "WebUIOmniboxFullPopup", "WebUIOmniboxSimplification"],
];

/** No sandbox, for containers that run as root; no graphics card; no connection of the browser's own. */
const flags = [
  "--no-sandbox",
  "--disable-gpu",
  "--enable-unsafe-swiftshader",
  "--no-first-run",
  "--disable-background-networking",
  "--disable-component-update",
  "--disable-sync",
  `--disable-features=${unneeded.join(",")}`,
];

/** Milliseconds that a page may take for one thing on a busy machine. */
const patience = 30_000;

/**
 * Starts the browser; the test that started it closes it.
 *
 * @param {string[]} [more] further flags
 * @returns {Promise<Browser>}
 */
export async function launch(more = []) {
  const executablePath = await findBrowser();
  if (executablePath === null) throw new Error("no browser: install Chromium or Chrome, or set CHROME_PATH to one");
  return chromium.launch({ executablePath, args: [...flags, ...more] });
}

/**
 * Opens a fresh page with storage of its own, hands it to the test, and closes it. Fails when the test does, when the page has
 * written an error or a warning to its console, or when it had an error that nothing caught.
 *
 * @template T
 * @param {Browser} browser
 * @param {PageOptions & { allow?: RegExp }} options of the page: size, colour scheme, touch, reduced motion, scripts; `allow`:
 *   messages that the test expects
 * @param {(page: Page) => Promise<T>} test
 * @returns {Promise<T>}
 */
export async function withPage(browser, { allow, ...options }, test) {
  const context = await browser.newContext(options);
  try {
    context.setDefaultTimeout(patience);
    const page = await context.newPage();
    const complaints = watch(page, allow);
    const result = await test(page);
    if (complaints.length > 0) throw new Error(`the page complained:\n${complaints.join("\n")}`);
    return result;
  } finally {
    await context.close();
  }
}

/** What Chromium says when it draws in three dimensions without a graphics card, which is no complaint. */
export const SOFTWARE = /GPU stall due to ReadPixels/;

/**
 * The complaints of a page from now on: a list that grows.
 *
 * @param {Page} page
 * @param {RegExp} [allow]
 * @returns {string[]}
 */
export function watch(page, allow) {
  /** @type {string[]} */
  const complaints = [];
  /** @param {string} text */
  const note = (text) => {
    if (!allow?.test(text)) complaints.push(text);
  };
  page.on("console", (message) => {
    if (["error", "warning"].includes(message.type())) note(`${message.type()}: ${message.text()} (${message.location().url})`);
  });
  page.on("pageerror", (error) => note(`uncaught: ${error.message}`));
  page.on("requestfailed", (request) => {
    const reason = request.failure()?.errorText ?? "failed";
    if (reason !== "net::ERR_ABORTED") note(`${reason}: ${request.url()}`);
  });
  return complaints;
}
