/**
 * The export panel as the tests use it.
 *
 * @import { Page } from "playwright-core"
 */
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { pick } from "./workbench.js";

/**
 * Opens the panel and chooses a format.
 * @param {Page} page
 * @param {"svg" | "png" | "csv" | "json"} format
 */
export async function openExport(page, format) {
  if ((await page.locator("[data-panel=export]").count()) === 0) await page.locator("[data-action=export]").click();
  await pick(page, "export-format", format);
}

/**
 * What Download hands out.
 * @param {Page} page
 * @param {"svg" | "png" | "csv" | "json"} format
 * @returns {Promise<Buffer>}
 */
export async function exported(page, format) {
  await openExport(page, format);
  const download = page.waitForEvent("download");
  await page.locator("[data-export=download]").click();
  const file = await download;
  assert.ok(file.suggestedFilename().endsWith(`.${format}`));
  return readFile(await file.path());
}
