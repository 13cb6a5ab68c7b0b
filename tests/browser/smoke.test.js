/** The built page, in a folder of a web server: it must ask for nothing outside that folder. */
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { launch, withPage } from "./support/browser.js";
import { screenshot } from "./support/screenshot.js";
import { serveDist } from "./support/server.js";

/** More colours than an empty canvas or a message has. */
const fewestColors = 50;

/** @type {import("playwright-core").Browser} */
let browser;
/** @type {import("../../scripts/lib/serve.mjs").Served} */
let served;

before(async () => {
  [browser, served] = await Promise.all([launch(), serveDist({ base: "/some/folder/" })]);
});
after(() => Promise.all([browser.close(), served.close()]));

test("the page shows a picture and stays inside its folder", async () => {
  await withPage(browser, {}, async (page) => {
    /** @type {string[]} */
    const outside = [];
    page.on("request", (request) => {
      if (!/^(data|blob):/.test(request.url()) && !request.url().startsWith(served.url)) outside.push(request.url());
    });
    const module = page.waitForResponse((response) => response.headers()["content-type"] === "application/wasm");
    await page.goto(served.url);
    assert.equal((await module).status(), 200);
    assert.match(await page.title(), /Directrix/);

    const canvas = page.locator("canvas").first();
    await canvas.waitFor();
    let colors = 0;
    for (const end = Date.now() + 30_000; colors < fewestColors && Date.now() < end; ) {
      colors = (await screenshot(canvas, "smoke")).colors();
    }
    assert.ok(colors >= fewestColors, `the canvas shows ${colors} colours`);
    assert.deepEqual(outside, []);
  });
});
