import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { test } from "node:test";
import { load } from "directrix";
import { audit } from "../support/axe.js";
import { SOFTWARE } from "../support/browser.js";
import { openPage } from "./open.js";
import { hashOf, presetFile } from "./sharing.js";
import { documentOf, eventually, field, pick, spoken, status } from "./workbench.js";

/**
 * @import { Page } from "playwright-core"
 * @import { TestContext } from "node:test"
 */

/** @param {TestContext} t @param {string} preset @param {import("./open.js").Options} [options] */
const open = (t, preset, options) => openPage(t, { allow: SOFTWARE, viewport: { width: 920, height: 560 }, hash: `#v=1&preset=hyperpatch-${preset}`, ...options });

/** Waits until every check of the open body has run. @param {Page} page */
const checked = (page) => page.locator("[data-body=checked]").waitFor({ state: "attached" });

test("a body: verdicts, section, reading, an edit of a corner, its link", async (t) => {
  const page = await open(t, "ring");
  await checked(page);
  await eventually(async () => assert.match(await status(page), /^Verified\s+8\s+cells/));
  assert.equal(await page.locator("[data-workbench=hyperpatch]").count(), 1);
  assert.equal(await page.locator("[data-bench=hyperpatch]").getAttribute("aria-current"), "page");
  await eventually(async () => assert.equal(await page.title(), "Ring of eight · Directrix"));
  assert.deepEqual(await audit(page), []);

  // A cell with what is certified of it.
  await page.locator('[data-cell="3"]').click();
  await eventually(async () => assert.match(await page.locator("[data-fact=jacobian]").innerText(), /0\.\d\d × mean/));
  assert.equal(await page.locator("[data-verdict=regular].verdict-badge").innerText(), "regular");

  // The section has the area of two rectangles of 1 by 1 in the ring between the radii 1 and 2.
  await pick(page, "body-axis", "x");
  await page.locator("[data-cut=shown]").waitFor({ state: "attached" });
  await eventually(async () => assert.match(await page.locator("[data-fact=area]").innerText(), /(2\.00|1\.99)\smm²/));
  const handle = page.locator("[data-plane-handle]");
  await handle.focus();
  await page.keyboard.press("ArrowUp");
  await eventually(async () => assert.match((await handle.getAttribute("aria-valuetext")) ?? "", /^x = /));

  // The middle of the picture is read by keyboard: from the front the wall of the ring, from above its hole.
  await pick(page, "body-axis", "off");
  await page.locator("[data-body-keys]").focus();
  await page.keyboard.press("6");
  await eventually(async () => assert.match(await spoken(page), /Seen from the front/));
  await page.keyboard.press("Enter");
  await eventually(async () => assert.match(await spoken(page), /^Cell \d, u \d\.\d\d, v \d\.\d\d, w \d\.\d\d, x \S+, y \u22122\.00, z 0\.5\d?, .*%/));
  await page.keyboard.press("8");
  await eventually(async () => assert.match(await spoken(page), /^Nothing of the body here/));
  await page.keyboard.press("Escape");

  // A corner moves by its field and by keys, as one body, and undo brings it back.
  const before = await documentOf(page);
  await page.locator("[data-body-keys]").focus();
  await page.keyboard.press("PageDown");
  await eventually(async () => assert.match(await spoken(page), /^Corner 1 of 32, shared by 2 cells/));
  const x = Number(await field(page, "corner-x").inputValue());
  await field(page, "corner-x").fill(String(x + 0.1));
  await field(page, "corner-x").press("Enter");
  await eventually(async () => assert.notDeepEqual((await documentOf(page)).operations, before.operations));
  await checked(page);
  await eventually(async () => assert.match(await status(page), /shared faces|Verified|Certified/));
  await page.locator("[data-action=undo]").click();
  await eventually(async () => assert.deepEqual((await documentOf(page)).operations, before.operations));
  await checked(page);

  // As it came, its link names the preset; it opens again as it is.
  await page.locator("[data-action=share]").click();
  await eventually(async () => assert.match(hashOf(await page.locator("[data-share-text]").inputValue()), /preset=hyperpatch-ring$/));
  await page.locator("[data-panel=share] [data-close]").click();

  // A file is the kernel's own.
  await page.locator("[data-action=export]").click();
  const [file] = await Promise.all([page.waitForEvent("download"), page.locator("[data-export=ply]").click()]);
  assert.equal(file.suggestedFilename(), "ring-of-eight.ply");
  const dx = await load();
  assert.ok((await readFile(await file.path())).equals(dx.hyperpatch(presetFile("hyperpatch/ring")).file({ format: "ply" })));
  await page.locator("[data-panel=export] [data-close]").click();

  // The other workbench has what was open there, and this one comes back to its body.
  await page.locator(".workbenches a").first().click();
  await eventually(async () => assert.equal((await documentOf(page)).kind, "curves"));
  await eventually(async () => assert.match(await status(page), /lines/));
  await page.locator("[data-bench=hyperpatch]").click();
  await checked(page);
  assert.equal((await documentOf(page)).title, "Ring of eight");
});

