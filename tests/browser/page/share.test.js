/** Sharing: what a link carries opens as the identical document, beside everything the person has; a wrong link changes nothing. */
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { test } from "node:test";
import { encodeDocument, readLink, writeLink } from "directrix/link";
import { audit } from "../support/axe.js";
import { heads, keptNow, nudge, preset, secondTab, stored } from "./kept.js";
import { openPage, openRaw } from "./open.js";
import { goToHash, hashOf, linkProblem, offered, open, presetFile, share, stranger } from "./sharing.js";
import { documentOf, drawn, eventually, field, pick, ready, spoken, status, uiOf } from "./workbench.js";

/** @import { Page } from "playwright-core" */

/** Waits for a title. @param {Page} page @param {string} title */
const titled = (page, title) => eventually(async () => assert.equal(await field(page, "title").inputValue(), title));

/** A document whose link is longer than is offered. */
function large() {
  const document = presetFile("amoeba");
  document.curves[1].points = Array.from({ length: 420 }, (_, i) => {
    const [angle, radius] = [(i * Math.PI) / 210, 60 + 0.9 * Math.sin(i * 12.9898)];
    return [radius * Math.cos(angle), radius * Math.sin(angle)];
  });
  return { ...document, title: "Many points" };
}

test("an edited document is shared and opened elsewhere as the identical one, with its view, mode and step", async (t) => {
  const page = await openPage(t, { permissions: ["clipboard-read", "clipboard-write"] });
  await nudge(page);
  await page.locator("[data-box=normals]").check();
  const document = await documentOf(page);
  const { layers, s } = await uiOf(page);
  await share(page);
  const link = await offered(page, /#v=1&s=[\w-]+$/);
  await eventually(async () => assert.equal(page.url(), link, "it stands in the address bar as well"));
  assert.match(await page.locator("[data-share-note]").innerText(), /^\d+ characters\. The link holds the whole document; nothing is uploaded\.$|kB/);
  assert.deepEqual(await page.evaluate(() => history.state.document), document, "the entry of the history keeps its state");
  await page.locator("[data-share=copy]").click();
  await eventually(async () => assert.equal(await page.locator("[data-share=copy]").innerText(), "Copied"));
  assert.equal(await page.evaluate(() => navigator.clipboard.readText()), link);
  await eventually(async () => assert.equal(await spoken(page), "Copied the link to the editor"));

  const other = await openPage(t, { hash: hashOf(link) });
  assert.equal(JSON.stringify(await documentOf(other)), JSON.stringify(document), "byte for byte");
  const ui = await uiOf(other);
  assert.deepEqual([ui.layers, ui.s, ui.mode], [layers, s, "figure"]);
  assert.match(await status(other), /Amoeba opened from a link, as an unsaved copy/);
  assert.equal(await other.locator("[data-state]").textContent(), "", "nothing was edited yet");
  assert.ok(await other.locator("[data-action=undo]").isDisabled());
  assert.deepEqual(await stored(other), {}, "a document that is only looked at is not kept");

  // The mode and the step go with it.
  await page.locator("[data-close=share]").click();
  await pick(page, "mode", "steps");
  await page.locator("[data-steps=forward]").click();
  await page.locator(".mode-stage[data-step='2']").waitFor();
  await share(page);
  await offered(page, /&view=steps&step=2$/);
  // And the panel follows what is done beside it.
  await page.locator("[data-steps=forward]").click();
  const stepped = await offered(page, /&view=steps&step=3$/);
  await share(page, "view");
  const view = await offered(page, /embed\.html#v=1&s=[\w-]+&view=steps&step=3&controls=minimal$/);
  assert.equal(JSON.stringify(readLink(hashOf(view)).document), JSON.stringify(readLink(hashOf(stepped)).document));
  await other.goto(stepped);
  await other.locator(".mode-stage[data-step='3']").waitFor();
  await eventually(async () => assert.equal(JSON.stringify(await documentOf(other)), JSON.stringify(document)));
  await other.reload();
  await ready(other);
  await other.locator(".mode-stage[data-step='3']").waitFor();
});

test("an unchanged preset has a short link, which gives it up with the first change and takes it back with undo", async (t) => {
  const page = await openPage(t);
  await share(page);
  await offered(page, /#v=1&preset=amoeba$/);
  assert.match(await page.locator("[data-share-note]").innerText(), /The link names the preset Amoeba/);
  await nudge(page);
  await offered(page, /#v=1&s=[\w-]+$/);
  await page.locator("[data-action=undo]").click();
  await offered(page, /#v=1&preset=amoeba$/);
  await page.locator("[data-box=grid]").uncheck();
  await offered(page, /#v=1&s=[\w-]+$/);
  await preset(page, "gear");
  await share(page);
  const link = await offered(page, /#v=1&preset=gear$/);
  const document = await documentOf(page);
  const other = await openPage(t, { hash: `${hashOf(link)}&step=2` });
  await other.locator(".mode-stage[data-step='2']").waitFor();
  assert.equal(JSON.stringify(await documentOf(other)), JSON.stringify(document));
});

test("a link opens beside the work at hand: it is kept, Back returns to it, and Forward to the edits of the copy", async (t) => {
  const page = await openPage(t);
  await nudge(page);
  const id = await keptNow(page);
  await nudge(page);
  const work = await documentOf(page);
  const link = writeLink({ document: { ...presetFile("kidney"), title: "From afar" }, view: "figure" });
  await goToHash(page, link);
  await titled(page, "From afar");
  const [head, ...more] = await heads(page);
  assert.deepEqual([head.id, head.title, more.length], [id, "Amoeba", 0], "the copy is not kept, and the work is");
  await eventually(async () => assert.deepEqual((await stored(page))[`body/${id}`].curves, work.curves, "with its last edit"));
  assert.equal(hashOf(page.url()), link);

  await nudge(page);
  const copy = await documentOf(page);
  assert.equal(hashOf(page.url()), "", "the address no longer says what is shown");
  await eventually(async () => assert.equal((await heads(page)).length, 2));
  await page.reload();
  await ready(page);
  assert.deepEqual(await documentOf(page), copy, "a reload keeps the edits");

  await page.goBack();
  await titled(page, "Amoeba");
  await eventually(async () => assert.deepEqual(await documentOf(page), work));
  await page.goForward();
  await titled(page, "From afar");
  await eventually(async () => assert.deepEqual(await documentOf(page), copy));
  assert.equal((await heads(page)).length, 2);
});

test("an edit after opening a link is still there after a reload, and so is the document that was not edited", async (t) => {
  const link = writeLink({ document: presetFile("kidney"), theme: "dark", controls: "minimal" });
  const page = await openPage(t, { hash: link });
  await page.reload();
  await ready(page);
  assert.equal(hashOf(page.url()), link);
  await nudge(page);
  const edited = await documentOf(page);
  assert.equal(hashOf(page.url()), "#v=1&controls=minimal&theme=dark", "how it looks stays in the address");
  await page.reload();
  await ready(page);
  assert.equal(JSON.stringify(await documentOf(page)), JSON.stringify(edited));
  assert.equal(await page.locator("html").getAttribute("data-controls"), "minimal");
});

test("places of the page and lessons are no links, and the way back from them takes no edit back", async (t) => {
  const page = await openPage(t);
  await documentOf(page);
  for (const hash of ["#lesson=greedy&step=3", "#stage"]) await goToHash(page, hash);
  await nudge(page);
  const work = await documentOf(page);
  await page.waitForTimeout(100);
  assert.equal(await page.locator("[data-panel=link]").count(), 0);
  assert.equal((await uiOf(page)).mode, "figure");
  for (let i = 0; i < 2; i += 1) {
    await page.goBack();
    await page.waitForTimeout(150);
    assert.deepEqual(await documentOf(page), work);
  }
  assert.equal(hashOf(page.url()), "");
});

test("two tabs with one link are two documents", async (t) => {
  const page = await openPage(t, { hash: writeLink({ document: { ...presetFile("kidney"), title: "Twin" } }) });
  const other = await secondTab(t, page);
  await nudge(page);
  await eventually(async () => assert.equal((await heads(page)).length, 1));
  await nudge(other, "Shift+ArrowDown");
  await eventually(async () => assert.equal((await heads(page)).length, 2));
  const bodies = Object.entries(await stored(page)).filter(([key]) => key.startsWith("body/"));
  const [a, b] = bodies.map(([, body]) => body.curves[1].points[1][1]);
  assert.notEqual(a, b);
});

test("a wrong link leaves what is open, says what is wrong beside it, and the next one is opened", async (t) => {
  const good = writeLink({ document: presetFile("kidney") });
  const page = await openPage(t, { hash: "#v=2&s=abc" });
  await linkProblem(page, /version 2 was found, which a later release of Directrix writes/);
  await eventually(async () => assert.match(await spoken(page), /^The link was not opened\. Link: version 2/));
  await titled(page, "Amoeba");
  assert.deepEqual(await audit(page), []);
  await nudge(page);
  const work = await documentOf(page);
  /** @type {[hash: string, says: RegExp][]} */
  const cases = [
    [good.slice(0, -30), /Document: the text was cut off/],
    ["#v=1&s=_____w", /Document: the text was changed on its way/],
    ["#json=57,abc", /Link: "json=57,abc" was found/],
    ["#v=1&preset=nothing-like-it", /Preset: "nothing-like-it" was found, and there is no preset of this name/],
    ["#v=1&preset=amoeba&view=match", /View: "match" was found; expected figure, steps, compare/],
    [`#v=1&s=${encodeDocument(/** @type {any} */ ({ directrix: 2, kind: "curves" }))}`, /Document: .*version/],
    [`#v=1&s=${encodeDocument({ ...presetFile("kidney"), colour: 1 })}`, /Document: .*colour/],
    [`#v=1&s=${encodeDocument({ ...presetFile("kidney"), title: "x".repeat(201) })}`, /Document: title/],
    ["#url=javascript:alert(1)", /Address: "javascript:alert\(1\)" was found/],
  ];
  for (const [hash, says] of cases) {
    await goToHash(page, hash);
    await linkProblem(page, says);
    assert.deepEqual(await documentOf(page), work, hash);
  }
  await goToHash(page, "#stage");
  await eventually(async () => assert.equal(await page.locator("[data-panel=link]").count(), 0, "a place of the page is no link"));
  await goToHash(page, good);
  await titled(page, presetFile("kidney").title);
  assert.equal(await page.locator("[data-panel=link]").count(), 0);
});

test("markup in a shared document is text and nothing else, and colours are colours", async (t) => {
  const markup = `<img src=x onerror="document.title='taken'"><script>document.title='taken'</script>&amp;"'`;
  const document = presetFile("amoeba");
  document.title = markup;
  document.curves[0].name = markup.slice(0, 60);
  document.materials[0].name = markup.slice(0, 60);
  const page = await openPage(t, { hash: writeLink({ document }) });
  await titled(page, markup);
  for (const tab of /** @type {const} */ (["editor", "view", "embed"])) await share(page, tab);
  for (const code of ["element", "iframe"]) {
    await pick(page, "share-code", code);
    const text = await offered(page, code === "element" ? /^<script type="module"/ : /^<iframe/);
    assert.ok(!text.includes("<img"), text);
    const found = await page.evaluate((html) => {
      const { body } = new DOMParser().parseFromString(html, "text/html");
      return [...body.querySelectorAll("*")].map((each) => each.localName);
    }, text);
    assert.deepEqual(found.filter((name) => name !== "script"), [code === "element" ? "directrix-figure" : "iframe"]);
    assert.equal(found.length, code === "element" ? found.length : 1);
  }
  assert.equal(await page.locator("img[src=x]").count(), 0);
  assert.match(await page.title(), /^<img/, "the title is what it says, not what it does");
  const color = structuredClone(document);
  color.materials[0].color = `red;background:url(https://example.org/)`;
  await goToHash(page, `#v=1&s=${encodeDocument(color)}`);
  await linkProblem(page, /Document: materials\[0\]\.color/);
  await goToHash(page, `#v=1&preset=${encodeURIComponent(markup)}`);
  await linkProblem(page, /Preset: "<img src=x/);
  assert.equal(await page.locator("img[src=x]").count(), 0);
});

test("the view, the controls and the theme of a link hold for the visit and are not stored", async (t) => {
  const page = await openPage(t, { hash: "#v=1&preset=gear&controls=minimal&theme=dark&view=compare" });
  await page.locator(".mode-stage .compare, .mode-stage > *").first().waitFor();
  assert.equal((await uiOf(page)).mode, "compare");
  assert.equal(await page.locator("html").getAttribute("data-theme"), "dark");
  assert.equal(await page.evaluate(() => localStorage.getItem("directrix-theme")), null);
  for (const id of ["inspector", "bar"]) assert.ok((await page.locator(`#${id}`).evaluate((each) => each.clientHeight)) === 0, id);
  assert.ok(await page.locator("#status").isVisible());
  assert.deepEqual(await audit(page), []);
  await page.locator("[data-show-controls]").click();
  assert.ok(await page.locator("#inspector").isVisible());
  assert.ok(await page.locator("[data-action=share]").isVisible());
  await page.goto(page.url().replace("minimal", "none").replace("view=compare", "view=figure"));
  await eventually(async () => assert.equal(await page.locator("#status").isVisible(), false));
  const [stage, window] = await page.evaluate(() => {
    const { width, height } = /** @type {HTMLElement} */ (document.querySelector("#stage")).getBoundingClientRect();
    return [[width, height], [innerWidth, innerHeight]];
  });
  assert.deepEqual(stage, window, "the figure has the whole window");
  await page.goto(page.url().replace("controls=none&theme=dark", "controls=full&theme=light"));
  await eventually(async () => assert.equal(await page.locator("html").getAttribute("data-theme"), "light"));
  assert.ok(await page.locator("#inspector").isVisible());
});

test("a document from an address is fetched only when the person agrees", async (t) => {
  const document = { ...presetFile("kidney"), title: "Hosted" };
  const { url, asked } = await stranger(t, { "/figures/kidney.json?x=1&y=2": open(document) });
  const page = await openRaw(t, { hash: writeLink({ url: `${url}/figures/kidney.json?x=1&y=2`, step: 2 }) });
  await ready(page);
  await eventually(async () =>
    assert.equal(await page.locator("[data-link-address]").innerText(), `${url}/figures/kidney.json?x=1&y=2`),
  );
  assert.deepEqual(await audit(page), []);
  await titled(page, "Amoeba");
  await page.waitForTimeout(300);
  assert.deepEqual(asked, [], "nothing before the person agrees");
  await page.reload();
  await ready(page);
  await page.locator("[data-ask=decline]").click();
  await page.locator("[data-panel=link]").waitFor({ state: "detached" });
  assert.deepEqual(asked, []);
  await goToHash(page, "#stage");
  await goToHash(page, writeLink({ url: `${url}/figures/kidney.json?x=1&y=2`, step: 2 }));
  await page.locator("[data-ask=agree]").waitFor();
  // Going to a hash takes the focus away with one of the next frames.
  await drawn(page);
  await page.locator("[data-ask=agree]").press("Enter");
  await titled(page, "Hosted");
  await page.locator(".mode-stage[data-step='2']").waitFor();
  assert.deepEqual(asked, ["GET /figures/kidney.json?x=1&y=2"]);
  await page.locator("[data-panel=link]").waitFor({ state: "detached" });
  await eventually(async () => assert.match(await status(page), /Hosted opened from 127\.0\.0\.1:\d+, as an unsaved copy/));
  await page.reload();
  await ready(page);
  await titled(page, "Hosted");
  assert.equal(await page.locator("[data-panel=link]").count(), 0, "what was opened is not asked for again");
  assert.equal(asked.length, 1);
});

test("what goes wrong while a document is fetched is told in plain words, and nothing is lost", async (t) => {
  const free = { "access-control-allow-origin": "*" };
  const { url } = await stranger(t, {
    "/closed.json": (response) => void response.writeHead(200).end(JSON.stringify(presetFile("kidney"))),
    "/page.html": (response) => void response.writeHead(200, free).end("<!doctype html><title>404</title>"),
    "/other.json": open({ type: "excalidraw" }),
    "/wrong.json": open({ ...presetFile("kidney"), curves: 3 }),
    "/bytes.json": (response) => void response.writeHead(200, free).end(Buffer.from([0x7b, 0xff, 0xfe])),
    "/large.json": (response) => void response.writeHead(200, free).end(Buffer.alloc((4 << 20) + 1, 0x20)),
    "/broken.json": (response) => void response.writeHead(500, free).end(),
  });
  const page = await openRaw(t, {});
  await ready(page);
  const work = await documentOf(page);
  /** @type {[address: string, says: RegExp][]} */
  const cases = [
    [`${url}/closed.json`, /does not let other pages read this file \(CORS\)/],
    [`${url}/missing.json`, /has no file at this address \(404\)/],
    [`${url}/broken.json`, /answered with the status 500/],
    [`${url}/page.html`, /is no JSON/],
    [`${url}/bytes.json`, /no text in UTF-8/],
    [`${url}/other.json`, /no document of Directrix/],
    [`${url}/wrong.json`, /Document: curves/],
    [`${url}/large.json`, /larger than 4 MiB/],
    ["http://127.0.0.1:9/closed.json", /127\.0\.0\.1:9 cannot be reached/],
  ];
  for (const [address, says] of cases) {
    await goToHash(page, writeLink({ url: address }));
    await eventually(async () => assert.equal(await page.locator("[data-link-address]").innerText(), address));
    await page.locator("[data-ask=agree]").click();
    await linkProblem(page, says);
    assert.equal(await page.locator("[data-ask=agree]").innerText(), "Try again");
  }
  await page.context().setOffline(true);
  await goToHash(page, writeLink({ url: "https://example.org/a.json" }));
  await eventually(async () => assert.match(await page.locator("[data-link-address]").innerText(), /example\.org/));
  await page.locator("[data-ask=agree]").click();
  await linkProblem(page, /offline/);
  await page.context().setOffline(false);
  await page.keyboard.press("Escape");
  assert.deepEqual(await documentOf(page), work);
});

test("a document too long for a link is offered as a file, with the way to host it", async (t) => {
  const document = large();
  const { url } = await stranger(t, { "/many-points.json": open(document) });
  const page = await openRaw(t, { hash: writeLink({ url: `${url}/many-points.json` }) });
  await ready(page);
  await page.locator("[data-ask=agree]").click();
  await titled(page, "Many points");
  const address = page.url();
  await share(page);
  await eventually(async () => assert.match(await page.locator("[data-share-long]").innerText(), /a link of 1\d(\.\d)? kB, and mail and chat programs cut links above 8 kB/));
  assert.equal(page.url(), address, "a link that long does not go into the address bar");
  const template = await offered(page, /#v=1&url=https:\/\/example\.org\/many-points\.json$/);
  assert.deepEqual(readLink(hashOf(template)), { url: "https://example.org/many-points.json" });
  const download = page.waitForEvent("download");
  await page.locator("[data-share=download]").click();
  const file = await download;
  assert.equal(file.suggestedFilename(), "many-points.json");
  const { view: _, ...body } = JSON.parse(await readFile(await file.path(), "utf8"));
  assert.deepEqual(body, await documentOf(page));
  await share(page, "embed");
  const code = await offered(page, /src="many-points\.json"/);
  assert.match(code, /<directrix-figure\n/);
  assert.match(await page.locator("[data-share-note]").innerText(), /stands in many-points\.json/);
});

test("the panel works by keyboard and touch, in the dark and on a phone, and without the clipboard", async (t) => {
  const page = await openPage(t, {
    viewport: { width: 390, height: 844 },
    hasTouch: true,
    isMobile: true,
    colorScheme: "dark",
    init: "navigator.clipboard.write = () => Promise.reject(new DOMException('no', 'NotAllowedError'))",
  });
  const button = page.locator("[data-action=share]");
  const { width = 0, height = 0 } = (await button.boundingBox()) ?? {};
  assert.ok(width >= 44 && height >= 44, `${width} × ${height}`);
  assert.equal(await button.getAttribute("aria-label"), "Share");
  await button.tap();
  await page.locator("[data-panel=share] h2").waitFor();
  await share(page, "embed");
  await offered(page, /directrix-figure/);
  for (const code of ["element", "iframe"]) {
    await pick(page, "share-code", code);
    assert.deepEqual(await audit(page), []);
  }
  const code = await offered(page, /<iframe/);
  await page.locator("[data-share=copy]").tap();
  await eventually(async () => assert.match(await page.locator("[data-message]").innerText(), /did not let the page copy/));
  assert.equal(await page.evaluate(() => getSelection()?.toString() || document.activeElement?.localName), code);
  await page.keyboard.press("Escape");
  assert.equal(await page.locator("[data-panel=share]").count(), 0);

  await page.locator("#steps-keys, body").first().press("l");
  await page.locator("[data-panel=share] h2").waitFor();
  await eventually(async () => assert.match(page.url(), /#v=1&preset=amoeba$/));
  await page.keyboard.press("Tab");
  await page.keyboard.press("Tab");
  await page.keyboard.press("ArrowRight");
  await eventually(async () => assert.ok(["editor", "view", "embed"].includes(await page.evaluate(() => /** @type {any} */ (document.activeElement)?.value))));
  await page.keyboard.press("Escape");
  await page.locator("[data-action=menu]").click();
  await page.locator("[data-item=shortcuts]").click();
  assert.match(await page.locator("[data-keys=share]").innerText(), /Share\s+L/);
});

test("where all storage throws a link opens, and Back returns to the work", async (t) => {
  const page = await openPage(t, {
    init: `for (const name of ["indexedDB", "localStorage"]) {
      Object.defineProperty(globalThis, name, { get() { throw new DOMException("no", "SecurityError") } });
    }`,
  });
  await nudge(page);
  await eventually(async () => assert.equal(await page.locator("[data-state]").textContent(), "Not saved"));
  const work = await documentOf(page);
  await goToHash(page, writeLink({ document: { ...presetFile("kidney"), title: "From afar" }, theme: "dark" }));
  await titled(page, "From afar");
  await documentOf(page);
  await page.goBack();
  await titled(page, "Amoeba");
  await eventually(async () => assert.deepEqual(await documentOf(page), work));
});
