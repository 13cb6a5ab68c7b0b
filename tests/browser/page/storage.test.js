import assert from "node:assert/strict";
import { test } from "node:test";
import { audit } from "../support/axe.js";
import { watch } from "../support/browser.js";
import { openPage } from "./open.js";
import { coordinates, documentOf, drag, eventually, field, handle, middle, ready, status } from "./workbench.js";

/**
 * @import { Page } from "playwright-core"
 */

/** What the browser's storage holds, by key. @param {Page} page @returns {Promise<{[key: string]: any}>} */
const stored = (page) =>
  page.evaluate(async () => {
    const { databases } = indexedDB;
    if (!(await databases.call(indexedDB)).some(({ name }) => name === "directrix")) return {};
    return new Promise((resolve, reject) => {
      const open = indexedDB.open("directrix");
      open.onerror = () => reject(open.error);
      open.onsuccess = () => {
        const store = open.result.transaction("documents").objectStore("documents");
        const [keys, values] = [store.getAllKeys(), store.getAll()];
        values.onsuccess = () => {
          open.result.close();
          resolve(Object.fromEntries(keys.result.map((key, i) => [key, values.result[i]])));
        };
      };
    });
  });

/** The heads of the stored documents. @param {Page} page */
const heads = async (page) => Object.entries(await stored(page)).filter(([key]) => key.startsWith("head/")).map(([, head]) => head);

/** The body of a stored document without its view. @param {{[key: string]: any}} all @param {string} id */
function body(all, id) {
  const { view: _, ...document } = all[`body/${id}`];
  return document;
}

/** Moves a control point by a key. @param {Page} page @param {string} [key] */
async function nudge(page, key = "Shift+ArrowUp") {
  await handle(page, "B2").focus();
  await page.keyboard.press(key);
}

/** Waits until the work is kept. @param {Page} page @param {number} [count] of documents */
const keptNow = (page, count = 1) =>
  eventually(async () => {
    const found = await heads(page);
    assert.equal(found.length, count);
    const document = await page.evaluate(() => history.state?.document);
    const { id, safe } = await page.evaluate(() => history.state?.kept ?? {});
    assert.ok(safe && id);
    const kept = body(await stored(page), id);
    assert.deepEqual(kept, document);
    assert.deepEqual(kept.curves[1].points[1], await coordinates(page, "B2"), "not yet the newest state");
    return id;
  });

/** @param {Page} page */
async function openRecent(page) {
  await page.locator("[data-action=file]").click();
  await page.locator("[data-item=recent]").click();
  await page.locator("[data-panel=recent] h2").waitFor();
}

/** Opens a preset by its name. @param {Page} page @param {string} name */
async function preset(page, name) {
  const before = await field(page, "title").inputValue();
  await page.locator("[data-action=gallery]").click();
  await page.locator(`[data-preset="${name}"]`).click();
  await eventually(async () => assert.notEqual(await field(page, "title").inputValue(), before));
}

/** Another page of the same browser at the same address. @param {import("node:test").TestContext} t @param {Page} page */
async function secondTab(t, page) {
  const other = await page.context().newPage();
  other.setDefaultTimeout(15_000);
  const complaints = watch(other);
  t.after(() => assert.deepEqual(complaints, []));
  await other.goto(page.url());
  await ready(other);
  return other;
}

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
  assert.equal(await pictures.count(), 2);
  assert.deepEqual(await pictures.evaluateAll((all) => all.map((each) => getComputedStyle(each).display !== "none")), [true, false]);
  await page.locator("[data-action=theme]").click();
  assert.deepEqual(await pictures.evaluateAll((all) => all.map((each) => getComputedStyle(each).display !== "none")), [false, true]);
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

test("a second tab works on a copy, and neither overwrites the other", async (t) => {
  const page = await openPage(t);
  await nudge(page);
  const id = await keptNow(page);
  const other = await secondTab(t, page);
  await openRecent(other);
  assert.match(await other.locator("[data-document]").innerText(), /open in another tab/);
  await other.locator("[data-open]").click();
  await eventually(async () => assert.match(await status(other), /Amoeba is open in another tab\. This is a copy\./));
  assert.equal(await field(other, "title").inputValue(), "Amoeba (copy)");
  await nudge(other, "Shift+ArrowLeft");
  const copy = await keptNow(other, 2);
  assert.notEqual(copy, id);
  await nudge(page, "Shift+ArrowRight");
  await keptNow(page, 2);
  const all = await stored(page);
  assert.deepEqual(body(all, id), await documentOf(page));
  assert.deepEqual(body(all, copy), await documentOf(other));
  // Once the first tab has closed it, the document itself opens.
  await page.close();
  await openRecent(other);
  await other.locator(`[data-document="${id}"] [data-open]`).click();
  await eventually(async () => assert.equal(await field(other, "title").inputValue(), "Amoeba"));
  await nudge(other);
  assert.equal(await keptNow(other, 2), id);
});

