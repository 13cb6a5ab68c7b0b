/** Materials: any number up to 16, their colours, order and removal, and what takes the place of one. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { load } from "directrix";
import { audit } from "../support/axe.js";
import { onOnePage } from "./one-page.js";
import { openPage } from "./open.js";
import { documentOf, eventually, field } from "./workbench.js";

/** @import { Page } from "playwright-core" */

/** @param {Page} page */
const names = async (page) => (await documentOf(page)).materials.map((/** @type {{name: string}} */ { name }) => name);

/** @param {Page} page */
const undo = (page) => page.locator("[data-action=undo]").click();

onOnePage("materials", {
  "a material in use goes only with a choice of what replaces it": async (page) => {
    const before = await documentOf(page);
    await page.locator("[data-swatch='1']").click();
    await page.locator("[data-remove='1']").click();
    const group = page.locator("[data-replace='1']");
    assert.deepEqual(await group.locator("button").allTextContents(), ["Polymer", "Titanium", "Keep it"]);
    assert.deepEqual(await documentOf(page), before, "nothing happened yet");
    await group.getByText("Keep it").click();
    await eventually(async () => assert.ok(await group.isHidden()));
    await page.locator("[data-remove='1']").click();
    await group.getByText("Titanium").click();
    await eventually(async () => assert.deepEqual(await names(page), ["Polymer", "Titanium"]));
    const { curves } = await documentOf(page);
    assert.ok(curves[1].composition.every((/** @type {{mix: number[]}} */ { mix }) => mix[0] === 0 && mix[1] === 1));
    await undo(page);
    await eventually(async () => assert.deepEqual(await documentOf(page), before));
  },

  "palette, free colour, empty space and order": async (page) => {
    const before = await documentOf(page);
    await page.locator("[data-swatch='0']").click();
    await page.locator("[data-chip='0 #d55e00']").click();
    await eventually(async () => assert.equal((await documentOf(page)).materials[0].color, "#d55e00"));
    assert.equal(await page.locator("[data-chip='0 #d55e00']").getAttribute("aria-pressed"), "true");
    await page.locator("[data-color='0']").fill("#123456");
    await eventually(async () => assert.equal((await documentOf(page)).materials[0].color, "#123456"));
    await page.locator("[data-box=void-0]").check();
    await eventually(async () => assert.equal((await documentOf(page)).materials[0].void, true));
    await page.locator("[data-action=down-0]").click();
    await eventually(async () => assert.deepEqual(await names(page), ["Ceramic", "Polymer", "Titanium"]));
    const { curves } = await documentOf(page);
    assert.deepEqual(curves[0].composition[0].mix, [0, 1, 0], "the mixes follow");
    assert.ok(await page.locator("[data-action=down-1]").isVisible(), "the details go with it");
    for (let i = 0; i < 4; i += 1) await undo(page);
    await eventually(async () => assert.deepEqual(await documentOf(page), before));
  },

  "the legend is a triangle for three materials, strips for two, names for more": async (page) => {
    const legend = page.locator("#legend");
    await eventually(async () => assert.ok(await legend.locator(".legend-triangle").isVisible()));
    await page.locator("[data-holder='1-1']").click();
    await eventually(async () => assert.ok(await legend.locator(".legend-bar").isVisible()));
    await undo(page);
    await page.locator("[data-action=add-material]").click();
    await page.locator("[data-holder='0-3']").click();
    await page.locator("[data-action=compose]").click();
    await page.locator('[data-key="B1 key"]').click();
    await field(page, "percent-0").fill("20");
    await page.keyboard.press("Enter");
    await eventually(async () => assert.equal(await legend.locator(".legend-name").count(), 4));
    await page.locator("[data-action=compose]").click();
  },

  "up to sixteen materials, each of its own colour while there are some": async (page) => {
    const add = page.locator("[data-action=add-material]");
    for (let count = 4; count <= 16; count += 1) {
      await add.click();
      await eventually(async () => assert.equal((await names(page)).length, count));
    }
    await eventually(async () => assert.ok(await add.isDisabled()));
    const { materials, curves } = await documentOf(page);
    assert.equal(new Set(materials.slice(0, 8).map((/** @type {{color: string}} */ { color }) => color)).size, 8);
    assert.equal(curves[0].composition[0].mix.length, 16);
    await field(page, "material-15").fill("Foam");
    await page.keyboard.press("Enter");
    await page.locator("[data-holder='0-15']").click();
    await eventually(async () => assert.equal((await documentOf(page)).curves[0].composition[0].mix[15], 1));
    await page.locator("[data-swatch='3']").click();
    await page.locator("[data-remove='3']").click();
    await eventually(async () => assert.equal((await names(page)).length, 15));
    await page.locator("[data-verdict=verified]").waitFor();
  },
});

test("amounts stand below the materials, follow an edit when it is done, and count empty space apart", async (t) => {
  const page = await openPage(t);
  const dx = await load();
  const texts = async () => (await page.locator("[data-amounts] tr").allTextContents()).map((text) => text.replace(/\s/g, " "));
  /** What should stand there for the document as it is now. */
  const expected = async () => {
    const amounts = dx.amounts(await documentOf(page));
    assert.ok(amounts);
    return amounts.materials.map(({ name, void: empty, amount, share }) => {
      assert.ok(amount >= 1000 && amount < 9999.5, "written as a whole number");
      return `${name}${empty ? " (empty)" : ""}${amount.toFixed(0)} mm²${(100 * share).toFixed(1)} %`;
    });
  };
  await eventually(async () => assert.deepEqual((await texts()).slice(0, 3), await expected()));
  const [polymer] = await texts();
  const box = await page.locator('[data-handle="B3"]').boundingBox();
  assert.ok(box);
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await page.mouse.down();
  await page.mouse.move(box.x - 60, box.y + 60, { steps: 4 });
  await page.waitForTimeout(600);
  assert.equal((await texts())[0], polymer, "nothing moves while something is dragged");
  await page.mouse.up();
  await eventually(async () => assert.notEqual((await texts())[0], polymer));
  await eventually(async () => assert.deepEqual((await texts()).slice(0, 3), await expected()));
  await page.locator("[data-swatch='0']").click();
  await page.locator("[data-box=void-0]").check();
  await eventually(async () => {
    const [first, second, third, body, band] = await texts();
    assert.deepEqual([first, second, third], await expected());
    assert.match(body, /^Body/);
    assert.match(band, /^Band.*100\.0 %$/);
  });
  // A matching that is not whole has no band.
  await page.locator("[data-swatch='0']").click();
  await field(page, "y").fill("-20");
  await page.keyboard.press("Enter");
  await eventually(async () => assert.ok(await page.locator("[data-amounts]").isHidden()));
});

test("materials are accessible with details and choice open", async (t) => {
  const page = await openPage(t, { colorScheme: "dark" });
  await page.locator("[data-swatch='1']").click();
  await page.locator("[data-remove='1']").click();
  assert.deepEqual(await audit(page), []);
});
