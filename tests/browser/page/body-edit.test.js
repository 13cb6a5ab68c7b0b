/** Bodies edited in the page, by pointer and by keyboard, against the kernel's own answers. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { load } from "directrix";
import { audit } from "../support/axe.js";
import { SOFTWARE } from "../support/browser.js";
import { openPage } from "./open.js";
import { presetFile } from "./sharing.js";
import { documentOf, eventually, field, middle, pick, spoken, status } from "./workbench.js";

/**
 * @import { Page } from "playwright-core"
 */

const dx = await load();

/** Waits until every check of the open body has run. @param {Page} page */
const checked = (page) => page.locator("[data-body=checked]").waitFor({ state: "attached" });

/** Operations besides the first one, which writes the cells of the preset out. @param {Page} page */
const added = async (page) => (await documentOf(page)).operations.slice(1);

/** @param {Page} page @param {string} name */
async function openGroup(page, name) {
  const button = page.locator(`[data-group-button="${name}"]`);
  if ((await button.getAttribute("aria-expanded")) === "false") await button.click();
  await eventually(async () => assert.equal(await button.getAttribute("aria-expanded"), "true"));
}

/** Chooses a corner of the block that so many cells have, by the keys of the picture. @param {Page} page @param {number} cells */
async function chooseCorner(page, cells) {
  const nth = dx.hyperpatch(presetFile("hyperpatch/block")).sharing().corners.findIndex(({ sides }) => sides.length === cells) + 1;
  await page.locator("[data-body-keys]").focus();
  await page.keyboard.press("Escape");
  for (let n = 1; n <= nth; n += 1) await page.keyboard.press("PageDown");
  const shared = cells === 1 ? "of one cell" : `shared by ${cells} cells`;
  await eventually(async () => assert.ok((await spoken(page)).startsWith(`Corner ${nth} of 27, ${shared}`)));
}