test("a tab that was duplicated becomes a copy", async (t) => {
  const page = await openPage(t);
  await nudge(page);
  const id = await keptNow(page);
  const state = await page.evaluate(() => history.state);
  // A browser duplicates the entry of its history; here the other page is given the same entry.
  const other = await page.context().newPage();
  await other.addInitScript((copied) => history.replaceState(copied, ""), state);
  await other.goto(page.url());
  await ready(other);
  await eventually(async () => assert.equal(await field(other, "title").inputValue(), "Amoeba (copy)"));
  assert.notEqual(await keptNow(other, 2), id);
  await nudge(page);
  assert.equal(await keptNow(page, 2), id);
});

for (const locks of [true, false]) {
  test(`work of another tab since then is not overwritten ${locks ? "with" : "without"} locks`, async (t) => {
    const page = await openPage(t, locks ? {} : { init: "Object.defineProperty(navigator, 'locks', { value: undefined })" });
    await nudge(page);
    const id = await keptNow(page);
    // As a tab that held no lock would have written it.
    await page.evaluate(
      (key) =>
        new Promise((resolve) => {
          const open = indexedDB.open("directrix");
          open.onsuccess = () => {
            const transaction = open.result.transaction("documents", "readwrite");
            const store = transaction.objectStore("documents");
            const get = store.get(`head/${key}`);
            get.onsuccess = () => store.put({ ...get.result, title: "Theirs", stamp: "other.7" }, `head/${key}`);
            transaction.oncomplete = () => (open.result.close(), resolve(null));
          };
        }),
      id,
    );
    await nudge(page);
    await eventually(async () => assert.match(await status(page), /was changed in another tab\. This is a copy\./));
    const copy = await keptNow(page, 2);
    assert.notEqual(copy, id);
    assert.equal((await stored(page))[`head/${id}`].title, "Theirs");
  });
}

test("leaving asks only while work is not kept yet", async (t) => {
  const page = await openPage(t);
  let asked = 0;
  page.on("dialog", (dialog) => {
    asked += 1;
    assert.equal(dialog.type(), "beforeunload");
    void dialog.accept();
  });
  // The browser asks only on a page that the person has touched.
  const leave = async () => {
    await page.locator("#stage").click({ position: { x: 20, y: 60 } });
    const again = page.waitForEvent("load");
    await page.evaluate(() => void setTimeout(() => location.reload(), 0));
    await again;
    await ready(page);
  };
  await page.locator("[data-zoom=plus]").click();
  await leave();
  assert.equal(asked, 0, "without an edit");
  await nudge(page);
  await leave();
  assert.equal(asked, 1, "with an edit that is not kept yet");
  await keptNow(page);
  await leave();
  assert.equal(asked, 1, "with all kept");
});

const FAULTS = [
  { name: "the database does not open", init: "indexedDB.open = () => { throw new DOMException('no', 'SecurityError') }", says: /does not keep/ },
  {
    name: "there is no database",
    init: "Object.defineProperty(globalThis, 'indexedDB', { value: undefined })",
    says: /does not keep/,
  },
  {
    name: "opening fails as in a private window",
    init: `IDBFactory.prototype.open = () => {
      const request = {};
      setTimeout(() => request.onerror?.(), 10);
      return Object.assign(request, { error: new DOMException("private", "InvalidStateError") });
    }`,
    says: /does not keep/,
  },
  {
    name: "there is no room",
    init: `IDBObjectStore.prototype.put = () => { throw new DOMException("full", "QuotaExceededError") }`,
    says: /no room left/,
    reads: true,
  },
  {
    name: "transactions are aborted",
    init: `{
      const { put } = IDBObjectStore.prototype;
      IDBObjectStore.prototype.put = function (...rest) {
        const request = put.apply(this, rest);
        this.transaction.abort();
        return request;
      };
    }`,
    says: /does not keep/,
    reads: true,
  },
  {
    name: "the database never answers",
    init: "IDBFactory.prototype.open = () => ({})",
    says: /does not keep/,
  },
];

for (const { name, init, says, reads = false } of FAULTS) {
  test(`where ${name} the page says so once and goes on`, async (t) => {
    const page = await openPage(t, { init });
    await nudge(page);
    await eventually(async () => assert.match(await status(page), says));
    assert.equal(await page.locator("[data-state]").textContent(), "Not saved");
    await nudge(page);
    await page.waitForTimeout(1500);
    assert.doesNotMatch(await status(page), says, "once is enough");
    const work = await documentOf(page);
    await openRecent(page);
    const shown = reads ? page.getByText("Nothing yet") : page.locator("[data-message]").getByText("does not keep");
    await shown.waitFor();
    await page.keyboard.press("Escape");
    await page.reload();
    await ready(page);
    assert.deepEqual(await documentOf(page), work);
  });
}

