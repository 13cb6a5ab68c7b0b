import assert from "node:assert/strict";
import { test } from "node:test";
import { audit, auditThemes } from "../support/axe.js";
import { onOnePage } from "./one-page.js";
import { openPage } from "./open.js";
import { eventually, field, handle } from "./workbench.js";

const PHONE = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true };

for (const [name, options] of /** @type {const} */ ([
  ["on a desk", {}],
  ["on a phone", PHONE],
])) {
  test(`axe finds nothing wrong ${name}, light and dark`, async (t) => {
    const page = await openPage(t, options);
    assert.deepEqual(await auditThemes(page), []);
  });
}

onOnePage("the page for everyone", {
  "handles say their name, place and how to move them": async (page) => {
    const group = page.locator("[data-curve='0']");
    assert.equal(await group.getAttribute("role"), "application");
    const help = await group.getAttribute("aria-describedby");
    assert.match((await page.locator(`#${help}`).textContent()) ?? "", /Arrow keys/);
    assert.match((await handle(page, "A1").getAttribute("aria-label")) ?? "", /^A1, x .+, y .+$/);
    assert.equal(await page.locator("[role=application]").count(), 2);
  },

  "focus is always seen": async (page) => {
    await page.locator("body").press("Tab");
    for (let i = 0; i < 40; i += 1) {
      await page.keyboard.press("Tab");
      const seen = await page.evaluate(() => {
        /** @param {Element | null} e @returns {boolean} */
        const ringed = (e) => {
          if (!e || e === document.body) return false;
          const style = getComputedStyle(e);
          return style.outlineStyle !== "none" && parseFloat(style.outlineWidth) >= 2;
        };
        const e = document.activeElement;
        if (!e || e === document.body) return true;
        const thumb =
          e.matches("input[type=range]") && getComputedStyle(e, "::-webkit-slider-thumb").outlineStyle !== undefined;
        return ringed(e) || ringed(e.nextElementSibling) || ringed(e.closest(".field")) || thumb;
      });
      assert.ok(seen, await page.evaluate(() => document.activeElement?.outerHTML.slice(0, 120)));
    }
  },

  "the order of Tab: bar, modes, reading, inner curve, outer curve, morph, grid, zoom, inspector": async (page) => {
    await page.waitForSelector("[data-segment=mode]");
    await page.locator("[data-action=share]").focus();
    const order = [];
    for (let i = 0; i < 12; i += 1) {
      await page.keyboard.press("Tab");
      order.push(
        await page.evaluate(() => {
          const e = /** @type {HTMLElement} */ (document.activeElement);
          return (
            e.id ||
            e.dataset.handle?.[0] ||
            (e.matches("[data-segment=mode] input") ? "mode" : null) ||
            (e.dataset.play !== undefined ? "play" : null) ||
            e.dataset.slider ||
            e.dataset.zoom ||
            e.dataset.groupButton
          );
        }),
      );
    }
    assert.deepEqual(order, ["mode", "probe-keys", "A", "B", "play", "s", "grid", "snap", "minus", "plus", "fit", "curves"]);
  },

  "axe finds nothing wrong with all groups, a menu, an error and a reading open": async (page) => {
    for (const group of ["sampling", "blend"]) await page.locator(`[data-group-button=${group}]`).click();
    await field(page, "x").fill("none");
    await page.locator("#probe-keys").focus();
    await page.keyboard.press("ArrowRight");
    await eventually(async () => assert.ok(await page.locator("#probe").isVisible()));
    assert.deepEqual(await audit(page), []);
    await page.locator("[data-action=file]").click();
    await eventually(async () => assert.ok(await page.locator("[role=menu]").isVisible()));
    assert.deepEqual(await audit(page), []);
  },

  "axe does find what is wrong": async (page) => {
    await page.evaluate(() => {
      const bad = document.createElement("button");
      bad.innerHTML = '<span style="color: #eee; background: #fff"></span>';
      document.querySelector("#bar")?.append(bad);
    });
    const found = await audit(page);
    assert.ok(
      found.some((each) => each.startsWith("button-name")),
      `${found}`,
    );
  },
});

