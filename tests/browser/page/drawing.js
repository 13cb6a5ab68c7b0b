/**
 * Steps of drawing and commanding that several tests take.
 *
 * @import { Page } from "playwright-core"
 */
import assert from "node:assert/strict";
import { idle } from "./idle.js";
import { documentOf, eventually } from "./workbench.js";

/** A page on a phone. */
export const PHONE = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true };

/**
 * Opens a new document by the menu.
 * @param {Page} page
 */
export async function newDocument(page) {
  const file = page.locator("[data-action=file]");
  await ((await file.isVisible()) ? file : page.locator("[data-action=menu]")).click();
  await page.locator("[data-item=new]").click();
  await idle(page);
  await eventually(async () => assert.deepEqual((await documentOf(page)).curves, []));
  await eventually(async () => assert.equal(await page.locator("#status").getAttribute("data-verdict"), "incomplete"));
  await page.locator("[data-empty=draw]").waitFor();
}

/**
 * Places round the middle of the canvas, on the screen.
 * @param {Page} page
 * @param {number} radius pixels
 * @param {number} count
 * @returns {Promise<[number, number][]>}
 */
export async function round(page, radius, count) {
  const box = await page.locator("#picture").boundingBox();
  assert.ok(box);
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  return Array.from({ length: count }, (_, i) => {
    const angle = (2 * Math.PI * i) / count + 0.2;
    return [x + radius * Math.cos(angle), y - radius * Math.sin(angle)];
  });
}

/**
 * Draws a closed curve by clicks and closes it with Enter.
 * @param {Page} page
 * @param {number} radius
 * @param {number} [count]
 */
export async function drawByClicks(page, radius, count = 6) {
  await page.keyboard.press("d");
  await page.waitForSelector("[data-segment=draw-mode]");
  for (const [x, y] of await round(page, radius, count)) await page.mouse.click(x, y);
  await page.keyboard.press("Enter");
  await eventually(async () => assert.equal(await page.locator("[data-segment=draw-mode]").count(), 0));
  await eventually(async () => assert.ok(await page.evaluate(() => document.activeElement?.closest("#overlay")), "the curve has the focus"));
}

/**
 * Chooses an entry of an open menu.
 * @param {Page} page
 * @param {string} name
 */
export const choose = (page, name) => page.locator(`[role=menu] [data-item="${name}"]`).click();

/**
 * Chooses a whole curve by its row.
 * @param {Page} page
 * @param {number} curve
 */
export const chooseCurve = (page, curve) => page.locator(`[data-curve-row="${curve}"]`).click();

/**
 * Chooses a command behind the three dots of the curves.
 * @param {Page} page
 * @param {string} name
 */
export async function command(page, name) {
  await page.locator("[data-action=more]").click();
  await choose(page, name);
}