test("what is wrong with a body is named, with its witness in the picture, and a link carries it", async (t) => {
  const page = await open(t, "ring");
  await checked(page);
  await page.locator("[data-action=gallery]").click();
  // Every preset has its picture.
  const pictures = page.locator(".listed-picture");
  await eventually(async () => {
    const sources = await pictures.evaluateAll((images) => images.map((image) => /** @type {HTMLImageElement} */ (image).src));
    assert.ok(sources.length === 14 && sources.every((source) => source.startsWith("data:image/png")) && new Set(sources).size >= 13);
  });
  await page.locator("[data-preset=hyperpatch-invalid]").click();
  await eventually(async () => assert.match(await status(page), /1 cell invalid/));
  await eventually(async () => assert.equal(await page.locator("[data-body-witness]").count(), 1));
  await page.locator("[data-problem]").click();
  await eventually(async () => assert.match(await page.locator(".body-facts").innerText(), /(Turned inside out|Runs through itself) at the cross/));
  await eventually(async () => assert.equal(await page.locator('[data-cell="0"]').getAttribute("aria-pressed"), "true"));
  const title = page.locator("[data-field=title], input[aria-label='Document title']").first();
  await title.fill("My fold");
  await title.press("Enter");
  await page.locator("[data-action=file]").click();
  await page.locator("[data-item=recent]").click();
  // Kept with its picture.
  const kept = page.locator("[data-panel=recent] li", { hasText: "My fold" }).locator(".recent-picture.on-light");
  await eventually(async () => assert.equal(await kept.evaluate((image) => /** @type {HTMLImageElement} */ (image).naturalWidth), 168));
  await page.locator("[data-panel=recent] [data-close]").click();
  await page.locator("[data-action=share]").click();
  const link = await eventually(async () => {
    const text = await page.locator("[data-share-text]").inputValue();
    assert.match(text, /#v=1&s=/);
    return text;
  });
  const other = await openPage(t, { allow: SOFTWARE, viewport: { width: 920, height: 560 }, hash: hashOf(link) });
  await eventually(async () => assert.match(await status(other), /1 cell invalid/));
  const { title: name, operations } = await documentOf(other);
  assert.equal(name, "My fold");
  assert.deepEqual(operations, presetFile("hyperpatch/invalid").operations);
});

test("without WebGL the page says so, and verdicts, cells and corners still work", async (t) => {
  const page = await open(t, "pair", {
    init: `const { getContext } = HTMLCanvasElement.prototype;
      HTMLCanvasElement.prototype.getContext = function (kind, ...rest) {
        return kind.startsWith("webgl") ? null : getContext.call(this, kind, ...rest);
      };`,
  });
  await checked(page);
  assert.match(await page.locator("[data-body-message]").innerText(), /WebGL 2 is missing/);
  await page.locator('[data-cell="1"]').click();
  await eventually(async () => assert.match(await page.locator("[data-fact=volume]").innerText(), /mm³/));
  await page.locator('[data-group-button="corner"]').click();
  await page.locator("[data-corner-next]").click();
  await eventually(async () => assert.match(await spoken(page), /^Corner 1 of/));
  assert.deepEqual(await audit(page), []);
});
