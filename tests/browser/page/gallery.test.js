import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { test } from "node:test";
import { audit, auditThemes } from "../support/axe.js";
import { onOnePage } from "./one-page.js";
import { openPage } from "./open.js";
import { documentOf, eventually, field, handle, status, uiOf } from "./workbench.js";

const PHONE = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true };

/** @type {{id: string, title: string, topic: string, line: string, matched?: false}[]} */
const index = JSON.parse(await readFile(new URL("../../../www/presets/index.json", import.meta.url), "utf8"));

/** @import { Page } from "playwright-core" */

/** @param {Page} page @param {string} id */
const entry = (page, id) => page.locator(`[data-preset="${id}"]`);

/** @param {Page} page */
async function openGallery(page) {
  const panel = page.locator("[data-panel=gallery]");
  if ((await panel.count()) === 0) await page.locator("[data-action=gallery]").click();
  await panel.waitFor();
}

/** The preset that has the focus. @param {Page} page */
const focused = (page) => page.evaluate(() => document.activeElement?.getAttribute("data-preset"));

/**
 * The pictures that are on the screen, once all of them have arrived.
 * @param {Page} page
 */
const pictures = (page) =>
  eventually(async () => {
    const found = await page.locator("[data-preset] img").evaluateAll((all) =>
      all
        .map((each) => /** @type {HTMLImageElement} */ (each))
        .filter((each) => {
          const { top, bottom } = each.getBoundingClientRect();
          return bottom > 100 && top < innerHeight;
        })
        .map(({ src, complete, naturalWidth }) => ({ src, complete, naturalWidth })),
    );
    assert.ok(found.length > 0 && found.every(({ complete, naturalWidth }) => complete && naturalWidth === 336), JSON.stringify(found));
    return found.map(({ src }) => src);
  });

test("every preset opens from the gallery with its verdict, and the gallery closes", async (t) => {
  const page = await openPage(t);
  await openGallery(page);
  const shown = await page.locator("[data-preset]").evaluateAll((all) => all.map((each) => each.getAttribute("data-preset")));
  assert.deepEqual([...shown].sort(), index.map(({ id }) => id).sort());
  await page.keyboard.press("Escape");
  for (const { id, title, matched = true } of index) {
    await openGallery(page);
    await entry(page, id).click();
    await eventually(async () => assert.equal(await field(page, "title").inputValue(), title));
    await eventually(async () => assert.equal(await page.locator("[data-panel=gallery]").count(), 0));
    const verdict = matched ? "verified" : "problems";
    await eventually(async () => assert.equal(await page.locator("#status").getAttribute("data-verdict"), verdict, id));
    const words = matched ? /Verified/ : /\d+ problems.*Not covered: \d+ \+ \d+ vertices\. Some see nothing/s;
    await eventually(async () => assert.match(await status(page), words));
    await eventually(async () => assert.equal(await page.locator("[data-state]").textContent(), ""));
  }
});

