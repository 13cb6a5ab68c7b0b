/** The feature list, the profile editor and the rules of a part. */
import assert from "node:assert/strict";
import { audit } from "../support/axe.js";
import { onOnePage } from "./one-page.js";
import { documentOf, drag, eventually, field, middle, pick, spoken } from "./workbench.js";

/** @import { Page } from "playwright-core" */

/** @param {Page} page @param {string} at body and place in the queue, such as `0.1` */
const row = (page, at) => page.locator(`[data-part-feature="${at}"]`);
/** @param {Page} page @param {string} id */
const handle = (page, id) => page.locator(`[data-plot-handle="${id}"]`);

/** The queue of the first body. @param {Page} page */
const queue = async (page) => (await documentOf(page)).bodies[0].features;
/** Waits until the names of the queue are these. @param {Page} page @param {string[]} names */
const names = (page, names) => eventually(async () => assert.deepEqual((await queue(page)).map((/** @type {any} */ each) => each.name), names));
/** Waits until something of the first feature of the queue holds. @param {Page} page @param {(feature: any) => void} look */
const first = (page, look) => eventually(async () => look((await queue(page))[0]));

/** Chooses a feature, and waits until the editor shows it. @param {Page} page @param {string} at @param {string} name */
async function choose(page, at, name) {
  await row(page, at).click();
  await eventually(async () => assert.equal(await field(page, "feature-name").inputValue(), name));
}

/** Opens a group that is closed. @param {Page} page @param {string} name */
async function opened(page, name) {
  const button = page.locator(`.part-groups [data-group-button=${name}]`);
  if ((await button.getAttribute("aria-expanded")) === "false") await button.click();
}

/** Waits until a row has the focus. @param {Page} page @param {string} key */
const focused = (page, key) => eventually(async () => assert.equal(await page.evaluate(() => /** @type {HTMLElement} */ (document.activeElement).dataset.key), key));

/** The picture's pixels as a sum, once the open document is measured: the same picture has the same one. @param {Page} page */
async function picture(page) {
  await page.locator(".part-stage[data-part=measured]").waitFor();
  return page.evaluate(() => {
    const canvas = /** @type {HTMLCanvasElement} */ (document.querySelector(".part-picture"));
    const copy = document.createElement("canvas");
    [copy.width, copy.height] = [200, 200];
    const context = copy.getContext("2d", { willReadFrequently: true });
    context?.drawImage(canvas, 0, 0, 200, 200);
    return [...(context?.getImageData(0, 0, 200, 200).data ?? [])].reduce((sum, value, n) => (sum * 31 + value * (n % 7)) % 1_000_003, 7);
  });
}

