import assert from "node:assert/strict";
import { test } from "node:test";
import { screenshot } from "../support/screenshot.js";
import { onOnePage } from "./one-page.js";
import { openPage } from "./open.js";
import { documentOf, drawn, eventually, field, handle, middle, status, uiOf } from "./workbench.js";

/** @import { Page } from "playwright-core" */

const PHONE = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true, deviceScaleFactor: 2 };

/**
 * The colour of the canvas where nothing is drawn: the most frequent one along its upper edge.
 * @param {Page} page
 */
async function canvasColor(page) {
  const picture = await screenshot(page.locator("#stage"), "canvas");
  /** @type {Map<string, number>} */
  const counts = new Map();
  for (let x = 0; x < picture.width; x += 1) {
    const key = picture.at(x, 2).join(" ");
    counts.set(key, (counts.get(key) ?? 0) + 1);
  }
  return [...counts].sort((a, b) => b[1] - a[1])[0]?.[0];
}

test("dark and light follow the system, and the button overrides", async (t) => {
  const page = await openPage(t, { colorScheme: "dark" });
  assert.equal(await canvasColor(page), "14 15 18");
  await page.locator("[data-action=theme]").click();
  await eventually(async () => assert.equal(await canvasColor(page), "255 255 255"));
  await page.reload();
  await page.waitForSelector("html[data-ready=true]");
  await eventually(async () => assert.equal(await canvasColor(page), "255 255 255"));
  await page.locator("[data-action=theme]").click();
  await page.emulateMedia({ colorScheme: "light" });
  await eventually(async () => assert.equal(await canvasColor(page), "255 255 255"));
});

/**
 * At a size of the window nothing is wider than it, leaves it, or lies on something else.
 * @param {Page} page
 * @param {number} width
 * @param {number} height
 */
async function nothingIsLost(page, width, height) {
  await page.setViewportSize({ width, height });
  // The sheet moves to its place.
  await eventually(() => nothingOverlaps(page));
}

/** @param {Page} page */
async function nothingOverlaps(page) {
  const wide = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
  assert.ok(wide <= 0, `${wide} px too wide`);
  const overlapping = await page.evaluate(() => {
    const parts = [
      ...document.querySelectorAll(
        "#bar button, #bar a, #bar input[type=text], #morph-controls > *, #zoom > *, .certificates > *, .remark > *",
      ),
    ];
    const boxes = parts
      .map((part) => ({
        name: part.outerHTML.slice(0, 60),
        box: part.getBoundingClientRect(),
        shown: part.checkVisibility(),
      }))
      .filter(({ box, shown }) => shown && box.width > 0);
    /** @type {string[]} */
    const found = [];
    boxes.forEach(({ name, box }, i) => {
      if (box.left < -1 || box.right > innerWidth + 1) found.push(`${name} leaves the window`);
      for (const other of boxes.slice(i + 1)) {
        const x = Math.min(box.right, other.box.right) - Math.max(box.left, other.box.left);
        const y = Math.min(box.bottom, other.box.bottom) - Math.max(box.top, other.box.top);
        if (x > 1 && y > 1) found.push(`${name} and ${other.name}`);
      }
    });
    return found;
  });
  assert.deepEqual(overlapping, []);
}

onOnePage("on a desk", {
  "the inspector shows every group but the last at 1440 x 900 without scrolling": async (page) => {
    const hidden = () =>
      page.locator("#inspector").evaluate((inspector) => {
        const edge = inspector.getBoundingClientRect().bottom;
        const heads = [...inspector.querySelectorAll(".group-head")];
        return heads.filter((head) => head.getBoundingClientRect().bottom > edge).map((head) => head.closest("section")?.dataset.group);
      });
    await page.locator("[data-amounts]").waitFor();
    assert.deepEqual(await hidden(), ["layers"]);
  },

  "every handle is inside the canvas and clear of the controls when the page opens": async (page) => {
    const stage = await page.locator("#stage").boundingBox();
    const morph = await page.locator("#morph-controls").boundingBox();
    assert.ok(stage && morph);
    const { curves } = await documentOf(page);
    for (let i = 1; i <= curves[1].points.length; i += 1) {
      const [x, y] = await middle(handle(page, `B${i}`));
      assert.ok(
        x > stage.x + 6 && x < stage.x + stage.width - 6 && y > stage.y + 6 && y < morph.y - 4,
        `B${i} at ${x}, ${y}`,
      );
    }
  },

  "nothing is cut off or runs together at 1440 x 900": (page) => nothingIsLost(page, 1440, 900),
  "nothing is cut off or runs together at 1200 x 800": (page) => nothingIsLost(page, 1200, 800),
  "nothing is cut off or runs together at 1024 x 768": (page) => nothingIsLost(page, 1024, 768),
  "nothing is cut off or runs together at 700 x 800": (page) => nothingIsLost(page, 700, 800),

  // On a tablet held upright a title ran into the workbenches and the commands beside it.
  "a long title gives way": async (page) => {
    await page.locator("#bar input[type=text]").fill("A block with a volume fillet, and a title that goes on");
    await page.keyboard.press("Enter");
    for (const width of [600, 768, 900, 1200]) await nothingIsLost(page, width, 800);
  },

  "between 600 and 899 px the inspector comes on demand": async (page) => {
    await page.setViewportSize({ width: 760, height: 800 });
    await drawn(page);
    const panel = page.locator("[data-action=panel]");
    await eventually(async () => assert.ok(await field(page, "normalWeight").isHidden()));
    await panel.click();
    await eventually(async () => assert.ok(await field(page, "normalWeight").isVisible()));
    assert.equal(await panel.getAttribute("aria-expanded"), "true");
    await field(page, "normalWeight").focus();
    await page.keyboard.press("Escape");
    await page.keyboard.press("Escape");
    await page.locator("[data-group-button=matching]").focus();
    await page.keyboard.press("Escape");
    await eventually(async () => assert.ok(await field(page, "normalWeight").isHidden()));
  },
});

