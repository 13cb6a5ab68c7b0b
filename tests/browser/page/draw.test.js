import assert from "node:assert/strict";
import { test } from "node:test";
import { audit } from "../support/axe.js";
import { idle } from "./idle.js";
import { onOnePage } from "./one-page.js";
import { openPage } from "./open.js";
import { choose, drawByClicks, newDocument, PHONE, round } from "./drawing.js";
import { documentOf, eventually, pick, spoken, status, uiOf } from "./workbench.js";

onOnePage("drawing", {
  "drawing where two curves are replaces the chosen one, says so, and keeps its composition": async (page) => {
    const before = await documentOf(page);
    await page.locator("[data-curve-row='0']").click();
    await page.locator("[data-action=more]").click();
    assert.match(await page.locator("[data-item=draw]").innerText(), /Draw inner anew/);
    await choose(page, "draw");
    await eventually(async () =>
      assert.match((await page.locator("[data-hint]").textContent()) ?? "", /replaces the inner curve and keeps its composition/),
    );
    for (const [x, y] of await round(page, 90, 6)) await page.mouse.click(x, y);
    await page.keyboard.press("Enter");
    await eventually(async () => assert.equal((await documentOf(page)).curves[0].points.length, 6));
    const after = await documentOf(page);
    assert.deepEqual(after.curves[0].composition, before.curves[0].composition);
    assert.deepEqual(after.curves[1], before.curves[1]);
  },

  "two curves drawn by clicks, each through its points, make a verified figure": async (page) => {
    await newDocument(page);
    await page.locator("[data-empty=draw]").click();
    const hint = page.locator("[data-hint]");
    await eventually(async () => assert.match((await hint.textContent()) ?? "", /first point/));
    assert.deepEqual(await audit(page), []);
    const outer = await round(page, 250, 7);
    for (const [x, y] of outer.slice(0, 2)) await page.mouse.click(x, y);
    await eventually(async () => assert.match((await hint.textContent()) ?? "", /1 more point to close/));
    for (const [x, y] of outer.slice(2)) await page.mouse.click(x, y);
    await page.mouse.move(outer[0][0] + 3, outer[0][1] - 2);
    // A click on the first point closes.
    await page.mouse.click(outer[0][0] + 3, outer[0][1] - 2);
    const one = await eventually(async () => {
      const { curves } = await documentOf(page);
      assert.equal(curves.length, 1);
      return curves[0];
    });
    assert.deepEqual([one.degree, one.form, one.points.length], [3, "periodic", 7]);
    await eventually(async () => assert.match(await status(page), /One curve/));
    assert.equal((await uiOf(page)).selection.curve, 0);

    // The curve passes the places that were clicked, within the tenth of a pixel that it is rounded to.
    const gaps = await page.evaluate((places) => {
      const path = /** @type {SVGPathElement} */ (document.querySelector("[data-outline='0']"));
      const box = /** @type {HTMLElement} */ (document.querySelector("#stage")).getBoundingClientRect();
      const length = path.getTotalLength();
      const along = Array.from({ length: 3000 }, (_, i) => path.getPointAtLength((length * i) / 3000));
      return places.map(([x, y]) => Math.min(...along.map((p) => Math.hypot(p.x + box.x - x, p.y + box.y - y))));
    }, outer);
    // The outline is drawn by chords.
    for (const gap of gaps) assert.ok(gap < 1, `${gaps}`);

    await page.locator("[data-command=draw]").click();
    await hint.waitFor();
    const inner = await round(page, 90, 5);
    for (const [x, y] of inner) await page.mouse.click(x, y);
    // A double click sets the last point and closes.
    const [lx, ly] = (await round(page, 60, 40))[39];
    await page.mouse.dblclick(lx, ly);
    await eventually(async () => assert.equal((await documentOf(page)).curves.length, 2));
    assert.equal((await documentOf(page)).curves[1].points.length, 6);
    await eventually(async () => assert.match(await status(page), /Verified/));
    assert.ok(await page.locator("[data-play]").isEnabled());
    await page.keyboard.press("Control+z");
    await page.keyboard.press("Control+z");
    assert.deepEqual((await documentOf(page)).curves, []);
  },

  "backspace and undo take the last point back, escape gives up and changes nothing": async (page) => {
    await newDocument(page);
    await begin(page);
    for (const [x, y] of await round(page, 150, 5)) await page.mouse.click(x, y);
    assert.equal(await page.locator(".draw-dot, .draw-first").count(), 5);
    await page.keyboard.press("Backspace");
    assert.equal(await page.locator(".draw-dot, .draw-first").count(), 4);
    await page.keyboard.press("Control+z");
    await page.locator("[data-draw=back]").click();
    assert.equal(await page.locator(".draw-dot, .draw-first").count(), 2);
    assert.ok(await page.locator("[data-draw=close]").isDisabled());
    await page.keyboard.press("Escape");
    assert.equal(await page.locator("[data-segment=draw-mode]").count(), 0);
    assert.deepEqual((await documentOf(page)).curves, []);
    assert.ok(await page.locator("[data-action=undo]").isDisabled());
    await eventually(async () => assert.match(await spoken(page), /given up/));
  },

  "points on one line are refused with a hint, and the drawing goes on": async (page) => {
    await newDocument(page);
    await begin(page);
    for (const x of [300, 400, 500]) await page.mouse.click(x, 400);
    await page.keyboard.press("Enter");
    await eventually(async () => assert.match((await page.locator("[data-hint]").textContent()) ?? "", /one line/));
    await page.mouse.click(400, 250);
    await page.keyboard.press("Enter");
    await eventually(async () => assert.equal((await documentOf(page)).curves.length, 1));
  },

  "a curve is drawn by the keyboard alone": async (page) => {
    await newDocument(page);
    await page.locator("[data-empty=draw]").focus();
    await page.keyboard.press("Enter");
    await page.waitForSelector("#draw-keys");
    assert.equal(await page.evaluate(() => document.activeElement?.id), "draw-keys");
    for (const keys of ["Shift+ArrowLeft", "Shift+ArrowDown", "Shift+ArrowRight", "Shift+ArrowUp"]) {
      await page.keyboard.press(keys);
      await page.keyboard.press(keys);
      await page.keyboard.press("Space");
    }
    await eventually(async () => assert.match(await spoken(page), /^Point 4, x .+, y .+/));
    await page.keyboard.press("Enter");
    await eventually(async () => assert.equal((await documentOf(page)).curves[0]?.points.length, 4));
    await eventually(async () => assert.match(await spoken(page), /Drew/));
  },

  "a freehand line is fitted with few points near to it; a short one gives a hint": async (page) => {
    await newDocument(page);
    await begin(page);
    await pick(page, "draw-mode", "freehand");
    const hint = page.locator("[data-hint]");
    assert.match((await hint.textContent()) ?? "", /Press/);
    await page.mouse.move(500, 400);
    await page.mouse.down();
    await page.mouse.move(515, 405, { steps: 4 });
    await page.mouse.up();
    await eventually(async () => assert.match((await hint.textContent()) ?? "", /too short/));
    assert.deepEqual((await documentOf(page)).curves, []);

    const line = (await round(page, 180, 90)).map(([x, y], i) => /** @type {[number, number]} */ ([x + 40 * Math.cos(i / 7), y]));
    await page.mouse.move(...line[0]);
    await page.mouse.down();
    for (const place of line) await page.mouse.move(...place);
    await page.mouse.up();
    const curve = await eventually(async () => {
      const { curves } = await documentOf(page);
      assert.equal(curves.length, 1);
      return curves[0];
    });
    assert.equal(curve.form, "periodic");
    assert.ok(curve.points.length >= 6 && curve.points.length <= 40, `${curve.points.length} points`);
    const far = await page.evaluate((places) => {
      const path = /** @type {SVGPathElement} */ (document.querySelector("[data-outline='0']"));
      const box = /** @type {HTMLElement} */ (document.querySelector("#stage")).getBoundingClientRect();
      const length = path.getTotalLength();
      const along = Array.from({ length: 2000 }, (_, i) => path.getPointAtLength((length * i) / 2000));
      return Math.max(...places.map(([x, y]) => Math.min(...along.map((p) => Math.hypot(p.x + box.x - x, p.y + box.y - y)))));
    }, line.slice(3, -3));
    assert.ok(far < 4, `${far} pixels from the line`);
  },

  "freehand and clicks survive a document that is opened meanwhile": async (page) => {
    await newDocument(page);
    await begin(page);
    await page.mouse.click(400, 300);
    await page.locator("[data-action=file]").click();
    await choose(page, "new");
    await idle(page);
    await eventually(async () => assert.equal(await page.locator("[data-segment=draw-mode]").count(), 0));
    await drawByClicks(page, 200, 4);
    assert.equal((await documentOf(page)).curves.length, 1);
  },

  "pan and zoom go on while drawing, and a drag sets no point": async (page) => {
    await newDocument(page);
    await begin(page);
    await page.mouse.click(400, 300);
    const place = () => page.locator(".draw-dot").first().getAttribute("cx");
    const before = Number(await place());
    await page.mouse.move(600, 500);
    await page.mouse.down();
    await page.mouse.move(650, 500, { steps: 4 });
    await page.mouse.up();
    await eventually(async () => assert.ok(Math.abs(Number(await place()) - before - 50) < 1));
    await page.mouse.wheel(0, -300);
    await eventually(async () => assert.ok(Math.abs(Number(await place()) - before - 50) > 20));
    assert.equal(await page.locator(".draw-dot").count(), 1);
  },

  "a new document is empty, says what to do, and keeps the page whole": async (page) => {
    await newDocument(page);
    for (const name of ["draw", "gallery", "import"]) assert.ok(await page.locator(`[data-empty=${name}]`).isVisible());
    assert.match(await status(page), /No curve yet/);
    assert.ok(await page.locator("[data-play]").isDisabled());
    assert.match((await page.locator("[data-play]").getAttribute("title")) ?? "", /two curves/);
    assert.ok(await page.locator("[data-slider=s]").isDisabled());
    assert.equal(await page.locator("[data-handle]:visible").count(), 0);
    await page.locator("[data-group-button=sampling]").click();
    await page.keyboard.press("Space");
    assert.deepEqual(await audit(page), []);
    const text = await page.locator("body").innerText();
    assert.doesNotMatch(text, /NaN|Infinity|undefined/);
    assert.equal(await page.locator("input[data-field=lines]").inputValue(), "44", "as many lines as there will be samples");
    await page.reload();
    await page.waitForSelector("html[data-ready=true]");
    await page.locator("[data-empty=draw]").waitFor();
    await page.locator("[data-empty=gallery]").click();
    await page.waitForSelector("[data-panel=gallery]");
  },
});

