import assert from "node:assert/strict";
import { test } from "node:test";
import { audit } from "../support/axe.js";
import { onOnePage } from "./one-page.js";
import { openPage } from "./open.js";
import { choose, chooseCurve, command, drawByClicks, newDocument, PHONE } from "./drawing.js";
import { documentOf, eventually, field, handle, middle, onOutline, outline, spoken, status, uiOf } from "./workbench.js";

test("a curve is duplicated to one that nests, and with two it is copied over the other", async (t) => {
  const page = await openPage(t);
  await newDocument(page);
  await drawByClicks(page, 120, 6);
  await page.keyboard.press("Control+d");
  await eventually(async () => assert.equal((await documentOf(page)).curves.length, 2));
  await eventually(async () => assert.match(await status(page), /Verified/));
  assert.deepEqual((await uiOf(page)).selection, { curve: 1, points: [] });
  await page.locator("[data-action=more]").click();
  assert.match(await page.locator("[data-item=duplicate-curve]").innerText(), /Copy over inner/);
  await choose(page, "duplicate-curve");
  await eventually(async () => assert.deepEqual((await uiOf(page)).selection, { curve: 0, points: [] }));
  await eventually(async () => assert.match(await status(page), /Verified/));
});

onOnePage("commands", {
  "the menu key opens the menu of what has the focus, and escape gives the focus back": async (page) => {
    await handle(page, "A4").focus();
    await page.keyboard.press("Shift+F10");
    await page.waitForSelector("[role=menu]");
    assert.equal(await page.locator("[role=menu]").getAttribute("aria-label"), "A4");
    await page.keyboard.press("ArrowDown");
    await page.keyboard.press("Escape");
    assert.equal(await page.evaluate(() => document.activeElement?.getAttribute("data-handle")), "A4");
  },
  "the shortcut sheet lists the keys, every one that it lists works or is said to belong to the focus": async (page) => {
    await page.keyboard.press("?");
    const panel = page.locator("[data-panel=shortcuts]");
    await panel.waitFor();
    assert.deepEqual(await audit(page), []);
    const rows = await panel.locator("[data-keys]").evaluateAll((all) => all.map((e) => [e.getAttribute("data-keys"), e.textContent]));
    for (const name of ["undo", "fit", "grid", "snap", "draw", "select-all", "delete-points", "frame-turn", "nudge"]) {
      assert.ok(rows.some(([each]) => each === name), name);
    }
    for (const [name, text] of rows) assert.ok(text && !/undefined|\[object/.test(text), `${name}: ${text}`);
    const headings = await panel.locator("h3").allTextContents();
    assert.deepEqual(headings.slice(-7), ["Steps", "Compare", "Solid", "Hyperpatch", "Part", "Laplace", "Lessons"], "keys of the other modes");
    await page.keyboard.press("Escape");
    assert.equal(await panel.count(), 0);
    // The tooltips name the same keys.
    for (const [selector, key] of /** @type {const} */ ([
      ["[data-action=undo]", "Ctrl+Z"],
      ["[data-zoom=fit]", "F"],
      ["[data-zoom=grid]", "G"],
      ["[data-action=add-point]", "Insert"],
      ["[data-play]", "Space"],
    ])) {
      assert.ok((await page.locator(selector).getAttribute("title"))?.includes(`(${key})`), selector);
    }
  },
  "About names the version and the licences of what is shipped": async (page) => {
    await page.locator("[data-action=file]").click();
    await choose(page, "about");
    const panel = page.locator("[data-panel=about]");
    await panel.waitFor();
    assert.match(await panel.innerText(), /Version \d+\.\d+\.\d+/);
    for (const name of ["wasm-bindgen", "palette", "glam", "katex", "@fontsource-variable/inter"]) {
      await panel.locator(`[data-part="${name}"]`).waitFor();
    }
    assert.equal(await panel.locator("[data-part='proptest'], [data-part='serde_derive'], [data-part='vite']").count(), 0);
    const entry = panel.locator("[data-part='robust']");
    await entry.locator("summary").click();
    assert.match(await entry.locator("pre").innerText(), /Apache License/);
    assert.deepEqual(await audit(page), []);
    await page.keyboard.press("Escape");
    await eventually(async () => assert.equal(await panel.count(), 0));
  },
  "keys of the canvas do nothing while something else has the focus": async (page) => {
    const before = await documentOf(page);
    await handle(page, "B3").click();
    await page.locator("[data-group-button=blend]").focus();
    for (const key of ["Delete", "r", "x", "Shift+Delete", "Control+d"]) await page.keyboard.press(key);
    await field(page, "title").focus();
    await page.keyboard.press("d");
    await page.keyboard.press("Escape");
    await page.waitForTimeout(200);
    assert.deepEqual(await documentOf(page), before);
  },
  "a doubled point draws the curve to it": async (page) => {
    const { curves } = await documentOf(page);
    await handle(page, "A3").click();
    await command(page, "duplicate-point");
    await eventually(async () => assert.equal((await documentOf(page)).curves[0].points.length, curves[0].points.length + 1));
    const { points } = (await documentOf(page)).curves[0];
    assert.deepEqual(points[2], points[3]);
    await eventually(async () => assert.match(await spoken(page), /Doubled A3/));
  },
  "a curve is renamed from the menu and by F2": async (page) => {
    await chooseCurve(page, 1);
    await command(page, "rename-curve");
    await eventually(async () => assert.ok(await field(page, "curve-name").evaluate((e) => e === document.activeElement)));
    await page.keyboard.type("Hull");
    await page.keyboard.press("Enter");
    assert.equal((await documentOf(page)).curves[1].name, "Hull");
    await handle(page, "A1").focus();
    await page.keyboard.press("F2");
    await eventually(async () => assert.ok(await field(page, "curve-name").evaluate((e) => e === document.activeElement)));
  },
  "the degree changes in its field, and says what keeps it": async (page) => {
    await chooseCurve(page, 0);
    await field(page, "degree").fill("5");
    await page.keyboard.press("Enter");
    await eventually(async () => assert.equal((await documentOf(page)).curves[0].degree, 5));
    await eventually(async () => assert.match(await status(page), /Verified/));
    await field(page, "degree").fill("30");
    await page.keyboard.press("Enter");
    const most = (await documentOf(page)).curves[0].points.length - 1;
    await eventually(async () => assert.match(await status(page), new RegExp(`at most ${most}`)));
    assert.equal((await documentOf(page)).curves[0].degree, most);
  },
  "swap, reverse and delete change the document and are undone one by one": async (page) => {
    const first = await documentOf(page);
    await chooseCurve(page, 0);
    await command(page, "swap-curves");
    await eventually(async () => assert.deepEqual((await documentOf(page)).curves, [first.curves[1], first.curves[0]]));
    assert.equal((await uiOf(page)).selection.curve, 1);
    await eventually(async () => assert.match(await status(page), /Verified/));
    await command(page, "reverse-curve");
    await eventually(async () => assert.notDeepEqual((await documentOf(page)).curves[1].points, first.curves[0].points));
    await eventually(async () => assert.match(await status(page), /Verified/));
    await command(page, "delete-curve");
    await eventually(async () => assert.equal((await documentOf(page)).curves.length, 1));
    await eventually(async () => assert.match(await status(page), /One curve/));
    assert.ok(await page.locator("[data-curve-row='1']").isHidden());
    for (let i = 0; i < 3; i += 1) await page.keyboard.press("Control+z");
    assert.deepEqual(await documentOf(page), first);
  },
  "deleting both curves leads to the empty canvas and back": async (page) => {
    await chooseCurve(page, 0);
    await outline(page, 0).focus();
    await page.keyboard.press("Shift+Delete");
    await eventually(async () => assert.equal((await documentOf(page)).curves.length, 1));
    await command(page, "delete-curve");
    await eventually(async () => assert.ok(await page.locator("[data-empty=draw]").isVisible()));
    await page.keyboard.press("Control+z");
    await page.keyboard.press("Control+z");
    await eventually(async () => assert.match(await status(page), /Verified/));
    assert.ok(await page.locator("[data-empty=draw]").isHidden());
  },
  "a right click opens the menu of a point, a curve or the canvas": async (page) => {
    const items = async () => page.locator("[role=menu] [data-item]").evaluateAll((all) => all.map((e) => e.getAttribute("data-item")));
    await page.mouse.click(...(await middle(handle(page, "B3"))), { button: "right" });
    await page.waitForSelector("[role=menu]");
    assert.ok((await items()).includes("duplicate-point"));
    assert.equal(await page.locator("[role=menu]").getAttribute("aria-label"), "B3");
    assert.deepEqual(await audit(page), []);
    await page.keyboard.press("Escape");

    const [x, y] = await onOutline(page, 1);
    const count = (await documentOf(page)).curves[1].points.length;
    await page.mouse.click(x, y, { button: "right" });
    await page.waitForSelector("[role=menu]");
    assert.deepEqual((await uiOf(page)).selection, { curve: 1, points: [] });
    await choose(page, "insert-point");
    await eventually(async () => assert.equal((await documentOf(page)).curves[1].points.length, count + 1));

    const box = await page.locator("#picture").boundingBox();
    assert.ok(box);
    await page.mouse.click(box.x + 20, box.y + 60, { button: "right" });
    await page.waitForSelector("[role=menu]");
    assert.ok((await items()).includes("draw") && (await items()).includes("fit"));
    await choose(page, "grid");
    await eventually(async () => assert.ok(!(await uiOf(page)).layers.includes("grid")));
  },
  "corners are counted beside their curve and smoothed on request": async (page) => {
    const corner = {
      directrix: 1,
      kind: "curves",
      title: "Square in a ring",
      curves: [
        { degree: 2, form: "clamped", points: [[8, 8], [-8, 8], [-8, -8], [8, -8], [8, 8]], knots: [0, 0, 0, 0.4, 0.6, 1, 1, 1] },
        { degree: 3, form: "periodic", points: [[40, 0], [0, 40], [-40, 0], [0, -40]] },
      ],
      matching: { method: "greedy" },
    };
    await page.locator("input[data-file]").setInputFiles({
      name: "square.json",
      mimeType: "application/json",
      buffer: Buffer.from(JSON.stringify(corner)),
    });
    await eventually(async () => assert.equal((await documentOf(page)).title, "Square in a ring"));
    await chooseCurve(page, 1);
    assert.ok(await page.locator("[data-action=smooth]").isHidden());
    await chooseCurve(page, 0);
    const smooth = page.locator("[data-action=smooth]");
    await eventually(async () => assert.ok(await smooth.isVisible()));
    assert.match(await page.locator(".corner-note").innerText(), /1 corner/);
    // In the picture it wears its bisector, and the status line says what it costs.
    const mark = page.locator(".corner-mark:visible");
    await eventually(async () => assert.equal(await mark.count(), 1));
    const [x, y] = await middle(mark.locator(".place"));
    const [hx, hy] = await middle(handle(page, "A1"));
    assert.ok(Math.hypot(x - hx, y - hy) < 2, "it lies at the corner");
    const eta = Number(/η\s*(\S+)/.exec(await status(page))?.[1]);
    await page.locator("[data-certificate=corners]").click();
    await eventually(async () => assert.match(await status(page), /The corner: 90°, with the bisector for its normal\. J is [\d.]+.% below its bound/));
    const told = Number(/J is ([\d.]+)/.exec(await status(page))?.[1]);
    assert.ok(eta > 0 && Math.abs(told - 100 * (1 - eta)) <= 0.1, `${told} % below where eta is ${eta}`);
    await eventually(async () => assert.match(await spoken(page), /On inner, x 8\.00, y 8\.00/));
    assert.ok(await mark.evaluate((element) => element.classList.contains("chosen")));
    assert.deepEqual(await audit(page), []);
    await smooth.click();
    await eventually(async () => assert.equal((await documentOf(page)).curves[0].form, "periodic"));
    await eventually(async () => assert.ok(await smooth.isHidden()));
    await eventually(async () => assert.equal(await mark.count(), 0));
    await page.keyboard.press("Control+z");
    await eventually(async () => assert.ok(await smooth.isVisible()));
  },
});

test("on a phone every command is behind the three dots", async (t) => {
  const page = await openPage(t, PHONE);
  await page.locator("[data-tab=curves]").tap();
  await page.locator("[data-curve-row='0']").tap();
  await page.locator("[data-action=more]").tap();
  const menu = page.locator("[role=menu]");
  await menu.waitFor();
  for (const each of await menu.locator("[data-item]").all()) {
    assert.ok(((await each.boundingBox())?.height ?? 0) >= 44, (await each.getAttribute("data-item")) ?? "");
  }
  await menu.locator("[data-item=reverse-curve]").tap();
  await eventually(async () => assert.match(await spoken(page), /Reversed inner/));
});