test("a body is edited by pointer and keys: corners, mixes, cells and the list of operations; invalid edits are asked about, and undo brings the bytes back", async (t) => {
  const page = await openPage(t, { allow: SOFTWARE, viewport: { width: 920, height: 560 }, hash: "#v=1&preset=hyperpatch-block" });
  await checked(page);
  const first = await documentOf(page);

  // The inner corner shows its 26 neighbours; one of them moves 17 others, and the body stays smooth.
  await chooseCorner(page, 8);
  await eventually(async () => assert.equal(await page.locator("[data-node]").count(), 27));
  await page.locator('[data-node][aria-pressed="true"]').focus();
  await page.keyboard.press("ArrowRight");
  await eventually(async () => assert.match(await page.locator("[data-group=corner]").innerText(), /Moves 18 coefficients/));
  await eventually(async () => assert.notEqual(await page.locator("[data-body-ghosts]").getAttribute("d"), ""));
  await field(page, "corner-y").focus();
  await page.keyboard.press("Shift+ArrowUp");
  await page.keyboard.press("Shift+ArrowUp");
  await field(page, "corner-y").blur();
  const [move] = await eventually(async () => {
    const list = await added(page);
    assert.deepEqual(list.map((/** @type {any} */ { op, by }) => [op, by[0], Number(by[1].toFixed(9)), by[2]]), [["move", 0, 0.4, 0]]);
    return list;
  });
  const neighbours = dx.hyperpatch(first).moves(move.cell, move.at);
  assert.equal(neighbours.length, 2 * (4 + 4 * 2 + 4), "18 points, as each of their cells has them");
  await checked(page);
  const smooth = dx.hyperpatch(await documentOf(page)).continuity();
  assert.ok(smooth.faces.every(({ shape }) => shape === "C1"));

  // Continuity is switched for the corner of one face.
  await pick(page, "joint-shape", "C0");
  await eventually(async () => assert.deepEqual((await added(page)).map((/** @type {any} */ { op, shape }) => [op, shape]).at(-1), ["continuity", "C0"]));
  await eventually(async () => assert.match(await spoken(page), /Shape: C0|Verified/));

  // The corner's block takes a mix in all its cells.
  await page.locator('[data-select="mix-mode"]').selectOption("corner");
  await field(page, "percent-2").fill("100");
  await field(page, "percent-2").press("Enter");
  const mixed = await eventually(async () => {
    const document = await documentOf(page);
    assert.deepEqual(document.operations.at(-1).mix, [0, 0, 1]);
    return document;
  });
  const { cell, corner } = mixed.operations.at(-1);
  assert.ok(Math.abs(dx.hyperpatch(mixed).sample(cell, corner).mix[2] - 1) < 1e-12);
  await page.locator('[data-slope="natural"]').click();
  await eventually(async () => assert.equal((await added(page)).at(-1).rule, "natural"));

  // The list of operations: the first one is changed upstream, put later, and taken out, by keys.
  await openGroup(page, "operations");
  await checked(page);
  const rows = page.locator("[data-operation-id]");
  await eventually(async () => assert.equal(await rows.count(), 5));
  await rows.nth(1).click();
  await field(page, "operation-by-y").fill("0.1");
  await field(page, "operation-by-y").press("Enter");
  await eventually(async () => assert.deepEqual((await added(page))[0].by, [0, 0.1, 0]));
  await rows.nth(1).focus();
  await page.keyboard.press("Alt+ArrowDown");
  await eventually(async () => assert.deepEqual((await added(page)).map((/** @type {any} */ { id }) => id), [2, 1, 3, 4]));
  await page.keyboard.press("Delete");
  await eventually(async () => assert.deepEqual((await added(page)).map((/** @type {any} */ { id }) => id), [2, 3, 4]));
  await checked(page);

  // Undo, entry by entry, gives the bytes of the preset.
  await eventually(async () => {
    await page.locator("[data-action=undo]").evaluate((button) => /** @type {HTMLElement} */ (button).click());
    assert.equal(JSON.stringify(await documentOf(page)), JSON.stringify(first));
  });
  await checked(page);

  // What turns a cell inside out is red while it is dragged, and taken back afterwards.
  await chooseCorner(page, 1);
  const refusal = page.locator("[data-refusal]");
  const from = await middle(page.locator("[data-gizmo=x]"));
  await page.mouse.move(from[0], from[1]);
  await page.mouse.down();
  // Along the arrow, to the other end of the body and beyond.
  const dot = await middle(page.locator("[data-gizmo=view]"));
  for (const share of [1, 3, 5, 7, 9]) await page.mouse.move(from[0] + (from[0] - dot[0]) * share, from[1] + (from[1] - dot[1]) * share);
  await eventually(async () => assert.match(await status(page), /invalid/));
  await refusal.waitFor();
  assert.equal(await page.locator("[data-invalid=back]").isVisible(), false);
  await eventually(async () => assert.ok((await page.locator("[data-body-witness]").count()) > 0));
  await page.mouse.up();
  await page.locator("[data-invalid=back]").click();
  await eventually(async () => assert.equal((await added(page)).length, 0));
  await refusal.waitFor({ state: "hidden" });
  await checked(page);

  // A copy beside the body, with its three checks.
  await page.locator('[data-cell="0"]').click();
  await openGroup(page, "build");
  await field(page, "build-x").fill("7");
  await field(page, "build-x").press("Enter");
  await page.locator("[data-build-apply]").click();
  await eventually(async () => assert.deepEqual(await added(page), [{ op: "copy", id: 1, cells: [0], by: [7, 0, 0] }]));
  await checked(page);
  const lines = page.locator("[data-group=build] [data-check]");
  await eventually(async () => assert.deepEqual(await lines.evaluateAll((all) => all.map((each) => each.getAttribute("data-ok"))), ["true", "true", "true"]));

  // Two faces of it are extruded, in one operation; the new cells are numbered after it.
  await page.locator('[data-cell="10000"]').click();
  await page.locator("[data-select=build]").selectOption("extrude");
  await page.locator('[data-face="w1"]').click();
  await page.locator('[data-face="u1"]').click();
  await page.locator("[data-build-apply]").click();
  await eventually(async () => assert.equal((await added(page))[1]?.faces.length, 2));
  await page.locator('[data-cell="20001"]').waitFor();
  assert.deepEqual(dx.hyperpatch(await documentOf(page)).operations.at(-1)?.made, [20000, 20001]);

  // A saved body is added where it lies.
  await page.locator("[data-select=build]").selectOption("import");
  const file = { name: "cell.json", mimeType: "application/json", buffer: Buffer.from(JSON.stringify(presetFile("hyperpatch/cell"))) };
  await page.locator("[data-add-body]").setInputFiles({ ...file, buffer: Buffer.from("[1, 2]") });
  await eventually(async () => assert.match(await page.locator("[data-add-error]").innerText(), /no document of hyperpatches/));
  await page.locator("[data-add-body]").setInputFiles(file);
  await eventually(async () => assert.equal((await added(page)).at(-1).op, "cells"));
  await checked(page);
  assert.equal(dx.hyperpatch(await documentOf(page)).cells.length, 8 + 1 + 2 + 1);
  assert.deepEqual(await audit(page), []);
});
