/** Why a line is one: the panel with its value, rank and rivals. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { audit } from "../support/axe.js";
import { openAsFile, rings } from "./documents.js";
import { onOnePage } from "./one-page.js";
import { openPage } from "./open.js";
import { eventually, spoken, status } from "./workbench.js";

/** @typedef {import("playwright-core").Page} Page */

const panel = (/** @type {Page} */ page) => page.locator("[data-panel=explain]");
const heading = async (/** @type {Page} */ page) => (await panel(page).locator("h2").textContent()) ?? "";

/** A place of the band without a handle near. @param {Page} page @returns {Promise<[number, number]>} */
async function inBand(page) {
  const box = await page.locator("#stage").boundingBox();
  assert.ok(box);
  return [box.x + box.width * 0.18, box.y + box.height * 0.5];
}

/** Reads the first line by the keyboard. @param {Page} page */
async function read(page) {
  await page.locator("#probe-keys").focus();
  await page.waitForSelector("#probe-keys[aria-valuemax='44']");
  await page.keyboard.press("ArrowRight");
  await eventually(async () => assert.ok(await page.locator("#probe").isVisible()));
}

onOnePage("explanations", {
  "a click on a line explains it, and another place closes it": async (page) => {
    const at = await inBand(page);
    await page.mouse.click(...at);
    await eventually(async () => assert.match(await heading(page), /^Line \d+$/));
    await eventually(async () => assert.equal(await panel(page).locator("section").count(), 2));
    assert.equal(await panel(page).locator("li").count(), 8);
    for (const rank of await panel(page).locator(".explain-rank").allTextContents()) {
      assert.match(rank, /^\d+(st|nd|rd|th) of \d+ that meet no curve$/);
    }
    for (const fate of await panel(page).locator(".explain-fate").allTextContents()) {
      assert.match(fate, /^(is a line too|meets a curve|crosses line \d+|has the lower f|lowers the whole)$/);
    }
    assert.ok(((await page.locator(".rival-lines").getAttribute("d")) ?? "").split("M").length === 9, "eight rivals are drawn");
    await eventually(async () => assert.match(await spoken(page), /^Line \d+\. At its end on inner \d+/));
    const box = await panel(page).boundingBox();
    assert.ok(box && (at[0] < box.x || at[0] > box.x + box.width), "the panel stands beside the line");
    assert.deepEqual(await audit(page), []);
    const stage = await page.locator("#stage").boundingBox();
    assert.ok(stage);
    await page.mouse.click(stage.x + 20, stage.y + stage.height * 0.4);
    await eventually(async () => assert.equal(await panel(page).count(), 0));
  },

  "Enter on a line that is read explains it, with the same value; buttons go round and Escape gives the focus back": async (page) => {
    await read(page);
    const value = await page.locator("#probe .probe-row .number").first().textContent();
    await page.keyboard.press("Enter");
    await eventually(async () => assert.equal(await heading(page), "Line 1"));
    await eventually(async () => assert.equal(await panel(page).locator(".explain-value strong").textContent(), value));
    const parts = (await panel(page).locator(".explain-row").allTextContents()).slice(0, 2);
    assert.match(parts[0] ?? "", /^normals, cos0\.\d{3}× 0\.\d+/);
    assert.match(parts[1] ?? "", /^length\d+\.\d\smm× /);
    await panel(page).locator("[data-explain=previous]").click();
    await eventually(async () => assert.equal(await heading(page), "Line 44"));
    await eventually(async () => assert.notEqual(await panel(page).locator(".explain-value strong").textContent(), value));
    await panel(page).locator("[data-explain=next]").click();
    await eventually(async () => assert.equal(await heading(page), "Line 1"));
    await eventually(async () => assert.equal(await panel(page).locator(".explain-value strong").textContent(), value));
    await panel(page).locator("h2").focus();
    await page.keyboard.press("Escape");
    await eventually(async () => assert.equal(await panel(page).count(), 0));
    await eventually(async () => assert.equal(await page.locator(".pin-end").count(), 0));
  },

  "the alignment is told where it has a weight": async (page) => {
    const values = async () => (await status(page)).replace(/[\d.]+\s*ms/, "");
    const before = await values();
    await page.locator("[data-more] summary").click();
    await page.locator("input[data-field=alignmentWeight]").fill("1");
    await page.keyboard.press("Enter");
    // What was read goes when other lines come, coarse ones first.
    await eventually(async () => {
      assert.notEqual(await values(), before);
      assert.match(await values(), /Verified/);
      assert.doesNotMatch(await values(), /refining/);
    });
    await read(page);
    await page.keyboard.press("Enter");
    await eventually(async () => assert.match((await panel(page).textContent()) ?? "", /along the normals[01]\.\d{3}× [01]\.\d+/));
  },
});

test("on a phone two taps explain a line, in a panel that leaves the line in sight", async (t) => {
  const page = await openPage(t, { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });
  await openAsFile(page, rings({ method: "exact", oneToOne: true }));
  await eventually(async () => assert.match(await status(page), /1\.000/));
  // Half-way between the rings, and between two control points.
  const at = await page.evaluate(() => {
    const { x, y } = /** @type {HTMLElement} */ (document.querySelector("#stage")).getBoundingClientRect();
    const [p, q] = [0, 1].map((curve) => {
      const path = /** @type {SVGPathElement} */ (document.querySelector(`[data-outline="${curve}"]`));
      return path.getPointAtLength(path.getTotalLength() / 16);
    });
    return /** @type {const} */ ([x + (p.x + q.x) / 2, y + (p.y + q.y) / 2]);
  });
  await page.touchscreen.tap(...at);
  await eventually(async () => assert.ok(await page.locator("#probe").isVisible()));
  await page.touchscreen.tap(...at);
  await eventually(async () => assert.match(await heading(page), /^Line \d+$/));
  await eventually(async () => assert.equal(await panel(page).locator("section").count(), 2));
  assert.deepEqual(await audit(page), []);
  await panel(page).locator("[data-close=explain]").tap();
  await eventually(async () => assert.equal(await panel(page).count(), 0));
});
