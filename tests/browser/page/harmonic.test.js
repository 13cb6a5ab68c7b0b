/** The harmonic blend on the page: certificates, fields, curves inside, reading, modes that need lines, faults, looks and their difference. */
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { writeLink } from "directrix/link";
import { audit } from "../support/axe.js";
import { onOnePage } from "./one-page.js";
import { documentOf, drag, eventually, field, handle, middle, pick, status, uiOf } from "./workbench.js";

/** @import { Page } from "playwright-core" */

const preset = JSON.parse(await readFile(new URL("../../../www/presets/three-cores.json", import.meta.url), "utf8"));
/** With few segments, which is quick. */
const cores = { ...preset, blend: { ...preset.blend, segments: 64 } };

/** @param {Page} page @param {RegExp} what */
const says = (page, what) => eventually(async () => assert.match(await status(page), what));
/** What the live regions have. @param {Page} page */
const spoken = async (page) => (await page.locator("[aria-live]").allTextContents()).join(" ");
/** Opens a document as a file that is dropped. @param {Page} page @param {object} document */
async function drop(page, document) {
  await page.evaluate((text) => {
    const stage = globalThis.document.querySelector("#stage");
    const dataTransfer = new DataTransfer();
    dataTransfer.items.add(new File([text], "dropped.json", { type: "application/json" }));
    for (const type of ["dragenter", "dragover", "drop"]) {
      stage?.dispatchEvent(new DragEvent(type, { bubbles: true, cancelable: true, dataTransfer }));
    }
  }, JSON.stringify(document));
}

