/** The step view: every step of the greedy growth and what follows it, checked against the kernel's own trace. */
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { test } from "node:test";
import { load } from "directrix";
import { auditThemes } from "../support/axe.js";
import { onOnePage } from "./one-page.js";
import { openPage } from "./open.js";
import { documentOf, eventually, pick, uiOf } from "./workbench.js";

/** @import { Page } from "playwright-core" */

const PHONE = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true };
const dx = await load({ module: "full" });
const amoeba = JSON.parse(await readFile(new URL("../../../www/presets/amoeba.json", import.meta.url), "utf8"));
const steps = dx.steps(amoeba);
const total = steps.growth.length + steps.removed.length + steps.inserted.length + 1;

const control = (/** @type {Page} */ page, /** @type {string} */ name) => page.locator(`[data-steps=${name}]`);
const stepOf = (/** @type {Page} */ page) => page.locator(".mode-stage").getAttribute("data-step").then(Number);
const fact = (/** @type {Page} */ page, /** @type {string} */ name) => page.locator(`[data-fact=${name}] .strong`).innerText();
const lit = (/** @type {Page} */ page) => page.locator("[data-code][aria-current]").getAttribute("data-code").then(Number);
const spoken = (/** @type {Page} */ page) => page.locator("#speech").innerText();

/** @param {Page} page */
async function openSteps(page) {
  await pick(page, "mode", "steps");
  await page.waitForSelector(".steps-transport");
  await eventually(async () => assert.ok((await page.locator(".step-curves").getAttribute("d"))?.length));
}

/** Moves the scrubber. @param {Page} page @param {number} step */
async function scrub(page, step) {
  const slider = page.locator("[data-slider=step]");
  await slider.fill(String(step));
  await eventually(async () => assert.equal(await stepOf(page), step));
}

/** Where a sample stands on the screen. @param {Page} page @param {0 | 1} curve @param {number} vertex */
async function place(page, curve, vertex) {
  const { view } = await uiOf(page);
  const box = await page.locator("#stage").boundingBox();
  assert.ok(box);
  const [x, y] = steps.samples[curve].points[vertex];
  return {
    x: box.x + box.width / 2 + (x - view.center[0]) * view.scale,
    y: box.y + box.height / 2 - (y - view.center[1]) * view.scale,
  };
}

/** Number of the pieces of a layer of the picture. @param {Page} page @param {string} name */
async function pieces(page, name) {
  const d = await page.locator(`.${name}`).first().getAttribute("d");
  return d?.match(/M/g)?.length ?? 0;
}

