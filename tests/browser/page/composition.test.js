/** Composition on the curve: keys by pointer, touch and keyboard, the mixing control, lines of equal mix, the probe's words. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { audit } from "../support/axe.js";
import { onOnePage } from "./one-page.js";
import { openPage } from "./open.js";
import { documentOf, drag, eventually, field, handle, middle, uiOf } from "./workbench.js";

/** @import { Page } from "playwright-core" */

/** @param {Page} page @param {string} name such as `B3` */
const key = (page, name) => page.locator(`[data-key="${name} key"]`);

/** @param {Page} page @param {number} curve */
const keysOf = async (page, curve) => (await documentOf(page)).curves[curve].composition;

/** @param {Page} page @param {number} curve */
const places = async (page, curve) =>
  (await keysOf(page, curve)).map((/** @type {{at: number}} */ { at }) => at);

/** @param {Page} page */
const speech = (page) => page.locator("#speech").textContent();

/** @param {Page} page */
async function compose(page) {
  if (await key(page, "B1").isHidden()) await page.locator("[data-action=compose]").click();
  await key(page, "B1").waitFor();
  await page.locator("[data-key-panel]").waitFor();
}

onOnePage("composition on the curve", {
  "the probe says the fractions when the pointer rests, on the curves as well": async (page) => {
    const frame = await page.locator("#stage").boundingBox();
    assert.ok(frame);
    await page.mouse.move(frame.x + frame.width * 0.2, frame.y + frame.height * 0.5);
    await eventually(async () => assert.match((await speech(page)) ?? "", /^s 0\.\d\d, Polymer \d+.%, Ceramic \d+.%/));
    // A little outside the outer curve, where it lies farthest to the left.
    const left = await page.evaluate(() => {
      const path = /** @type {SVGPathElement} */ (document.querySelector('[data-outline="1"]'));
      const points = Array.from({ length: 400 }, (_, i) => path.getPointAtLength((path.getTotalLength() * i) / 400));
      const { x, y } = points.reduce((best, point) => (point.x < best.x ? point : best));
      return [x, y];
    });
    await page.mouse.move(frame.x + left[0] - 3, frame.y + left[1]);
    await eventually(async () => assert.match((await speech(page)) ?? "", /^On outer at 0\.\d{3}, Ceramic 100.%$/));
    await page.mouse.move(frame.x + 4, frame.y + 4);
    await eventually(async () => assert.ok(await page.locator("#probe").isHidden()));
    await page.locator("#probe-keys").focus();
    await page.keyboard.press("ArrowRight");
    await eventually(async () => assert.match((await speech(page)) ?? "", /^s 0\.50, Polymer 50.%/));
  },
  "lines of equal mix are drawn for the chosen material, with a few names on them": async (page) => {
    const picture = () =>
      page.locator("#picture").evaluate((canvas) => /** @type {HTMLCanvasElement} */ (canvas).toDataURL());
    const plain = await picture();
    await page.locator("[data-box=isoComposition]").check();
    await eventually(async () => assert.notEqual(await picture(), plain));
    await eventually(async () => assert.equal(await page.locator(".line-label").count(), 4));
    const of = page.locator("[data-select=iso-material]");
    assert.deepEqual(await of.locator("option").allTextContents(), ["Polymer", "Ceramic", "Titanium"]);
    const first = await picture();
    await of.selectOption("2");
    await eventually(async () => assert.notEqual(await picture(), first));
    assert.equal((await uiOf(page)).isoMaterial, 2);
    await page.locator("[data-group-button=blend]").click();
    await page.locator("[data-box=stage-labels]").check();
    await page.locator("[data-box=isoComposition]").uncheck();
    await eventually(async () =>
      assert.deepEqual(await page.locator(".line-label").allTextContents(), ["s 0.20", "s 0.40", "s 0.60", "s 0.80"]),
    );
    // Two pure curves: every in-between has one fraction.
    await page.locator("[data-holder='1-1']").click();
    await eventually(async () =>
      assert.equal(await page.locator(".line-label").first().textContent(), "s 0.20 · Ceramic 20\u00a0%"),
    );
  },
  "keys take the place of the control points and give it back": async (page) => {
    assert.ok(await handle(page, "A1").isVisible());
    await compose(page);
    assert.ok(await handle(page, "A1").isHidden());
    assert.equal(await page.locator("[data-key]:visible").count(), 5);
    assert.match((await key(page, "B3").getAttribute("aria-label")) ?? "", /^Key 3 of 4 on Outer, at 0\.760, Titanium 100/);
    await page.locator("[data-action=compose]").click();
    await eventually(async () => assert.ok(await handle(page, "A1").isVisible()));
    assert.ok(await key(page, "B1").isHidden());
    await compose(page);
    await key(page, "B1").focus();
    await page.keyboard.press("Escape");
    await eventually(async () => assert.ok(await handle(page, "A1").isVisible()));
    assert.equal(await page.evaluate(() => document.activeElement?.getAttribute("data-action")), "compose");
  },
  "a key slides under the pointer between its neighbours, as one step to undo": async (page) => {
    await compose(page);
    const before = await places(page, 1);
    const [x, y] = await middle(key(page, "B3"));
    await drag(page, [x, y], [-60, 0]);
    await eventually(async () => {
      const [first, second, third, fourth] = await places(page, 1);
      assert.deepEqual([first, second, fourth], [before[0], before[1], before[3]]);
      assert.ok(third < 0.75 && third > before[1], String(third));
    });
    await page.locator("[data-action=undo]").click();
    await eventually(async () => assert.deepEqual(await places(page, 1), before));
    assert.ok(await page.locator("[data-action=undo]").isDisabled());

    // Far past its neighbour it stops beside it; Escape takes the drag back.
    const other = await middle(key(page, "B2"));
    await drag(page, await middle(key(page, "B3")), [other[0] - x, other[1] - y - 60], { release: false });
    await eventually(async () => assert.equal((await places(page, 1))[2], 0.580001));
    await page.keyboard.press("Escape");
    await page.mouse.up();
    await eventually(async () => assert.deepEqual(await places(page, 1), before));
  },
  "arrows, page keys, Insert and Delete work on keys, past the seam as well": async (page) => {
    await compose(page);
    await key(page, "B4").focus();
    await page.keyboard.press("ArrowRight");
    await eventually(async () => assert.equal((await places(page, 1))[3], 0.95));
    await page.keyboard.press("Alt+ArrowLeft");
    await eventually(async () => assert.equal((await places(page, 1))[3], 0.949));
    await eventually(async () => assert.match((await speech(page)) ?? "", /^Key 4 of 4 on Outer, at 0\.949, Titanium/));
    await page.keyboard.press("Shift+ArrowRight");
    await eventually(async () => assert.deepEqual(await places(page, 1), [0.049, 0.14, 0.58, 0.76]));
    assert.equal(await page.evaluate(() => document.activeElement?.getAttribute("data-key")), "B1 key", "focus stays with it");
    await page.keyboard.press("Escape");
    await eventually(async () => assert.deepEqual(await places(page, 1), [0.14, 0.58, 0.76, 0.94]));

    await key(page, "B2").focus();
    await page.keyboard.press("Insert");
    await eventually(async () => assert.deepEqual(await places(page, 1), [0.14, 0.58, 0.67, 0.76, 0.94]));
    assert.deepEqual((await keysOf(page, 1))[2].mix, [0, 0.5, 0.5], "the profile keeps its shape");
    assert.equal(await page.evaluate(() => document.activeElement?.getAttribute("data-key")), "B3 key");
    await page.keyboard.press("PageDown");
    assert.equal(await page.evaluate(() => document.activeElement?.getAttribute("data-key")), "B4 key");
    await page.keyboard.press("PageUp");
    await page.keyboard.press("Delete");
    await eventually(async () => assert.deepEqual(await places(page, 1), [0.14, 0.58, 0.76, 0.94]));

    await key(page, "A1").focus();
    await page.keyboard.press("Delete");
    await eventually(async () => assert.equal(await speech(page), "A curve keeps at least one key"));
    assert.equal((await keysOf(page, 0)).length, 1);
  },
  "a double click on a curve or on its strip adds a key there": async (page) => {
    await compose(page);
    const at = await page.evaluate(() => {
      const path = /** @type {SVGPathElement} */ (document.querySelector('[data-key-outline="0"]'));
      const box = /** @type {HTMLElement} */ (document.querySelector("#stage")).getBoundingClientRect();
      const point = path.getPointAtLength(path.getTotalLength() / 2);
      return /** @type {[number, number]} */ ([box.left + point.x, box.top + point.y]);
    });
    await page.mouse.dblclick(at[0], at[1]);
    await eventually(async () => assert.equal((await keysOf(page, 0)).length, 2));
    assert.deepEqual((await keysOf(page, 0))[1].mix, [1, 0, 0]);
    assert.deepEqual((await page.locator("[data-key-panel] .key-title").textContent()), "Key 2 of 2 on Inner");

    const strip = page.locator("[data-strip='1']");
    const box = await strip.boundingBox();
    assert.ok(box);
    await page.mouse.dblclick(box.x + box.width * 0.35, box.y + box.height / 2);
    await eventually(async () => assert.equal((await keysOf(page, 1)).length, 5));
    assert.ok(Math.abs((await places(page, 1))[1] - 0.35) < 0.01);
    await page.locator("[data-action=remove-key]").click();
    await eventually(async () => assert.equal((await keysOf(page, 1)).length, 4));
    await page.locator("[data-action=add-key]").click();
    await eventually(async () => assert.equal((await keysOf(page, 1)).length, 5));
    const stop = await middle(page.locator('[data-stop="B1 stop"]'));
    await drag(page, stop, [-10, 0]);
    await eventually(async () => assert.ok((await places(page, 1))[0] < 0.14));
  },
  "bars, fields and triangle change the mix and never leave the simplex": async (page) => {
    await compose(page);
    await key(page, "B1").focus();
    const mix = async () => (await keysOf(page, 1))[0].mix;
    const sumsToOne = async () => {
      const fractions = await mix();
      assert.ok(Math.abs(fractions.reduce((/** @type {number} */ a, /** @type {number} */ b) => a + b) - 1) <= 1e-9);
      assert.ok(fractions.every((/** @type {number} */ f) => f >= 0));
    };
    await field(page, "percent-1").fill("60");
    await page.keyboard.press("Enter");
    await eventually(async () => assert.deepEqual(await mix(), [0, 0.6, 0.4]));
    await field(page, "percent-0").fill("33.33");
    await page.keyboard.press("Enter");
    await eventually(async () => assert.deepEqual(await mix(), [0.3333, 0.4, 0.2667]));
    await sumsToOne();
    await field(page, "percent-0").fill("130");
    await page.keyboard.press("Enter");
    assert.match((await page.locator("#error-percent-0").textContent()) ?? "", /from 0 to 100/);
    await page.keyboard.press("Escape");
    assert.deepEqual(await mix(), [0.3333, 0.4, 0.2667]);

    const bar = page.locator("[data-slider='mix-2']");
    await bar.focus();
    await page.keyboard.press("End");
    await eventually(async () => assert.deepEqual(await mix(), [0, 0, 1]));
    for (let i = 0; i < 50; i += 1) await page.keyboard.press("ArrowLeft");
    await eventually(async () => assert.equal((await mix())[2], 0.5));
    await sumsToOne();
    const [first, second] = await mix();
    assert.ok(Math.abs(first / second - 0.3333 / 0.4) < 2e-3, "the proportions of the others come back");

    const pad = page.locator("[data-triangle]");
    await pad.scrollIntoViewIfNeeded();
    const box = await pad.boundingBox();
    assert.ok(box);
    await drag(page, [box.x + box.width / 2, box.y + (box.height * 2) / 3], [0, 400]);
    await eventually(async () => {
      const [a, b, c] = await mix();
      assert.ok(c === 0 && Math.abs(a - b) < 0.03, String([a, b, c]));
    });
    await pad.focus();
    await page.keyboard.press("Shift+ArrowRight");
    await eventually(async () => {
      const [a, b, c] = await mix();
      assert.ok(b - a > 0.15 && c === 0, String([a, b, c]));
    });
    await page.keyboard.press("ArrowUp");
    await sumsToOne();
    await eventually(async () => {
      assert.match((await pad.getAttribute("aria-valuetext")) ?? "", /^Polymer \d+.%, Ceramic \d+.%, Titanium 1.%$/);
    });
    await eventually(async () => {
      await page.keyboard.press("Control+z");
      assert.deepEqual(await mix(), [0, 1, 0]);
    });
  },
  "the place of a key is a number that stops at its neighbours": async (page) => {
    await compose(page);
    await key(page, "B2").focus();
    await page.getByText("Key 2 of 4 on Outer").waitFor();
    await field(page, "key-at").fill("0.3");
    await page.keyboard.press("Enter");
    await eventually(async () => assert.deepEqual(await places(page, 1), [0.14, 0.3, 0.76, 0.94]));
    await field(page, "key-at").fill("0.9");
    await page.keyboard.press("Enter");
    await eventually(async () => assert.equal((await places(page, 1))[1], 0.759999));
    await field(page, "key-at").fill("1.2");
    await page.keyboard.press("Enter");
    assert.match((await page.locator("#error-key-at").textContent()) ?? "", /from 0/);
  },
  "composition editing is accessible": async (page) => {
    await compose(page);
    await page.locator("[data-swatch='0']").click();
    assert.deepEqual(await audit(page), []);
  },
});

test("a key slides by touch", async (t) => {
  const page = await openPage(t, { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });
  await page.locator("[data-tab=materials]").tap();
  await page.locator("[data-action=compose]").tap();
  await key(page, "B3").waitFor();
  const box = await key(page, "B3").boundingBox();
  assert.ok(box && box.width >= 44 && box.height >= 44, JSON.stringify(box));
  const before = await places(page, 1);
  const [x, y] = await middle(key(page, "B3"));
  const touch = await page.context().newCDPSession(page);
  const send = (/** @type {"touchStart" | "touchMove" | "touchEnd"} */ type, /** @type {number} */ by) =>
    touch.send("Input.dispatchTouchEvent", { type, touchPoints: type === "touchEnd" ? [] : [{ x: x + by, y }] });
  await send("touchStart", 0);
  for (const by of [-8, -16, -24, -30]) await send("touchMove", by);
  await send("touchEnd", 0);
  await eventually(async () => {
    const after = await places(page, 1);
    assert.ok(after[2] < before[2] - 0.01, String(after));
  });
});
