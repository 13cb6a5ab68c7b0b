/**
 * The documentation in a browser, in a folder of a web server: its pages, the links between them, its figures, and what it asks for.
 *
 * @import { Browser, Page } from "playwright-core"
 * @import { DirectrixFigure } from "../../js/element.js"
 */
import assert from "node:assert/strict";
import { readFile, readdir } from "node:fs/promises";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { readLink } from "../../js/link.js";
import { tested } from "../../scripts/lib/documentation.mjs";
import { eventually } from "./page/workbench.js";
import { audit } from "./support/axe.js";
import { launch, withPage } from "./support/browser.js";
import { serve } from "./support/server.js";

/** Width of a phone in CSS pixels. */
const phone = 390;

/** @type {Browser} */
let browser;
/** @type {import("../../scripts/lib/serve.mjs").Served} */
let served;
/** The names of all pages. @type {string[]} */
let names;

before(async () => {
  [browser, served] = await Promise.all([launch(), serve(tested.to, { base: tested.base })]);
  names = (await readdir(tested.to)).filter((file) => file.endsWith(".html") && file !== "404.html");
});
after(() => Promise.all([browser?.close(), served?.close()]));

/**
 * Opens a page and waits until its scripts have taken it over.
 * @param {Page} page
 * @param {string} name
 */
async function open(page, name) {
  await page.goto(served.url + name);
  await page.waitForFunction(() => /** @type {any} */ (document.querySelector("#app")).__vue_app__ !== undefined);
}

/**
 * What a figure says of its result once it has one, with the figure in the viewport.
 * @param {Page} page
 * @param {number} index
 */
async function resultOf(page, index) {
  const figure = page.locator("directrix-figure").nth(index);
  await figure.scrollIntoViewIfNeeded();
  return eventually(async () => {
    const result = await figure.evaluate((element) => /** @type {DirectrixFigure} */ (element).result);
    assert.ok(result, `figure ${index} shows nothing yet`);
    return result;
  });
}

test("every page opens on a phone without a complaint, asks nobody else, and its links lead somewhere", async () => {
  /** @type {Map<string, Set<string>>} */
  const anchors = new Map();
  /** @type {{on: string, to: URL}[]} */
  const links = [];
  /** @type {string[]} */
  const outside = [];
  await withPage(browser, { viewport: { width: phone, height: 844 }, hasTouch: true, isMobile: true }, async (page) => {
    page.on("request", (request) => {
      if (!/^(data|blob):/.test(request.url()) && !request.url().startsWith(served.url)) outside.push(request.url());
    });
    for (const name of names) {
      await open(page, name);
      const found = await page.evaluate(() => ({
        ids: [...document.querySelectorAll("[id]")].map(({ id }) => id),
        links: [...document.querySelectorAll("a")].map(({ href }) => href),
        broken: [...document.images].filter(({ complete, naturalWidth }) => complete && naturalWidth === 0).map(({ src }) => src),
        headings: document.querySelectorAll("main h1").length,
        width: document.documentElement.scrollWidth,
      }));
      anchors.set(new URL(name, served.url).pathname, new Set(found.ids));
      links.push(...found.links.map((to) => ({ on: name, to: new URL(to) })));
      assert.deepEqual(found.broken, [], name);
      assert.equal(found.headings, 1, name);
      assert.equal(found.width, phone, name);
    }
  });
  assert.deepEqual(outside, []);
  assert.ok(names.length > 9 && links.length > 100, `${names.length} pages with ${links.length} links`);

  /** @type {Map<string, Promise<boolean>>} */
  const there = new Map();
  const isThere = (/** @type {string} */ href) => {
    const known = there.get(href) ?? fetch(href, { method: "HEAD" }).then(({ ok }) => ok);
    there.set(href, known);
    return known;
  };
  for (const { on, to } of links) {
    if (to.origin !== new URL(served.url).origin) {
      assert.equal(to.protocol, "https:", `${on} leads to ${to.href}`);
      continue;
    }
    const path = to.pathname.endsWith("/") ? `${to.pathname}index.html` : to.pathname;
    assert.ok(await isThere(new URL(path, to).href), `${on} leads to ${to.href}, which is not there`);
    const ids = anchors.get(path);
    if (to.hash && ids) assert.ok(ids.has(decodeURIComponent(to.hash.slice(1))), `${on} leads to ${to.href}, where nothing has this name`);
  }
});

