import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { test } from "node:test";
import { load } from "directrix";
import { PNG } from "pngjs";
import { audit } from "../support/axe.js";
import { exported, openExport } from "./exporting.js";
import { onOnePage } from "./one-page.js";
import { openPage } from "./open.js";
import { documentOf, eventually, field, handle, pick } from "./workbench.js";

/**
 * @import { Page } from "playwright-core"
 */

/** Types a size into the fields. @param {Page} page @param {number} width @param {number} height */
async function size(page, width, height) {
  for (const [name, value] of /** @type {const} */ ([["width", width], ["height", height]])) {
    await field(page, `export-${name}`).fill(String(value));
    await page.keyboard.press("Enter");
  }
}

/** @param {Page} page */
const png = async (page) => PNG.sync.read(await exported(page, "png"));

/** The pixel at a place. @param {PNG} picture @param {number} x @param {number} y */
const pixel = ({ data, width }, x, y) => [...data.subarray((y * width + x) * 4, (y * width + x) * 4 + 4)];

test("a PNG has the size asked for, in the colours and on the ground asked for", async (t) => {
  const page = await openPage(t);
  await openExport(page, "png");
  const stage = await page.locator("#stage").evaluate((element) => [element.clientWidth, element.clientHeight]);
  for (const scale of [1, 2]) {
    await pick(page, "export-scale", String(scale));
    const { width, height } = await png(page);
    assert.deepEqual([width, height], stage.map((side) => side * scale));
  }
  await pick(page, "export-scale", "4");
  assert.equal(await field(page, "export-width").inputValue(), "4096", "no side is above the limit");
  const large = await png(page);
  assert.deepEqual([large.width, large.height], [4096, Math.round((stage[1] * 4096) / stage[0])]);
  await page.locator("[data-box=grid]").uncheck();
  await size(page, 320, 200);
  const light = await png(page);
  assert.deepEqual([light.width, light.height, ...pixel(light, 3, 3)], [320, 200, 255, 255, 255, 255]);
  await pick(page, "export-theme", "dark");
  assert.deepEqual(pixel(await png(page), 3, 3), [14, 15, 18, 255]);
  await page.locator("[data-box=export-transparent]").check();
  const bare = await png(page);
  assert.equal(pixel(bare, 3, 3)[3], 0);
  assert.ok(new Set(new Uint32Array(bare.data.buffer)).size > 1000);
});