onOnePage("the harmonic blend", {
  "is certified, has fields of its own, and is clean for axe in light and dark": async (page) => {
    await says(page, /Verified\s*256\s*segments[^]*60\s*gradient lines[^]*crossings\s*0[^]*flow balanced to[^]*residual/);
    await page.locator("[data-group-button=blend]").click();
    await page.locator("[data-group-button=sampling]").click();
    await eventually(async () => assert.equal(await page.locator("[data-unused]:visible").count(), 2));
    await field(page, "harmonic-segments").fill("60");
    await page.keyboard.press("Enter");
    await says(page, /Verified\s*240\s*segments/);
    await field(page, "harmonic-lines").fill("24");
    await page.keyboard.press("Enter");
    await says(page, /24\s*gradient lines/);
    const { blend } = await documentOf(page);
    assert.deepEqual([blend.kind, blend.segments, blend.lines], ["harmonic", 60, 24]);
    for (const _ of [0, 1]) {
      // Colours change over a moment.
      await eventually(async () => assert.deepEqual(await audit(page), []));
      await page.locator("[data-action=theme]").click();
    }
  },

  "takes curves inside, which can be dragged, doubled and deleted": async (page) => {
    await page.locator("[data-action=add-curve]").click();
    await says(page, /Verified\s*320\s*segments/);
    await eventually(async () => assert.match(await spoken(page), /Added inner E inside/));
    const before = (await documentOf(page)).curves[4].points[0];
    await page.locator("[data-curve-row='4']").click();
    await drag(page, await middle(handle(page, "E1")), [-6, 4]);
    await eventually(async () => assert.notDeepEqual((await documentOf(page)).curves[4].points[0], before));
    await says(page, /Verified\s*320\s*segments/);
    await handle(page, "B1").focus();
    await page.keyboard.press("Control+d");
    await eventually(async () => assert.equal((await documentOf(page)).curves.length, 6));
    await says(page, /Verified\s*384\s*segments/);
    await page.locator("[data-stack='remove-5']").click();
    await says(page, /Verified\s*320\s*segments/);
    assert.equal(await page.locator("[data-stack^=up]:visible").count(), 0);
    assert.equal(await page.locator("[data-action=insert-curve]:visible").count(), 0);
  },

  "is read by keys along its lines, and modes that need ruling lines say why not": async (page) => {
    await says(page, /Verified/);
    await page.locator("#probe-keys").focus();
    await page.keyboard.press("ArrowRight");
    const text = () => page.locator("#probe-keys").getAttribute("aria-valuetext");
    await eventually(async () => assert.match(String(await text()), /Line 1, s 0\.50, gradient/));
    await page.keyboard.press("ArrowUp");
    await eventually(async () => assert.match(String(await text()), /Line 1, s 0\.55, gradient/));
    await page.keyboard.press("Enter");
    await eventually(async () => assert.match(await spoken(page), /follow the gradient/));
    await page.keyboard.press("Escape");
    for (const mode of ["steps", "compare", "solid"]) {
      await pick(page, "mode", mode);
      await page.locator(`[data-refusal=${mode}]`).waitFor();
    }
    assert.deepEqual(await audit(page, [".mode-stage"]), []);
    assert.equal(await page.locator("#stage .handle:visible, .legend:visible, #morph-controls:visible").count(), 0, "nothing of the figure is left");
    assert.match(await status(page), /Not with a harmonic blend/);
    assert.ok(await page.locator("[data-group-button=blend]").isVisible(), "the blend can be changed");
    await page.locator("[data-action=to-figure]").click();
    await says(page, /Verified/);
  },

  "names what does not fit, with its curves and its place; a stack with several curves inside gets the way out": async (page) => {
    const meeting = structuredClone(cores);
    meeting.curves[2].points = meeting.curves[2].points.map((/** @type {number[]} */ [x, y]) => [x - 50, y + 5]);
    await drop(page, meeting);
    await says(page, /1\s*problem[^]*Titanium core and ceramic core touch near/);
    await page.locator("[data-certificate=place]").click();
    await eventually(async () => assert.match(await spoken(page), /Shown: x/));
    await drop(page, { ...cores, blend: { ...cores.blend, kind: "ruled" } });
    await says(page, /lie side by side in one curve/);
    await page.locator("[data-command=use-harmonic]").click();
    await says(page, /Verified\s*256\s*segments/);
    assert.equal((await documentOf(page)).blend.kind, "harmonic");
    await page.keyboard.press("Control+z");
    await says(page, /lie side by side in one curve/);
  },

  "is seen beside the linear blend and as their difference, which changes no document": async (page) => {
    await page.evaluate(() => void (location.hash = "#preset=warm-band"));
    await says(page, /Verified\s*400\s*segments/);
    const before = await documentOf(page);
    await pick(page, "look", "difference");
    await eventually(async () => assert.match(String(await page.locator("[data-mean]").textContent()), /mean 0\.0\d\d/));
    assert.ok((await uiOf(page)).layers.includes("difference"));
    await eventually(async () => assert.match(await spoken(page), /Difference: largest 0\.\d+, mean 0\.\d+/));
    assert.deepEqual(await audit(page, ["#stage", "#inspector"]), []);
    await pick(page, "look", "ruled");
    await says(page, /Verified\s*44\s*lines[^]*η/);
    assert.equal(await page.locator("[data-legend=difference]:visible").count(), 0);
    await pick(page, "look", "harmonic");
    await says(page, /Verified\s*400\s*segments/);
    assert.deepEqual(await documentOf(page), before);
    // The linear blend has the same look, and goes over to the harmonic one as an edit.
    await pick(page, "blend-kind", "ruled");
    await says(page, /Verified\s*44\s*lines[^]*η/);
    await pick(page, "look", "harmonic");
    await says(page, /Verified\s*400\s*segments/);
    assert.equal((await documentOf(page)).blend.kind, "ruled");
    await page.keyboard.press("Control+z");
  },

  "is exported as tables of its own, without what needs ruling lines": async (page) => {
    await page.locator("[data-action=export]").click();
    await pick(page, "export-format", "csv");
    assert.equal(await page.locator("[data-segment=export-table] input[value=cells]").isDisabled(), true);
    assert.equal(await page.locator("[data-segment=export-format] input[value=solid]").isDisabled(), true);
    await pick(page, "export-table", "stages");
    const [file] = await Promise.all([page.waitForEvent("download"), page.locator("[data-export=download]").click()]);
    const text = await readFile(String(await file.path()), "utf8");
    assert.match(text, /^stage,s,loop,x,y\n1,0\.2,0,/);
    assert.equal(new Set(text.trimEnd().split("\n").slice(1).map((row) => row.split(",")[1])).size, 4);
  },
}, { hash: writeLink({ document: cores }), acceptDownloads: true });
