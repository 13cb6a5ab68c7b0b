/** The workbench Lessons: links, keys, questions, terms, own curves, the way to the editor, and what must not leak to the page behind. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { load } from "directrix";
import { documentNamed } from "../../../scripts/lib/lesson-plugin.mjs";
import { figureDocument, momentOf } from "../../../www/src/lessons/document.js";
import { audit } from "../support/axe.js";
import { cell, control, first, goTo, greedy, lessons, named, lit, shows, term } from "./lesson.js";
import { onOnePage } from "./one-page.js";
import { openPage, openRaw } from "./open.js";
import { documentOf, drag, drawn, eventually, field, handle, middle, ready, spoken, uiOf } from "./workbench.js";

/** @import { Lesson } from "../../../scripts/lib/lesson.mjs" */

const PHONE = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true };
const [validity, corner, material, transform, overlaps, voxels, elements, precondition] =
  ["cell-validity", "corner-continuity", "material-continuity", "distance-transform", "overlaps", "voxel-error", "boundary-elements", "why-precondition"].map(named);
const dx = await load({ module: "full" });

/** Where a vertex of the second curve stands on the screen: the end of the ring of dots that the figure draws in order. */
const samplesOf = (/** @type {import("../../../www/src/types.js").CurvesDocument} */ document) => dx.steps(document).samples;

test("nothing of lessons is loaded until they are opened; every step has a link, and back and reload lead to it", async (t) => {
  const page = await openPage(t);
  const loaded = () => page.evaluate(() => performance.getEntriesByType("resource").map(({ name }) => name).filter((name) => /lesson|katex/i.test(name)));
  assert.deepEqual((await loaded()).filter((name) => !/Math-Italic/.test(name)), []);
  await page.getByRole("link", { name: "Lessons" }).click();
  await shows(page, first, 1);
  assert.equal(await page.getByRole("link", { name: "Lessons", exact: true }).getAttribute("aria-current"), "page");
  assert.equal(await page.title(), `${first.steps[0]?.title} · ${first.title} · Directrix`);
  await control(page, "next").click();
  await shows(page, first, 2);
  assert.equal(await page.evaluate(() => document.activeElement?.textContent), first.steps[1]?.title);
  await page.getByRole("link", { name: first.steps[3]?.title ?? "" }).click();
  await shows(page, first, 4);
  await page.goBack();
  await shows(page, first, 2);
  await page.reload();
  await shows(page, first, 2);
  await page.goBack();
  await shows(page, first, 1);
  await page.getByRole("link", { name: "Curves", exact: true }).click();
  await ready(page);
  assert.ok(await page.locator(".lessons").isHidden());
  assert.equal(await page.title(), "Amoeba · Directrix");
  await page.goBack();
  await shows(page, first, 1);
});

