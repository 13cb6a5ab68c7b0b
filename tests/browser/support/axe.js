/** The accessibility checker axe in a page. */
import axe from "axe-core";

/** @typedef {import("playwright-core").Page} Page */

/**
 * What axe finds wrong in the page, one line for each element: the rule, where, and what to do. axe sees nothing of what is
 * painted on a canvas. It is evaluated in the page rather than added as a script, which a strict policy of the page would block.
 *
 * @param {Page} page
 * @param {string[]} [within] selectors of the parts that are looked at, those that are there; the whole page by default
 * @returns {Promise<string[]>} empty for a clean page
 */
export async function audit(page, within) {
  const isThere = await page.evaluate(() => "axe" in globalThis);
  if (!isThere) await page.evaluate(axe.source);
  const { violations } = await page.evaluate((parts) => {
    const there = parts?.filter((part) => document.querySelector(part));
    return /** @type {any} */ (globalThis).axe.run(there ? { include: there.map((part) => [part]) } : document, {
      resultTypes: ["violations"],
    });
  }, within);
  return /** @type {import("axe-core").Result[]} */ (violations).flatMap(({ id, help, nodes }) =>
    nodes.map((node) => `${id} (${help}): ${node.target.join(" ")}: ${node.failureSummary ?? ""}`),
  );
}