onOnePage("the features of a part", {
  async "are gone through, renamed, hidden, copied and deleted by keys"(page) {
    await choose(page, "0.0", "A");
    await page.keyboard.press("ArrowDown");
    await focused(page, "feature 0.1");
    await page.keyboard.press("Home");
    await focused(page, "body 0");
    await page.keyboard.press("b");
    await focused(page, "feature 0.1");
    await page.keyboard.press("F2");
    await page.locator("[data-tree-name]:visible").waitFor();
    await page.keyboard.type("below");
    await page.keyboard.press("Enter");
    await names(page, ["A", "below"]);
    await focused(page, "feature 0.1");
    await page.keyboard.press("Shift+F10");
    await page.locator("[data-item=duplicate]").click();
    await names(page, ["A", "below", "below 2"]);
    await focused(page, "feature 0.2");
    await page.keyboard.press("Delete");
    await names(page, ["A", "below"]);
    await row(page, "0.0").hover();
    await row(page, "0.0").locator(".tree-eye").click();
    await first(page, (feature) => assert.equal(feature.hidden, true));
    await page.locator("[data-action=undo]").click();
    await first(page, (feature) => assert.equal(feature.hidden, false));
  },

  async "change the printed picture when they are put in another order, and not the repaired one"(page) {
    await choose(page, "0.0", "A");
    const repaired = await picture(page);
    await page.keyboard.press("Alt+ArrowDown");
    await names(page, ["B", "A"]);
    await eventually(async () => assert.match(await spoken(page), /A is 2 of 2/));
    await eventually(async () => assert.equal(await picture(page), repaired));
    await pick(page, "part-rule", "printed");
    await eventually(async () => assert.equal(await page.locator("[data-part-order]").innerText(), "B \u2192 A"));
    await eventually(async () => assert.notEqual(await picture(page), repaired));
    const printed = await picture(page);
    const from = await middle(row(page, "0.1"));
    const to = await middle(page.locator('[data-part-default="0"]'));
    await drag(page, from, [0, to[1] + 10 - from[1]]);
    await names(page, ["A", "B"]);
    await eventually(async () => assert.notEqual(await picture(page), printed));
  },

  async "have a profile whose handles move by pointer and by keys"(page) {
    await choose(page, "0.0", "A");
    await handle(page, "to").scrollIntoViewIfNeeded();
    await drag(page, await middle(handle(page, "to")), [-40, 0]);
    await first(page, (feature) => assert.ok(feature.to > 15 && feature.to < 28, String(feature.to)));
    await handle(page, "end").focus();
    await page.keyboard.press("Shift+ArrowUp");
    await first(page, (feature) => assert.deepEqual(feature.end, [0.1, 0, 0.9]));
    await eventually(async () => assert.match(await page.locator("[data-part-meets]").innerText(), /led there over the last/));
    await page.locator("[data-action=meet-default]").click();
    await first(page, (feature) => assert.deepEqual(feature.end, [0, 0, 1]));
    await eventually(async () => assert.match(await page.locator("[data-part-meets]").innerText(), /meets the default/));
    await handle(page, "middle").scrollIntoViewIfNeeded();
    await drag(page, await middle(handle(page, "middle")), [0, 25]);
    await first(page, (feature) => assert.ok(feature.course.kind === "power" && feature.course.power < 0.8, JSON.stringify(feature.course)));
  },

  async "have keys that are added, moved and deleted"(page) {
    await choose(page, "0.0", "A");
    await page.locator("[data-select=part-course]").selectOption("piecewise");
    await first(page, (feature) => assert.deepEqual(feature.course.keys.map((/** @type {any} */ key) => key.at), [0, 0.5, 1]));
    await handle(page, "key 0").focus();
    await page.keyboard.press("Insert");
    await first(page, (feature) => assert.deepEqual(feature.course.keys.map((/** @type {any} */ key) => key.at), [0, 0.25, 0.5, 1]));
    await eventually(async () => assert.equal(await page.evaluate(() => /** @type {HTMLElement} */ (document.activeElement).dataset.plotHandle), "key 1"));
    await page.keyboard.press("ArrowUp");
    await first(page, (feature) => assert.equal(feature.course.keys[1].mix[0], 0.76));
    await page.keyboard.press("Delete");
    await first(page, (feature) => assert.equal(feature.course.keys.length, 3));
  },

  async "say where an expression is wrong, and go on with the last one that was right"(page) {
    await choose(page, "0.0", "A");
    await page.locator("[data-select=part-course]").selectOption("expression");
    await first(page, (feature) => assert.deepEqual(feature.course, { kind: "expression", text: "t" }));
    const text = field(page, "part-expression");
    await text.fill("t ^ 3");
    await first(page, (feature) => assert.equal(feature.course.text, "t ^ 3"));
    await text.fill("t ^ three");
    await eventually(async () => assert.match(await page.locator("#error-part-expression").innerText(), /character 5: .three. is not known/));
    assert.equal((await queue(page))[0].course.text, "t ^ 3");
    assert.deepEqual(await audit(page, [".part-tree", ".part-groups"]), []);
    await text.blur();
    await eventually(async () => assert.equal(await text.inputValue(), "t ^ 3"));
  },

  async "break design rules, which are counted, added and taken away"(page) {
    await opened(page, "rules");
    const rule = page.locator('[data-part-rule="0"]');
    await eventually(async () => assert.match(await rule.innerText(), /\d px/));
    await rule.click();
    await field(page, "rule-most").fill("5");
    await page.keyboard.press("Enter");
    await eventually(async () => assert.equal((await documentOf(page)).rules[0].most, 5));
    await eventually(async () => assert.match(await rule.innerText(), /kept/));
    await page.locator("[data-action=add-rule]").click();
    await eventually(async () => assert.equal((await documentOf(page)).rules.length, 2));
    await page.locator("[data-action=remove-rule]").click();
    await eventually(async () => assert.equal((await documentOf(page)).rules.length, 1));
  },

  async "lose a material to another one"(page) {
    await opened(page, "materials");
    const list = page.locator(".part-materials");
    await list.locator('[data-swatch="1"]').click();
    await list.locator('[data-remove="1"]').click();
    await list.locator('[data-replace="1"] [data-into="0"]').click();
    await eventually(async () => assert.deepEqual((await documentOf(page)).materials.map((/** @type {any} */ each) => each.name), ["red", "yellow"]));
    assert.deepEqual((await queue(page))[1].start, [1, 0]);
  },
}, { hash: "#v=1&preset=part-rectangle" });