onOnePage("lessons", {
  "a link to what there is not says so, and a step past the end is the last": async (page) => {
    await page.evaluate(() => void (location.hash = "#lesson=<b>nothing</b>&step=2"));
    await eventually(async () => assert.match(await page.locator(".lesson-refused").innerText(), /There is no lesson “<b>nothing<\/b>”/));
    await page.getByRole("link", { name: greedy.title }).click();
    await shows(page, greedy, 1);
    await page.evaluate((name) => void (location.hash = `#lesson=${name}&step=99`), first.name);
    await shows(page, first, first.steps.length);
  },

  "arrow keys and a clicker go from step to step and from lesson to lesson; P presents, Escape ends it": async (page) => {
    await goTo(page, first, first.steps.length - 1);
    await page.keyboard.press("PageDown");
    await shows(page, first, first.steps.length);
    await page.keyboard.press("ArrowRight");
    await shows(page, /** @type {Lesson} */ (lessons[1]), 1);
    await page.keyboard.press("PageUp");
    await shows(page, first, first.steps.length);
    const size = () => page.locator(".lesson-text p").first().evaluate((element) => parseFloat(getComputedStyle(element).fontSize));
    const plain = await size();
    await page.keyboard.press("p");
    await eventually(async () => assert.ok((await size()) > 1.4 * plain));
    assert.ok(await page.locator("#bar").isHidden());
    assert.ok(await page.locator(".lesson-list").isHidden());
    await eventually(async () => assert.match(await spoken(page), /^Presentation\./));
    await page.keyboard.press("ArrowLeft");
    await shows(page, first, first.steps.length - 1);
    const wide = await page.locator(".lesson-picture").boundingBox();
    assert.ok(wide && wide.width > 600 && wide.x + wide.width <= 1440);
    assert.deepEqual(await audit(page), []);
    await page.keyboard.press("Escape");
    await eventually(async () => assert.ok(await page.locator("#bar").isVisible()));
    assert.equal(await size(), plain);
    await control(page, "present").click();
    await control(page, "end").click();
    assert.ok(await page.locator("#bar").isVisible());
  },

  "a prediction is made by pointer and by keyboard, shows the reason, and stays": async (page) => {
    await goTo(page, first, 2);
    const told = page.locator(".lesson-told");
    assert.ok(await told.isHidden());
    await page.locator("[data-choice='0']").click();
    assert.match(await told.innerText(), /^Not quite\. It is/);
    assert.equal(await page.locator(".lesson-question").getAttribute("data-verdict"), "wrong");
    assert.ok(await page.locator("[data-choice='1'].right").isVisible());
    await eventually(async () => assert.match(await spoken(page), /^Not quite\..*50 % polymer/));
    await page.locator("[data-choice='1']").dispatchEvent("click");
    assert.equal(await page.locator(".lesson-question").getAttribute("data-verdict"), "wrong", "a prediction is made once");
    await goTo(page, first, 3);
    await page.locator("[data-choice='2']").focus();
    await page.keyboard.press("Enter");
    assert.match(await told.innerText(), /^Right\./);
    await goTo(page, first, 2);
    assert.match(await told.innerText(), /^Not quite\./);
    await goTo(page, first, 5);
    await control(page, "reveal").click();
    assert.match(await told.innerText(), /^Answer\./);
  },

  "where a line lands is predicted by the keyboard or by a click on a vertex": async (page) => {
    const { figure } = /** @type {Lesson["steps"][0]} */ (greedy.steps[2]);
    const source = figureDocument(await documentNamed(figure.document), figure);
    const steps = dx.steps(source);
    const line = steps.growth[momentOf(steps, figure.step) - 1];
    assert.ok(line);
    await goTo(page, greedy, 3);
    assert.equal(await page.locator(".step-winner").getAttribute("d"), "", "the line is not told");
    await control(page, "choose").click();
    await page.keyboard.press("ArrowRight");
    await eventually(async () => assert.match(await spoken(page), /^Aim at q\d+$/));
    await page.keyboard.press("Enter");
    await eventually(async () => assert.match(await page.locator(".lesson-told").innerText(), /^(Right|Not quite)\. [^]*lands on/));
    assert.notEqual(await page.locator(".step-winner").getAttribute("d"), "");
    assert.ok(await page.locator(".lesson-reveal").count() === 0);

    await page.reload();
    await shows(page, greedy, 3);
    const box = await page.locator(".lesson-picture").boundingBox();
    assert.ok(box);
    const view = dx.fit(source, { width: Math.round(box.width), height: Math.round(box.height) });
    const [x = 0, y = 0] = samplesOf(source)[1].points[line.to] ?? [];
    const place = [box.x + box.width / 2 + (x - view.center[0]) * view.scale, box.y + box.height / 2 - (y - view.center[1]) * view.scale];
    await page.mouse.click(place[0] ?? 0, place[1] ?? 0);
    await eventually(async () => assert.match(await page.locator(".lesson-told").innerText(), /^Right\./));
  },

  "terms light up what they name, by pointer and by focus, and are lit by it": async (page) => {
    await goTo(page, first, 4);
    await term(page, "lines").hover();
    await eventually(async () => assert.equal(await lit(page, "strokes"), 44));
    await term(page, "second").focus();
    await eventually(async () => assert.equal(await lit(page, "strokes"), 1));
    await page.mouse.move(10, 300);
    await term(page, "stage").focus();
    await eventually(async () => assert.equal(await lit(page, "strokes"), 1));
    await page.locator(".lesson h1").focus();
    await eventually(async () => assert.equal(await lit(page, "strokes"), 0));

    const box = await page.locator(".lesson-picture").boundingBox();
    assert.ok(box);
    // Downwards from the middle of the hole the first thing to come is the first curve, then the ring with its lines and the outline.
    /** @type {Set<string>} */
    const found = new Set();
    for (let y = box.y + box.height * 0.5; y < box.y + box.height; y += 3) {
      await page.mouse.move(box.x + box.width * 0.5, y);
      const now = await page.locator(".lesson .term.lit").first().getAttribute("data-term", { timeout: 50 }).catch(() => null);
      if (now) found.add(now);
    }
    for (const name of ["first", "second"]) assert.ok(found.has(name), [...found].join());
    assert.ok(found.has("stage") || found.has("lines"), [...found].join());

    await goTo(page, greedy, 4);
    await term(page, "winner").hover();
    await eventually(async () => assert.equal(await lit(page, "strokes"), 1));
    await term(page, "valid").click();
    await page.mouse.move(10, 300);
    await eventually(async () => assert.equal(await lit(page, "dots"), 5, "a term that was pressed stays lit"));
  },

  "control points of a figure are dragged and moved by keys; R puts them back": async (page) => {
    await goTo(page, first, 3);
    const point = page.locator(".lesson-handles .handle").nth(12);
    const name = () => point.getAttribute("aria-label");
    const start = await name();
    const numbers = () => page.locator(".lesson-status").innerText();
    const eta = await numbers();
    await drag(page, await middle(point), [24, -18]);
    await eventually(async () => assert.notEqual(await numbers(), eta));
    const dragged = await name();
    assert.notEqual(dragged, start);
    await point.focus();
    await page.keyboard.press("Shift+ArrowLeft");
    await eventually(async () => assert.equal(await spoken(page), await name()));
    assert.notEqual(await name(), dragged);
    await page.locator(".lesson h1").focus();
    await page.keyboard.press("r");
    await eventually(async () => assert.equal(await name(), start));
    await eventually(async () => assert.equal(await numbers(), eta));
  },

  "with reduced motion play goes from in-between to in-between": async (page) => {
    await page.emulateMedia({ reducedMotion: "reduce" });
    await goTo(page, first, 4);
    assert.equal(await control(page, "play").getAttribute("aria-label"), "Next in-between curve");
    await control(page, "play").click();
    await eventually(async () => assert.equal(await control(page, "s").innerText(), "0.60"));
    await page.waitForTimeout(400);
    assert.equal(await control(page, "s").innerText(), "0.60");
    await control(page, "reset").click();
    await eventually(async () => assert.equal(await control(page, "s").innerText(), "0.40"));
    await goTo(page, greedy, 4);
    await page.locator("[data-steps=play]").click();
    await eventually(async () => assert.equal(await page.locator(".lesson-figure").getAttribute("data-step"), "9"));
    await page.emulateMedia({ reducedMotion: "no-preference" });
  },

  "without reduced motion play moves the outline and can be paused": async (page) => {
    await goTo(page, first, 4);
    await control(page, "play").click();
    await eventually(async () => assert.notEqual(await control(page, "s").innerText(), "0.40"));
    await control(page, "play").click();
    assert.equal(await control(page, "play").getAttribute("aria-label"), "Play");
  },

  "print shows the step alone": async (page) => {
    await goTo(page, first, 2);
    await page.emulateMedia({ media: "print" });
    for (const selector of ["#bar", ".lesson-list", ".lesson-foot", ".lesson-controls", "#status"]) {
      assert.ok(await page.locator(selector).isHidden(), selector);
    }
    for (const selector of [".lesson h1", ".lesson-picture canvas", ".lesson figcaption", ".lesson-question"]) {
      assert.ok(await page.locator(selector).isVisible(), selector);
    }
    assert.ok(await page.locator(".lesson-scroll").evaluate((element) => element.scrollHeight <= element.clientHeight + 1), "nothing is cut off");
    await page.emulateMedia({ media: "screen" });
  },
});

