/**
 * A walk through every state of the page, with axe at each stop. A page is loaded once for a walk, and axe looks at what the state has changed;
 * what lies on the canvas, which axe cannot judge, is measured.
 *
 * @import { Page } from "playwright-core"
 */
import assert from "node:assert/strict";
import { test } from "node:test";
import { audit } from "../support/axe.js";
import { openPage } from "./open.js";
import { drag, eventually, field, handle, middle, pick } from "./workbench.js";

const DRAWING = '<svg xmlns="http://www.w3.org/2000/svg"><circle id="hole" cx="100" cy="100" r="30"/><rect id="plate" x="20" y="20" width="160" height="160"/></svg>';

/** @param {Page} page @param {string} name @param {string} content */
const choose = (page, name, content) =>
  page.locator("[data-file]").setInputFiles({ name, mimeType: "text/plain", buffer: Buffer.from(content) });

/** @param {Page} page @param {string} name */
async function panel(page, name) {
  await page.locator(`[data-panel=${name}]`).waitFor();
  return [`[data-panel=${name}]`];
}

/** @param {Page} page @param {string} item of the menu File */
async function fileItem(page, item) {
  await page.locator("[data-action=file]").click();
  await page.locator(`[data-item=${item}]`).click();
}

/** @param {Page} page @param {string} preset */
async function open(page, preset) {
  await page.locator("[data-action=gallery]").click();
  await page.locator(`[data-preset=${preset}]`).click();
  await page.locator("[data-panel=gallery]").waitFor({ state: "detached" });
}

/**
 * The stops: what leads to a state, and the parts of the page that it changes.
 * @type {[string, (page: Page) => Promise<string[]>][]}
 */
const STOPS = [
  ["gallery", async (page) => (await page.locator("[data-action=gallery]").click(), panel(page, "gallery"))],
  ["export", async (page) => (await page.locator("[data-action=export]").click(), panel(page, "export"))],
  ["recent documents", async (page) => (await fileItem(page, "recent"), panel(page, "recent"))],
  ["shortcuts", async (page) => (await fileItem(page, "shortcuts"), panel(page, "shortcuts"))],
  ["about", async (page) => {
    await fileItem(page, "about");
    await page.locator("[data-part]").first().waitFor();
    return panel(page, "about");
  }],
  ["import", async (page) => (await choose(page, "washers.svg", DRAWING), panel(page, "import"))],
  ["menu", async (page) => {
    await page.locator("[data-close]").click();
    await page.locator("[data-action=file]").click();
    await page.locator("[role=menu]").waitFor();
    return ["[role=menu]", "#bar"];
  }],
  ["all groups and an error", async (page) => {
    await page.keyboard.press("Escape");
    const closed = page.locator("[data-group-button][aria-expanded=false]");
    await eventually(async () => {
      if ((await closed.count()) > 0) await closed.first().click();
      assert.equal(await closed.count(), 0);
    });
    await field(page, "x").fill("none");
    await page.locator(".field-error:not([hidden])").first().waitFor();
    return ["#inspector", "#status"];
  }],
  ["patterns", async (page) => {
    await field(page, "x").press("Escape");
    await page.locator("[data-box=patterns]").check();
    await page.locator(".legend .hatched").first().waitFor();
    return ["#stage", "#inspector"];
  }],
  ["composition keys", async (page) => {
    await page.locator("[data-box=patterns]").uncheck();
    await page.locator("[data-action=compose]").click();
    await page.locator(".key").first().waitFor();
    return ["#stage", "#inspector"];
  }],
  ["a reading", async (page) => {
    await page.locator("[data-action=compose]").click();
    await page.locator("#probe-keys").focus();
    await page.waitForSelector("#probe-keys[aria-valuemax]");
    await page.keyboard.press("ArrowRight");
    await page.locator("#probe:not([hidden])").waitFor();
    return ["#stage"];
  }],
  ["an explanation", async (page) => (await page.keyboard.press("Enter"), panel(page, "explain"))],
  ["a drag", async (page) => {
    await page.keyboard.press("Escape");
    await drag(page, await middle(handle(page, "B3")), [30, 20], { release: false });
    await page.locator(".handle.held").waitFor();
    return ["#stage", "#status"];
  }],
  ["curves that cross", async (page) => {
    await page.mouse.up();
    await drag(page, await middle(handle(page, "B3")), [-420, 230]);
    await page.waitForSelector("#status[data-verdict=error], #status[data-verdict=problems]");
    return ["#stage", "#status"];
  }],
  ["steps", async (page) => {
    await page.keyboard.press("Control+z");
    await pick(page, "mode", "steps");
    await page.locator(".steps-code [aria-current]").waitFor();
    return ["#stage", "#inspector", "#status"];
  }],
  ["the game", async (page) => {
    await page.locator("[data-steps=predict]").click();
    await page.locator(".steps-ask").waitFor();
    return ["#stage"];
  }],
  ["the comparison", async (page) => {
    await pick(page, "mode", "compare");
    await page.locator(".method-eta:not(:empty)").nth(5).waitFor();
    return ["#stage", "#inspector", "#status"];
  }],
  ["curves that cannot be matched", async (page) => {
    await pick(page, "mode", "figure");
    await open(page, "closed-pocket");
    await page.locator("#status [data-command=repair]").waitFor();
    return ["#stage", "#status"];
  }],
  ["no curve yet", async (page) => {
    await page.keyboard.press("Escape");
    await fileItem(page, "new");
    await page.locator(".empty").waitFor();
    return ["#stage", "#inspector", "#status", "#bar"];
  }],
  ["drawing", async (page) => {
    await page.locator("[data-command=draw]").click();
    await page.locator(".draw-bar").waitFor();
    return ["#stage", "#status"];
  }],
];

