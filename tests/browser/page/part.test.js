/** The workbench Part: what its pictures show, how it is read, its checks, rules side by side, files. */
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { test } from "node:test";
import { load } from "directrix";
import { audit } from "../support/axe.js";
import { idle } from "./idle.js";
import { onOnePage } from "./one-page.js";
import { openPage } from "./open.js";
import { hashOf, offered, share } from "./sharing.js";
import { documentOf, drag, eventually, field, middle, pick, spoken, status, uiOf } from "./workbench.js";

/** @import { Page } from "playwright-core" */

const dx = await load();

/** An outline that crosses itself, limits in the wrong order, and a name that no shape has. */
const BROKEN = {
  directrix: 1,
  kind: "part",
  title: "Broken",
  shapes: [
    { name: "bow", kind: "polygon", points: [[0, 0], [100, 60], [100, 0], [0, 60]] },
    { name: "plate", kind: "polygon", points: [[120, 0], [180, 0], [180, 60], [120, 60]] },
  ],
  bodies: [
    { name: "first", outline: "bow" },
    { name: "second", outline: "plate", features: [{ name: "F", reference: "plate", from: 20, to: 10, start: [0, 1] }, { name: "G", reference: "nowhere", to: 10, start: [0, 1] }] },
  ],
};

/** Waits until the part as it stands is painted with all its pixels and measured. @param {Page} page */
const measured = (page) => page.locator(".part-stage[data-part=measured]").waitFor();

/** Where a place of the plane lies on the screen. @param {Page} page @param {[number, number]} at @returns {Promise<[number, number]>} */
async function onScreen(page, [x, y]) {
  const { view } = await uiOf(page);
  const box = await page.locator(".part-stage").boundingBox();
  assert.ok(box && view);
  return [box.x + box.width / 2 + (x - view.center[0]) * view.scale, box.y + box.height / 2 - (y - view.center[1]) * view.scale];
}

/** The colour of a canvas at a place of the screen. @param {Page} page @param {string} canvas @param {[number, number]} at @returns {Promise<number[]>} */
const colorAt = (page, canvas, at) =>
  page.evaluate(
    ([selector, [px, py]]) => {
      const source = /** @type {HTMLCanvasElement} */ (document.querySelector(/** @type {string} */ (selector)));
      const box = source.getBoundingClientRect();
      const ratio = source.width / box.width;
      // Read from a copy, because a canvas that is read from often is painted without the graphics card.
      const copy = document.createElement("canvas");
      [copy.width, copy.height] = [1, 1];
      const context = copy.getContext("2d", { willReadFrequently: true });
      context?.drawImage(source, -Math.floor((Number(px) - box.x) * ratio), -Math.floor((Number(py) - box.y) * ratio));
      return [...(context?.getImageData(0, 0, 1, 1).data ?? [])];
    },
    /** @type {const} */ ([canvas, at]),
  );

/** What the kernel paints there. @param {any} document @param {[number, number]} at */
function kernelColor(document, [x, y]) {
  const { colors } = dx.part(document).evaluate({ box: [[x - 0.01, y - 0.01], [x + 0.01, y + 0.01]], size: [1, 1], colors: true });
  return [...(colors ?? [])];
}

/** Waits until the picture has the colours of the kernel at places. @param {Page} page @param {[number, number][]} places */
async function paintsAsKernel(page, places) {
  await measured(page);
  await eventually(async () => {
    const document = await documentOf(page);
    for (const at of places) {
      const [found, wanted] = [await colorAt(page, ".part-stage > .part-picture", await onScreen(page, at)), kernelColor(document, at)];
      assert.ok(wanted.every((value, k) => Math.abs(value - found[k]) <= 4), `${found}, not ${wanted} at ${at}`);
    }
  });
}