test("where lessons cannot be fetched the page says so and goes on with the curves", async (t) => {
  const page = await openRaw(t, {});
  await ready(page);
  const work = await eventually(() => documentOf(page));
  await page.route(/\/lessons-[^/]*\.js$/, (route) => route.abort());
  const link = page.getByRole("link", { name: "Lessons" });
  await link.click();
  await eventually(async () => assert.match(await page.locator("#status").innerText(), /fetch/));
  assert.equal(new URL(page.url()).hash, "#stage");
  assert.ok(await page.locator("#inspector").isVisible());
  assert.deepEqual(await documentOf(page), work);
});

test("formulas are set under a policy that allows no styles in texts", async (t) => {
  const policy = "default-src 'self'; script-src 'self' 'unsafe-inline' 'wasm-unsafe-eval'; style-src 'self'";
  const page = await openRaw(t, { headers: { "Content-Security-Policy": policy } });
  /** @type {string[]} */
  const complaints = [];
  page.on("console", (message) => complaints.push(message.text()));
  await ready(page);
  await goTo(page, /** @type {Lesson} */ (lessons[1]), 5);
  const struts = await page.locator(".katex-strut").evaluateAll((all) => all.map((strut) => strut.getBoundingClientRect().height));
  assert.ok(struts.length > 5 && struts.every((height) => height > 4), struts.join());
  assert.deepEqual(complaints.filter((text) => /style/i.test(text)), []);
});

