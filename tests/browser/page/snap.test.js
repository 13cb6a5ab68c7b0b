import assert from "node:assert/strict";
import { test } from "node:test";
import { onOnePage } from "./one-page.js";
import { openPage } from "./open.js";
import { newDocument, PHONE, round } from "./drawing.js";
import { documentOf, drag, eventually, handle, middle, onOutline, spoken, uiOf } from "./workbench.js";

/** The step of the drawn grid in document units. @param {import("playwright-core").Page} page */
async function step(page) {
  const { view } = await uiOf(page);
  const least = 48 / view.scale;
  const decade = 10 ** Math.floor(Math.log10(least));
  return [1, 2, 5, 10].map((factor) => factor * decade).find((each) => each >= least * (1 - 1e-12)) ?? Number.NaN;
}

/** @param {number} value @param {number} of */
const isMultiple = (value, of) => Math.abs(value / of - Math.round(value / of)) < 1e-9;

onOnePage("the grid", {
  "G shows and hides the grid with its axes, and the button agrees with the layers": async (page) => {
    assert.ok(await page.locator(".axes").isVisible());
    await page.keyboard.press("g");
    await eventually(async () => assert.ok(!(await uiOf(page)).layers.includes("grid")));
    assert.ok(await page.locator(".axes").isHidden());
    assert.equal(await page.locator("[data-zoom=grid]").getAttribute("aria-pressed"), "false");
    assert.ok(!(await page.locator("[data-box=grid]").isChecked()));
    await page.locator("[data-zoom=grid]").click();
    await eventually(async () => assert.ok(await page.locator(".axes").isVisible()));
  },
  "the coordinates of the pointer stand above the scale": async (page) => {
    const place = page.locator(".pointer-place");
    const { view } = await uiOf(page);
    const box = await page.locator("#stage").boundingBox();
    assert.ok(box);
    await page.mouse.move(box.x + box.width / 2 + 90, box.y + box.height / 2 - 45);
    await eventually(async () => {
      const found = /x (\S+) +y (\S+)/.exec(((await place.textContent()) ?? "").replaceAll("\u2212", "-"));
      assert.ok(found);
      assert.ok(Math.abs(Number(found[1]) - (view.center[0] + 90 / view.scale)) < 0.06);
      assert.ok(Math.abs(Number(found[2]) - (view.center[1] + 45 / view.scale)) < 0.06);
    });
    await page.mouse.move(box.x + box.width + 60, box.y + 200);
    await eventually(async () => assert.equal(await place.textContent(), ""));
  },
  "with snapping a dragged point rests on the grid; Control inverts": async (page) => {
    await page.keyboard.press("s");
    await eventually(async () => assert.equal(await page.locator("[data-zoom=snap]").getAttribute("aria-pressed"), "true"));
    await eventually(async () => assert.match(await spoken(page), /Snapping on/));
    const grid = await step(page);
    await drag(page, await middle(handle(page, "B3")), [-31, 23]);
    const [x, y] = (await documentOf(page)).curves[1].points[2];
    assert.ok(isMultiple(x, grid) && isMultiple(y, grid), `${x}, ${y} of ${grid}`);
    await page.keyboard.down("Control");
    await drag(page, await middle(handle(page, "B3")), [-9, 7]);
    await page.keyboard.up("Control");
    const [fx, fy] = (await documentOf(page)).curves[1].points[2];
    assert.ok(!isMultiple(fx, grid) || !isMultiple(fy, grid));
    await page.locator("[data-zoom=snap]").click();
    await page.keyboard.down("Control");
    await drag(page, await middle(handle(page, "B3")), [11, 13]);
    await page.keyboard.up("Control");
    const [gx, gy] = (await documentOf(page)).curves[1].points[2];
    assert.ok(isMultiple(gx, grid) && isMultiple(gy, grid));
  },
  "a whole curve moves by steps of the grid": async (page) => {
    const before = (await documentOf(page)).curves[0].points;
    await page.keyboard.press("s");
    const grid = await step(page);
    await drag(page, await onOutline(page, 0), [33, -14]);
    const after = (await documentOf(page)).curves[0].points;
    const moved = after[0].map((/** @type {number} */ value, /** @type {number} */ axis) => value - before[0][axis]);
    assert.ok(isMultiple(moved[0], grid) && isMultiple(moved[1], grid), `${moved}`);
  },
});

test("the step follows the zoom, and a drawn point snaps as well", async (t) => {
  const page = await openPage(t);
  await newDocument(page);
  await page.keyboard.press("Shift+G");
  for (let i = 0; i < 6; i += 1) await page.keyboard.press("+");
  await eventually(async () => assert.ok((await step(page)) < 5));
  const grid = await step(page);
  await page.keyboard.press("d");
  await page.waitForSelector("[data-segment=draw-mode]");
  const dots = () => page.locator(".draw-dot").evaluateAll((all) => all.map((e) => [Number(e.getAttribute("cx")), Number(e.getAttribute("cy"))]));
  for (const [x, y] of (await round(page, 200, 6)).slice(0, 2)) await page.mouse.click(x, y);
  const { view, size } = { ...(await uiOf(page)), size: await page.locator("#stage").boundingBox() };
  assert.ok(size);
  for (const [sx, sy] of await dots()) {
    const x = view.center[0] + (sx - size.width / 2) / view.scale;
    const y = view.center[1] - (sy - size.height / 2) / view.scale;
    for (const value of [x, y]) assert.ok(Math.abs(value / grid - Math.round(value / grid)) * grid * view.scale < 0.2, `${value} of ${grid}`);
  }
});

test("on a phone the layers switch snapping", async (t) => {
  const page = await openPage(t, PHONE);
  await page.locator("[data-tab=layers]").tap();
  await page.locator("[data-box=snap]").check();
  assert.equal((await uiOf(page)).snap, true);
});
