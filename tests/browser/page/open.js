/**
 * Opens the built page for one test and closes it after; the test fails when the page complained on its console, or
 * asked any other host for anything.
 *
 * @import { BrowserContextOptions, Page } from "playwright-core"
 * @import { TestContext } from "node:test"
 *
 * @typedef {BrowserContextOptions & {init?: string, hash?: string, allow?: RegExp}} Options `init`: a script that runs before the page's own;
 *   `hash`: that of the address; `allow`: messages on the console that are no complaints
 */
import assert from "node:assert/strict";
import { after, before } from "node:test";
import { launch, watch } from "../support/browser.js";
import { serveDist } from "../support/server.js";
import { countCalls } from "./idle.js";
import { ready } from "./workbench.js";

/** @type {import("playwright-core").Browser} */
let browser;
/** @type {Awaited<ReturnType<typeof serveDist>>} */
let server;

before(async () => {
  [browser, server] = await Promise.all([launch(), serveDist()]);
});
after(async () => {
  await browser?.close();
  await server?.close();
});

/**
 * The page with its first figure painted.
 * @param {TestContext} t
 * @param {Options} [options]
 */
export async function openPage(t, { init, hash = "", allow, ...context } = {}) {
  const page = await newPage(t, context, init);
  const complaints = watch(page, allow);
  const [home] = server.url.split("/", 3).slice(2);
  page.on("request", (request) => {
    const { protocol, host } = new URL(request.url());
    if (protocol.startsWith("http") && host !== home) complaints.push(`a request to ${request.url()}`);
  });
  t.after(() => assert.deepEqual(complaints, []));
  await page.goto(`${server.url}${hash}`);
  await ready(page);
  return page;
}

/**
 * The page as it comes, for the cases in which it cannot work; its complaints are expected.
 * @param {TestContext} t
 * @param {{init?: string, hash?: string, headers?: Record<string, string>, context?: BrowserContextOptions}} options
 */
export async function openRaw(t, { init, hash = "", headers, context = {} }) {
  const page = await newPage(t, context, init);
  if (!headers) {
    await page.goto(`${server.url}${hash}`);
    return page;
  }
  const own = await serveDist({ headers });
  t.after(() => own.close());
  await page.goto(own.url);
  return page;
}

/**
 * @param {TestContext} t
 * @param {BrowserContextOptions} options
 * @param {string | undefined} init
 * @returns {Promise<Page>}
 */
async function newPage(t, options, init) {
  const context = await browser.newContext({ viewport: { width: 1440, height: 900 }, ...options });
  t.after(() => context.close());
  // Keeping the page for use without a network has tests of its own, and is much work for the machine.
  await context.addInitScript("Object.defineProperty(navigator, 'serviceWorker', { value: undefined });");
  await countCalls(context);
  if (init) await context.addInitScript(init);
  const page = await context.newPage();
  page.setDefaultTimeout(15_000);
  return page;
}
