import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { test } from "node:test";
import { audit } from "../support/axe.js";
import { openPage } from "./open.js";
import { coordinates, documentOf, eventually, field, handle, ready, status } from "./workbench.js";

/**
 * @import { Page } from "playwright-core"
 */

/** A browser without pickers. */
const PLAIN = "delete globalThis.showSaveFilePicker; delete globalThis.showOpenFilePicker;";

/**
 * A browser whose pickers give the file of that name in the page's private files, which are real ones: they can be read, written
 * and remembered. `asked` counts how often a picker was shown.
 */
const PICKERS = `
  globalThis.asked = 0;
  const file = async (name) => (await navigator.storage.getDirectory()).getFileHandle(name, { create: true });
  globalThis.choice = "mine.json";
  globalThis.showSaveFilePicker = async ({ suggestedName, types }) => {
    globalThis.asked += 1;
    globalThis.suggested = [suggestedName, Object.keys(types[0].accept)];
    if (globalThis.choice === null) throw new DOMException("The user aborted a request.", "AbortError");
    return file(globalThis.choice);
  };
  globalThis.showOpenFilePicker = async () => {
    globalThis.asked += 1;
    if (globalThis.choice === null) throw new DOMException("The user aborted a request.", "AbortError");
    return [await file(globalThis.choice)];
  };`;

/** @param {Page} page */
const asked = (page) => page.evaluate(() => /** @type {any} */ (globalThis).asked);

/** What the next picker gives; null turns away. @param {Page} page @param {string | null} name */
const choose = (page, name) => page.evaluate((chosen) => void (/** @type {any} */ (globalThis).choice = chosen), name);

/** The text of a private file. @param {Page} page @param {string} [name] */
const onDisk = (page, name = "mine.json") =>
  page.evaluate(async (file) => {
    const found = await (await navigator.storage.getDirectory()).getFileHandle(file);
    return (await found.getFile()).text();
  }, name);

/** @param {Page} page @param {unknown} content @param {string} [name] */
const putOnDisk = (page, content, name = "mine.json") =>
  page.evaluate(
    async ([file, text]) => {
      const found = await (await navigator.storage.getDirectory()).getFileHandle(file, { create: true });
      const writable = await found.createWritable();
      await writable.write(text);
      await writable.close();
    },
    [name, JSON.stringify(content)],
  );

/** @param {Page} page */
const state = (page) => page.locator("[data-state]").textContent();

/** @param {Page} page @param {string} name */
async function fileMenu(page, name) {
  await page.locator("[data-action=file]").click();
  await page.locator(`[data-item="${name}"]`).click();
}

/** @param {Page} page */
async function nudge(page) {
  const before = await coordinates(page, "B2");
  await handle(page, "B2").focus();
  await page.keyboard.press("Shift+ArrowUp");
  await eventually(async () => assert.notDeepEqual(await coordinates(page, "B2"), before));
}

/** A file without the view that the page writes into it. @param {string} text */
function withoutView(text) {
  const { view: _, ...document } = JSON.parse(text);
  return document;
}

test("where the browser cannot write to files, Save downloads the document", async (t) => {
  const page = await openPage(t, { init: PLAIN });
  await nudge(page);
  await eventually(async () => assert.equal(await state(page), "Edited"));
  const download = page.waitForEvent("download");
  await page.keyboard.press("Control+s");
  const file = await download;
  assert.equal(file.suggestedFilename(), "amoeba.json");
  assert.deepEqual(withoutView(await readFile(await file.path(), "utf8")), await documentOf(page));
  await eventually(async () => assert.equal(await state(page), "Saved"));
  assert.match(await status(page), /Saved amoeba\.json/);
  await nudge(page);
  await eventually(async () => assert.equal(await state(page), "Edited"));
});

test("Save asks once where to write, and then writes to that file", async (t) => {
  const page = await openPage(t, { init: PICKERS });
  await nudge(page);
  await page.keyboard.press("Control+s");
  await eventually(async () => assert.equal(await state(page), "Saved"));
  assert.deepEqual(await page.evaluate(() => /** @type {any} */ (globalThis).suggested), ["amoeba.json", ["application/json"]]);
  assert.deepEqual(withoutView(await onDisk(page)), await documentOf(page));
  await nudge(page);
  await page.keyboard.press("Control+s");
  await eventually(async () => assert.deepEqual(withoutView(await onDisk(page)), await documentOf(page)));
  await eventually(async () => assert.equal(await state(page), "Saved"));
  assert.equal(await asked(page), 1);
  await page.keyboard.press("Control+z");
  await eventually(async () => assert.equal(await state(page), "Edited"));
  await page.keyboard.press("Control+y");
  await eventually(async () => assert.equal(await state(page), "Saved"));
});

