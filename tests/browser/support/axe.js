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

/**
 * What axe finds wrong in the page when the system is light and when it is dark, once what fades from one to the other has faded.
 *
 * @param {Page} page
 * @param {string[]} [within] as of `audit`
 * @returns {Promise<string[]>} empty for a clean page
 */
export async function auditThemes(page, within) {
  /** @type {string[]} */
  const found = [];
  for (const colorScheme of /** @type {const} */ (["light", "dark"])) {
    await page.emulateMedia({ colorScheme });
    await page.evaluate(async () => {
      await new Promise((done) => requestAnimationFrame(() => setTimeout(done)));
      const fading = document.getAnimations().filter((each) => each instanceof CSSTransition);
      await Promise.allSettled(fading.map(({ finished }) => finished));
    });
    found.push(...(await audit(page, within)).map((line) => `${colorScheme}: ${line}`));
  }
  return found;
}
