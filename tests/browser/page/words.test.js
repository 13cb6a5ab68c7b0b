/** The picture in words: the canvas is described by the result and the curves, and a new result is spoken once the page rests. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { openPage } from "./open.js";
import { choosePoint, drag, eventually, field, handle, middle, pick } from "./workbench.js";

/** @typedef {import("playwright-core").Page} Page */

/** What the canvas is described by. @param {Page} page */
const description = (page) =>
  page.evaluate(() =>
    (document.querySelector("#picture")?.getAttribute("aria-describedby") ?? "")
      .split(" ")
      .map((id) => document.getElementById(id)?.textContent ?? "")
      .join(" "),
  );

test("the canvas has a name, the result and the curves", async (t) => {
  const page = await openPage(t);
  await eventually(async () =>
    assert.match(
      await description(page),
      /^44 lines, none crossing, none blocked, eta 0\.\d{3} Inner: degree 3, 10 control points within .* mm, of Polymer\. Outer: degree 3, 14 control points/,
    ),
  );
  assert.match((await page.locator("#picture").getAttribute("aria-label")) ?? "", /^Amoeba: two curves/);
  assert.equal(await page.locator("#outcome").getAttribute("aria-live"), "polite");
});

test("a drag says nothing until it is over, then the new result once", async (t) => {
  const page = await openPage(t);
  await page.locator("#outcome").waitFor({ state: "attached" });
  const before = await page.locator("#outcome").textContent();
  await page.evaluate(() => {
    const said = /** @type {string[]} */ ([]);
    Object.assign(globalThis, { said });
    const region = document.querySelector("#outcome");
    if (region) new MutationObserver(() => said.push(region.textContent ?? "")).observe(region, { childList: true, characterData: true, subtree: true });
  });
  const said = () => page.evaluate(() => /** @type {any} */ (globalThis).said);
  await drag(page, await middle(handle(page, "B3")), [60, 40], { release: false });
  assert.deepEqual(await said(), []);
  await page.mouse.up();
  await eventually(async () => assert.equal((await said()).length, 1));
  const [text] = await said();
  assert.match(text, /^44 lines, none crossing, none blocked, eta 0\.\d{3}$/);
  assert.notEqual(text, before);
});

test("what fails is in the words, and an error is as well", async (t) => {
  const page = await openPage(t);
  await page.locator("#outcome").waitFor({ state: "attached" });
  await page.locator("select").filter({ hasText: "Same parameter" }).or(page.locator("[data-select=method]")).first().selectOption("parameter");
  await eventually(async () => assert.match((await page.locator("#outcome").textContent()) ?? "", /^44 lines, \d+ crossing, \d+ blocked/));
  await choosePoint(page, "B3");
  await field(page, "x").fill("-56");
  await field(page, "x").press("Enter");
  await eventually(async () => assert.match((await page.locator("#outcome").textContent()) ?? "", /cross|meet/i));
});

test("steps and comparison state their results", async (t) => {
  const page = await openPage(t);
  await pick(page, "mode", "steps");
  await eventually(async () =>
    assert.match((await page.locator(".step-picture desc").textContent()) ?? "", /^The growth ends in \d+ lines, none crossing, none blocked, eta 0\.\d{3}/),
  );
  assert.match((await page.locator(".step-picture").getAttribute("aria-label")) ?? "", /^Amoeba, Step 1 of/);
  await pick(page, "mode", "compare");
  await eventually(async () =>
    assert.match((await page.locator("[data-method=exact]").textContent()) ?? "", /0\.\d{3}.*, 44 lines, none crossing, none blocked/),
  );
});