test("the file is remembered by a reload and by the recent documents", async (t) => {
  const page = await openPage(t, { init: PICKERS });
  await nudge(page);
  await page.keyboard.press("Control+s");
  await eventually(async () => assert.equal(await state(page), "Saved"));
  await eventually(async () => assert.ok(await page.evaluate(() => history.state.kept.stamp)));
  await page.reload();
  await ready(page);
  await eventually(async () => assert.equal(await state(page), "Saved"));
  await nudge(page);
  await page.keyboard.press("Control+s");
  await eventually(async () => assert.deepEqual(withoutView(await onDisk(page)), await documentOf(page)));
  assert.equal(await asked(page), 0, "the reloaded page asks for nothing");
  await page.locator("[data-action=gallery]").click();
  await page.locator("[data-preset=u-in-oval]").click();
  await eventually(async () => assert.notEqual(await field(page, "title").inputValue(), "Amoeba"));
  await fileMenu(page, "recent");
  const row = page.locator("[data-document]");
  assert.match(await row.innerText(), /Amoeba\s+just now · mine\.json/);
  await row.locator("[data-open]").click();
  await eventually(async () => assert.equal(await state(page), "Saved"));
  await nudge(page);
  await page.keyboard.press("Control+s");
  await eventually(async () => assert.deepEqual(withoutView(await onDisk(page)), await documentOf(page)));
  assert.equal(await asked(page), 0);
});

test("what was saved is a version that opens again", async (t) => {
  const page = await openPage(t, { init: PICKERS });
  await nudge(page);
  await page.keyboard.press("Control+s");
  await eventually(async () => assert.equal(await state(page), "Saved"));
  const saved = await documentOf(page);
  await nudge(page);
  await fileMenu(page, "recent");
  await page.locator("[data-versions]").click();
  assert.match(await page.locator("[data-version]").innerText(), /as saved/);
  await page.locator("[data-version]").click();
  await eventually(async () => assert.deepEqual((await documentOf(page)).curves, saved.curves));
  assert.equal(await state(page), "Edited");
});

test("Save a copy writes elsewhere and leaves the document with its file", async (t) => {
  const page = await openPage(t, { init: PICKERS });
  await page.keyboard.press("Control+s");
  await eventually(async () => assert.equal(await state(page), "Saved"));
  await nudge(page);
  await choose(page, "copy.json");
  await page.keyboard.press("Control+Shift+s");
  await eventually(async () => assert.match(await status(page), /Saved a copy as copy\.json/));
  assert.equal(await state(page), "Edited");
  assert.deepEqual(withoutView(await onDisk(page, "copy.json")), await documentOf(page));
  assert.notDeepEqual(withoutView(await onDisk(page)), await documentOf(page));
  await page.keyboard.press("Control+s");
  await eventually(async () => assert.equal(await state(page), "Saved"));
  assert.deepEqual(withoutView(await onDisk(page)), await documentOf(page));
});

test("turning away from a picker changes nothing", async (t) => {
  const page = await openPage(t, { init: PICKERS });
  await nudge(page);
  await choose(page, null);
  const before = await documentOf(page);
  for (const keys of ["Control+s", "Control+Shift+s", "Control+o"]) await page.keyboard.press(keys);
  await eventually(async () => assert.equal(await asked(page), 3));
  assert.equal(await state(page), "Edited");
  assert.deepEqual(await documentOf(page), before);
  assert.equal(await page.locator("#status [data-reason]").count(), 0, "nothing is wrong");
});

const REFUSALS = [
  { name: "the disk refuses", init: "FileSystemFileHandle.prototype.createWritable = async () => { throw new DOMException('The disk is full.', 'QuotaExceededError') }", says: /The disk is full/ },
  {
    name: "the person does not allow it",
    init: "Object.assign(FileSystemFileHandle.prototype, { queryPermission: async () => 'prompt', requestPermission: async () => 'denied' })",
    says: /may not write/,
  },
];

