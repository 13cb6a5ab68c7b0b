import assert from "node:assert/strict";
import { test } from "node:test";
import { body, keptNow, nudge, openRecent, secondTab, stored } from "./kept.js";
import { openPage } from "./open.js";
import { documentOf, eventually, field, ready, status } from "./workbench.js";

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
