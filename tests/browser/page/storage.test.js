import assert from "node:assert/strict";
import { test } from "node:test";
import { auditThemes } from "../support/axe.js";
import { body, heads, keptNow, nudge, openRecent, preset, stored } from "./kept.js";
import { openPage } from "./open.js";
import { coordinates, documentOf, drag, eventually, field, handle, middle, ready } from "./workbench.js";

test("work is kept a pause after the last edit, and a preset that is only looked at is not", async (t) => {
  const page = await openPage(t);
  await preset(page, "star-in-circle");
  await page.waitForTimeout(1200);
  assert.deepEqual(await stored(page), {});
  await nudge(page);
  const early = Date.now();
  const id = await keptNow(page);
  assert.ok(Date.now() - early > 500, "not before the pause is over");
  const [head] = await heads(page);
  assert.equal(head.title, "Star in circle");
  assert.equal(head.id, id);
  await eventually(async () => assert.match((await heads(page))[0].thumbnail.light, /^data:image\/png;base64,/));
});

test("nothing is written while a drag lasts, however long", async (t) => {
  const page = await openPage(t);
  await drag(page, await middle(handle(page, "B3")), [-20, 12], { release: false });
  await page.waitForTimeout(2500);
  assert.deepEqual(await stored(page), {});
  await page.mouse.up();
  await keptNow(page);
});

test("a closed document is restored from the recent ones, with its picture, its view and what it was", async (t) => {
  const page = await openPage(t);
  await nudge(page);
  await page.locator("[data-box=normals]").check();
  const work = await documentOf(page);
  // Opened over it at once: what was not kept yet is kept now.
  await preset(page, "u-in-oval");
  await eventually(async () => assert.equal((await heads(page)).length, 1));
  await openRecent(page);
  const row = page.locator("[data-document]");
  assert.equal(await row.count(), 1);
  assert.match(await row.innerText(), /Amoeba\s+just now · not in a file/);
  await row.locator("[data-open]").click();
  await eventually(async () => assert.deepEqual(await documentOf(page), work));
  assert.equal(await page.locator("[data-panel=recent]").count(), 0);
  assert.ok(await page.locator("[data-box=normals]").isChecked());
  assert.equal(await page.locator("[data-state]").textContent(), "Edited");
  await nudge(page);
  await keptNow(page);
});

test("thumbnails are small pictures of the document, one for each theme", async (t) => {
  const page = await openPage(t);
  await nudge(page);
  await eventually(async () => assert.ok((await heads(page))[0]?.thumbnail));
  await openRecent(page);
  const pictures = page.locator("[data-document] img");
  const shown = (/** @type {boolean[]} */ wanted) =>
    eventually(async () => assert.deepEqual(await pictures.evaluateAll((all) => all.map((each) => getComputedStyle(each).display !== "none")), wanted));
  await shown([true, false]);
  await page.locator("[data-action=theme]").click();
  await shown([false, true]);
  const colors = await pictures.last().evaluate(async (image) => {
    const picture = /** @type {HTMLImageElement} */ (image);
    await picture.decode();
    const canvas = new OffscreenCanvas(picture.naturalWidth, picture.naturalHeight);
    const context = /** @type {OffscreenCanvasRenderingContext2D} */ (canvas.getContext("2d"));
    context.drawImage(picture, 0, 0);
    const { data } = context.getImageData(0, 0, canvas.width, canvas.height);
    return { width: canvas.width, colors: new Set(new Uint32Array(data.buffer)).size, corner: data[3] };
  });
  assert.equal(colors.width, 168);
  assert.ok(colors.colors > 300, `${colors.colors} colours`);
  assert.equal(colors.corner, 0, "the ground is the page's own");
});