onOnePage("the gallery", {
  "thumbnails were painted before, follow the theme, and are not asked for until the gallery opens": async (page) => {
    const asked = () =>
      page.evaluate(() => performance.getEntriesByType("resource").filter(({ name }) => /thumbnail|-light|-dark|gallery/.test(name)).length);
    assert.equal(await asked(), 0);
    await openGallery(page);
    const light = await pictures(page);
    assert.ok(light.every((src) => /-light/.test(src)), `${light}`);
    await page.locator("[data-action=theme]").click();
    await eventually(async () => assert.ok((await pictures(page)).every((src) => /-dark/.test(src))));
    assert.ok((await asked()) > 0);
    await entry(page, "void-core").scrollIntoViewIfNeeded();
    await pictures(page);
  },
  "each entry says its title and why it matters; the one without a matching is marked": async (page) => {
    await openGallery(page);
    for (const { id, title, line, matched = true } of index) {
      const text = (await entry(page, id).innerText()).replaceAll("\n", " ");
      assert.ok(text.includes(title) && text.includes(line), text);
      assert.equal(/No matching/.test(text), !matched, id);
    }
    const headings = await page.locator("[data-panel=gallery] h3").allInnerTexts();
    assert.deepEqual(headings, ["Shapes", "Pockets", "Measures and limits", "Materials", "Stacks"]);
  },
  "the button closes what it opened, and keys in the gallery do not reach the figure": async (page) => {
    await openGallery(page);
    const before = JSON.stringify(await documentOf(page));
    for (const key of ["f", "Delete", "ArrowRight", "-"]) await page.keyboard.press(key);
    assert.equal(JSON.stringify(await documentOf(page)), before);
    await page.locator("[data-action=gallery]").click();
    await eventually(async () => assert.equal(await page.locator("[data-panel=gallery]").count(), 0));
  },
  "an edited document stays until a preset is opened": async (page) => {
    await handle(page, "A1").focus();
    await page.keyboard.press("Shift+ArrowRight");
    const edited = JSON.stringify(await documentOf(page));
    await openGallery(page);
    await page.keyboard.press("Escape");
    assert.equal(JSON.stringify(await documentOf(page)), edited);
    assert.equal(await page.locator("[data-state]").textContent(), "Edited");
  },
  "the first preset is the document that the page opens with": async (page) => {
    const first = JSON.stringify(await documentOf(page));
    await openGallery(page);
    assert.equal(await focused(page), index[0]?.id);
    await entry(page, index[1]?.id ?? "").click();
    await eventually(async () => assert.notEqual(JSON.stringify(await documentOf(page)), first));
    await openGallery(page);
    await page.keyboard.press("Enter");
    await eventually(async () => assert.equal(JSON.stringify(await documentOf(page)), first));
  },
  "arrows go through the grid as it lies, Enter opens, Escape closes and gives the focus back": async (page) => {
    const button = page.locator("[data-action=gallery]");
    await button.focus();
    await page.keyboard.press("Enter");
    await eventually(async () => assert.equal(await focused(page), "amoeba"));
    const place = (/** @type {string} */ id) => entry(page, id).evaluate((element) => element.getBoundingClientRect());

    await page.keyboard.press("ArrowRight");
    assert.equal(await focused(page), "star-in-circle");
    await page.keyboard.press("ArrowDown");
    const below = (await focused(page)) ?? "";
    const [from, to] = [await place("star-in-circle"), await place(below)];
    assert.ok(to.top > from.bottom - 1 && Math.abs(to.left - from.left) < 1, below);
    await page.keyboard.press("ArrowUp");
    assert.equal(await focused(page), "star-in-circle");
    await page.keyboard.press("End");
    const last = index.filter(({ topic }) => topic === "stacks").at(-1)?.id;
    assert.equal(await focused(page), last, "the last one of the last topic");
    await page.keyboard.press("ArrowDown");
    assert.equal(await focused(page), last);
    await page.keyboard.press("Home");
    await page.keyboard.press("ArrowLeft");
    await page.keyboard.press("ArrowUp");
    assert.equal(await focused(page), "amoeba");

    const seen = new Set(["amoeba"]);
    for (let step = 0; step < index.length; step += 1) {
      await page.keyboard.press("ArrowDown");
      seen.add((await focused(page)) ?? "");
    }
    assert.ok(seen.size >= 6, "down goes through every topic");
    await page.keyboard.press("Tab");
    assert.equal(await focused(page), null, "Tab leaves the grid");

    await page.keyboard.press("Shift+Tab");
    await page.keyboard.press("Escape");
    assert.equal(await page.locator("[data-panel=gallery]").count(), 0);
    assert.ok(await button.evaluate((element) => element === document.activeElement));

    await page.keyboard.press("Enter");
    await eventually(async () => assert.equal(await focused(page), "amoeba"));
    await page.keyboard.press("ArrowRight");
    await page.keyboard.press("Enter");
    await eventually(async () => assert.equal(await field(page, "title").inputValue(), "Star in circle"));
    assert.ok(await button.evaluate((element) => element === document.activeElement));
  },
});

onOnePage(
  "on a phone",
  {
    "axe finds nothing wrong in the gallery on a phone": async (page) => {
      await page.locator("[data-action=menu]").tap();
      await page.locator("[data-item=gallery]").tap();
      await pictures(page);
      assert.deepEqual(await audit(page), []);
      await page.locator("[data-panel=gallery] [data-close]").tap();
      await eventually(async () => assert.equal(await page.locator("[data-panel=gallery]").count(), 0));
    },
    "on a phone the gallery is one entry of the menu and takes the whole width": async (page) => {
      await page.locator("[data-action=menu]").tap();
      await page.locator("[data-item=gallery]").tap();
      const panel = page.locator("[data-panel=gallery]");
      await panel.waitFor();
      const box = await panel.boundingBox();
      assert.ok(box && box.x === 0 && box.width === 390 && box.height > 780, JSON.stringify(box));
      const sizes = await page.locator("[data-preset]").evaluateAll((all) => all.map((each) => each.getBoundingClientRect().height));
      assert.ok(sizes.every((height) => height >= 44));
      assert.ok(await panel.evaluate((element) => element.scrollWidth <= element.clientWidth));
      await entry(page, "snail").scrollIntoViewIfNeeded();
      await entry(page, "snail").tap();
      await eventually(async () => assert.equal(await field(page, "title").inputValue(), "Snail"));
      assert.equal(await panel.count(), 0);
      assert.ok(!(await uiOf(page)).layers.includes("samples"), "dots run into each other on a phone");
    },
  },
  PHONE,
);

test("axe finds nothing wrong in the gallery, light and dark", async (t) => {
  const page = await openPage(t);
  await page.locator("[data-action=gallery]").click();
  await pictures(page);
  assert.deepEqual(await auditThemes(page), []);
});
