/** The page for iframes: its links, and the messages with the page around it. */
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { dist } from "../../../scripts/lib/paths.mjs";
import { writeLink } from "../../../js/link.js";
import { audit } from "../support/axe.js";
import { launch } from "../support/browser.js";
import { eventually, stage, standing, stateOf, visit } from "./host.js";

/** @type {import("playwright-core").Browser} */
let browser;
/** @type {import("./host.js").Stage} */
let host;

before(async () => {
  [browser, host] = await Promise.all([launch(), stage()]);
});
after(() => Promise.all([browser.close(), host.close()]));

/** @param {string} name */
const preset = async (name) => JSON.parse(await readFile(join(dist, "presets", `${name}.json`), "utf8"));

/**
 * A page with an iframe that keeps the messages it gets in `window.got`.
 *
 * @param {string} hash
 * @param {string} [more] further attributes, or elements behind
 */
const around = (hash, more = "") =>
  host.page(`<iframe id="f" title="A figure" width="640" height="420" src="${host.app}embed.html${hash.replaceAll("&", "&amp;")}" ${more}></iframe>`, {
    head: `<script>const got = []; addEventListener("message", ({ data, source, origin }) => got.push({ ...data, mine: source === document.getElementById("f").contentWindow, origin }));</script>`,
  });

/** @param {import("playwright-core").Page} page @param {string} type @returns {Promise<any[]>} */
const got = (page, type) => page.evaluate((type) => /** @type {any} */ (globalThis).eval("got").filter((/** @type {any} */ message) => message.type === type), `directrix:${type}`);

/** @param {import("playwright-core").Page} page @param {unknown} message */
const send = (page, message) => page.evaluate((message) => /** @type {HTMLIFrameElement} */ (document.getElementById("f")).contentWindow?.postMessage(message, "*"), message);

/** @param {import("playwright-core").Page} page @param {(state: any) => void} check of the last state that was told */
const told = (page, check) => eventually(async () => check((await got(page, "state")).at(-1)));

test("a sandboxed iframe of another origin tells what it shows, and takes wishes", async () => {
  await visit(browser, around("#v=1&preset=amoeba&controls=full", `sandbox="allow-scripts"`), {}, async (page) => {
    await told(page, (state) => {
      assert.equal(state.document.title, "Amoeba");
      assert.equal(state.result.text, "44 lines, none crossing, η 0.97");
      assert.deepEqual([state.v, state.mine, state.origin, state.s], [1, true, "null", 0.4]);
    });
    const [ready] = await got(page, "ready");
    assert.equal(ready.v, 1);
    const size = (await got(page, "resize")).at(-1);
    assert.deepEqual([size.width, size.height, size.suits], [640, 420, 400]);

    await send(page, { type: "directrix:set", v: 1, s: 0.75 });
    await told(page, (state) => assert.equal(state.s, 0.75));
    const kidney = { ...(await preset("kidney")), title: "<b>Sent</b>" };
    await send(page, { type: "directrix:set", v: 1, document: kidney, s: 0.2, controls: "minimal", theme: "dark" });
    await told(page, (state) => assert.deepEqual([state.document.title, state.s], ["<b>Sent</b>", 0.2]));
    const frame = page.frameLocator("#f");
    assert.equal(await frame.locator("directrix-figure").getAttribute("controls"), "minimal");
    assert.equal(await frame.locator("directrix-figure .frame").getAttribute("data-theme"), "dark");
    await send(page, { type: "directrix:set", v: 1, preset: "petals", playing: true });
    await told(page, (state) => assert.equal(state.document.title, "Petals"));
    await frame.getByRole("button", { name: "Pause" }).waitFor();
    await send(page, { type: "directrix:set", v: 1, preset: "hyperpatch-pair", s: 0.25 });
    await told(page, (state) => {
      assert.deepEqual([state.document.kind, state.s], ["hyperpatch", 0.25]);
      assert.deepEqual(state.result.body, { cells: 2, invalid: 0, degenerate: 0, overlaps: 0, volume: state.result.body.volume, checked: true });
    });
    await frame.getByRole("slider", { name: "Section" }).waitFor();
    assert.deepEqual(await got(page, "error"), []);
  });
});