onOnePage("the steps", {
  "every step shows its lines, sets, candidates and line of the code": async (page) => {
    await openSteps(page);
    assert.equal(await stepOf(page), 1);
    for (const step of [1, 2, 26, 60, steps.growth.length]) {
      await scrub(page, step);
      const { from, to } = steps.growth[step - 1];
      const sets = dx.sets(amoeba, { step: step - 1, vertex: from });
      const candidates = sets.visible.filter(({ candidate }) => candidate);
      await eventually(async () => {
        assert.equal(await fact(page, "visible"), String(sets.visible.length));
        assert.equal(await fact(page, "valid"), String(sets.valid.length));
        assert.equal(await fact(page, "both"), String(candidates.length));
        assert.match(await fact(page, "best"), new RegExp(`^q${to},`));
      });
      assert.equal(await pieces(page, "step-accepted"), step - 1);
      assert.equal(await page.locator(".step-candidates").nth(1).getAttribute("d").then((d) => d?.match(/M/g)?.length ?? 0), candidates.length);
      assert.equal(await pieces(page, "step-visible"), sets.visible.length - candidates.length);
      assert.deepEqual(
        await page.locator("[data-candidate]").evaluateAll((rows) => rows.map((row) => Number(row.getAttribute("data-candidate")))),
        candidates.slice(0, 12).map(({ vertex }) => vertex),
      );
      assert.equal(await lit(page), 4);
      assert.deepEqual(await page.locator(".step-names text").allTextContents().then((names) => names.sort()), [`p${from}`, `q${to}`].sort());
    }
    assert.deepEqual(await documentOf(page).then(({ matching }) => matching.method), amoeba.matching.method, "looking changes nothing");
  },

  "a prediction is asked for, told right or wrong, and counted": async (page) => {
    await openSteps(page);
    await scrub(page, 12);
    await control(page, "predict").click();
    await eventually(async () => assert.equal(await stepOf(page), 13));
    const [right, later] = [steps.growth[12], steps.growth[13]];
    assert.equal(await pieces(page, "step-winner"), 0);
    assert.equal(await page.locator("[data-fact]").count(), 0, "nothing gives it away");
    assert.equal(await pieces(page, "step-candidates"), 0);
    await eventually(async () => assert.match(await spoken(page), new RegExp(`next line starts at p${right.from}\\.`)));
    const { x, y } = await place(page, 1, right.to);
    await page.mouse.click(x, y);
    const answer = page.locator(".steps-ask");
    await eventually(async () => assert.equal(await answer.getAttribute("data-verdict"), "right"));
    assert.match(await answer.innerText(), new RegExp(`Right: the line lands on q${right.to}\\. 1 of 1 right`));
    assert.equal(await pieces(page, "step-winner"), 1);
    assert.equal(await lit(page), 5);
    // Once more by the keyboard, and wrong on purpose.
    await page.keyboard.press("Enter");
    await eventually(async () => assert.equal(await page.locator(".mode-stage").getAttribute("data-hidden"), "true"));
    const count = steps.samples[1].points.length;
    let aim = -1;
    for (let k = 0; k < count && (aim < 0 || aim === later.to); k++) {
      await page.keyboard.press("ArrowRight");
      await eventually(async () => assert.match(await spoken(page), /^Aim at q\d+/));
      aim = Number((await spoken(page)).match(/\d+/)?.[0]);
    }
    await page.keyboard.press("Enter");
    await eventually(async () => assert.equal(await answer.getAttribute("data-verdict"), "wrong"));
    assert.match(await answer.innerText(), new RegExp(`Not q${aim}, .*the line lands on q${later.to}\\. 1 of 2 right`));
    assert.equal(await pieces(page, "step-guess"), 1);
    await page.keyboard.press("Escape");
    await eventually(async () => assert.equal(await control(page, "predict").getAttribute("aria-pressed"), "false"));
    await page.keyboard.press("End");
    await control(page, "predict").click();
    await eventually(async () => assert.match(await page.locator("#status").innerText(), /The growth is over/));
  },

  "removal and insertion go one line at a time, to the verified result": async (page) => {
    await openSteps(page);
    const growth = steps.growth.length;
    const first = growth + steps.removed.length;
    for (const [k, line] of [[0, steps.removed[0]], [steps.removed.length - 1, steps.removed.at(-1)]]) {
      await scrub(page, growth + 1 + Number(k));
      const { from, to } = steps.growth[Number(line)];
      await eventually(async () => assert.match(await fact(page, "line"), new RegExp(`^p${from} – q${to},`)));
      assert.ok(Number(await fact(page, "degree-0")) > 1 && Number(await fact(page, "degree-1")) > 1, "both ends have another line");
      assert.equal(await pieces(page, "step-winner"), 1);
      assert.equal(await lit(page), 8);
      assert.equal(await page.locator("[data-total=lines] .strong").innerText(), String(growth - 1 - Number(k)));
    }
    for (const [k, { curve, vertex }] of [...steps.inserted.entries()].filter(([k]) => k % 5 === 0)) {
      await scrub(page, first + 1 + k);
      assert.equal(await lit(page), curve === 0 ? 9 : 10);
      await eventually(async () => assert.equal(await fact(page, "inserted"), String(k + 1)));
      assert.deepEqual(await page.locator(".step-names text").allTextContents(), [`${curve === 0 ? "q" : "p"}${vertex}`]);
      assert.equal(await page.locator("[data-total=lines] .strong").innerText(), String(steps.lines.length));
      assert.equal(await pieces(page, "step-left"), 1);
    }
    await page.keyboard.press("End");
    await eventually(async () => assert.equal(await stepOf(page), total));
    assert.equal(await lit(page), 11);
    assert.equal(await fact(page, "lines"), String(steps.pairs.length));
    assert.equal(await pieces(page, "step-accepted"), steps.pairs.length);
    assert.deepEqual([await fact(page, "crossings"), await fact(page, "blocked")], ["0", "0"]);
    await page.locator("[data-group-button=optimum]").click();
    assert.match(await fact(page, "gap"), /^0\.\d+\s%$/);
    await page.locator("[data-group-button=optimum]").click();
  },

  "keys and buttons go forward and back; play plays, pauses and ends": async (page) => {
    await openSteps(page);
    await scrub(page, 1);
    const at = (/** @type {number} */ step) => eventually(async () => assert.equal(await stepOf(page), step));
    await page.locator("#stage").evaluate((element) => element.ownerDocument.activeElement instanceof HTMLElement && element.ownerDocument.activeElement.blur());
    await page.keyboard.press("ArrowRight");
    await at(2);
    await page.keyboard.press("ArrowLeft");
    await page.keyboard.press("ArrowLeft");
    await at(0);
    assert.equal(await lit(page), 0);
    assert.ok(await control(page, "back").isDisabled());
    await control(page, "forward").click();
    await control(page, "forward").click();
    await at(2);
    const { from, to } = steps.growth[1];
    await eventually(async () => assert.match(await spoken(page), new RegExp(`^Step 2 of ${total}: line p${from} – q${to}, f .+, after 1.line`)));
    await control(page, "last").click();
    await at(total);
    await page.keyboard.press("Home");
    await at(0);
    await page.locator("[data-slider=step]").focus();
    await page.keyboard.press("ArrowRight");
    await at(1);
    await control(page, "speed").selectOption("8");
    await control(page, "play").click();
    await eventually(async () => assert.ok((await stepOf(page)) > 4));
    await control(page, "play").click();
    const stopped = await stepOf(page);
    await page.waitForTimeout(300);
    assert.equal(await stepOf(page), stopped);
    await scrub(page, total - 2);
    await control(page, "play").click();
    await at(total);
    assert.equal(await control(page, "play").getAttribute("aria-label"), "Play");
    await eventually(async () => assert.match(await spoken(page), /result, \d+.lines/));
  },

  "with reduced motion play takes one step": async (page) => {
    await page.emulateMedia({ reducedMotion: "reduce" });
    await openSteps(page);
    await scrub(page, 1);
    assert.equal(await control(page, "play").getAttribute("aria-label"), "Next step");
    await control(page, "play").click();
    await eventually(async () => assert.equal(await stepOf(page), 2));
    await page.waitForTimeout(700);
    assert.equal(await stepOf(page), 2);
    await page.emulateMedia({ reducedMotion: "no-preference" });
  },

  "a vertex of either curve shows its sets, by a click and by the arrow keys": async (page) => {
    await openSteps(page);
    await scrub(page, 26);
    for (const [curve, vertex] of /** @type {[0 | 1, number][]} */ ([[0, 30], [1, 5]])) {
      const { x, y } = await place(page, curve, vertex);
      await page.mouse.click(x, y);
      const sets = dx.sets(amoeba, { step: 25, curve, vertex });
      await eventually(async () => {
        assert.equal(await fact(page, "visible"), String(sets.visible.length));
        assert.equal(await fact(page, "valid"), String(sets.valid.length));
      });
      await eventually(async () => assert.match(await spoken(page), new RegExp(`^${curve === 0 ? "p" : "q"}${vertex}: sees ${sets.visible.length}, ${sets.valid.length} keep`)));
    }
    await page.keyboard.press("ArrowRight");
    await eventually(async () => assert.equal(await page.locator("[data-fact=visible] span").first().innerText(), "Visible from q6, set V"));
    await page.keyboard.press("ArrowUp");
    await eventually(async () => assert.match(await page.locator("[data-fact=visible] span").first().innerText(), /Visible from p\d+/));
    await page.keyboard.press("PageDown");
    await eventually(async () => assert.equal(await stepOf(page), 27));
    assert.ok(await control(page, "follow").isVisible(), "the vertex stays chosen from step to step");
    await page.keyboard.press("Escape");
    await eventually(async () => assert.match(await page.locator("[data-fact=visible] span").first().innerText(), new RegExp(`from p${steps.growth[26].from},`)));
  },

  "the view can be moved and fitted, and what is left of the figure is hidden": async (page) => {
    await openSteps(page);
    assert.equal(await page.locator("[data-handle=A1]").isVisible(), false);
    const before = await page.locator(".step-curves").getAttribute("d");
    await page.mouse.move(500, 760);
    await page.mouse.move(480, 300);
    await page.mouse.wheel(0, -300);
    await eventually(async () => assert.notEqual(await page.locator(".step-curves").getAttribute("d"), before));
    await page.keyboard.press("f");
    await eventually(async () => assert.equal(await page.locator(".step-curves").getAttribute("d"), before));
  },

  "a document of another method shows the greedy growth for its weights, and says so with the gap": async (page) => {
    await openSteps(page);
    await scrub(page, 1);
    await pick(page, "mode", "figure");
    await page.locator("select[data-select=method]").selectOption("greedy");
    await openSteps(page);
    await eventually(async () => assert.equal(await page.locator(".steps-reading").innerText(), `step 1 of ${total}`));
    assert.ok(await page.locator("[data-steps-note]").isHidden(), "a greedy document needs no word on it");
    await pick(page, "mode", "figure");
    await page.locator("select[data-select=method]").selectOption("integral");
    await openSteps(page);
    assert.equal((await documentOf(page)).matching.method, "exact");
    await eventually(async () =>
      assert.match(await page.locator("[data-steps-note]").innerText(), /matched by the exact optimum\. The steps show the greedy growth/),
    );
    assert.equal(await page.locator(".steps-reading").innerText(), `step 1 of ${total}`);
    await page.locator("[data-group-button=optimum]").click();
    for (const name of ["greedy", "optimum", "gap", "own"]) await eventually(async () => assert.ok((await fact(page, name)).length > 0));
  },

  "the steps follow the document: its method, its curves, undo, and a reload": async (page) => {
    await openSteps(page);
    await scrub(page, 40);
    await page.reload();
    await page.waitForSelector(".steps-transport");
    await pick(page, "mode", "figure");
    await page.locator("[data-handle=A1]").focus();
    for (let k = 0; k < 5; k++) await page.keyboard.press("ArrowRight");
    const moved = dx.steps(await documentOf(page));
    assert.notDeepEqual(moved.growth, steps.growth);
    await openSteps(page);
    await scrub(page, 1);
    const sum = page.locator("[data-fact=best] .strong");
    await eventually(async () => assert.match(await sum.innerText(), new RegExp(`^q${moved.growth[0].to}, `)));
    const length = moved.growth.length + moved.removed.length + moved.inserted.length + 1;
    await eventually(async () => assert.equal(await page.locator(".steps-reading").innerText(), `step 1 of ${length}`));
    for (let k = 0; k < 6 && (await documentOf(page)).curves[0].points[0][0] !== amoeba.curves[0].points[0][0]; k++) {
      await page.keyboard.press("Control+z");
    }
    await eventually(async () => assert.equal(await page.locator(".steps-reading").innerText(), `step 1 of ${total}`));
  },
});

