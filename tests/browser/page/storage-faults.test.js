/** @import { Page } from "playwright-core" */
import assert from "node:assert/strict";
import { test } from "node:test";
import { keptNow, nudge, openRecent, stored } from "./kept.js";
import { openPage } from "./open.js";
import { documentOf, eventually, ready, status } from "./workbench.js";

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