test("a message with a fault is answered by the field, and others are let pass", async () => {
  await visit(browser, around("#v=1&preset=amoeba"), {}, async (page) => {
    await told(page, (state) => assert.equal(state.document.title, "Amoeba"));
    /** @type {[object, string, string][]} */
    const faults = [
      [{ v: 2, s: 0.1 }, "version", "v"],
      [{ s: 0.1 }, "version", "v"],
      [{ v: 1, s: 3 }, "range", "s"],
      [{ v: 1, s: "0.5" }, "range", "s"],
      [{ v: 1, controls: "many" }, "range", "controls"],
      [{ v: 1, preset: "../../x" }, "range", "preset"],
      [{ v: 1, document: 7 }, "range", "document"],
      [{ v: 1, html: "<script>" }, "unknown-field", "html"],
      [{ v: 1, document: { directrix: 1, kind: "curves", curves: [], matching: { method: "none" } } }, "range", "matching.method"],
    ];
    for (const [k, [message, code, path]] of faults.entries()) {
      await send(page, { type: "directrix:set", ...message });
      await eventually(async () => assert.equal((await got(page, "error")).length, k + 1));
      const error = (await got(page, "error")).at(-1);
      assert.deepEqual([error.code, error.path, error.v], [code, path, 1], JSON.stringify(error));
      assert.ok(error.message.length > 10);
    }
    for (const other of [null, 3, "directrix:set", [], { type: "set", v: 1, s: 0 }, { type: "directrix:state", v: 1, s: 0 }, { type: { toString: 1 } }]) await send(page, other);
    await send(page, { type: "directrix:set", v: 1, s: 0.9 });
    await told(page, (state) => assert.equal(state.s, 0.9));
    assert.equal((await got(page, "error")).length, faults.length);
  });
});

test("messages from another window are not heard", async () => {
  const other = `></iframe><iframe id="other" title="Other" srcdoc="<script>addEventListener('message', () => parent.frames[0].postMessage({ type: 'directrix:set', v: 1, s: 0.11 }, '*'))</script>"`;
  await visit(browser, around("#v=1&preset=amoeba", other), {}, async (page) => {
    await told(page, (state) => assert.equal(state.s, 0.4));
    await page.evaluate(() => /** @type {HTMLIFrameElement} */ (document.getElementById("other")).contentWindow?.postMessage("go", "*"));
    await page.waitForTimeout(200);
    await send(page, { type: "directrix:set", v: 1, s: 0.5 });
    await told(page, (state) => assert.equal(state.s, 0.5));
    assert.ok(!(await got(page, "state")).some(({ s }) => s === 0.11));
  });
});

test("a link carries the whole document, and a changed hash is followed", async () => {
  const kidney = { ...(await preset("kidney")), title: "In the link" };
  await visit(browser, `${host.app}embed.html${writeLink({ document: kidney, controls: "none", theme: "dark" })}`, {}, async (page) => {
    await standing(page);
    assert.deepEqual((await stateOf(page)).document, kidney);
    assert.match(await page.title(), /In the link/);
    assert.deepEqual(await audit(page), []);
    await page.evaluate(() => (location.hash = "#v=1&preset=petals&controls=full"));
    await eventually(async () => assert.equal((await stateOf(page)).document.title, "Petals"));
    assert.deepEqual(await audit(page), []);
  });
});

test("a document at an address is not asked for before a person says so", async () => {
  const address = `${host.app}presets/kidney.json`;
  await visit(browser, `${host.app}embed.html${writeLink({ url: address })}`, {}, async (page) => {
    let asked = 0;
    page.on("request", (request) => (asked += Number(request.url() === address)));
    const button = page.getByRole("button", { name: "Load it" });
    await button.waitFor();
    assert.ok(await page.getByText(address).isVisible());
    assert.deepEqual(await audit(page), []);
    assert.equal(asked, 0);
    await button.click();
    await standing(page);
    assert.equal(asked, 1);
  });
});

test("a link that was cut off, or of a later release, is told", async () => {
  for (const [hash, pattern] of /** @type {[string, RegExp][]} */ ([
    ["#v=9&preset=amoeba", /v: .*later release/],
    ["#v=1&s=AAAA", /s: /],
    ["#v=1&preset=%3Cimg%3E", /preset: /],
    ["", /No figure is named here/],
  ])) {
    await visit(browser, `${host.app}embed.html${hash}`, {}, async (page) => {
      await eventually(async () => assert.match((await page.locator(".refused").textContent()) ?? "", pattern));
      assert.deepEqual(await audit(page), []);
    });
  }
});
