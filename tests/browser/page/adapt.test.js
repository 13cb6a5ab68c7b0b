/**
 * What a person's own settings ask of the page: forced colours, more contrast, zoom to 400 %, wider text, and targets that can be hit.
 *
 * @import { Page } from "playwright-core"
 */
import assert from "node:assert/strict";
import { test } from "node:test";
import { openPage } from "./open.js";
import { eventually, pick } from "./workbench.js";

/** WCAG 2.2, 1.4.12. */
const SPACING =
  "* { line-height: 1.5 !important; letter-spacing: .12em !important; word-spacing: .16em !important } p { margin-bottom: 2em !important }";

/** A page of 1280 by 1024 at 400 %. */
const ZOOMED = { viewport: { width: 320, height: 256 } };

/**
 * Contrasts of what tells something by a fill or a ring against what lies beside it.
 * @param {Page} page
 * @param {[string, string, string, string][]} pairs selector and property, and those of the other
 */
const contrasts = (page, pairs) =>
  page.evaluate((all) => {
    const luminance = (/** @type {string} */ text) => {
      const [r = 0, g = 0, b = 0] = (text.match(/rgba?\(([^)]*)\)/)?.[1] ?? "").split(/[ ,/]+/).map((part) => {
        const value = Number(part) / 255;
        return value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4;
      });
      return 0.2126 * r + 0.7152 * g + 0.0722 * b;
    };
    const colour = (/** @type {string} */ place, /** @type {string} */ property) => {
      const [selector = "", pseudo] = place.split("::");
      const element = document.querySelector(selector);
      if (!element) throw new Error(`no ${selector}`);
      const value = getComputedStyle(element, pseudo ? `::${pseudo}` : undefined).getPropertyValue(property);
      if (!/rgb/.test(value) || /^rgba\([^)]*, 0\)$/.test(value)) throw new Error(`${place} has no ${property}: ${value}`);
      return luminance(value);
    };
    return all.map(([a, of, b, beside]) => {
      const [low = 0, high = 0] = [colour(a, of), colour(b, beside)].sort((p, q) => p - q);
      return { what: `${a} ${of} on ${b} ${beside}`, ratio: (high + 0.05) / (low + 0.05) };
    });
  }, pairs);

for (const colorScheme of /** @type {const} */ (["light", "dark"])) {
  test(`forced colours, ${colorScheme}: what is chosen, on, held or filled is seen`, async (t) => {
    const page = await openPage(t, { forcedColors: "active", colorScheme });
    await page.locator("[data-segment=mode]").waitFor();
    const segment = "[data-segment=mode] input:checked + span";
    const found = await contrasts(page, [
      [segment, "background-color", "#inspector", "background-color"],
      [segment, "color", segment, "background-color"],
      [".box input:checked", "background-color", "#inspector", "background-color"],
      [".box input:checked::before", "background-color", ".box input:checked", "background-color"],
      [".slider::before", "background-image", "#inspector", "background-color"],
      [".curve-row[aria-pressed=true]", "background-color", "#inspector", "background-color"],
      [".curve-row[aria-pressed=true] .aside", "color", ".curve-row[aria-pressed=true]", "background-color"],
      [".holder[aria-pressed=true]", "color", ".holder[aria-pressed=true]", "background-color"],
      ["[data-zoom=grid][aria-pressed=true]", "background-color", "#inspector", "background-color"],
      [".handle::before", "box-shadow", ".handle::before", "background-color"],
      [".handle.chosen::before", "background-color", "#inspector", "background-color"],
      ["[data-play]", "background-color", "#inspector", "background-color"],
      [".field", "border-top-color", "#inspector", "background-color"],
      [".verdict", "color", "#status", "background-color"],
      [".swatch", "box-shadow", "#inspector", "background-color"],
    ]);
    for (const { what, ratio } of found) assert.ok(ratio >= 3, `${what}: ${ratio.toFixed(2)}`);
    // Colours of materials are data and stay.
    assert.equal(await page.locator(".swatch").first().evaluate((e) => getComputedStyle(e).backgroundColor), "rgb(240, 228, 66)");
    await page.locator("[data-action=undo]").evaluate((e) => e.removeAttribute("disabled"));
    await page.locator("[data-action=file]").focus();
    await page.keyboard.press("Tab");
    const ring = await page.evaluate(() => {
      const { outlineStyle, outlineWidth, outlineColor } = getComputedStyle(/** @type {Element} */ (document.activeElement));
      return { outlineStyle, outlineWidth, outlineColor };
    });
    assert.equal(ring.outlineStyle, "solid");
    assert.equal(ring.outlineWidth, "2px");

    await pick(page, "mode", "compare");
    await page.locator(".method[aria-current]").waitFor();
    await page.locator(".chosen .bar-fill").first().waitFor();
    await pick(page, "mode", "steps");
    await page.locator(".steps-code [aria-current]").waitFor();
    const line = ".steps-code [aria-current]";
    const [lit, read] = await contrasts(page, [
      [line, "background-color", "#inspector", "background-color"],
      [line, "color", line, "background-color"],
    ]);
    assert.ok((lit?.ratio ?? 0) >= 3 && (read?.ratio ?? 0) >= 4.5, `${lit?.ratio} ${read?.ratio}`);
  });
}