test("a figure opens in the editor as it stands, and the document that was open is kept", async (t) => {
  const page = await openPage(t);
  await field(page, "title").fill("Mine");
  await page.keyboard.press("Enter");
  await page.locator("[data-action=gallery]").click();
  await page.getByRole("link", { name: "Lessons" }).click();
  await goTo(page, first, 4);
  assert.equal(await page.locator("[data-panel]").count(), 0, "no panel lies over the lessons");
  await page.locator("[data-slider=lesson-s]").fill("0.75");
  await control(page, "open").click();
  await ready(page);
  const { figure } = /** @type {Lesson["steps"][0]} */ (first.steps[3]);
  const { view, ...wanted } = dx.defaults(figureDocument(await documentNamed(figure.document), figure));
  await eventually(async () => assert.deepEqual(await documentOf(page), wanted));
  const ui = await uiOf(page);
  assert.equal(ui.s, 0.75);
  assert.deepEqual(ui.layers, view?.layers);
  await page.locator("[data-action=file]").click();
  await page.locator("[data-item=recent]").click();
  await eventually(async () => assert.match(await page.locator("[data-panel]").innerText(), /Mine/));
  await page.keyboard.press("Escape");
  await page.goBack();
  await shows(page, first, 4);
  await eventually(async () => assert.equal((await documentOf(page)).title, "Mine", "the way back leads to the document of the person"));

  await goTo(page, greedy, 4);
  await page.locator("[data-steps=forward]").click();
  await control(page, "open").click();
  await eventually(async () => assert.equal(await page.locator(".mode-stage").getAttribute("data-step"), "9"));
  assert.deepEqual((await documentOf(page)).sampling.counts, [16, 16]);
});

test("what was edited just before is there on the way back from a lesson", async (t) => {
  const page = await openPage(t);
  await field(page, "title").fill("Just now");
  await page.keyboard.press("Enter");
  await page.getByRole("link", { name: "Lessons" }).click();
  await shows(page, first, 1);
  await page.goBack();
  await ready(page);
  await eventually(async () => assert.equal(await page.title(), "Just now · Directrix"));
  await page.waitForTimeout(200);
  assert.equal((await documentOf(page)).title, "Just now");
  assert.ok(await page.locator("[data-action=undo]").isEnabled());
});