test("figures come alive as they are reached, without moving the text", async () => {
  await withPage(browser, { viewport: { width: 1280, height: 800 } }, async (page) => {
    await page.addInitScript(() => {
      const shifts = { total: 0 };
      Object.assign(globalThis, { shifts });
      new PerformanceObserver((list) => {
        for (const entry of list.getEntries()) shifts.total += /** @type {any} */ (entry).value;
      }).observe({ type: "layout-shift", buffered: true });
    });
    await open(page, "five-pictures.html");
    const count = await page.locator("directrix-figure").count();
    assert.equal(count, 5);
    const results = [];
    for (let index = 0; index < count; index += 1) results.push(await resultOf(page, index));
    assert.deepEqual(results.map(({ ok }) => ok), [true, true, true, false, true]);
    assert.equal(results[0].eta?.toFixed(3), "1.000");
    const shifted = await page.evaluate(() => /** @type {any} */ (globalThis).shifts.total);
    assert.ok(shifted < 0.02, `what was there moved by ${shifted}`);
    // Bodies come alive as well, on a page that came by a link.
    await page.locator(".VPSidebar").getByRole("link", { name: "Hyperpatches" }).click();
    await page.locator("h1", { hasText: "Hyperpatches" }).waitFor();
    assert.equal((await resultOf(page, 0)).body?.cells, 8);
    assert.equal((await resultOf(page, 1)).body?.invalid, 1);
    assert.deepEqual(await audit(page), [], "hyperpatches.html");
  });
});

test("a figure is edited by keys, and opens in the application with the edit", async () => {
  await withPage(browser, {}, async (page) => {
    await open(page, "index.html");
    const before = await resultOf(page, 0);
    await page.locator("directrix-figure .handle").first().focus();
    await page.keyboard.press("Shift+ArrowUp");
    const figure = page.locator("directrix-figure").first();
    await eventually(async () => {
      const after = await figure.evaluate((element) => /** @type {DirectrixFigure} */ (element).result);
      assert.ok(after?.ok && after.eta !== before.eta);
    });
    const edited = await figure.evaluate((element) => /** @type {DirectrixFigure} */ (element).document?.curves[0].points[0]);
    assert.notDeepEqual(edited, [34, 6]);
    await eventually(async () => {
      const href = await page.locator("directrix-figure .open").first().evaluate((each) => /** @type {HTMLAnchorElement} */ (each).href);
      assert.ok(href.startsWith(`${served.url}app/index.html#`), href);
      assert.deepEqual(readLink(new URL(href).hash).document?.curves[0].points[0], edited);
    });
  });
});

test("the wheel over a figure scrolls the page", async () => {
  await withPage(browser, { viewport: { width: 1280, height: 800 } }, async (page) => {
    await open(page, "index.html");
    await resultOf(page, 0);
    await page.locator("directrix-figure").first().hover();
    const at = await page.evaluate(() => scrollY);
    await page.mouse.wheel(0, 240);
    await eventually(async () => assert.ok((await page.evaluate(() => scrollY)) >= at + 200));
  });
});

test("pages follow each other without loading anew, and their figures come alive", async () => {
  await withPage(browser, { viewport: { width: 1280, height: 800 } }, async (page) => {
    await open(page, "api.html");
    await page.evaluate(() => Object.assign(globalThis, { stayed: true }));
    await page.locator(".VPSidebar").getByRole("link", { name: "What it is" }).click();
    await page.locator("h1", { hasText: "What it is" }).waitFor();
    assert.equal((await resultOf(page, 1)).ok, true);
    assert.equal(await page.evaluate(() => /** @type {any} */ (globalThis).stayed), true);
  });
});

test("the search finds a word in the pages", async () => {
  await withPage(browser, { viewport: { width: 1280, height: 800 } }, async (page) => {
    await open(page, "index.html");
    await page.locator(".VPNavBarSearch button").first().click();
    await page.locator(".VPLocalSearchBox input").fill("divide and conquer");
    await page.locator(".VPLocalSearchBox .result").filter({ hasText: "Architecture" }).first().waitFor();
  });
});

test("dark pages have dark figures, and the switch takes them along", async () => {
  await withPage(browser, { viewport: { width: 1280, height: 800 }, colorScheme: "dark" }, async (page) => {
    await open(page, "what-it-is.html");
    await resultOf(page, 0);
    await page.locator('directrix-figure .frame[data-theme="dark"]').first().waitFor();
    await page.locator(".VPNavBarAppearance button").click();
    await page.locator('directrix-figure .frame[data-theme="light"]').first().waitFor();
    assert.equal(await page.locator("html").evaluate((root) => getComputedStyle(root).colorScheme), "light");
  });
});

for (const [colorScheme, pages] of /** @type {const} */ ([
  ["light", ["index.html", "embedding.html"]],
  ["dark", ["first-steps.html"]],
])) {
  test(`axe finds nothing on ${colorScheme} pages`, async () => {
    await withPage(browser, { colorScheme, viewport: { width: 1280, height: 800 } }, async (page) => {
      for (const name of pages) {
        await open(page, name);
        if (name !== "embedding.html") await resultOf(page, 0);
        assert.deepEqual(await audit(page), [], name);
      }
    });
  });
}

test("the licences of what the pages carry lie beside them", async () => {
  const parts = JSON.parse(await readFile(join(tested.to, "licences.json"), "utf8"));
  const found = parts.map((/** @type {{name: string}} */ { name }) => name);
  for (const name of ["@fontsource-variable/inter", "vitepress", "vue"]) assert.ok(found.includes(name), name);
  JSON.parse(await readFile(join(tested.to, "app/licences.json"), "utf8"));
});
