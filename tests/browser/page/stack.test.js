/** Stacks on the page: curves come in, change places and go; spans have their certificates; the link carries them. */
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { test } from "node:test";
import { audit } from "../support/axe.js";
import { onOnePage } from "./one-page.js";
import { openPage } from "./open.js";
import { documentOf, drag, eventually, handle, middle, pick, status } from "./workbench.js";

/** @import { Page } from "playwright-core" */

const nest = JSON.parse(await readFile(new URL("../../../www/presets/layered-implant.json", import.meta.url), "utf8"));

/** Names of the curves, or their numbers of points where they have none. @param {Page} page */
const names = async (page) =>
  (await documentOf(page)).curves.map((/** @type {any} */ curve) => curve.name ?? curve.points.length);
/** @param {Page} page @param {RegExp} what */
const says = (page, what) => eventually(async () => assert.match(await status(page), what));

onOnePage("stacks", {
  "curves are moved, inserted and removed, each step is undone, and keys do it too": async (page) => {
    await says(page, /Verified\s*120\s*lines[^]*η\s*0\.98\d\s*A–B/);
    const before = await documentOf(page);
    assert.equal(before.curves.length, 3);
    assert.equal(await page.locator("[data-curve-row]:visible").count(), 3);
    assert.deepEqual(await audit(page), []);

    await page.locator("[data-curve-row='1']").click();
    await page.locator("[data-action=insert-curve]").click();
    await eventually(async () => assert.equal((await documentOf(page)).curves.length, 4));
    await says(page, /Verified\s*180\s*lines/);
    const inserted = await documentOf(page);
    assert.deepEqual(inserted.sampling.counts, [60, 60, 60, 60]);
    assert.deepEqual(inserted.curves[2].composition, [{ at: 0, mix: [0, 0.5, 0.5] }]);

    // The curve that came in is out of order before the one it follows.
    await page.locator("[data-stack='up-2']").click();
    await says(page, /1\s*problem[^]*out of order/);
    await page.keyboard.press("Control+z");
    await says(page, /Verified/);
    await page.locator("[data-curve-row='2']").focus();
    await page.keyboard.press("Alt+ArrowUp");
    await says(page, /out of order/);
    assert.match((await page.locator("[aria-live]").allTextContents()).join(" "), /is curve 2 of 4 now/);
    assert.equal(await page.evaluate(() => document.activeElement?.getAttribute("data-curve-row")), "1");
    await page.keyboard.press("Alt+ArrowDown");
    await says(page, /Verified/);
    assert.deepEqual((await documentOf(page)).curves, inserted.curves);

    await page.locator("[data-stack='remove-2']").click();
    await eventually(async () => assert.deepEqual((await documentOf(page)).curves, before.curves));
    assert.deepEqual((await documentOf(page)).sampling.counts, before.sampling.counts);
    await page.locator("[data-action=add-curve]").click();
    await eventually(async () => assert.equal((await documentOf(page)).curves.length, 4));
    await says(page, /Verified/);
    for (const count of [3, 4, 4, 4, 3]) {
      await page.keyboard.press("Control+z");
      await eventually(async () => assert.equal((await documentOf(page)).curves.length, count));
    }
  },

  "steps and comparison look at one span, and single lines are explained": async (page) => {
    await says(page, /Verified/);
    await page.locator("input[value=compare]").check({ force: true });
    const span = page.locator("[data-field=span]");
    await span.waitFor();
    assert.deepEqual(await span.locator("option").allTextContents(), ["A–B", "B–C"]);
    await eventually(async () => assert.match(await status(page), /6\s*methods[^]*60 : 60/));
    await span.selectOption("1");
    await eventually(async () => assert.match(await status(page), /6\s*methods[^]*best\s*η\s*0\.99\d/));
    await page.locator("input[value=steps]").check({ force: true });
    await span.waitFor();
    await eventually(async () => assert.match(await status(page), /uncovered/));
    assert.deepEqual(await audit(page), []);
    await page.locator("input[value=figure]").check({ force: true });
    await span.waitFor({ state: "detached" });
    await says(page, /Verified/);
    assert.deepEqual(await names(page), nest.curves.map((/** @type {any} */ { name }) => name));
  },
}, { hash: "#preset=layered-implant" });

test("a stack is blended either way, its curves are dragged, and it is shared whole", async (t) => {
  const page = await openPage(t, { hash: "#preset=layered-implant" });
  await says(page, /Verified/);
  await page.locator("[data-group-button=blend]").click();
  await pick(page, "blend-kind", "ruled");
  await eventually(async () => assert.equal((await documentOf(page)).blend.kind, "ruled"));
  await says(page, /Verified/);
  const point = (await documentOf(page)).curves[2].points[3];
  await drag(page, await middle(handle(page, "C4")), [0, -10]);
  await eventually(async () => assert.notDeepEqual((await documentOf(page)).curves[2].points[3], point));
  await says(page, /Verified/);
  await page.keyboard.press("l");
  const link = page.locator("[data-share-text]");
  await link.waitFor();
  const hash = await eventually(async () => {
    const found = /#.*$/.exec(await link.inputValue())?.[0] ?? "";
    assert.ok(found.length > 100);
    return found;
  });
  const shared = await documentOf(page);
  const other = await openPage(t, { hash });
  await says(other, /Verified\s*120\s*lines/);
  const { curves, blend, sampling } = await documentOf(other);
  assert.deepEqual([curves, blend, sampling], [shared.curves, shared.blend, shared.sampling]);
});

