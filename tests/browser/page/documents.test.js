import assert from "node:assert/strict";
import { test } from "node:test";
import { exported } from "./exporting.js";
import { onOnePage } from "./one-page.js";
import { openPage } from "./open.js";
import { documentOf, drag, eventually, field, handle, middle, status, uiOf } from "./workbench.js";

onOnePage("documents", {
  "menus are left with Escape and gone through with arrows": async (page) => {
    const button = page.locator("[data-action=file]");
    await button.focus();
    await page.keyboard.press("ArrowDown");
    const focused = () => page.evaluate(() => document.activeElement?.getAttribute("data-item"));
    await eventually(async () => assert.equal(await focused(), "new"));
    await page.keyboard.press("End");
    assert.equal(await focused(), "about");
    await page.keyboard.press("Escape");
    assert.equal(await page.locator("[role=menu]").count(), 0);
    assert.ok(await button.evaluate((element) => element === document.activeElement));
  },

  "undo to the start restores the document to the byte, redo the last one": async (page) => {
    const states = [JSON.stringify(await documentOf(page))];
    const edits = [
      async () => drag(page, await middle(handle(page, "B3")), [-20, 12]),
      async () => {
        await handle(page, "A1").focus();
        await page.keyboard.press("ArrowUp");
      },
      async () => {
        await field(page, "distanceWeight").fill("1.7");
        await page.keyboard.press("Enter");
      },
      () => page.locator("[data-holder='1-0']").click(),
      async () => {
        await handle(page, "A4").focus();
        await page.keyboard.press("Delete");
      },
      async () => {
        await field(page, "title").fill("Changed");
        await page.keyboard.press("Enter");
      },
    ];
    for (const edit of edits) {
      await edit();
      const now = await eventually(async () => {
        const text = JSON.stringify(await documentOf(page));
        assert.notEqual(text, states.at(-1));
        return text;
      });
      states.push(now);
    }
    for (let i = states.length - 2; i >= 0; i -= 1) {
      await page.locator("[data-action=undo]").click();
      assert.equal(JSON.stringify(await documentOf(page)), states[i]);
    }
    await eventually(async () => assert.ok(await page.locator("[data-action=undo]").isDisabled()));
    for (let i = 1; i < states.length; i += 1) {
      await page.locator("[data-action=redo]").click();
      assert.equal(JSON.stringify(await documentOf(page)), states[i]);
    }
    await eventually(async () => assert.ok(await page.locator("[data-action=redo]").isDisabled()));
  },

  "a document of the required fields alone opens with all defaults, a clamped curve too": async (page) => {
    const ring = [[40, 0], [20, 35], [-20, 35], [-40, 0], [-20, -35], [20, -35]];
    const bare = {
      directrix: 1,
      kind: "curves",
      matching: { method: "greedy" },
      curves: [
        { degree: 2, form: "clamped", points: [[10, 0], [10, 10], [-10, 10], [-10, -10], [10, -10], [10, 0]] },
        { degree: 3, form: "periodic", points: ring },
      ],
    };
    const buffer = Buffer.from(JSON.stringify(bare));
    await page.locator("[data-file]").setInputFiles({ name: "bare.json", mimeType: "application/json", buffer });
    const document = await eventually(async () => {
      const found = await documentOf(page);
      assert.equal(found.title, "Untitled");
      return found;
    });
    await page.waitForSelector("#status[data-verdict=verified]");
    assert.deepEqual(document.curves.map((/** @type {{ composition: unknown }} */ curve) => curve.composition), [[{ at: 0, mix: [1, 0] }], [{ at: 0, mix: [0, 1] }]]);
    await handle(page, "A1").focus();
    await page.keyboard.press("Shift+ArrowRight");
    const { points } = (await documentOf(page)).curves[0];
    assert.deepEqual(points.at(-1), points[0], "the seam of a clamped curve moves as one");
    assert.notDeepEqual(points[0], [10, 0]);
  },

  "an exported document opens again as it was, dropped on the page": async (page) => {
    await handle(page, "B2").focus();
    await page.keyboard.press("Shift+ArrowUp");
    const document = await documentOf(page);
    const text = (await exported(page, "json")).toString("utf8");
    await page.keyboard.press("Escape");
    await handle(page, "B2").focus();
    await page.keyboard.press("ArrowUp");
    await page.evaluate((content) => {
      const data = new DataTransfer();
      data.items.add(new File([content], "mine.json", { type: "application/json" }));
      window.dispatchEvent(new DragEvent("drop", { dataTransfer: data, bubbles: true, cancelable: true }));
    }, text);
    await eventually(async () => assert.deepEqual(await documentOf(page), document));
  },
});

test("a reload loses nothing", async (t) => {
  const page = await openPage(t);
  await handle(page, "B5").focus();
  await page.keyboard.press("Shift+ArrowRight");
  await page.locator("[data-box=normals]").check();
  await page.locator("[data-zoom=plus]").click();
  const document = await documentOf(page);
  const ui = await uiOf(page);
  await page.reload();
  await page.waitForSelector("html[data-ready=true]");
  assert.deepEqual(await documentOf(page), document);
  assert.deepEqual(await uiOf(page), ui);
  assert.equal(await page.locator("[data-state]").textContent(), "Edited");
});

/** A document that left out its compositions was opened in part: the panel of the materials stopped at them. */
test("leaving and coming back keeps the work", async (t) => {
  const page = await openPage(t);
  await handle(page, "B5").focus();
  await page.keyboard.press("Shift+ArrowRight");
  const document = await documentOf(page);
  await page.goto("about:blank");
  await page.goBack();
  await page.waitForSelector("html[data-ready=true]");
  assert.deepEqual(await documentOf(page), document);
});

const BAD = [
  { name: "text.json", text: "{ not json", says: /not JSON/ },
  { name: "kind.json", text: '{"directrix": 1, "kind": "soup"}', says: /kind/ },
  { name: "missing.json", text: '{"directrix": 1, "kind": "curves"}', says: /curves|matching/ },
];

onOnePage("a bad file is refused with its reason", {
  ...Object.fromEntries(BAD.map(({ name, text, says }) => [name, async (page) => {
    const before = JSON.stringify(await documentOf(page));
    await page.locator("[data-file]").setInputFiles({ name, mimeType: "application/json", buffer: Buffer.from(text) });
    await eventually(async () => assert.match(await status(page), new RegExp(`Could not open ${name}`)));
    assert.match(await status(page), says);
    assert.match(await status(page), /unchanged/);
    assert.equal(JSON.stringify(await documentOf(page)), before);
  }])),
  "the path of a wrong field is named": async (page) => {
    const document = await documentOf(page);
    document.curves[0].points[3][1] = "high";
    const buffer = Buffer.from(JSON.stringify(document));
    await page.locator("[data-file]").setInputFiles({ name: "high.json", mimeType: "application/json", buffer });
    await eventually(async () => assert.match(await status(page), /curves\[0\]\.points\[3\]\[1\]/));
    const isWhole = await page.locator("[data-reason]").evaluate(({ scrollWidth, clientWidth }) => scrollWidth <= clientWidth);
    assert.ok(isWhole, "the reason is read to its end");
    assert.doesNotMatch(await status(page), /mean/, "measures make room for it");
  },
});