test("work is kept again once there is room", async (t) => {
  const page = await openPage(t, {
    init: `{
      globalThis.full = true;
      const { put } = IDBObjectStore.prototype;
      IDBObjectStore.prototype.put = function (...rest) {
        if (globalThis.full) throw new DOMException("full", "QuotaExceededError");
        return put.apply(this, rest);
      };
    }`,
  });
  await nudge(page);
  await eventually(async () => assert.equal(await page.locator("[data-state]").textContent(), "Not saved"));
  assert.deepEqual(await stored(page), {});
  await page.evaluate("globalThis.full = false");
  await nudge(page);
  await eventually(async () => assert.equal(await page.locator("[data-state]").textContent(), "Edited"));
  await keptNow(page);
});

/** Puts things into the database before the page looks at it. @param {Page} page @param {{[key: string]: unknown}} entries @param {number} [version] @param {string} [store] */
const plant = (page, entries, version = 1, store = "documents") =>
  page.evaluate(
    ([all, number, name]) =>
      new Promise((resolve) => {
        const open = indexedDB.open("directrix", number);
        open.onupgradeneeded = () => open.result.createObjectStore(name);
        open.onsuccess = () => {
          const transaction = open.result.transaction(name, "readwrite");
          for (const [key, value] of Object.entries(all)) transaction.objectStore(name).put(value, key);
          transaction.oncomplete = () => (open.result.close(), resolve(null));
        };
      }),
    /** @type {const} */ ([entries, version, store]),
  );

const HEAD = {
  version: 1, id: "x", title: "Planted", file: null, modified: null, edited: true, born: 1e12, time: 1e12, deleted: null,
  stamp: "else.1", thumbnail: null, versions: [],
};

test("garbage in the store is passed over, and stays", async (t) => {
  const page = await openPage(t);
  const garbage = {
    "head/a": "text", "head/b": null, "head/c": { ...HEAD, version: 2 }, "head/d": { ...HEAD, time: Number.NaN },
    "head/e": { ...HEAD, thumbnail: { light: "javascript:alert(1)", dark: 3 } }, "head/f": { ...HEAD, versions: [{}] },
    "head/x": HEAD, "body/x": { directrix: 1, kind: "soup" }, other: [1, 2],
  };
  await plant(page, garbage);
  await openRecent(page);
  await eventually(async () => assert.equal(await page.locator("[data-document]").count(), 1));
  const before = await documentOf(page);
  await page.locator("[data-open]").click();
  await eventually(async () => assert.match(await status(page), /Could not open Planted: .*kind.*unchanged/));
  assert.deepEqual(await documentOf(page), before);
  await page.keyboard.press("Escape");
  await nudge(page);
  await eventually(async () => assert.equal(Object.keys(await stored(page)).length, Object.keys(garbage).length + 2));
});

test("a database of a newer version works, and one without the documents does not stop the page", async (t) => {
  const page = await openPage(t);
  await plant(page, {}, 7);
  await nudge(page);
  await keptNow(page);
  const other = await openPage(t);
  await plant(other, {}, 3, "elsewhere");
  await nudge(other);
  await eventually(async () => assert.match(await status(other), /does not keep/));
  await nudge(other);
});

test("the bin holds 20 documents and 30 days", async (t) => {
  const page = await openPage(t);
  const now = Date.now();
  const entries = Object.fromEntries(
    Array.from({ length: 24 }, (_, i) => [`head/d${i}`, { ...HEAD, id: `d${i}`, deleted: now - i * 1000 }]),
  );
  const day = 24 * 3_600_000;
  await plant(page, {
    ...entries,
    "head/old": { ...HEAD, id: "old", deleted: now - 31 * day },
    "head/live": { ...HEAD, id: "live", time: now - 400 * day },
    "body/d23": {},
  });
  await openRecent(page);
  await eventually(async () => assert.equal(await page.locator("[data-bin] [data-document]").count(), 20));
  const keys = Object.keys(await stored(page));
  assert.equal(keys.length, 21);
  assert.ok(keys.includes("head/d19") && keys.includes("head/live"));
});

test("the recent documents are clean to axe, light and dark, and work by keyboard", async (t) => {
  for (const colorScheme of /** @type {const} */ (["light", "dark"])) {
    const page = await openPage(t, { colorScheme });
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
    assert.deepEqual(await audit(page), []);
    await page.keyboard.press("Enter");
    await eventually(async () => assert.equal(await page.locator("[data-bin]").isVisible(), false));
    await page.locator("[data-open]").nth(1).press("Enter");
    await eventually(async () => assert.equal(await field(page, "title").inputValue(), "Amoeba"));
  }
});
