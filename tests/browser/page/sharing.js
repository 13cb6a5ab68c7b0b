/**
 * The panel Share, and other people's servers, as the tests use them.
 *
 * @import { Page } from "playwright-core"
 */
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { createServer } from "node:http";
import { eventually, pick } from "./workbench.js";

/** A preset as it is stored. @param {string} name @returns {any} */
export const presetFile = (name) =>
  JSON.parse(readFileSync(new URL(`../../../www/presets/${name}.json`, import.meta.url), "utf8"));

/**
 * Opens the panel and waits until the link of a tab is made.
 * @param {Page} page
 * @param {"editor" | "view" | "embed"} [tab]
 */
export async function share(page, tab = "editor") {
  if ((await page.locator("[data-panel=share]").count()) === 0) await page.locator("[data-action=share]").click();
  await page.locator("[data-panel=share] h2").waitFor();
  await pick(page, "share-tab", tab);
  await eventually(async () => assert.notEqual(await page.locator("[data-share-text]").inputValue(), ""));
}

/** What the open tab offers, once it holds a text. @param {Page} page @param {RegExp} like */
export const offered = (page, like) =>
  eventually(async () => {
    const text = await page.locator("[data-share-text]").inputValue();
    assert.match(text, like);
    return text;
  });

/** The hash of an address. @param {string} address */
export const hashOf = (address) => new URL(address).hash;

/** Puts a hash into the address bar of a page that is open. @param {Page} page @param {string} hash */
export const goToHash = (page, hash) => page.evaluate((text) => void (location.hash = text), hash);

/** What is said of a link that was not opened. @param {Page} page @param {RegExp} like */
export const linkProblem = (page, like) =>
  eventually(async () => assert.match(await page.locator("[data-link-problem]").innerText(), like));

/**
 * A server of somebody else, at another port and therefore another origin.
 * @param {import("node:test").TestContext} t
 * @param {{[path: string]: (response: import("node:http").ServerResponse) => void}} answers
 */
export async function stranger(t, answers) {
  /** @type {string[]} */
  const asked = [];
  const server = createServer((request, response) => {
    asked.push(`${request.method} ${request.url}`);
    assert.equal(request.headers.referer, undefined, "no one is told where the link was opened");
    assert.equal(request.headers.cookie, undefined);
    const answer = answers[request.url ?? ""];
    if (answer) answer(response);
    else response.writeHead(404, { "access-control-allow-origin": "*" }).end();
  });
  await new Promise((done) => server.listen(0, "127.0.0.1", () => done(undefined)));
  t.after(() => {
    server.closeAllConnections();
    server.close();
  });
  const { port } = /** @type {import("node:net").AddressInfo} */ (server.address());
  return { url: `http://127.0.0.1:${port}`, asked };
}

/** JSON that any page may read. @param {unknown} value */
export const open = (value) => (/** @type {import("node:http").ServerResponse} */ response) =>
  void response.writeHead(200, { "access-control-allow-origin": "*", "content-type": "application/json" }).end(JSON.stringify(value));