test("on a phone a curve is drawn by taps, and by one stroke", async (t) => {
  const page = await openPage(t, PHONE);
  await newDocument(page);
  await page.locator("[data-empty=draw]").tap();
  await page.waitForSelector("[data-segment=draw-mode]");
  assert.match((await page.locator("[data-hint]").textContent()) ?? "", /Tap/);
  for (const element of await page.locator(".draw-bar button").all()) {
    assert.ok(((await element.boundingBox())?.height ?? 0) >= 44);
  }
  const places = await round(page, 130, 5);
  for (const [x, y] of places) await page.touchscreen.tap(x, y);
  await page.touchscreen.tap(...places[0]);
  await eventually(async () => assert.equal((await documentOf(page)).curves[0]?.points.length, 5));
  assert.deepEqual(await audit(page), []);

  await page.locator("[data-command=draw]").tap();
  await pick(page, "draw-mode", "freehand");
  await stroke(page, await round(page, 50, 40));
  await eventually(async () => assert.equal((await documentOf(page)).curves.length, 2));
});

/** Begins to draw by the key. @param {import("playwright-core").Page} page */
async function begin(page) {
  await page.keyboard.press("d");
  await page.waitForSelector("[data-segment=draw-mode]");
}

/**
 * One touch that goes along places.
 * @param {import("playwright-core").Page} page
 * @param {[number, number][]} places
 */
async function stroke(page, places) {
  const session = await page.context().newCDPSession(page);
  const point = ([x, y] = [0, 0]) => [{ x, y, id: 1 }];
  await session.send("Input.dispatchTouchEvent", { type: "touchStart", touchPoints: point(places[0]) });
  for (const place of places) await session.send("Input.dispatchTouchEvent", { type: "touchMove", touchPoints: point(place) });
  await session.send("Input.dispatchTouchEvent", { type: "touchEnd", touchPoints: [] });
}
