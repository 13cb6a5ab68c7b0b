/**
 * Tests that share a page, because opening one takes longer than most looks at it.
 *
 * @import { Page } from "playwright-core"
 * @import { Options } from "./open.js"
 *
 * @typedef {{[name: string]: (page: Page) => Promise<void>}} Looks
 */
import assert from "node:assert/strict";
import { test } from "node:test";
import { idle } from "./idle.js";
import { openPage } from "./open.js";
import { eventually } from "./workbench.js";

/**
 * Runs tests one after the other on one page. Each begins with the document as it was opened: every edit of the one before it is taken back. What else it
 * changes, such as layers or what has the focus, stays.
 * @param {string} name of all of them
 * @param {Looks} looks the tests by their names
 * @param {Options} [options]
 */
export function onOnePage(name, looks, options) {
  test(name, async (t) => {
    const page = await openPage(t, options);
    for (const [each, look] of Object.entries(looks)) {
      await t.test(each, () => look(page));
      await takeBack(page);
    }
  });
}

/** Undoes until there is nothing left to be undone. @param {Page} page */
async function takeBack(page) {
  await eventually(async () => {
    const isDone = await page.evaluate(() => {
      const undo = /** @type {HTMLButtonElement} */ (document.querySelector("[data-action=undo]"));
      if (!undo.disabled) undo.click();
      return undo.disabled;
    });
    assert.ok(isDone, "there is still something to undo");
  });
  await idle(page);
}