test("more contrast: hairlines and quiet words are as strong as the others", async (t) => {
  const page = await openPage(t, { contrast: "more" });
  await page.locator("[data-segment=mode]").waitFor();
  const found = await contrasts(page, [
    [".row-label", "color", "#inspector", "background-color"],
    [".bar", "border-bottom-color", ".bar", "background-color"],
    [".field", "border-top-color", "#inspector", "background-color"],
  ]);
  const [label, hairline, outline] = found.map(({ ratio }) => ratio);
  assert.ok((label ?? 0) >= 7, `${label}`);
  assert.ok((hairline ?? 0) >= 3, `${hairline}`);
  assert.ok((outline ?? 0) >= 7, `${outline}`);
});

/**
 * Words that are cut off, that stand over the edge of their control, or that are beside the window.
 * @param {Page} page
 * @returns {Promise<string[]>}
 */
const lost = (page) =>
  page.evaluate(() => {
    /** @type {string[]} */
    const found = [];
    if (document.documentElement.scrollWidth > innerWidth) found.push(`the page is ${document.documentElement.scrollWidth} wide`);
    for (const element of document.querySelectorAll("body *")) {
      const words = [...element.childNodes].some((node) => node.nodeType === Node.TEXT_NODE && node.textContent?.trim());
      if (!words || element.closest("svg, .spoken, option")) continue;
      if (!element.checkVisibility({ opacityProperty: true, visibilityProperty: true })) continue;
      const { overflowX, overflowY, textOverflow } = getComputedStyle(element);
      const name = `${element.className || element.tagName} "${element.textContent?.slice(0, 40)}"`;
      // What stands beside a closed group or a title repeats what is in it.
      const repeats = element.matches(".aside, .mix-name") && textOverflow === "ellipsis";
      if (repeats) continue;
      if (overflowX !== "visible" && element.scrollWidth > element.clientWidth + 1) found.push(`cut: ${name}`);
      if (overflowY === "hidden" && element.scrollHeight > element.clientHeight + 2) found.push(`cut below: ${name}`);
      const range = document.createRange();
      range.selectNodeContents(element);
      const text = range.getBoundingClientRect();
      if (text.width > 0 && (text.right > innerWidth + 1 || text.left < -1)) found.push(`beside the window: ${name}`);
      const control = element.closest("button, .segment span, .field");
      if (!control || control.matches(".method")) continue;
      const box = control.getBoundingClientRect();
      if (text.height > box.height + 2 || text.width > box.width + 2) found.push(`over its control: ${name}`);
    }
    return found;
  });

/** @param {Page} page @param {() => Promise<void>} look */
async function inEveryMode(page, look) {
  for (const mode of ["figure", "compare", "steps"]) {
    // A click on its word, which at this size may be behind something: the test of focus looks after that.
    await page.locator(`[data-segment=mode] input[value=${mode}]`).evaluate((input) => /** @type {HTMLElement} */ (input).click());
    await page.waitForSelector(mode === "figure" ? "html:is([data-mode=figure], :not([data-mode]))" : `html[data-mode=${mode}]`);
    if (mode === "compare") await page.locator(".method-eta:not(:empty)").nth(5).waitFor();
    if (mode === "steps") await page.locator(".steps-buttons").waitFor();
    await eventually(look);
  }
}

for (const viewport of [ZOOMED.viewport, { width: 320, height: 640 }]) {
  test(`at 400 %, ${viewport.width} x ${viewport.height}, nothing is cut off, and nothing wants a second direction of scrolling`, async (t) => {
    const page = await openPage(t, { viewport });
    await page.locator("[data-segment=mode]").waitFor();
    await inEveryMode(page, async () => {
      for (const stop of ["half", "full", "low"]) {
        await page.evaluate((at) => (document.documentElement.dataset.sheet = at), stop);
        if (stop === "low") continue;
        assert.deepEqual(await lost(page), [], stop);
      }
    });
  });
}

