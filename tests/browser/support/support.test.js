/** The helpers must see what is wrong: each is shown a page that has the fault. */
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { audit } from "./axe.js";
import { launch, withPage } from "./browser.js";
import { screenshot } from "./screenshot.js";

const clean = `<!doctype html><html lang="en"><title>A page</title><main><h1>A page</h1></main></html>`;

/** @type {import("playwright-core").Browser} */
let browser;
before(async () => (browser = await launch()));
after(() => browser.close());

test("a page without faults passes", async () => {
  const found = await withPage(browser, {}, async (page) => {
    await page.setContent(clean);
    return audit(page);
  });
  assert.deepEqual(found, []);
});

test("axe sees a button without a name", async () => {
  const found = await withPage(browser, {}, async (page) => {
    await page.setContent(clean.replace("</main>", "<button></button></main>"));
    return audit(page);
  });
  assert.equal(found.length, 1);
  assert.match(found[0], /^button-name /);
});

for (const [fault, script] of [
  ["an error in the console", "console.error('broken')"],
  ["an uncaught error", "setTimeout(() => { throw new Error('broken'); })"],
  ["a rejected promise", "Promise.reject(new Error('broken'))"],
]) {
  test(`a page with ${fault} fails`, async () => {
    const visit = withPage(browser, {}, async (page) => {
      await page.setContent(clean.replace("</main>", `</main><script>${script}</script>`));
      await page.waitForTimeout(100);
    });
    await assert.rejects(visit, /the page complained:[^]*broken/);
  });
}

test("expected messages are allowed", async () => {
  await withPage(browser, { allow: /broken/ }, (page) => page.evaluate(() => console.error("broken")));
});

test("a screenshot tells colours apart that lie close together", async () => {
  await withPage(browser, { viewport: { width: 40, height: 20 } }, async (page) => {
    const body = (/** @type {string} */ color) => `<body style="margin: 0; background: ${color}">`;
    await page.setContent(body("hsl(200 60% 50%)"));
    const one = await screenshot(page, "support-one");
    await page.setContent(body("hsl(210 60% 50%)"));
    const other = await screenshot(page, "support-other");
    assert.deepEqual(one.at(5, 5), [51, 153, 204]);
    assert.equal(one.colors(), 1);
    assert.equal(one.difference(one), 0);
    assert.equal(one.difference(other), 1);
  });
});
