/**
 * What the browser keeps of the documents, as the tests of the storage see it.
 *
 * @import { Page } from "playwright-core"
 */
import assert from "node:assert/strict";
import { watch } from "../support/browser.js";
import { coordinates, eventually, field, handle, ready } from "./workbench.js";

/** What the browser's storage holds, by key. @param {Page} page @returns {Promise<{[key: string]: any}>} */
export const stored = (page) =>
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
export const heads = async (page) => Object.entries(await stored(page)).filter(([key]) => key.startsWith("head/")).map(([, head]) => head);

/** The body of a stored document without its view. @param {{[key: string]: any}} all @param {string} id */
export function body(all, id) {
  const { view: _, ...document } = all[`body/${id}`];
  return document;
}

/** Moves a control point by a key. @param {Page} page @param {string} [key] */
export async function nudge(page, key = "Shift+ArrowUp") {
  await handle(page, "B2").focus();
  await page.keyboard.press(key);
}

/** Waits until the work is kept. @param {Page} page @param {number} [count] of documents */
export const keptNow = (page, count = 1) =>
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
export async function openRecent(page) {
  await page.locator("[data-action=file]").click();
  await page.locator("[data-item=recent]").click();
  await page.locator("[data-panel=recent] h2").waitFor();
}

/** Opens a preset by its name. @param {Page} page @param {string} name */
export async function preset(page, name) {
  const before = await field(page, "title").inputValue();
  await page.locator("[data-action=gallery]").click();
  await page.locator(`[data-preset="${name}"]`).click();
  await eventually(async () => assert.notEqual(await field(page, "title").inputValue(), before));
}

/** Another page of the same browser at the same address. @param {import("node:test").TestContext} t @param {Page} page */
export async function secondTab(t, page) {
  const other = await page.context().newPage();
  other.setDefaultTimeout(15_000);
  const complaints = watch(other);
  t.after(() => assert.deepEqual(complaints, []));
  await other.goto(page.url());
  await ready(other);
  return other;
}