onOnePage(
  "a part",
  {
    async "is painted with the colours of the kernel, verified, and named"(page) {
      await paintsAsKernel(page, [[10, 50], [60, 12], [80, 50], [15, 25], [29, 31]]);
      assert.equal(await page.locator("[data-bench=part]").getAttribute("aria-current"), "page");
      await eventually(async () => assert.match((await status(page)).replaceAll("\u2009", ""), /Broken: red changes slowly[\s\S]*area\s+6000\smm²/));
      await eventually(async () => assert.match((await page.locator(".part-stage > .part-picture").getAttribute("aria-label")) ?? "", /^Rectangle of two profiles\. 1 body, area 6000/));
      // A gradient of the fraction red on the whole left edge gives its area within a pixel of the closed form.
      await eventually(async () => assert.match((await page.locator("[data-part-amount='2']").innerText()).replace(/\s+/g, " "), /yellow 39\d\d mm² 6\d %/));
      assert.deepEqual(await audit(page), []);
    },

    async "is read by pointer and by keyboard"(page) {
      await measured(page);
      const [x, y] = await onScreen(page, [60, 12]);
      await page.mouse.move(x + 5, y);
      await page.mouse.move(x, y);
      const card = page.locator("[data-part-reading]");
      const place = dx.part(await documentOf(page)).probe([60, 12]);
      const green = Math.round(100 * (place?.fractions?.[1] ?? NaN));
      await eventually(async () => assert.match(await card.innerText(), new RegExp(`(60\\.0|59\\.9)[\\s\\S]*to B\\s+12\\.0.mm[\\s\\S]*green\\s+${green}.%`)));
      await page.mouse.move(4, 4);
      await eventually(async () => assert.ok(await card.isHidden()));

      await page.locator("[data-part-keys]").focus();
      await page.keyboard.press("ArrowRight");
      await eventually(async () => assert.match(await spoken(page), /^x \S+, y \S+, rectangle, .*%.*nearest [AB], [\d.]+ mm$/));
      const before = await spoken(page);
      await page.keyboard.press("Shift+ArrowDown");
      await eventually(async () => assert.notEqual(await spoken(page), before));
      await page.keyboard.press("Escape");
      await eventually(async () => assert.ok(await card.isHidden()));
    },

    async "has lines of equal fraction, hatched violations and named leaves"(page) {
      await measured(page);
      await openGroup(page, "display");
      await page.locator("[data-select=part-isolines]").selectOption("0");
      const lines = page.locator("[data-part-isolines]");
      await eventually(async () => assert.equal(((await lines.getAttribute("d")) ?? "").split("M").length - 1, 9));
      await eventually(async () => assert.match(await page.locator(".part-told").innerText(), /^red fraction, lines every 0\.1$/));
      await page.locator("[data-select=part-isolines]").selectOption("");
      await eventually(async () => assert.ok(await lines.isHidden()));

      // Where red changes too fast it is hatched, and the count is the kernel's.
      const { rules } = dx.part(await documentOf(page)).violations({ size: [1000, 600] });
      await openGroup(page, "checks");
      await eventually(async () => assert.match((await page.locator("[data-broken='0']").innerText()).replaceAll("\u2009", ""), new RegExp(`broken in ${rules[0].count} pixels`)));

      await pick(page, "part-look", "leaves");
      await openGroup(page, "leaves");
      await eventually(async () => assert.deepEqual((await page.locator("[data-leaf] .part-name").allInnerTexts()).sort(), ["A", "A ∩ B", "B", "no feature"]));
      await eventually(async () => assert.match((await page.locator("[data-leaf='0.3']").innerText()).replaceAll("\u2009", ""), /900\smm²/));
      const at = await onScreen(page, [83, 47]);
      await eventually(async () => assert.deepEqual(await colorAt(page, ".part-stage > .part-picture", at), [205, 208, 214, 255]));
      await page.locator("[data-leaf='0.3']").click();
      await eventually(async () => assert.ok((await colorAt(page, ".part-stage > .part-picture", at))[3] < 128));
      await page.locator("[data-leaf='0.3']").click();
      await pick(page, "part-look", "colors");
      await paintsAsKernel(page, [[80, 50]]);
    },

    async "is blended from its boundary, piece by piece, and says what is wrong beside the piece"(page) {
      const blend = async () => (await documentOf(page)).bodies[0].blend;
      await openGroup(page, "blend");
      await pick(page, "part-blend", "laplace");
      await eventually(async () => assert.deepEqual((await blend())?.boundaries, [{ on: "rectangle", within: 0, value: [0, 0, 1] }]));
      await eventually(async () => assert.match(await spoken(page), /rectangle is blended from its boundary/));
      assert.equal(await page.locator("[data-part-default='0'] .tree-name").innerText(), "Blend");

      // A piece of the outline is told by a shape on it, and lit while it is looked at.
      await page.locator("[data-action=add-piece]").click();
      await page.getByRole("menuitem", { name: "edge A" }).click();
      const line = page.locator("[data-blend-piece='edge A']");
      await eventually(async () => assert.equal(await line.getAttribute("aria-expanded"), "true"));
      await line.hover();
      await page.locator(".shape.lit").first().waitFor();
      const piece = page.locator(".blend-piece", { has: line });
      await piece.locator("input[data-field=percent-0]").fill("100");
      await piece.locator("input[data-field=percent-0]").press("Enter");
      await eventually(async () => assert.deepEqual((await blend())?.boundaries[1].value, [1, 0, 0]));
      await page.locator("[data-blend-piece=rectangle]").click();
      const rest = page.locator(".blend-piece", { has: page.locator("[data-blend-piece=rectangle]") });
      await rest.locator("[data-select=blend-condition]").selectOption("insulated");
      await eventually(async () => assert.deepEqual((await blend())?.boundaries[0], { on: "rectangle", within: 0 }));
      await paintsAsKernel(page, [[90, 50], [60, 45]]);
      assert.deepEqual(await audit(page), []);

      // The same place twice with different conditions: the piece says so, and the default is back until that is undone.
      await line.click();
      await piece.locator("input[data-field=blend-within]").fill("500");
      await piece.locator("input[data-field=blend-within]").press("Enter");
      await page.locator("[data-action=add-piece]").click();
      await page.getByRole("menuitem", { name: "edge B" }).click();
      const second = page.locator(".blend-piece", { has: page.locator("[data-blend-piece='edge B']") });
      await eventually(async () => assert.match(await second.locator(".part-fault").innerText(), /boundaries\[1\] has another condition/));
      await eventually(async () => assert.match(await status(page), /^1 problem/));
      await page.locator("[data-action=undo]").click();
      await eventually(async () => assert.doesNotMatch(await status(page), /problem/));
    },

    async "follows a drag with few pixels, and has all of them once it rests"(page) {
      await measured(page);
      const pixels = async () => Number((await page.locator("[data-total=pixels] .strong").innerText()).replaceAll("\u2009", ""));
      const all = await pixels();
      await page.locator('[data-part-shape="edge A"]').focus();
      const end = page.locator('[data-part-point="edge A.1"]');
      await end.waitFor();
      const from = await middle(end);
      await drag(page, from, [80, 0], { release: false });
      await eventually(async () => assert.ok((await shapeOf(page, "edge A")).to[0] > 1 || (await shapeOf(page, "edge A")).from[0] > 1));
      await page.locator(".part-stage[data-part=shown]").waitFor();
      await eventually(async () => assert.ok((await pixels()) < all / 2));
      await eventually(async () => {
        const [found, wanted] = [await colorAt(page, ".part-stage > .part-picture", await onScreen(page, [12, 40])), kernelColor(await documentOf(page), [12, 40])];
        assert.ok(wanted.every((value, k) => Math.abs(value - found[k]) <= 16), `${found}, not ${wanted}`);
      });
      await page.mouse.up();
      await paintsAsKernel(page, [[12, 40], [20, 12]]);
      await eventually(async () => assert.equal(await pixels(), all));
      await page.locator("[data-action=undo]").click();
      await eventually(async () => assert.deepEqual((await shapeOf(page, "edge A")).to, [0, 60]));
    },

    async "shows three rules side by side, of which one is adopted and taken back"(page) {
      await measured(page);
      await pick(page, "part-look", "compare");
      await page.locator("[data-part-rule=printed] .part-rule-differs", { hasText: /by up to \d\d/ }).waitFor();
      const picture = page.locator("[data-part-rule=repaired] .part-rule-picture");
      const box = await picture.boundingBox();
      assert.ok(box);
      await page.mouse.move(box.x + box.width * 0.9, box.y + box.height * 0.9);
      for (const rule of ["repaired", "depth", "printed"]) {
        await eventually(async () => assert.match(await page.locator(`[data-part-rule=${rule}] .part-rule-reading`).innerText(), /green\s+\d+.%/));
      }
      // Away from the overlap the printed rule fades the profile that the others keep.
      const share = async (/** @type {string} */ rule) => Number(/green\s+(\d+)/.exec(await page.locator(`[data-part-rule=${rule}] .part-rule-reading`).innerText())?.[1]);
      assert.ok((await share("printed")) < (await share("repaired")) - 20, `${await share("printed")} and ${await share("repaired")}`);
      assert.equal(await share("depth"), await share("repaired"));
      assert.deepEqual(await audit(page), []);

      await page.locator("[data-rule=printed]").click();
      await eventually(async () => assert.equal((await documentOf(page)).bodies[0].rule, "printed"));
      await eventually(async () => assert.equal(await page.locator("[data-rule=printed]").getAttribute("aria-pressed"), "true"));
      await eventually(async () => assert.match(await spoken(page), /rectangle follows the rule as printed/));
      await pick(page, "part-look", "colors");
      await measured(page);
      await openGroup(page, "display");
      const at = await onScreen(page, [95, 1]);
      const plain = await colorAt(page, ".part-stage > .part-picture", at);
      await page.locator("[data-box=part-difference]").check({ force: true });
      await eventually(async () => assert.notDeepEqual(await colorAt(page, ".part-stage > .part-picture", at), plain));
      await page.locator("[data-box=part-difference]").uncheck({ force: true });
      await eventually(async () => assert.deepEqual(await colorAt(page, ".part-stage > .part-picture", at), plain));
      await page.locator("[data-action=undo]").click();
      await eventually(async () => assert.equal((await documentOf(page)).bodies[0].rule, "repaired"));
      await paintsAsKernel(page, [[95, 1]]);
    },

    async "is zoomed, panned, fitted, and comes back after a reload and from other workbenches"(page) {
      await measured(page);
      const [x, y] = await onScreen(page, [50, 30]);
      await page.mouse.move(x, y);
      const { view } = await uiOf(page);
      await page.mouse.wheel(0, -400);
      await eventually(async () => assert.ok((await uiOf(page)).view.scale > 1.5 * view.scale));
      const near = await onScreen(page, [50, 30]);
      assert.ok(Math.hypot(near[0] - x, near[1] - y) < 1.5, `${near}, not ${[x, y]}`);
      await drag(page, await onScreen(page, [70, 45]), [30, 20]);
      await eventually(async () => {
        const moved = await onScreen(page, [50, 30]);
        assert.ok(Math.hypot(moved[0] - x - 30, moved[1] - y - 20) < 1.5, String(moved));
      });
      await paintsAsKernel(page, [[50, 20]]);
      const seen = (await uiOf(page)).view;

      await page.locator("[data-bench=curves]").click();
      await page.locator("#morph").waitFor();
      await page.locator("[data-bench=part]").click();
      await measured(page);
      await eventually(async () => assert.deepEqual((await uiOf(page)).view, seen));
      await page.reload();
      await measured(page);
      await eventually(async () => assert.deepEqual((await uiOf(page)).view, seen));
      await paintsAsKernel(page, [[50, 20]]);
      await page.locator(".part-stage > .part-picture").click({ position: { x: 40, y: 120 }, trial: true });
      await page.keyboard.press("f");
      await eventually(async () => assert.ok(Math.abs((await uiOf(page)).view.scale - view.scale) < 1e-9));
    },

    async "is written in files whose pixels and memory are known beforehand"(page) {
      await measured(page);
      await page.locator("[data-action=export]").click();
      const estimate = page.locator("[data-estimate]");
      await field(page, "part-longer").fill("100");
      await field(page, "part-longer").press("Enter");
      await eventually(async () => assert.match(await estimate.innerText(), /^100 × 60 = 6000 pixels, about 1 MiB/));
      assert.deepEqual(await audit(page), []);
      const document = await documentOf(page);
      const bytes = async (/** @type {string} */ ending) => {
        const [file] = await Promise.all([page.waitForEvent("download"), page.locator("[data-export=download]").click()]);
        assert.equal(file.suggestedFilename(), `rectangle-of-two-profiles.${ending}`);
        const content = await readFile(await file.path());
        // The page is done with it before the next one is asked for.
        await page.locator("[data-message]", { hasText: `.${ending}` }).waitFor();
        return content;
      };
      const size = /** @type {[number, number]} */ ([100, 60]);
      assert.ok((await bytes("png")).equals(dx.part(document).file({ format: "png", size })));
      await pick(page, "part-dither", "blue-noise");
      assert.ok((await bytes("png")).equals(dx.part(document).file({ format: "png", size, dither: "blue-noise" })));
      await pick(page, "part-format", "vti");
      assert.ok((await bytes("vti")).equals(dx.part(document).file({ format: "vti", size })));
      await pick(page, "part-format", "json");
      assert.deepEqual(JSON.parse((await bytes("json")).toString()), document);

      // Too many pixels are refused before anything is evaluated.
      await pick(page, "part-format", "csv");
      await field(page, "part-pitch").fill("0.01");
      await field(page, "part-pitch").press("Enter");
      await eventually(async () => assert.match((await estimate.innerText()).replaceAll("\u2009", ""), /10000 × 6000 = 60000000 pixels.*At most 4194304/));
      assert.equal(await page.locator("[data-export=download]").getAttribute("aria-disabled"), "true");
      await page.locator("[data-panel=export] [data-close]").click();
    },
  },
  { hash: "#v=1&preset=part-rectangle", viewport: { width: 1280, height: 800 } },
);

