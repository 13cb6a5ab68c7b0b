/**
 * The page as the tests see it: by roles, names and data attributes, never by pixel positions of its own.
 *
 * @import { Page } from "playwright-core"
 */
import assert from "node:assert/strict";

/** Milliseconds after which a wait is a failure. */
const PATIENCE = 10_000;

/**
 * Waits until the first figure is painted and its certificates stand.
 * @param {Page} page
 */
export async function ready(page) {
  await page.waitForSelector("html[data-ready=true]", { timeout: PATIENCE });
  await page.waitForSelector("#status[data-verdict]:not([data-verdict=none])", { timeout: PATIENCE });
  // What the page fetches after its first figure, such as what listens to files.
  await page.waitForSelector(".modes", { state: "attached", timeout: PATIENCE });
}

/**
 * Repeats a look at the page until it passes.
 * @template T
 * @param {() => Promise<T>} look throws while it does not hold
 * @returns {Promise<T>}
 */
export async function eventually(look) {
  const end = Date.now() + PATIENCE;
  for (;;) {
    try {
      return await look();
    } catch (error) {
      if (Date.now() > end) throw error;
      await new Promise((done) => setTimeout(done, 40));
    }
  }
}

/**
 * Waits until the page has drawn what it holds: it draws once a frame, some time after the state has changed.
 * @param {Page} page
 */
export function drawn(page) {
  return page.evaluate(
    () =>
      new Promise((done) => {
        // A page in the background has no frames, and nobody reads places off it.
        setTimeout(done, 200);
        requestAnimationFrame(() => setTimeout(done));
      }),
  );
}

/**
 * What the page would keep across a reload, once it is drawn.
 * @param {Page} page
 * @returns {Promise<any>}
 */
function kept(page) {
  return eventually(async () => {
    await drawn(page);
    const state = await page.evaluate(() => {
      dispatchEvent(new Event("pagehide"));
      return history.state;
    });
    // An entry that was just gone to is written once the page has done what its address says.
    assert.ok(state, "the page keeps nothing yet");
    return state;
  });
}

/**
 * The open document, as the page would keep it across a reload.
 * @param {Page} page
 * @returns {Promise<any>}
 */
export const documentOf = async (page) => (await kept(page)).document;

/**
 * What the page keeps besides the document.
 * @param {Page} page
 * @returns {Promise<any>}
 */
export const uiOf = async (page) => (await kept(page)).ui;

/**
 * Takes one choice of a row of choices, as a click on its word does.
 * @param {Page} page
 * @param {string} name of the row
 * @param {string} value
 */
export async function pick(page, name, value) {
  const input = page.locator(`[data-segment=${name}] input[value="${value}"]`);
  await input.waitFor();
  // Its word lies over the input, which Playwright takes for something in the way.
  await input.check({ force: true });
  await drawn(page);
}

/** @param {Page} page @param {string} name such as `A1` */
export const handle = (page, name) => page.locator(`[data-handle="${name}"]`);

/** @param {Page} page @param {number} curve */
export const outline = (page, curve) => page.locator(`[data-outline="${curve}"]`);

/** @param {Page} page @param {string} name */
export const field = (page, name) => page.locator(`input[data-field="${name}"]`);

/**
 * The coordinates in the name of a handle.
 * @param {Page} page
 * @param {string} name
 * @returns {Promise<[number, number]>}
 */
export async function coordinates(page, name) {
  const label = await handle(page, name).getAttribute("aria-label");
  const found = /x (\S+), y (\S+)$/.exec((label ?? "").replaceAll("\u2212", "-"));
  assert.ok(found, `the handle ${name} has no coordinates in "${label}"`);
  return [Number(found[1]), Number(found[2])];
}

/**
 * Chooses a point by the keyboard, and waits until the fields show it: what is typed before would be taken back.
 * @param {Page} page
 * @param {string} name
 */
export async function choosePoint(page, name) {
  const { curves } = await documentOf(page);
  const [x, y] = curves["AB".indexOf(name[0])].points[Number(name.slice(1)) - 1];
  await handle(page, name).focus();
  const value = async (/** @type {string} */ axis) => Number((await field(page, axis).inputValue()).replace("\u2212", "-"));
  await eventually(async () => assert.deepEqual([await value("x"), await value("y")], [x, y]));
}

/**
 * The middle of an element on the screen.
 * @param {import("playwright-core").Locator} locator
 * @returns {Promise<[number, number]>}
 */
export async function middle(locator) {
  const box = await locator.boundingBox();
  assert.ok(box, "the element is not on the screen");
  return [box.x + box.width / 2, box.y + box.height / 2];
}

/**
 * Presses at one place, moves by steps, and lets go.
 * @param {Page} page
 * @param {[number, number]} from
 * @param {[number, number]} by
 * @param {{release?: boolean}} [options]
 */
export async function drag(page, from, by, { release = true } = {}) {
  await page.mouse.move(from[0], from[1]);
  await page.mouse.down();
  for (const part of [0.25, 0.5, 0.75, 1]) await page.mouse.move(from[0] + by[0] * part, from[1] + by[1] * part);
  if (release) await page.mouse.up();
}

/**
 * A place of a curve's outline on the screen, away from its handles.
 * @param {Page} page
 * @param {number} curve
 * @returns {Promise<[number, number]>}
 */
export function onOutline(page, curve) {
  return page.evaluate((index) => {
    const path = /** @type {SVGPathElement} */ (document.querySelector(`[data-outline="${index}"]`));
    const frame = /** @type {HTMLElement} */ (document.querySelector("#stage")).getBoundingClientRect();
    const handles = [...document.querySelectorAll("[data-handle]")].map((each) => {
      const box = each.getBoundingClientRect();
      return [box.x + box.width / 2, box.y + box.height / 2];
    });
    const length = path.getTotalLength();
    let best = { clear: -1, x: 0, y: 0 };
    for (let i = 0; i < 200; i += 1) {
      const point = path.getPointAtLength((length * i) / 200);
      const [x, y] = [point.x + frame.x, point.y + frame.y];
      const clear = Math.min(...handles.map(([hx = 0, hy = 0]) => Math.hypot(hx - x, hy - y)));
      if (clear > best.clear) best = { clear, x, y };
    }
    return /** @type {[number, number]} */ ([best.x, best.y]);
  }, curve);
}

/** The text of the status line. @param {Page} page */
export const status = (page) => page.locator("#status").innerText();

/** What was spoken last. @param {Page} page */
export const spoken = async (page) =>
  ((await page.locator("#speech").textContent()) ?? "").replaceAll("\u00a0", " ").trim();

/**
 * Where a handle stands in document units follows from two handles and the screen; this is the scale in pixels per unit.
 * @param {Page} page
 */
export async function scaleOf(page) {
  const [a, b] = [await coordinates(page, "B1"), await coordinates(page, "B4")];
  const [p, q] = [await middle(handle(page, "B1")), await middle(handle(page, "B4"))];
  return Math.hypot(p[0] - q[0], p[1] - q[1]) / Math.hypot(a[0] - b[0], a[1] - b[1]);
}
