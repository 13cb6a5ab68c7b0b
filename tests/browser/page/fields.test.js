import assert from "node:assert/strict";
import { onOnePage } from "./one-page.js";
import { coordinates, documentOf, drag, eventually, field, handle, middle, pick, status } from "./workbench.js";

onOnePage("fields", {
  "a number field moves the point, and a wrong text does not": async (page) => {
    await handle(page, "B3").focus();
    const [, y] = await coordinates(page, "B3");
    await field(page, "x").fill("51.5");
    await page.keyboard.press("Enter");
    await eventually(async () => assert.deepEqual(await coordinates(page, "B3"), [51.5, y]));

    await field(page, "x").fill("fifty");
    const message = page.locator("#error-x");
    assert.match((await message.textContent()) ?? "", /number/);
    assert.equal(await field(page, "x").getAttribute("aria-invalid"), "true");
    await page.keyboard.press("Enter");
    assert.deepEqual(await coordinates(page, "B3"), [51.5, y]);
    await page.keyboard.press("Escape");
    assert.ok(await message.isHidden());
    assert.equal(await field(page, "x").inputValue(), "51.50");
  },
  "arrows step a field and escape takes the steps back": async (page) => {
    await handle(page, "B3").focus();
    const [x] = await coordinates(page, "B3");
    await field(page, "x").focus();
    await page.keyboard.press("ArrowUp");
    await page.keyboard.press("Shift+ArrowUp");
    await eventually(async () => assert.equal((await coordinates(page, "B3"))[0], x + 11));
    await page.keyboard.press("Escape");
    await eventually(async () => assert.equal((await coordinates(page, "B3"))[0], x));
  },
  "a field is dragged sideways, and one drag is one entry of the log": async (page) => {
    const before = (await documentOf(page)).matching.normalWeight;
    const input = field(page, "normalWeight");
    await drag(page, await middle(input), [20, 0]);
    await eventually(async () => assert.ok((await documentOf(page)).matching.normalWeight > before));
    await page.keyboard.press("Control+z");
    await eventually(async () => assert.equal((await documentOf(page)).matching.normalWeight, before));
    await eventually(async () => assert.ok(await page.locator("[data-action=undo]").isDisabled()));
  },
  "a sweep of a slider is one entry of the log": async (page) => {
    const before = (await documentOf(page)).matching.distanceWeight;
    const slider = page.locator("[data-slider=distanceWeight]");
    await drag(page, await middle(slider), [30, 0]);
    await eventually(async () => assert.notEqual((await documentOf(page)).matching.distanceWeight, before));
    await page.locator("[data-action=undo]").click();
    assert.equal((await documentOf(page)).matching.distanceWeight, before);
    assert.ok(await page.locator("[data-action=undo]").isDisabled());
  },
  "a count out of range names the range and keeps the last value": async (page) => {
    await page.locator("[data-group-button=sampling]").click();
    const before = (await documentOf(page)).sampling.counts[1];
    await field(page, "count-1").fill("2");
    assert.match((await page.locator("#error-count-1").textContent()) ?? "", /3 to 1000/);
    await field(page, "count-0").focus();
    assert.equal((await documentOf(page)).sampling.counts[1], before);
    assert.equal(await field(page, "count-1").inputValue(), String(before));
  },
  "sampling, stages and the mode for negative products reach the document": async (page) => {
    // The group is open since the test before.
    await field(page, "count-0").fill("30");
    await page.keyboard.press("Enter");
    await pick(page, "scheme", "parameter");
    await page.locator("[data-more] summary").click();
    await pick(page, "negative", "clamp");
    await page.locator("[data-group-button=blend]").click();
    await field(page, "stages").fill("8");
    await page.keyboard.press("Enter");
    const { sampling, matching, blend } = await documentOf(page);
    assert.deepEqual(
      [sampling.counts[0], sampling.scheme, matching.negative, blend.stages],
      [30, "parameter", "clamp", 8],
    );
    await eventually(async () => assert.match(await status(page), /\d+\s*lines/));
    assert.equal(await page.locator("#morph-controls .ticks span").count(), 9);
  },
  "materials: colour, name and the curve that holds them": async (page) => {
    await page.locator("[data-swatch='0']").click();
    await page.locator("[data-color='0']").fill("#d55e00");
    await field(page, "material-0").fill("Rubber");
    await page.keyboard.press("Enter");
    await page.locator("[data-holder='1-0']").click();
    const document = await documentOf(page);
    assert.deepEqual([document.materials[0].color, document.materials[0].name], ["#d55e00", "Rubber"]);
    assert.equal(document.curves[1].composition.length, 1);
    assert.equal(document.curves[1].composition[0].mix[0], 1);
    await page.locator("[data-action=add-material]").click();
    await eventually(async () => assert.equal((await documentOf(page)).materials.length, document.materials.length + 1));
    assert.equal((await documentOf(page)).curves[0].composition[0].mix.length, document.materials.length + 1);
    await page.locator(`[data-swatch='${document.materials.length}']`).click();
    await page.locator(`[data-remove='${document.materials.length}']`).click();
    await eventually(async () => assert.deepEqual(await documentOf(page), document));
  },
  "title and curve names are edited in place": async (page) => {
    await field(page, "title").fill("Two blobs");
    await page.keyboard.press("Enter");
    await eventually(async () => assert.match(await page.title(), /^Two blobs/));
    await field(page, "curve-name").fill("Rim");
    await page.keyboard.press("Enter");
    await eventually(async () => assert.match((await page.locator("[data-curve-row='1']").textContent()) ?? "", /^Rim/));
  },
  "layers change the picture and nothing in the document": async (page) => {
    const before = JSON.stringify(await documentOf(page));
    const picture = () =>
      page.locator("#picture").evaluate((canvas) => /** @type {HTMLCanvasElement} */ (canvas).toDataURL());
    const first = await picture();
    await page.locator("[data-box=material]").uncheck();
    await eventually(async () => assert.notEqual(await picture(), first));
    assert.equal(JSON.stringify(await documentOf(page)), before);
    await page.locator("[data-box=controlPoints]").uncheck();
    await eventually(async () => assert.ok(await handle(page, "A1").isHidden()));
  },
});
