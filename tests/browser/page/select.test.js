import assert from "node:assert/strict";
import { test } from "node:test";
import { audit } from "../support/axe.js";
import { onOnePage } from "./one-page.js";
import { openPage } from "./open.js";
import { PHONE } from "./drawing.js";
import { coordinates, documentOf, drag, eventually, field, handle, middle, spoken, uiOf } from "./workbench.js";

/** @param {import("playwright-core").Page} page @param {string} name */
async function shiftClick(page, name) {
  await page.keyboard.down("Shift");
  await page.mouse.click(...(await middle(handle(page, name))));
  await page.keyboard.up("Shift");
}

onOnePage("a selection of points", {
  "points align and spread by the buttons of the inspector": async (page) => {
    assert.ok(await page.locator("[data-align=left]").isHidden());
    await handle(page, "A2").click();
    await shiftClick(page, "A3");
    await shiftClick(page, "A4");
    const { curves } = await documentOf(page);
    const least = Math.min(...[1, 2, 3].map((i) => curves[0].points[i][1]));
    await page.locator("[data-align=bottom]").click();
    await eventually(async () => {
      const now = (await documentOf(page)).curves[0].points;
      for (const i of [1, 2, 3]) assert.equal(now[i][1], least);
    });
    await page.locator("[data-align=across]").click();
    await eventually(async () => {
      const xs = [1, 2, 3].map(async (i) => (await documentOf(page)).curves[0].points[i][0]);
      const [a, b, c] = (await Promise.all(xs)).sort((p, q) => p - q);
      assert.ok(Math.abs(b - a - (c - b)) < 1e-9);
    });
    await page.keyboard.press("Control+z");
    await page.keyboard.press("Control+z");
    assert.deepEqual((await documentOf(page)).curves, curves);
  },
  "Shift and a click add a point and take it out; the inspector shows their number and mean": async (page) => {
    await handle(page, "B2").click();
    await shiftClick(page, "B4");
    await shiftClick(page, "B6");
    assert.deepEqual((await uiOf(page)).selection, { curve: 1, points: [1, 3, 5] });
    assert.equal(await page.locator(".row.place .row-label").innerText(), "3 points");
    const places = await Promise.all(["B2", "B4", "B6"].map((name) => coordinates(page, name)));
    const mean = places.reduce((sum, [x]) => sum + x / 3, 0);
    assert.ok(Math.abs(Number((await field(page, "x").inputValue()).replace("\u2212", "-")) - mean) < 0.01);
    await shiftClick(page, "B4");
    assert.deepEqual((await uiOf(page)).selection.points, [1, 5]);
    await shiftClick(page, "A1");
    assert.deepEqual((await uiOf(page)).selection, { curve: 0, points: [0] });
  },
  "several points are dragged and nudged together, each as one entry of the log": async (page) => {
    const before = await documentOf(page);
    await handle(page, "A2").click();
    await shiftClick(page, "A5");
    await drag(page, await middle(handle(page, "A5")), [12, -8]);
    const after = await documentOf(page);
    const moved = (/** @type {number} */ i) => [0, 1].map((axis) => after.curves[0].points[i][axis] - before.curves[0].points[i][axis]);
    assert.ok(Math.abs(moved(1)[0] - moved(4)[0]) < 1e-9 && moved(1)[0] > 0);
    assert.ok(Math.abs(moved(1)[1] - moved(4)[1]) < 1e-9 && moved(1)[1] > 0);
    assert.deepEqual(after.curves[0].points[2], before.curves[0].points[2]);
    assert.deepEqual((await uiOf(page)).selection.points, [1, 4]);
    await page.keyboard.press("ArrowLeft");
    await page.keyboard.press("ArrowLeft");
    await eventually(async () => assert.match(await spoken(page), /^2 points, x/));
    const nudged = await documentOf(page);
    for (const i of [1, 4]) assert.ok(Math.abs(nudged.curves[0].points[i][0] - after.curves[0].points[i][0] + 2) < 1e-9);
    await page.keyboard.press("Control+z");
    assert.deepEqual(await documentOf(page), after);
    await page.keyboard.press("Control+z");
    assert.deepEqual(await documentOf(page), before);
  },
  "a click on a chosen point of several leaves it alone": async (page) => {
    await handle(page, "B2").click();
    await shiftClick(page, "B3");
    await page.mouse.click(...(await middle(handle(page, "B3"))));
    assert.deepEqual((await uiOf(page)).selection, { curve: 1, points: [2] });
  },
  "a box over the canvas with Shift selects the points in it, and a plain drag pans": async (page) => {
    const view = (await uiOf(page)).view;
    const [a, b] = [await middle(handle(page, "A1")), await middle(handle(page, "A2"))];
    const from = /** @type {[number, number]} */ ([Math.min(a[0], b[0]) - 16, Math.min(a[1], b[1]) - 16]);
    const by = /** @type {[number, number]} */ ([Math.abs(a[0] - b[0]) + 32, Math.abs(a[1] - b[1]) + 32]);
    await page.keyboard.down("Shift");
    await drag(page, from, by, { release: false });
    assert.ok(await page.locator(".select-box").isVisible());
    await page.mouse.up();
    await page.keyboard.up("Shift");
    const { selection, view: now } = await uiOf(page);
    assert.equal(selection.curve, 0);
    assert.ok(selection.points.includes(0) && selection.points.includes(1));
    assert.deepEqual(now, view);
    assert.ok(await page.locator(".select-box").isHidden());
    await eventually(async () => assert.match(await spoken(page), /selected|2 points/));
  },
  "Control and A takes all points, Home the whole curve, and Shift with page keys one more": async (page) => {
    await handle(page, "A1").focus();
    await page.keyboard.press("Shift+PageDown");
    await page.keyboard.press("Shift+PageDown");
    assert.deepEqual((await uiOf(page)).selection, { curve: 0, points: [0, 1, 2] });
    await page.keyboard.press("Control+a");
    const count = (await documentOf(page)).curves[0].points.length;
    await eventually(async () => assert.equal((await uiOf(page)).selection.points.length, count));
    await page.keyboard.press("Home");
    assert.deepEqual((await uiOf(page)).selection, { curve: 0, points: [] });
  },
  "several points are removed at once, or none where the curve cannot spare them": async (page) => {
    const before = await documentOf(page);
    const count = before.curves[0].points.length;
    await handle(page, "A2").click();
    await shiftClick(page, "A5");
    await page.keyboard.press("Delete");
    await eventually(async () => assert.equal((await documentOf(page)).curves[0].points.length, count - 2));
    await page.keyboard.press("Control+z");
    assert.deepEqual(await documentOf(page), before);
    await page.keyboard.press("Control+a");
    await eventually(async () => assert.ok((await uiOf(page)).selection.points.length > 2));
    assert.ok(await page.locator("[data-action=remove-point]").isDisabled());
    await handle(page, "A1").focus();
    await page.keyboard.press("Delete");
    await eventually(async () => assert.match(await spoken(page), /keeps at least/));
    assert.deepEqual(await documentOf(page), before);
  },
});

test("on a phone a long press opens a menu that adds to the selection", async (t) => {
  const page = await openPage(t, PHONE);
  await page.locator("[data-tab=curves]").tap();
  await page.locator("[data-curve-row='0']").tap();
  await handle(page, "A2").tap();
  const session = await page.context().newCDPSession(page);
  const [x, y] = await middle(handle(page, "A7"));
  await session.send("Input.dispatchTouchEvent", { type: "touchStart", touchPoints: [{ x, y, id: 1 }] });
  await page.waitForSelector("[role=menu]");
  await session.send("Input.dispatchTouchEvent", { type: "touchEnd", touchPoints: [] });
  assert.deepEqual(await audit(page), []);
  await page.locator("[data-item=select-add]").tap();
  await eventually(async () => assert.deepEqual((await uiOf(page)).selection, { curve: 0, points: [1, 6] }));
});