for (const colorScheme of /** @type {const} */ (["light", "dark"])) {
  test(`axe finds nothing wrong in any state, ${colorScheme}`, async (t) => {
    const page = await openPage(t, { colorScheme });
    await page.locator("[data-segment=mode]").waitFor();
    await t.test("words and marks over the canvas stand out", async () => {
      await eventually(async () => {
        const found = await overlays(page);
        assert.ok(found.length > 24, `${found.length}`);
        for (const { name, ratio, least } of found) assert.ok(ratio >= least, `${name}: ${ratio.toFixed(2)}`);
      });
    });
    for (const [name, go] of STOPS) {
      const parts = await go(page).catch((error) => assert.fail(`${name}: ${error}`));
      assert.deepEqual(await audit(page, parts), [], name);
    }
  });
}

test("axe finds nothing wrong at any stop of the sheet on a phone", async (t) => {
  const page = await openPage(t, { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true, colorScheme: "dark" });
  for (const stop of ["half", "full", "low"]) {
    await page.evaluate((at) => (document.documentElement.dataset.sheet = at), stop);
    assert.deepEqual(await audit(page, ["#inspector", "#stage"]), [], stop);
  }
  await page.locator("[data-action=menu]").click();
  await page.locator("[role=menu]").waitFor();
  assert.deepEqual(await audit(page, ["[role=menu]"]), []);
});

/**
 * Contrasts of words and marks over the canvas: of their colour with the ground they bring along, or with the canvas below them.
 * @param {Page} page
 */
const overlays = (page) =>
  page.evaluate(() => {
    const parts = (/** @type {string} */ text) => (text.match(/[\d.]+/g) ?? []).map(Number);
    const luminance = (/** @type {number[]} */ rgb) => {
      const [r = 0, g = 0, b = 0] = rgb.map((value) => (value / 255 <= 0.04045 ? value / 255 / 12.92 : ((value / 255 + 0.055) / 1.055) ** 2.4));
      return 0.2126 * r + 0.7152 * g + 0.0722 * b;
    };
    const contrast = (/** @type {number[]} */ a, /** @type {number[]} */ b) => {
      const [low = 0, high = 0] = [luminance(a), luminance(b)].sort((p, q) => p - q);
      return (high + 0.05) / (low + 0.05);
    };
    const canvas = parts(getComputedStyle(document.querySelector("#picture") ?? document.body).backgroundColor);
    /** @type {{name: string, ratio: number, least: number}[]} */
    const found = [];
    for (const element of document.querySelectorAll("#stage .handle-name, #stage .legend span, #scale, .morph-end, .morph-reading, .zoom-value, .modes label span")) {
      if (!element.checkVisibility() || !element.textContent?.trim()) continue;
      const { color, backgroundColor } = getComputedStyle(element);
      const own = parts(backgroundColor);
      found.push({ name: element.className || element.id, ratio: contrast(parts(color), own[3] === 0 || own.length < 3 ? canvas : own), least: 4.5 });
    }
    for (const mark of document.querySelectorAll(".handle")) {
      const { backgroundColor, boxShadow } = getComputedStyle(mark, "::before");
      // A handle brings its own ring and ground, so that it shows on every colour of the band.
      found.push({ name: mark.className, ratio: contrast(parts(backgroundColor), parts(/rgba?\([^)]*\)/.exec(boxShadow)?.[0] ?? "")), least: 3 });
    }
    return found;
  });
