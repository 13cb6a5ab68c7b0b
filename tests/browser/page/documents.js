/** Documents that tests put into the page. */
import assert from "node:assert/strict";
import { idle } from "./idle.js";
import { documentOf, eventually } from "./workbench.js";

/** @typedef {import("playwright-core").Page} Page */

/**
 * Opens a document by the page's own way for files.
 * @param {Page} page
 * @param {{title?: string}} document
 */
export async function openAsFile(page, document) {
  const buffer = Buffer.from(JSON.stringify(document));
  await page.locator("input[data-file]").setInputFiles({ name: "opened.json", mimeType: "application/json", buffer });
  await eventually(async () => assert.equal((await documentOf(page)).title, document.title));
  await idle(page);
}

/** A ring of eight control points. @param {number} radius @param {number} [x] of its middle @param {number} [height] */
export const ring = (radius, x = 0, height = 0) => ({
  degree: 3,
  form: "periodic",
  height,
  points: Array.from({ length: 8 }, (_, k) => {
    const angle = (k * Math.PI) / 4;
    return [x + radius * Math.cos(angle), radius * Math.sin(angle)];
  }),
});

/** Two rings with a document round them. @param {object} matching @param {object} [more] */
export const rings = (matching, more = {}) => ({
  directrix: 1,
  kind: "curves",
  title: "Rings",
  curves: [ring(20), ring(50)],
  matching,
  ...more,
});