/** A shape of the open document. @param {Page} page @param {string} name */
async function shapeOf(page, name) {
  return (await documentOf(page)).shapes.find((/** @type {{name: string}} */ each) => each.name === name);
}

/** Opens a group of the inspector where it is closed. @param {Page} page @param {string} name */
async function openGroup(page, name) {
  const button = page.locator(`[data-group-button=${name}]`);
  if ((await button.getAttribute("aria-expanded")) !== "true") await button.click();
  await eventually(async () => assert.equal(await button.getAttribute("aria-expanded"), "true"));
}

/**
 * Lets a test have the module stop at the next question about a part whose text has some words, and hold questions back so that they take as long as it
 * wants. Small pictures of the gallery ask about other parts meanwhile, and took the fault on a busy machine.
 */
const WORKER = `{
  const Real = Worker;
  globalThis.Worker = class extends Real {
    postMessage(message, ...rest) {
      const isQuestion = message.type === "call" && message.name === "part";
      const isMeant = (words) => isQuestion && words && String(message.args[0]).includes(words);
      if (isMeant(globalThis.hold)) return;
      if (isMeant(globalThis.failNext)) {
        globalThis.failNext = "";
        const error = { code: "trap", path: "", message: "unreachable" };
        this.onmessage?.({ data: { type: "error", id: message.id, error } });
        return;
      }
      super.postMessage(message, ...rest);
    }
  };
}`;