test("wider text does not cut anything off", async (t) => {
  const page = await openPage(t);
  await page.locator("[data-segment=mode]").waitFor();
  await page.addStyleTag({ content: SPACING });
  await inEveryMode(page, async () => assert.deepEqual(await lost(page), []));
});

test("at 400 % the sheet can be used, and what has the focus is never below it", async (t) => {
  const page = await openPage(t, ZOOMED);
  const grip = page.locator("[data-grip]");
  const height = () => page.locator("#inspector").evaluate((sheet) => sheet.getBoundingClientRect().height);
  await eventually(async () => assert.ok((await height()) < 60));
  // The canvas has the larger part of what is left by the bar.
  assert.ok((await page.locator("#stage").evaluate((stage) => stage.getBoundingClientRect().height)) > 150);
  await grip.focus();
  await page.keyboard.press("ArrowUp");
  await page.keyboard.press("ArrowUp");
  await eventually(async () => assert.ok((await height()) > 200));
  // Everything in the group can be scrolled to.
  const last = page.locator("#groups .group:not([hidden]) :is(button, input, select, summary)").last();
  await last.scrollIntoViewIfNeeded();
  assert.ok(await last.evaluate((element) => {
    const { top, bottom } = element.getBoundingClientRect();
    return top >= 0 && bottom <= innerHeight;
  }));

  /** What lies on the middle of what has the focus, where it is another element. */
  const covered = () =>
    page.evaluate(() => {
      const focused = document.activeElement;
      if (!focused || focused === document.body || focused.matches("#probe-keys, .draw-keys")) return null;
      const target = focused.matches(".segment input, .slider input") ? (focused.closest("label, .slider") ?? focused) : focused;
      const { left, right, top, bottom } = target.getBoundingClientRect();
      const on = document.elementFromPoint((left + right) / 2, (top + bottom) / 2);
      const clear = on && (target.contains(on) || on.contains(target) || on.closest("#overlay, #stage svg"));
      return clear && bottom > 0 && top < innerHeight ? null : `${focused.outerHTML.slice(0, 120)} under ${on?.outerHTML.slice(0, 80)}`;
    });
  const sheet = () => page.evaluate(() => document.documentElement.dataset.sheet);
  await page.locator("[data-handle=B3]").focus();
  await eventually(async () => assert.equal(await sheet(), "low"));
  await page.locator("[data-action=menu]").focus();
  for (let i = 0; i < 24; i += 1) {
    await page.keyboard.press("Tab");
    // The sheet takes a moment to get out of the way.
    await eventually(async () => assert.equal(await covered(), null));
  }
  await page.locator("#groups [role=tab][aria-selected=true]").focus();
  await eventually(async () => assert.notEqual(await sheet(), "low"));
});

/**
 * Targets smaller than they may be: what is seen, and what is added to it invisibly.
 * @param {Page} page
 * @param {number} least CSS pixels
 */
const small = (page, least) =>
  page.evaluate((side) => {
    /** @type {string[]} */
    const found = [];
    for (const element of document.querySelectorAll("button, input, select, a[href], [role=tab], summary")) {
      if (!element.checkVisibility({ visibilityProperty: true }) || element.closest(".spoken")) continue;
      const whole =
        (element.matches("[type=checkbox]") && element.closest("label")) ||
        (element.matches(".field :is(input, select)") && element.closest(".field")) ||
        element;
      const { width, height } = whole.getBoundingClientRect();
      const { content, top, right, bottom, left } = getComputedStyle(whole, "::after");
      const grown = content === "none" || content === "normal" ? [0, 0, 0, 0] : [top, right, bottom, left].map((part) => -parseFloat(part) || 0);
      const [up = 0, east = 0, down = 0, west = 0] = grown.map((part) => Math.max(0, part));
      if (width + east + west < side - 0.5 || height + up + down < side - 0.5) {
        found.push(`${width} x ${height}: ${element.outerHTML.slice(0, 120)}`);
      }
    }
    return found;
  }, least);

for (const [name, least, options] of /** @type {const} */ ([
  ["a pointer", 24, {}],
  ["a finger on a phone", 44, { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true }],
  ["a finger on a tablet", 44, { viewport: { width: 1000, height: 760 }, hasTouch: true, isMobile: true }],
])) {
  test(`targets for ${name} are at least ${least} pixels either way`, async (t) => {
    const page = await openPage(t, options);
    await page.locator("[data-segment=mode]").waitFor();
    await eventually(async () => assert.deepEqual(await small(page, least), []));
  });
}