for (const { name, init, says } of REFUSALS) {
  test(`where ${name} the work counts as edited and the reason is told`, async (t) => {
    const page = await openPage(t, { init: `${PICKERS}${init}` });
    await nudge(page);
    await page.keyboard.press("Control+s");
    await eventually(async () => {
      const text = await status(page);
      assert.match(text, /Could not save (mine|amoeba)\.json: /);
      assert.match(text, says);
    });
    assert.equal(await state(page), "Edited");
  });
}

test("in a page inside another one, where pickers are forbidden, Save downloads", async (t) => {
  const refuse = "globalThis.showSaveFilePicker = async () => { throw new DOMException('Cross origin sub frames', 'SecurityError') };";
  const page = await openPage(t, { init: refuse });
  const download = page.waitForEvent("download");
  await fileMenu(page, "save");
  assert.equal((await download).suggestedFilename(), "amoeba.json");
});

test("an opened file is saved to again, by picker and by drop, and is listed once", async (t) => {
  const page = await openPage(t, { init: PICKERS });
  const document = { ...(await documentOf(page)), title: "From disk" };
  await putOnDisk(page, document);
  await page.keyboard.press("Control+o");
  await eventually(async () => assert.equal(await field(page, "title").inputValue(), "From disk"));
  assert.equal(await state(page), "Saved");
  const heads = () => page.evaluate(() => history.state.kept.id);
  const id = await eventually(async () => {
    const found = await heads();
    assert.ok(found && (await page.evaluate(() => history.state.kept.stamp)));
    return found;
  });
  await page.evaluate(async () => {
    const found = await (await navigator.storage.getDirectory()).getFileHandle("mine.json");
    Reflect.set(DataTransferItem.prototype, "getAsFileSystemHandle", async () => found);
    const data = new DataTransfer();
    data.items.add(await found.getFile());
    window.dispatchEvent(new DragEvent("drop", { dataTransfer: data, bubbles: true, cancelable: true }));
  });
  await page.waitForTimeout(1500);
  assert.equal(await heads(), id, "the same file is the same document");
  await nudge(page);
  await page.keyboard.press("Control+s");
  await eventually(async () => assert.deepEqual(withoutView(await onDisk(page)), await documentOf(page)));
  assert.equal(await asked(page), 1);
  await fileMenu(page, "recent");
  await eventually(async () => assert.equal(await page.locator("[data-document]").count(), 1));
});

test("a file that was changed outside is not replaced unasked", async (t) => {
  const page = await openPage(t, { init: PICKERS });
  await putOnDisk(page, await documentOf(page));
  await page.keyboard.press("Control+o");
  await eventually(async () => assert.equal(await state(page), "Saved"));
  await nudge(page);
  const theirs = { changed: "by another program" };
  await page.waitForTimeout(20);
  await putOnDisk(page, theirs);
  await page.keyboard.press("Control+s");
  await eventually(async () => assert.match(await status(page), /mine\.json was changed outside this page\. Save again to replace it/));
  assert.deepEqual(JSON.parse(await onDisk(page)), theirs);
  assert.equal(await state(page), "Edited");
  await page.keyboard.press("Control+s");
  await eventually(async () => assert.equal(await state(page), "Saved"));
  assert.deepEqual(withoutView(await onDisk(page)), await documentOf(page));
});

test("Save takes what is still being typed with it", async (t) => {
  const page = await openPage(t, { init: PICKERS });
  await field(page, "title").fill("Typed");
  await page.keyboard.press("Control+s");
  await eventually(async () => assert.equal(await state(page), "Saved"));
  assert.equal(JSON.parse(await onDisk(page)).title, "Typed");
});

test("the menu File shows its keys and is clean to axe; on a phone it is part of the menu", async (t) => {
  const page = await openPage(t);
  await page.locator("[data-action=file]").click();
  const keys = async (/** @type {string} */ name) => page.locator(`[data-item="${name}"] .menu-keys`).textContent();
  assert.deepEqual([await keys("open"), await keys("save"), await keys("save-copy")], ["Ctrl+O", "Ctrl+S", "Ctrl+Shift+S"]);
  assert.deepEqual(await audit(page), []);
  const phone = await openPage(t, { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true, init: PLAIN });
  await phone.locator("[data-action=menu]").tap();
  const download = phone.waitForEvent("download");
  await phone.locator("[data-item=save]").tap();
  assert.equal((await download).suggestedFilename(), "amoeba.json");
});
