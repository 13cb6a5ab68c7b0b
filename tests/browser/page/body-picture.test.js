import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { test } from "node:test";
import { PNG } from "pngjs";
import { audit } from "../support/axe.js";
import { SOFTWARE } from "../support/browser.js";
import { manyCells } from "../support/many-cells.js";
import { openPage } from "./open.js";
import { documentOf, drag, eventually, field, middle, pick, spoken, status, uiOf } from "./workbench.js";

/** @import { Page } from "playwright-core" */

/** @param {Page} page @param {string} name @param {number} value */
const slide = (page, name, value) =>
  page.locator(`[data-slider="${name}"]`).evaluate((input, text) => {
    /** @type {HTMLInputElement} */ (input).value = text;
    input.dispatchEvent(new Event("input", { bubbles: true }));
  }, String(value));

/** What the picture costs: draw calls and triangles. @param {Page} page */
const cost = (page) => page.locator(".body-stage [data-space]").evaluate((canvas) => ["calls", "triangles"].map((name) => Number(/** @type {HTMLElement} */ (canvas).dataset[name])));

const position = async (/** @type {Page} */ page) => Promise.all(["x", "y", "z"].map(async (axis) => Number(await field(page, `corner-${axis}`).inputValue())));

test("cells apart and seen through, how they continue, and a corner dragged by its gizmo", async (t) => {
  const page = await openPage(t, { allow: SOFTWARE, viewport: { width: 920, height: 700 }, hash: "#v=1&preset=hyperpatch-block" });
  await page.locator("[data-body=checked]").waitFor({ state: "attached" });
  const [, together] = await cost(page);

  const keys = page.locator("[data-body-keys]");
  await keys.focus();
  await page.keyboard.press("Enter");
  await eventually(async () => assert.match(await spoken(page), /^Cell \d, u /));

  // Six faces of eight cells rather than the 24 of the boundary.
  await slide(page, "body-apart", 0.5);
  await eventually(async () => assert.ok((await cost(page))[1] > together * 1.5, `${await cost(page)} after ${together}`));
  // What is read is what is drawn: from the front one looks between the cells.
  await keys.focus();
  await page.keyboard.press("6");
  await eventually(async () => assert.match(await spoken(page), /^Nothing of the body here/));
  await page.keyboard.press("Escape");
  await page.keyboard.press("5");
  await slide(page, "body-apart", 0);
  await eventually(async () => assert.ok((await cost(page))[1] < together * 1.5));

  // Every one of 12 inner faces continues smoothly at its four corners.
  await slide(page, "body-transparency", 0.6);
  await pick(page, "body-continuity", "shape");
  await eventually(async () => assert.match(await page.locator("[data-meeting=C1]").innerText(), /48$/));
  assert.match(await page.locator("[data-meeting=C0]").innerText(), /0$/);
  await eventually(async () => assert.equal(await page.locator("[data-meetings]").innerText(), "Corners of shared faces: 48 smooth, 0 with a crease"));
  assert.deepEqual(await audit(page), []);

  // The picture of it has the size asked for.
  await page.locator("[data-action=export]").click();
  await field(page, "body-width").fill("640");
  await field(page, "body-width").press("Enter");
  await field(page, "body-height").fill("480");
  await field(page, "body-height").press("Enter");
  assert.deepEqual(await audit(page), []);
  const [file] = await Promise.all([page.waitForEvent("download"), page.locator("[data-export=png]").click()]);
  assert.equal(file.suggestedFilename(), "block-of-eight.png");
  const { width, height, data } = PNG.sync.read(await readFile(await file.path()));
  assert.deepEqual([width, height], [640, 480]);
  const colors = new Set(Array.from({ length: width * height }, (_, n) => data.readUInt32BE(4 * n)));
  assert.ok(colors.size > 1000, `${colors.size} colours`);
  assert.deepEqual([...data.subarray(0, 4)], [255, 255, 255, 255]);
  await page.context().grantPermissions(["clipboard-read", "clipboard-write"]);
  await page.locator("[data-panel=export] [data-export=copy]").click();
  await eventually(async () => assert.match(await spoken(page), /The picture is copied/));
  assert.deepEqual(await page.evaluate(async () => (await navigator.clipboard.read()).flatMap(({ types }) => types)), ["image/png"]);
  await page.locator("[data-panel=export] [data-close]").click();

  // The corner in the middle of the block has 26 neighbours, which no other has.
  await keys.focus();
  for (let n = 1; n <= 27; n += 1) {
    await page.keyboard.press("PageDown");
    await eventually(async () => assert.match(await spoken(page), new RegExp(`^Corner ${n} of 27`)));
    if (/shared by 8 cells/.test(await spoken(page))) break;
  }
  await eventually(async () => assert.equal(((await page.locator(".body-grid-points").getAttribute("d")) ?? "").split("M").length - 1, 26));

  // Along z alone, by its arrow; Escape takes the drag back, and undo takes back a whole one.
  const before = (await documentOf(page)).operations;
  const start = await position(page);
  await drag(page, await middle(page.locator("[data-gizmo=z]")), [0, -30], { release: false });
  await eventually(async () => assert.ok((await position(page))[2] > start[2] + 0.02));
  await page.keyboard.press("Escape");
  await page.mouse.up();
  await eventually(async () => assert.deepEqual(await position(page), start));
  await drag(page, await middle(page.locator("[data-gizmo=z]")), [0, -30]);
  await eventually(async () => assert.ok((await position(page))[2] > start[2] + 0.02));
  assert.deepEqual((await position(page)).slice(0, 2), start.slice(0, 2));
  await drag(page, await middle(page.locator("[data-gizmo=xy]")), [20, 5]);
  await eventually(async () => assert.notEqual((await position(page))[0], start[0]));
  await page.locator("[data-action=undo]").click();
  await eventually(async () => assert.deepEqual((await position(page)).slice(0, 2), start.slice(0, 2)));
  await page.locator("[data-action=undo]").click();
  await eventually(async () => assert.deepEqual((await documentOf(page)).operations, before));

  // From the front, right is x and up is away; Home is up.
  await keys.focus();
  await page.keyboard.press("6");
  await page.keyboard.press("ArrowRight");
  await eventually(async () => assert.ok((await position(page))[0] > start[0]));
  await page.keyboard.press("ArrowUp");
  await eventually(async () => assert.ok((await position(page))[1] > start[1]));
  await page.keyboard.press("Home");
  await eventually(async () => assert.ok((await position(page))[2] > start[2]));

  // A reload comes back to the picture as it was left.
  await slide(page, "body-apart", 0.25);
  await eventually(async () => assert.equal((await uiOf(page)).body?.display.apart, 0.25));
  await page.reload();
  await page.locator("[data-body=checked]").waitFor({ state: "attached" });
  await eventually(async () => assert.equal(await page.locator("[data-slider=body-apart]").inputValue(), "0.25"));
  await page.locator("[data-meeting=C1]").waitFor();
  assert.equal((await uiOf(page)).body?.camera?.azimuth, -90);
});