test("deleted documents can be restored, at once and later, or deleted for good", async (t) => {
  const page = await openPage(t);
  await nudge(page);
  const id = await keptNow(page);
  await preset(page, "u-in-oval");
  await openRecent(page);
  const remove = page.locator(`[data-document="${id}"] [data-delete]`);
  await remove.click();
  await page.locator("[data-bin]").waitFor();
  assert.match(await page.locator("[data-message]").innerText(), /Deleted Amoeba/);
  await page.keyboard.press("Enter");
  await eventually(async () => assert.equal(await page.locator("[data-bin]").isVisible(), false));
  await page.locator(`[data-document="${id}"] [data-open]`).focus();
  await page.keyboard.press("Delete");
  await page.locator("[data-bin]").waitFor();
  await page.locator("[data-panel] [data-close]").click();
  await openRecent(page);
  await page.locator("[data-bin-act=restore]").click();
  await eventually(async () => assert.equal((await heads(page))[0].deleted, null));
  await remove.click();
  await page.locator("[data-bin-act=erase]").click();
  await eventually(async () => assert.deepEqual(await stored(page), {}));
  assert.ok(await page.getByText("Nothing yet").isVisible());
});

test("every stored version opens again, as a document of its own", async (t) => {
  const page = await openPage(t);
  await page.clock.install();
  await nudge(page);
  await page.clock.runFor(1000);
  const id = await keptNow(page);
  const states = [await page.evaluate(() => history.state.document)];
  for (let i = 0; i < 3; i += 1) {
    await page.clock.runFor(11 * 60_000);
    await nudge(page);
    await page.clock.runFor(1000);
    await eventually(async () => assert.equal((await heads(page))[0].versions.length, i + 1));
    states.push(body(await stored(page), id));
  }
  for (let i = 0; i < 3; i += 1) {
    await openRecent(page);
    await page.locator(`[data-document="${id}"] [data-versions]`).click();
    const versions = page.locator("[data-version]");
    await eventually(async () => assert.equal(await versions.count(), 3));
    await versions.nth(2 - i).click();
    await page.clock.runFor(1000);
    await eventually(async () => assert.deepEqual((await documentOf(page)).curves, states[i].curves));
    assert.equal((await documentOf(page)).title, "Amoeba (copy)");
  }
  assert.deepEqual(body(await stored(page), id), states[3], "the document itself stays");
});

test("a reload goes on with the same document", async (t) => {
  const page = await openPage(t);
  await nudge(page);
  const id = await keptNow(page);
  await page.reload();
  await ready(page);
  await nudge(page);
  assert.equal(await keptNow(page), id);
  assert.equal(await field(page, "title").inputValue(), "Amoeba");
});

test("a reload in the moment after an edit loses nothing and makes no copy", async (t) => {
  const page = await openPage(t);
  for (let i = 0; i < 3; i += 1) {
    const before = await coordinates(page, "B2");
    await nudge(page);
    const place = await eventually(async () => {
      const now = await coordinates(page, "B2");
      assert.notDeepEqual(now, before);
      return now;
    });
    await page.reload();
    await ready(page);
    assert.deepEqual(await coordinates(page, "B2"), place);
  }
  await nudge(page);
  await keptNow(page);
  assert.equal(await field(page, "title").inputValue(), "Amoeba");
});

test("the recent documents are clean to axe, light and dark, and work by keyboard", async (t) => {
  const page = await openPage(t);
  await nudge(page);
  await keptNow(page);
  await preset(page, "u-in-oval");
  await nudge(page);
  await keptNow(page, 2);
  await page.locator("[data-action=file]").focus();
  await page.keyboard.press("Enter");
  await page.keyboard.press("End");
  await page.locator("[data-item=recent]").focus();
  await page.keyboard.press("Enter");
  await page.locator("[data-document]").nth(1).waitFor();
  await page.keyboard.press("Tab");
  await page.keyboard.press("Tab");
  await page.keyboard.press("ArrowDown");
  await page.keyboard.press("Delete");
  await page.locator("[data-bin]").waitFor();
  assert.deepEqual(await auditThemes(page), []);
  await page.keyboard.press("Enter");
  await eventually(async () => assert.equal(await page.locator("[data-bin]").isVisible(), false));
  await page.locator("[data-open]").nth(1).press("Enter");
  await eventually(async () => assert.equal(await field(page, "title").inputValue(), "Amoeba"));
});
