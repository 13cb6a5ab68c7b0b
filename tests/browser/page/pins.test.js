/** Pins: lines held at both ends, from the figure, the keyboard and the inspector. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { audit } from "../support/axe.js";
import { openAsFile, rings } from "./documents.js";
import { onOnePage } from "./one-page.js";
import { openPage } from "./open.js";
import { documentOf, drag, eventually, field, middle, spoken, status } from "./workbench.js";

/** @typedef {import("playwright-core").Page} Page */

const pinsOf = async (/** @type {Page} */ page) => (await documentOf(page)).matching.pins ?? [];
const end = (/** @type {Page} */ page, /** @type {string} */ name) => page.locator(`[data-pin-end="${name}"]`);

/** Counts the rings that were opened: each pair has a title and a number of lines of its own, so that none is taken for the one before. */
let opened = 0;

/** Two rings of some 30 lines, ten more each time; pins add lines of their own. @param {Page} page @param {object} [matching] */
async function openRings(page, matching = {}) {
  opened += 1;
  const lines = 20 + 10 * opened;
  await openAsFile(page, rings({ method: "exact", oneToOne: true, ...matching }, { title: `Rings ${opened}`, sampling: { counts: [lines, lines] } }));
  await eventually(async () => assert.match(await status(page), new RegExp(`\\b${lines / 10}\\d\\s*lines`)));
}

/** Chooses the first line by the keyboard. @param {Page} page */
async function choose(page) {
  await page.locator("#probe-keys").focus();
  await page.keyboard.press("ArrowRight");
  await eventually(async () => assert.ok(await page.locator("#probe").isVisible()));
  await page.keyboard.press("Enter");
  await eventually(async () => assert.ok(await end(page, "line-v").isVisible()));
}