test("every preset opens from the gallery; what is wrong is named; a new part is empty", async (t) => {
  const page = await openPage(t, { hash: "#v=1&preset=part-coating", viewport: { width: 1280, height: 800 }, colorScheme: "dark", init: WORKER });
  for (const id of ["base", "references", "lens", "scaffold", "tool", "rectangle"]) {
    await page.locator("[data-action=gallery]").click();
    await page.locator(`[data-preset=part-${id}]`).click();
    await idle(page);
    await measured(page);
    await eventually(async () => assert.match((await status(page)).replaceAll("\u2009", ""), /\d pixels|\d\spixels/));
  }
  await paintsAsKernel(page, [[10, 50], [60, 12]]);
  assert.deepEqual(await audit(page), []);

  // A module that stops, and a person who gives up, leave the edit in the document, and another try shows it.
  for (const [fault, rule, said] of /** @type {const} */ ([["failNext", "depth", /started again/], ["hold", "repaired", /Cancelled/]])) {
    await page.evaluate(([key, words]) => Object.assign(globalThis, { [key]: words }), [fault, `"rule":"${rule}"`]);
    await pick(page, "part-rule", rule);
    if (fault === "hold") await page.locator("#status [data-command=cancel]").click();
    await eventually(async () => assert.match(await status(page), said));
    await page.evaluate((key) => Object.assign(globalThis, { [key]: "" }), fault);
    await page.locator("#status [data-command=retry]").click();
    await measured(page);
    await eventually(async () => assert.doesNotMatch(await status(page), said));
    assert.equal((await documentOf(page)).bodies[0].rule, rule);
  }
  await paintsAsKernel(page, [[15, 25]]);

  const dropped = await page.evaluateHandle((text) => {
    const data = new DataTransfer();
    data.items.add(new File([text], "broken.json", { type: "application/json" }));
    return data;
  }, JSON.stringify(BROKEN));
  await page.dispatchEvent("#stage", "drop", { dataTransfer: dropped });
  await eventually(async () => assert.match(await status(page), /^3 problems/));
  // The area of the body that could be made.
  await eventually(async () => assert.match(await status(page), /area\s+3600\smm²/));
  await page.locator("[data-problem=skipped]").click();
  await page.locator("[data-part-witness]").waitFor();
  await eventually(async () => assert.equal((await uiOf(page)).part.shown.shape, "bow"));
  await openGroup(page, "checks");
  await page.locator("[data-diagnostic=limits]").click();
  await eventually(async () => assert.deepEqual([(await uiOf(page)).part.shown.body, (await uiOf(page)).part.shown.feature], [1, 0]));

  // A part of one's own goes with its link, whatever is wrong with it.
  const broken = await documentOf(page);
  await share(page);
  const link = await offered(page, /#v=1&s=[\w-]+$/);
  await page.locator("[data-close=share]").click();
  const other = await openPage(t, { hash: hashOf(link) });
  await measured(other);
  assert.deepEqual(await documentOf(other), broken);
  await other.close();

  await page.locator("[data-action=file]").click();
  await page.locator("[data-item=new]").click();
  await page.locator("[data-part-empty]").waitFor();
  await measured(page);
  await eventually(async () => assert.deepEqual((await documentOf(page)).bodies, []));
  await eventually(async () => assert.match(await status(page), /^Nothing to evaluate/));
});

test("on a phone: the features first, a tap reads, three rules on one screen", async (t) => {
  const page = await openPage(t, { hash: "#v=1&preset=part-rectangle", viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });
  await measured(page);
  assert.equal(await page.locator("[data-tab=tree]").getAttribute("aria-selected"), "true");
  const [x, y] = await onScreen(page, [60, 12]);
  await page.touchscreen.tap(x, y);
  await eventually(async () => assert.match(await page.locator("[data-part-reading]").innerText(), /to B/));
  await pick(page, "part-look", "compare");
  for (const rule of ["repaired", "depth", "printed"]) await eventually(async () => assert.ok(await page.locator(`[data-rule=${rule}]`).isVisible()));
  await page.locator("[data-part-rule=printed] .part-rule-differs", { hasText: /\d/ }).waitFor();
  assert.deepEqual(await audit(page), []);
});
