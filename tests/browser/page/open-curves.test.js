/** Open curves on the page: a preset, its ends, handles that work, and drawing. */
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { test } from "node:test";
import { audit } from "../support/axe.js";
import { openAsFile } from "./documents.js";
import { newDocument, round } from "./drawing.js";
import { openPage } from "./open.js";
import { documentOf, drag, eventually, handle, middle, pick, status } from "./workbench.js";

const strip = JSON.parse(await readFile(new URL("../../../www/presets/graded-strip.json", import.meta.url), "utf8"));

test("a strip is verified, its ends are a choice, and its handles work", async (t) => {
  const page = await openPage(t);
  assert.ok(await page.locator("[data-segment=ends]").isHidden(), "closed curves have no ends");
  await openAsFile(page, strip);
  await eventually(async () => assert.match(await status(page), /Verified\s*60\s*lines/));
  assert.equal(await page.locator("[data-handle]:visible").count(), 13);
  for (const curve of [0, 1]) {
    assert.doesNotMatch((await page.locator(`[data-outline="${curve}"]`).getAttribute("d")) ?? "Z", /Z/);
  }
  await page.locator("[data-segment=ends]").waitFor();
  await pick(page, "ends", "free");
  await eventually(async () => assert.equal((await documentOf(page)).matching.ends, "free"));
  await eventually(async () => assert.match(await status(page), /Verified/));
  assert.deepEqual(await audit(page), []);
  const before = (await documentOf(page)).curves[0].points[6];
  await drag(page, await middle(handle(page, "A7")), [0, 24]);
  await eventually(async () => assert.notDeepEqual((await documentOf(page)).curves[0].points[6], before));
  await eventually(async () => assert.match(await status(page), /Verified/));
});

test("a curve is left open while it is drawn, and the second one follows", async (t) => {
  const page = await openPage(t);
  await newDocument(page);
  await page.locator("[data-empty=draw]").click();
  await page.locator("[data-hint]").waitFor();
  const half = async (/** @type {number} */ radius) => (await round(page, radius, 10)).slice(0, 5);
  for (const [x, y] of await half(220)) await page.mouse.click(x, y);
  await page.locator("[data-draw=leave]").click();
  await eventually(async () => assert.deepEqual((await documentOf(page)).curves.map((/** @type {any} */ curve) => curve.form), ["open"]));
  await page.locator("[data-command=draw]").click();
  await page.locator("[data-hint]").waitFor();
  assert.equal(await page.locator("[data-draw=leave]").count(), 0, "beside an open curve there is no choice");
  for (const [x, y] of await half(120)) await page.mouse.click(x, y);
  await page.keyboard.press("Enter");
  await eventually(async () => assert.deepEqual((await documentOf(page)).curves.map((/** @type {any} */ curve) => curve.form), ["open", "open"]));
  await eventually(async () => assert.match(await status(page), /Verified/));
});