for (const [name, options] of /** @type {const} */ ([
  ["large", {}],
  ["on a phone", PHONE],
])) {
  test(`axe finds nothing wrong, light and dark, ${name}, in the growth, in the game and at the end`, async (t) => {
    const page = await openPage(t, options);
    await openSteps(page);
    await scrub(page, 26);
    await eventually(async () => assert.ok(await page.locator("[data-fact=visible]").isVisible()));
    assert.deepEqual(await auditThemes(page), []);
    await control(page, "predict").click();
    assert.deepEqual(await auditThemes(page), []);
    await page.keyboard.press("Escape");
    await scrub(page, total);
    if (!("isMobile" in options)) for (const group of ["accepted", "optimum"]) await page.locator(`[data-group-button=${group}]`).click();
    assert.deepEqual(await auditThemes(page), []);
    const wide = await page.evaluate(() => document.documentElement.scrollWidth > innerWidth);
    assert.equal(wide, false);
  });
}

test("by touch a vertex is chosen and a prediction made; targets are large enough", async (t) => {
  const page = await openPage(t, PHONE);
  await openSteps(page);
  for (const name of ["first", "back", "play", "forward", "last", "predict"]) {
    const box = await control(page, name).boundingBox();
    assert.ok(box && box.width >= 44 && box.height >= 44, `${name} ${JSON.stringify(box)}`);
  }
  await scrub(page, 12);
  await control(page, "predict").tap();
  await eventually(async () => assert.equal(await stepOf(page), 13));
  const { x, y } = await place(page, 1, steps.growth[12].to);
  await page.touchscreen.tap(x, y);
  await eventually(async () => assert.equal(await page.locator(".steps-ask").getAttribute("data-verdict"), "right"));
  await page.locator("[data-tab=candidates]").tap();
  assert.ok(await page.locator("[data-candidate]").first().isVisible());
});
