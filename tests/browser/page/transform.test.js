import assert from "node:assert/strict";
import { test } from "node:test";
import { audit } from "../support/axe.js";
import { onOnePage } from "./one-page.js";
import { openPage } from "./open.js";
import { chooseCurve, PHONE } from "./drawing.js";
import { documentOf, eventually, field, handle, middle, spoken, uiOf } from "./workbench.js";

/** @param {import("playwright-core").Page} page @param {string} name */
const frame = (page, name) => page.locator(`[data-frame="${name}"]`);

/** @param {[number, number][]} points */
function box(points) {
  const [xs, ys] = [points.map(([x]) => x), points.map(([, y]) => y)];
  return { left: Math.min(...xs), right: Math.max(...xs), low: Math.min(...ys), high: Math.max(...ys) };
}

/** The first curve, chosen whole, with its frame. @param {import("playwright-core").Page} page */
async function framed(page) {
  await chooseCurve(page, 0);
  await page.waitForSelector("[data-frame=turn]");
  return (await documentOf(page)).curves[0].points;
}

onOnePage("the frame of a selection", {
  "the frame is there for a whole curve and for several points, not for one": async (page) => {
    assert.equal(await page.locator("[data-frame]:visible").count(), 0);
    await framed(page);
    assert.equal(await page.locator("[data-frame]:visible").count(), 9);
    assert.deepEqual(await audit(page), []);
    await handle(page, "A1").click();
    await eventually(async () => assert.equal(await page.locator("[data-frame]:visible").count(), 0));
    await page.keyboard.press("Control+a");
    await eventually(async () => assert.equal(await page.locator("[data-frame]:visible").count(), 9));
  },
  "a side handle scales along one axis about the other side; Alt about the centre": async (page) => {
    const before = box(await framed(page));
    const [x, y] = await middle(frame(page, "e"));
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x + 60, y + 25, { steps: 5 });
    await page.mouse.up();
    const after = box((await documentOf(page)).curves[0].points);
    assert.ok(Math.abs(after.left - before.left) < 1e-6);
    assert.ok(after.right > before.right + 2);
    assert.ok(Math.abs(after.low - before.low) < 1e-9 && Math.abs(after.high - before.high) < 1e-9);
    await eventually(async () => assert.match(await spoken(page), /Scaled to/));
    await page.keyboard.press("Control+z");
    await eventually(async () => assert.ok(await page.locator("[data-action=undo]").isDisabled()));

    await page.keyboard.down("Alt");
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x - 40, y, { steps: 5 });
    await page.mouse.up();
    await page.keyboard.up("Alt");
    const centred = box((await documentOf(page)).curves[0].points);
    assert.ok(Math.abs(centred.left + centred.right - before.left - before.right) < 1e-6);
    assert.ok(centred.right < before.right - 2);
  },
  "a corner with Shift keeps the proportion": async (page) => {
    const before = box(await framed(page));
    const [x, y] = await middle(frame(page, "se"));
    await page.keyboard.down("Shift");
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x - 70, y - 10, { steps: 5 });
    await page.mouse.up();
    await page.keyboard.up("Shift");
    const after = box((await documentOf(page)).curves[0].points);
    const [fx, fy] = [
      (after.right - after.left) / (before.right - before.left),
      (after.high - after.low) / (before.high - before.low),
    ];
    assert.ok(fx < 0.95 && Math.abs(fx - fy) < 1e-6, `${fx} ${fy}`);
  },
  "the turning handle turns about the middle, in steps of 15 degrees with Shift; escape takes it back": async (page) => {
    const points = await framed(page);
    const before = box(points);
    const center = [(before.left + before.right) / 2, (before.low + before.high) / 2];
    const [x, y] = await middle(frame(page, "turn"));
    await page.keyboard.down("Shift");
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x + 100, y + 25, { steps: 5 });
    await page.mouse.up();
    await page.keyboard.up("Shift");
    const after = (await documentOf(page)).curves[0].points;
    const angle = (/** @type {number[]} */ p) => (Math.atan2(p[1] - center[1], p[0] - center[0]) * 180) / Math.PI;
    const turns = after.map((/** @type {number[]} */ p, /** @type {number} */ i) => (angle(p) - angle(points[i]) + 720) % 360);
    const nearest = Math.round(turns[0] / 15) * 15;
    assert.ok(nearest !== 0 && nearest !== 360);
    for (const each of turns) assert.ok(Math.abs(each - nearest) < 1e-6, `${turns}`);

    await page.mouse.move(...(await middle(frame(page, "turn"))));
    await page.mouse.down();
    await page.mouse.move(x + 30, y + 60, { steps: 3 });
    await page.keyboard.press("Escape");
    await page.mouse.up();
    assert.deepEqual((await documentOf(page)).curves[0].points, after);
  },
  "by keyboard: one degree, ten with Shift, a tenth with Alt; page keys go round the frame": async (page) => {
    const points = await framed(page);
    await frame(page, "turn").focus();
    await page.keyboard.press("ArrowLeft");
    await page.keyboard.press("Shift+ArrowLeft");
    await page.keyboard.press("Alt+ArrowRight");
    const after = (await documentOf(page)).curves[0].points;
    const side = (/** @type {number[][]} */ p) => Math.atan2(p[3][1] - p[0][1], p[3][0] - p[0][0]);
    const degrees = (((side(after) - side(points)) * 180) / Math.PI + 360) % 360;
    assert.ok(Math.abs(degrees - 10.9) < 1e-6, `${degrees}`);
    await page.keyboard.press("Escape");
    assert.deepEqual((await documentOf(page)).curves[0].points, points);
    await page.keyboard.press("PageUp");
    assert.equal(await page.evaluate(() => document.activeElement?.getAttribute("data-frame")), "w");
    const before = box(points);
    await page.keyboard.press("ArrowLeft");
    const wider = box((await documentOf(page)).curves[0].points);
    assert.ok(Math.abs(wider.left - before.left + 1) < 1e-6 && Math.abs(wider.right - before.right) < 1e-9);
    assert.equal(await page.locator("[data-frame][tabindex='0']").count(), 1);
  },
  "the fields of the inspector turn and scale, and rest again": async (page) => {
    const points = await framed(page);
    await field(page, "turn").fill("90");
    await page.keyboard.press("Enter");
    await eventually(async () => {
      const turned = box((await documentOf(page)).curves[0].points);
      const before = box(points);
      assert.ok(Math.abs(turned.right - turned.left - (before.high - before.low)) < 1e-6);
    });
    await field(page, "scale").fill("50");
    await page.keyboard.press("Enter");
    await eventually(async () => {
      const halved = box((await documentOf(page)).curves[0].points);
      const before = box(points);
      assert.ok(Math.abs(2 * (halved.right - halved.left) - (before.high - before.low)) < 1e-6);
    });
    await field(page, "x").focus();
    assert.equal(await field(page, "scale").inputValue(), "100");
    assert.equal(await field(page, "turn").inputValue(), "0");
    await page.keyboard.press("Control+z");
    await page.keyboard.press("Control+z");
    assert.deepEqual((await documentOf(page)).curves[0].points, points);
  },
  "arrows in the turning field add up to what it shows, as one entry of the log": async (page) => {
    const points = await framed(page);
    await field(page, "turn").focus();
    for (let i = 0; i < 3; i += 1) await page.keyboard.press("Shift+ArrowUp");
    assert.equal(await field(page, "turn").inputValue(), "30");
    const after = (await documentOf(page)).curves[0].points;
    const side = (/** @type {number[][]} */ p) => Math.atan2(p[3][1] - p[0][1], p[3][0] - p[0][0]);
    const degrees = (((side(after) - side(points)) * 180) / Math.PI + 360) % 360;
    assert.ok(Math.abs(degrees - 30) < 1e-6, `${degrees}`);
    await field(page, "y").focus();
    await page.keyboard.press("Control+z");
    assert.deepEqual((await documentOf(page)).curves[0].points, points);
  },
});

test("on a phone the handles of the frame are 44 pixels and clear of the edges", async (t) => {
  const page = await openPage(t, PHONE);
  await page.locator("[data-tab=curves]").tap();
  await page.locator("[data-curve-row='1']").tap();
  await page.waitForSelector("[data-frame=turn]");
  const stage = await page.locator("#stage").boundingBox();
  for (const each of await page.locator("[data-frame]").all()) {
    const place = await each.boundingBox();
    assert.ok(place && stage && place.width >= 44 && place.height >= 44);
    const [x, y] = [place.x + 22, place.y + 22];
    assert.ok(x >= stage.x && x <= stage.x + stage.width && y >= stage.y && y <= stage.y + stage.height);
  }
  const before = (await uiOf(page)).selection;
  assert.deepEqual(before, { curve: 1, points: [] });
});