test("400 cells are drawn in at most 12 calls and 400 000 triangles", async (t) => {
  const page = await openPage(t, { allow: SOFTWARE, viewport: { width: 920, height: 560 }, hash: "#v=1&preset=hyperpatch-cell" });
  const buffer = Buffer.from(JSON.stringify(manyCells(10, 8, 5)));
  await page.locator("input[data-file]").setInputFiles({ name: "many.json", mimeType: "application/json", buffer });
  await eventually(async () => assert.match(await status(page), /400\s+cells/));
  await slide(page, "body-apart", 0.3);
  await slide(page, "body-transparency", 0.3);
  await pick(page, "body-continuity", "material");
  await pick(page, "body-axis", "y");
  await page.locator('[data-cell="0"]').click();
  await page.locator("[data-cut=shown]").waitFor({ state: "attached" });
  await page.locator("[data-meeting=C1]").waitFor();
  const [calls, triangles] = await eventually(async () => {
    const found = await cost(page);
    assert.ok(found[1] > 400 * 6 * 2, `${found[1]} triangles`);
    return found;
  });
  assert.ok(calls <= 12, `${calls} draw calls`);
  assert.ok(triangles <= 400_000, `${triangles} triangles`);
  t.diagnostic(`${calls} draw calls, ${triangles} triangles`);
});