test("a figure shows the reader's own curves; keys, undo and paste do not reach the page behind", async (t) => {
  const page = await openPage(t);
  const before = await documentOf(page);
  await handle(page, "B1").focus();
  await page.keyboard.press("Shift+ArrowRight");
  await page.keyboard.press("Shift+ArrowUp");
  await eventually(async () => assert.notDeepEqual((await documentOf(page)).curves, before.curves));
  const own = await documentOf(page);
  await page.getByRole("link", { name: "Lessons" }).click();
  await goTo(page, first, 4);
  const lines = () => page.locator(".lesson-status").innerText();
  const standard = await lines();
  await control(page, "mine").click();
  await eventually(async () => {
    assert.match(await page.locator(".lesson-mine").innerText(), /These are your curves, “Amoeba”/);
    assert.equal(await page.locator(".lesson-figure").getAttribute("data-drawn"), "true");
    assert.notEqual(await lines(), standard);
  });
  const { totals } = dx.match(own);
  assert.match((await lines()).replace(/\s+/g, " "), new RegExp(`${totals.pairs?.count} lines η ${totals.pairs?.eta?.toFixed(3)}`));
  await goTo(page, greedy, 8);
  assert.match(await page.locator(".lesson-mine").innerText(), /your curves/, "the next figures show them too");
  for (const key of ["Control+z", "x", "d", "Delete", "2", "r", "Space", "Control+s"]) await page.keyboard.press(key);
  await page.evaluate(() => {
    const clipboardData = new DataTransfer();
    clipboardData.setData("text/plain", "0,0\n10,0\n10,10\n0,10\n");
    document.body.dispatchEvent(new ClipboardEvent("paste", { clipboardData, bubbles: true, cancelable: true }));
  });
  await control(page, "mine").click();
  await eventually(async () => assert.ok(await page.locator(".lesson-mine").isHidden()));
  assert.deepEqual(await documentOf(page), own);
  assert.equal((await uiOf(page)).mode, "figure");
  await page.getByRole("link", { name: "Curves", exact: true }).click();
  const undo = page.locator("[data-action=undo]");
  await drawn(page);
  while (await undo.isEnabled()) {
    await undo.click();
    await drawn(page);
  }
  await eventually(async () => assert.deepEqual((await documentOf(page)).curves, before.curves));
});

test("axe finds nothing on any step", async (t) => {
  const page = await openPage(t);
  for (const lesson of lessons) {
    /** Steps of a lesson with the same parts in figure and text are alike to axe. @type {Set<string>} */
    const seen = new Set();
    for (const [step, { figure, blocks }] of lesson.steps.entries()) {
      const controls = Object.entries(figure).filter(([name, value]) => value && !["document", "changes", "caption"].includes(name));
      const make = JSON.stringify([figure.view, figure.reading, figure.controls, controls.map(([name]) => name), [...new Set(blocks.map(({ kind }) => kind))].sort()]);
      if (seen.has(make)) continue;
      seen.add(make);
      await goTo(page, lesson, step + 1);
      // The frame around a step is the same on all of them.
      assert.deepEqual(await audit(page, lesson === first && step === 0 ? undefined : [".lesson"]), [], `${lesson.name}, step ${step + 1}`);
    }
  }
});

test("on a phone, in the dark: contents, turning, targets, and nothing wider than the screen", async (t) => {
  const page = await openPage(t, { ...PHONE, colorScheme: "dark" });
  await page.locator("[data-action=menu]").tap();
  await page.locator("[data-item=lessons]").tap();
  await shows(page, first, 1);
  await page.locator(".lesson-contents").tap();
  await page.getByRole("link", { name: greedy.title }).tap();
  await shows(page, greedy, 1);
  for (const [lesson, step] of /** @type {[Lesson, number][]} */ ([[greedy, 3], [first, 2], [first, 3], [cell, 2], [cell, 3], [validity, 3], [corner, 2], [material, 1], [transform, 3], [overlaps, 2], [voxels, 1], [elements, 3], [precondition, 2]])) {
    await goTo(page, lesson, step);
    assert.deepEqual(await audit(page, lesson === greedy ? undefined : [".lesson"]), []);
    const wide = await page.locator(".lesson-scroll").evaluate((element) => element.scrollWidth > element.clientWidth);
    assert.equal(wide, false, `${lesson.name}, step ${step}`);
    const own = lesson.order < cell.order ? ["mine"] : (lesson === cell && step === 3) || lesson === corner ? ["coefficient"] : lesson === overlaps ? ["place"] : [];
    for (const name of ["back", "next", "open", "reset", "present", ...own]) {
      const box = await control(page, name).boundingBox();
      assert.ok(box && box.height >= 44, `${name} ${JSON.stringify(box)}`);
    }
  }
  await page.getByRole("link", { name: "Curves", exact: true }).tap();
  await eventually(async () => assert.ok(await page.locator("#inspector").isVisible()));
});