onOnePage(
  "in a narrow window",
  {
    "nothing is cut off or runs together at 390 x 844": (page) => nothingIsLost(page, 390, 844),
    "nothing is cut off or runs together at 320 x 640": (page) => nothingIsLost(page, 320, 640),
  },
  { viewport: { width: 390, height: 844 } },
);

onOnePage("on a phone", {
  "touch targets of the sheet are at least 44 px high": async (page) => {
    const small = await page.evaluate(() =>
      [...document.querySelectorAll("#inspector button, #inspector input, #inspector summary, .field")]
        .filter(
          (element) =>
            element.checkVisibility() && !element.matches("[data-grip], .segment input, .field input, .status button"),
        )
        .map((element) => ({
          name: element.outerHTML.slice(0, 70),
          height: (element.closest("label") ?? element).getBoundingClientRect().height,
        }))
        .filter(({ height }) => height < 44),
    );
    assert.deepEqual(small, []);
  },

  "on a phone the groups are tabs of a sheet with three stops": async (page) => {
    const sheet = async () => (await page.locator("#inspector").boundingBox())?.height ?? 0;
    assert.ok(Math.abs((await sheet()) - 411) < 3);
    assert.ok(await field(page, "normalWeight").isVisible());
    await page.locator("[data-tab=layers]").tap();
    await eventually(async () => assert.ok(await page.locator("[data-box=grid]").isVisible()));
    assert.ok(await field(page, "normalWeight").isHidden());
    const grip = page.locator("[data-grip]");
    await grip.tap();
    await eventually(async () => assert.ok((await sheet()) > 700));
    await grip.tap();
    await eventually(async () => assert.ok(Math.abs((await sheet()) - 88) < 1));
    assert.match(await status(page), /lines/);
    await grip.focus();
    await page.keyboard.press("ArrowUp");
    await eventually(async () => assert.ok(Math.abs((await sheet()) - 411) < 3));
  },

  "on a phone one menu holds gallery, files, export and theme": async (page) => {
    await page.locator("[data-action=menu]").tap();
    for (const name of ["gallery", "open", "save", "recent", "export", "theme"]) {
      await page.locator(`[data-item=${name}]`).scrollIntoViewIfNeeded();
      assert.ok(await page.locator(`[data-item=${name}]`).isVisible(), name);
    }
    await page.keyboard.press("Escape");
  },

  "a finger drags a point, two fingers zoom, and the page does not scroll": async (page) => {
    const touch = await page.context().newCDPSession(page);
    /** @param {string} type @param {...[number, number]} points */
    const send = (type, ...points) =>
      touch.send("Input.dispatchTouchEvent", {
        type: /** @type {"touchStart"} */ (type),
        touchPoints: points.map(([x, y], id) => ({ x, y, id })),
      });
    const before = await documentOf(page);
    const [x, y] = await middle(handle(page, "B3"));
    await send("touchStart", [x + 9, y + 9]);
    assert.ok(await handle(page, "B3").evaluate((element) => element.classList.contains("touched")));
    for (const step of [1, 2, 3, 4]) await send("touchMove", [x + 9 - 8 * step, y + 9 + 5 * step]);
    await send("touchEnd");
    await eventually(async () =>
      assert.notDeepEqual((await documentOf(page)).curves[1].points[2], before.curves[1].points[2]),
    );
    assert.deepEqual((await documentOf(page)).curves[0], before.curves[0]);

    const scale = (await uiOf(page)).view.scale;
    const stage = await page.locator("#stage").boundingBox();
    assert.ok(stage);
    const [cx, cy] = [stage.x + stage.width / 2, stage.y + 160];
    await send("touchStart", [cx - 20, cy], [cx + 20, cy]);
    for (const apart of [30, 40, 50, 60]) await send("touchMove", [cx - apart, cy], [cx + apart, cy]);
    await send("touchEnd");
    await eventually(async () => {
      const now = (await uiOf(page)).view.scale;
      assert.ok(now / scale > 2 && now / scale < 4, `${now / scale}`);
    });
    assert.equal(await page.evaluate(() => scrollY), 0);
  },
}, PHONE);