onOnePage("exports", {
  "two presses of Enter on Export download the picture": async (page) => {
    await page.locator("[data-action=export]").focus();
    await page.keyboard.press("Enter");
    await page.locator("[data-export=download]:focus").waitFor();
    const download = page.waitForEvent("download");
    await page.keyboard.press("Enter");
    const file = await download;
    assert.equal(file.suggestedFilename(), "amoeba.png");
    assert.equal((await readFile(await file.path())).subarray(1, 4).toString("latin1"), "PNG");
    await page.keyboard.press("Escape");
    assert.ok(await page.locator("[data-action=export]").evaluate((element) => element === document.activeElement));
  },
  "a PNG shows the same as the kernel paints for the view and the layers on the screen": async (page) => {
    await page.locator("[data-box=samples]").uncheck();
    await page.locator("[data-zoom=plus]").click();
    await openExport(page, "png");
    await pick(page, "export-scale", "1");
    const picture = await png(page);
    const [document, ui] = [await documentOf(page), await page.evaluate(() => history.state.ui)];
    const dx = await load({ module: "figure" });
    const { width, height } = picture;
    const { layers, s, view, isoMaterial } = ui;
    const same = dx.paint(document, { width, height, layers, s, view, isoMaterial, theme: "light", line: null });
    assert.deepEqual(Buffer.compare(Buffer.from(picture.data), Buffer.from(same.data)), 0);
  },
  "sizes out of range are refused beside the field, tiny pictures work": async (page) => {
    await openExport(page, "png");
    await field(page, "export-width").fill("5000");
    assert.match(await page.locator("#error-export-width").innerText(), /16 to 4\s?096/);
    await size(page, 16, 16);
    const { width, height } = await png(page);
    assert.deepEqual([width, height], [16, 16]);
  },
  "tables hold what the kernel says, digit for digit": async (page) => {
    const dx = await load();
    await page.locator("[data-select=method]").selectOption("greedy");
    await page.locator("[data-box=one-to-one]").uncheck();
    const document = await documentOf(page);
    const [match, stages] = [dx.match(document), dx.stages(document)];
    const rows = (/** @type {Buffer} */ text) => text.toString("utf8").trimEnd().split("\n").map((line) => line.split(","));
    const [head, ...lines] = rows(await exported(page, "csv"));
    assert.deepEqual(head, ["line", "u", "v", "x1", "y1", "x2", "y2", "value", "cosine", "length", "visible"]);
    assert.equal(lines.length, match.lines.length);
    lines.forEach((cells, i) => {
      const { from, to, value } = match.lines[i];
      const [, u, v, x1, y1, x2, y2, f] = cells.map(Number);
      assert.deepEqual([u, v], [match.samples[0].parameters[from], match.samples[1].parameters[to]]);
      assert.deepEqual([x1, y1, x2, y2], [...match.samples[0].points[from], ...match.samples[1].points[to]]);
      assert.equal(f, value);
    });
    await pick(page, "export-table", "stages");
    const [names, ...points] = rows(await exported(page, "csv"));
    assert.deepEqual(names, ["stage", "s", "x", "y"]);
    const expected = stages.flatMap(({ s, points: all }, i) => all.map(([x, y]) => [i, s, x, y]));
    assert.deepEqual(points.map((cells) => cells.map(Number)), expected);
    await pick(page, "export-table", "cells");
    const [columns, ...cells] = rows(await exported(page, "csv"));
    assert.deepEqual([columns[2], columns[10], ...columns.slice(14)], ["x1 [mm]", "area [mm²]", "Polymer", "Ceramic", "Titanium"]);
    const found = dx.cells(document);
    assert.deepEqual(cells.map((row) => Number(row[10])), found.map(({ area }) => area));
    await openExport(page, "json");
    await pick(page, "export-content", "cells");
    const told = JSON.parse((await exported(page, "json")).toString("utf8"));
    assert.deepEqual(told.cells.map((/** @type {any} */ cell) => Object.values(cell.mix)), found.map(({ fractions }) => fractions));
  },
  "tables of what cannot be matched say why beside the button": async (page) => {
    // One point across the whole figure makes the outer curve cross itself.
    const { curves } = await documentOf(page);
    const [x, y] = curves[1].points[Math.floor(curves[1].points.length / 2)];
    await handle(page, "B1").focus();
    for (const [name, value] of /** @type {const} */ ([["x", x * 1.6], ["y", y * 1.6]])) {
      await field(page, name).fill(String(value));
      await page.keyboard.press("Enter");
    }
    await page.waitForSelector("#status[data-verdict=error]");
    await openExport(page, "csv");
    await pick(page, "export-table", "stages");
    await page.locator("[data-export=download]").click();
    await eventually(async () => assert.match(await page.locator("[data-panel=export] [data-message]").innerText(), /did not work: .+/));
  },
  "an SVG has the colours asked for": async (page) => {
    const light = (await exported(page, "svg")).toString("utf8");
    assert.match(light, /^(<\?xml[^>]*>\s*)?<svg/);
    await pick(page, "export-theme", "dark");
    const dark = (await exported(page, "svg")).toString("utf8");
    assert.notEqual(light, dark);
    assert.match(dark, /#0e0f12/i);
    await page.locator("[data-box=export-transparent]").check();
    assert.doesNotMatch((await exported(page, "svg")).toString("utf8"), /#0e0f12/i);
  },
});

test("pictures and texts go to the clipboard", async (t) => {
  const page = await openPage(t, { permissions: ["clipboard-read", "clipboard-write"] });
  await openExport(page, "png");
  await size(page, 320, 200);
  const message = page.locator("[data-panel=export] [data-message]");
  const copy = async () => {
    await page.locator("[data-export=copy]").click();
    await eventually(async () => assert.equal(await message.innerText(), "Copied to the clipboard"));
  };
  await copy();
  const [types, width] = await page.evaluate(async () => {
    const [item] = await navigator.clipboard.read();
    const picture = await createImageBitmap(await item.getType("image/png"));
    return [item.types, picture.width];
  });
  assert.deepEqual([types, width], [["image/png"], 320]);
  for (const [format, looks] of /** @type {const} */ ([["svg", /^<svg/], ["csv", /^line,u,v/], ["json", /^{\n {2}"directrix": 1/]])) {
    await openExport(page, format);
    await copy();
    assert.match(await page.evaluate(() => navigator.clipboard.readText()), looks);
  }
});

test("a clipboard that refuses is told beside the button", async (t) => {
  const page = await openPage(t, {
    init: `Clipboard.prototype.write = () => Promise.reject(new DOMException("Write permission denied.", "NotAllowedError"))`,
  });
  await openExport(page, "svg");
  await page.locator("[data-export=copy]").click();
  const message = page.locator("[data-panel=export] [data-message]");
  await eventually(async () => assert.equal(await message.innerText(), "That did not work: Write permission denied."));
  await pick(page, "export-format", "png");
  assert.ok(await message.isHidden());
});

test("the export is clean to axe, light and dark, large and small", async (t) => {
  for (const [colorScheme, width] of /** @type {const} */ ([["light", 1440], ["dark", 390]])) {
    const page = await openPage(t, { colorScheme, viewport: { width, height: 844 }, hasTouch: width < 600 });
    if (width < 600) {
      await page.locator("[data-action=menu]").click();
      await page.locator("[data-item=export]").click();
    } else await page.locator("[data-action=export]").click();
    await page.locator("[data-panel=export]").waitFor();
    assert.deepEqual(await audit(page), []);
    if (width > 600) continue;
    const heights = await page.locator("[data-export]").evaluateAll((all) => all.map((each) => each.getBoundingClientRect().height));
    assert.deepEqual(heights, [44, 44]);
  }
});