onOnePage("pins", {
  "the end of a line is dragged: the line is pinned, the rest follows, and one undo takes it back": async (page) => {
    await openRings(page);
    await choose(page);
    assert.match((await end(page, "line-v").getAttribute("aria-label")) ?? "", /^End of line 1 on outer.*moving it pins the line$/i);
    await drag(page, await middle(end(page, "line-v")), [0, -60], { release: false });
    await eventually(async () => assert.equal(await page.locator(".pin-end").count(), 2));
    const during = await pinsOf(page);
    assert.equal(during.length, 1);
    // Solved while the end is held.
    await eventually(async () => assert.match(await status(page), /Verified/));
    await page.mouse.up();
    const [pin] = await pinsOf(page);
    assert.ok(Math.abs(pin.u - pin.v) > 0.01, "it is no radius any more");
    await eventually(async () => assert.match(await status(page), /Verified/));
    await eventually(async () => assert.match(await spoken(page), /^Pin 1 on outer, at/i));
    assert.deepEqual(await audit(page), []);
    await page.keyboard.press("Control+z");
    assert.deepEqual(await pinsOf(page), [], "one edit");
    await page.keyboard.press("Control+y");
    assert.deepEqual(await pinsOf(page), [pin]);
  },

  "Escape gives a drag up and leaves no trace": async (page) => {
    await openRings(page);
    await choose(page);
    await drag(page, await middle(end(page, "line-v")), [0, -60], { release: false });
    assert.equal((await pinsOf(page)).length, 1);
    await page.keyboard.press("Escape");
    await page.mouse.up();
    assert.deepEqual(await pinsOf(page), []);
    await eventually(async () => assert.ok(await page.locator("[data-action=undo]").isDisabled()));
  },

  "pins are moved by keys and fields, listed and removed": async (page) => {
    await openRings(page, { pins: [{ u: 0.1, v: 0.1 }, { u: 0.6, v: 0.6 }] });
    await eventually(async () => assert.equal(await page.locator(".pin-end").count(), 4));
    await eventually(async () => assert.equal(await page.locator("[data-pin-remove]").count(), 2));
    await end(page, "1v").focus();
    await page.keyboard.press("ArrowRight");
    await eventually(async () => assert.equal((await pinsOf(page))[0].v, 0.11));
    await page.keyboard.press("Shift+ArrowLeft");
    await eventually(async () => assert.equal((await pinsOf(page))[0].v, 0.01));
    await page.keyboard.press("Alt+ArrowLeft");
    await eventually(async () => assert.equal((await pinsOf(page))[0].v, 0.009));
    await eventually(async () => assert.match(await spoken(page), /^Pin 1 on outer, at 0\.009$/i));
    await page.keyboard.press("Shift+ArrowLeft");
    await eventually(async () => assert.equal((await pinsOf(page))[0].v, 0.909, "on round the seam"));
    await page.keyboard.press("Escape");
    await eventually(async () => assert.equal((await pinsOf(page))[0].v, 0.1, "the run is taken back"));

    await field(page, "pin-2u").fill("0.55");
    await page.keyboard.press("Enter");
    assert.deepEqual((await pinsOf(page))[1], { u: 0.55, v: 0.6 });
    await field(page, "pin-2u").press("ArrowUp");
    assert.equal((await pinsOf(page))[1].u, 0.56);
    assert.deepEqual(await audit(page), []);

    await page.locator("[data-pin-remove='1']").click();
    assert.deepEqual(await pinsOf(page), [{ u: 0.56, v: 0.6 }]);
    await eventually(async () => assert.ok(await page.locator("[data-pin-remove='1']").evaluate((e) => e === document.activeElement)));
    await end(page, "1u").focus();
    await page.keyboard.press("Delete");
    assert.deepEqual(await pinsOf(page), []);
    await eventually(async () => assert.ok(await page.locator("[data-pin-list]").isHidden()));
    assert.equal(await page.locator(".pin-end").count(), 0);
  },

  "pins that cannot be kept are named beside the list, with what is wrong with them": async (page) => {
    await openRings(page, { pins: [{ u: 0.5, v: 0.5 }, { u: 0.1, v: 0.14 }, { u: 0.12, v: 0.1 }] });
    const reason = page.locator("[data-pin-reason]");
    await eventually(async () => assert.match((await reason.textContent()) ?? "", /^Pins 2 and 3 cross\. Move an end, or remove one\.$/));
    assert.match(await status(page), /Pins 2 and 3 cross\./);
    assert.equal(await page.locator(".pin-end.wrong").count(), 4);
    assert.deepEqual(await audit(page), []);
    await field(page, "pin-2v").fill("0.08");
    await page.keyboard.press("Enter");
    await eventually(async () => assert.ok(await reason.isHidden()));
    await eventually(async () => assert.match(await status(page), /Verified/));
    await field(page, "pin-2v").fill("0.6");
    await page.keyboard.press("Enter");
    await eventually(async () => assert.match((await reason.textContent()) ?? "", /^Pin 2 meets a curve/));
  },

  "pinning makes the matching exact, and another method gives the pins up, both said and undone in one": async (page) => {
    await openRings(page, { method: "greedy", oneToOne: false });
    await choose(page);
    await page.locator("[data-explain=pin]").click();
    const { method, pins } = (await documentOf(page)).matching;
    assert.deepEqual([method, pins.length], ["exact", 1]);
    await eventually(async () => assert.match(await status(page), /matching is exact now/));
    await page.locator("[data-select=method]").selectOption("greedy");
    assert.deepEqual([(await documentOf(page)).matching.method, await pinsOf(page)], ["greedy", []]);
    await eventually(async () => assert.match(await status(page), /1 pin was removed/));
    await page.keyboard.press("Control+z");
    assert.deepEqual(await pinsOf(page), pins);
  },
});

test("by touch the end of a line is large enough, and is dragged", async (t) => {
  const page = await openPage(t, { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });
  await openRings(page, { pins: [{ u: 0.25, v: 0.25 }] });
  await eventually(async () => assert.ok(await end(page, "1v").isVisible()));
  const box = await end(page, "1v").boundingBox();
  assert.ok(box && box.width > 43.9 && box.height > 43.9);
  const client = await page.context().newCDPSession(page);
  const at = { x: box.x + box.width / 2, y: box.y + box.height / 2 };
  const touch = (/** @type {"touchStart" | "touchMove" | "touchEnd"} */ type, /** @type {number} */ by) =>
    client.send("Input.dispatchTouchEvent", { type, touchPoints: type === "touchEnd" ? [] : [{ x: at.x + by, y: at.y }] });
  await touch("touchStart", 0);
  for (const by of [8, 16, 24]) await touch("touchMove", by);
  await touch("touchEnd", 24);
  await eventually(async () => assert.ok((await pinsOf(page))[0].v < 0.25));
});
