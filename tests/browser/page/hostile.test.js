/**
 * Bad input on the page: whatever is opened or typed, the document, its history and its picture stay, and the error says
 * what is wrong beside it.
 *
 * @import { Page } from "playwright-core"
 */
import assert from "node:assert/strict";
import { test } from "node:test";
import { base, cases, garbled, numbers } from "../../node/hostile.js";
import { idle } from "./idle.js";
import { onOnePage } from "./one-page.js";
import { openPage } from "./open.js";
import { documentOf, eventually, field, handle, spoken, status } from "./workbench.js";

const SEED = 20_261_123;

/** Refusals that a look at the two curves together takes: such documents open and are drawn with the fault marked. */
const DRAWN = ["self-intersection", "contact"];

/** The painted picture. @param {Page} page */
const picture = (page) =>
  page
    .locator("#stage canvas")
    .first()
    .evaluate((canvas) => /** @type {HTMLCanvasElement} */ (canvas).toDataURL());

/** @param {Page} page @param {string} name @param {string} text */
const open = (page, name, text) =>
  page.locator("[data-file]").setInputFiles({ name, mimeType: "application/json", buffer: Buffer.from(text) });

/**
 * A page with one edit made, and a look at whether all of it is still there.
 * @param {import("node:test").TestContext} t
 */
async function edited(t) {
  const page = await openPage(t);
  await handle(page, "B3").focus();
  await page.keyboard.press("Shift+ArrowUp");
  await eventually(async () => assert.ok(await page.locator("[data-action=undo]").isEnabled()));
  await page.waitForSelector("#status[data-verdict=verified]");
  await idle(page);
  // The finer picture of a page at rest.
  await page.waitForTimeout(400);
  await idle(page);
  const before = [JSON.stringify(await documentOf(page)), await picture(page)];
  const isUnharmed = async () => {
    await idle(page);
    assert.equal(JSON.stringify(await documentOf(page)), before[0]);
    assert.ok((await picture(page)) === before[1], "the picture is the same");
    assert.ok(await page.locator("[data-action=undo]").isEnabled(), "the history is there");
  };
  return { page, isUnharmed };
}

test("bad files are refused one after the other, and nothing is lost", { timeout: 180_000 }, async (t) => {
  const { page, isUnharmed } = await edited(t);
  // The page opens documents of either kind, each with its own fields.
  const files = cases.filter(({ code }) => ![...DRAWN, "kind"].includes(code ?? ""));
  assert.ok(files.length > 25);
  for (const [i, { name, text, code, path, says }] of files.entries()) {
    const file = `bad-${i}.json`;
    await open(page, file, text);
    await eventually(async () => assert.match(await status(page), new RegExp(`Could not open ${file}: .`), name));
    const words = await status(page);
    assert.match(words, /The open document is unchanged/, name);
    // What is not meant to be a document of ours is read for points, with words of its own.
    const isOurs = text.startsWith("{") && text.includes('"directrix"') && code !== "syntax";
    for (const expected of isOurs ? [path ?? "", ...says] : []) assert.ok(words.includes(expected), `${name}: ${words}`);
    await eventually(async () => assert.match(await spoken(page), new RegExp(`Could not open ${file}`), name));
    await isUnharmed();
  }
  await page.locator("[data-action=undo]").click();
  await page.waitForSelector("#status[data-verdict=verified]");
  await eventually(async () => assert.ok(await page.locator("[data-action=undo]").isDisabled()));
});

test(`garbled files by the dozen are opened or refused (seed ${SEED})`, { timeout: 180_000 }, async (t) => {
  const page = await openPage(t);
  const number = numbers(SEED);
  for (let i = 0; i < 40; i++) {
    const before = JSON.stringify(await documentOf(page));
    const file = `garbled-${i}.json`;
    await open(page, file, garbled(JSON.stringify({ ...base, title: file }), number));
    await eventually(async () => {
      const [words, now] = [await status(page), JSON.stringify(await documentOf(page))];
      assert.ok(words.includes(`Could not open ${file}`) ? now === before : now !== before, `${file}: ${words}`);
    });
  }
  await open(page, "good.json", JSON.stringify({ ...base, title: "Good again" }));
  await eventually(async () => assert.equal((await documentOf(page)).title, "Good again"));
  await page.waitForSelector("#status[data-verdict=verified]");
});

onOnePage("a document is drawn with its fault marked", {
  ...Object.fromEntries(cases.filter(({ code }) => DRAWN.includes(code ?? "")).map(({ name, text, code }) => [name, async (page) => {
    await open(page, "fault.json", JSON.stringify({ ...JSON.parse(text), title: name }));
    await eventually(async () => assert.equal((await documentOf(page)).title, name));
    await eventually(async () => assert.match(await status(page), code === "contact" ? /touch/ : /crosses itself/));
    assert.match(await status(page), /near \(/, "the place is named");
    assert.notEqual(await page.locator("#status").getAttribute("data-verdict"), "verified");
    await handle(page, "A1").focus();
    await page.keyboard.press("ArrowUp");
    const undo = page.locator("[data-action=undo]");
    await undo.click();
    await eventually(async () => assert.ok(await undo.isDisabled(), "its history works"));
  }])),
  "curves side by side, and the status says why they are not matched": async (page) => {
    const apart = structuredClone(base);
    for (const point of apart.curves[0].points) point[0] += 100;
    await open(page, "apart.json", JSON.stringify(apart));
    await eventually(async () => assert.match(await status(page), /No line connects the two curves/));
    assert.notEqual(await page.locator("#status").getAttribute("data-verdict"), "verified");
    // A corner is a remark, and not the reason.
    const [curve] = apart.curves;
    curve.points.splice(1, 0, ...Array.from({ length: curve.degree - 1 }, () => [...curve.points[0]]));
    await open(page, "corner.json", JSON.stringify({ ...apart, title: "Apart, with a corner" }));
    await page.locator("[data-certificate=corners], .corner-mark:visible").first().waitFor();
    await eventually(async () => assert.match(await status(page), /No line connects the two curves/));
  },
});

/** Typed in place of a coordinate: moves that make the curves cross, lie side by side, or turn one into a figure eight. */
const MOVES = [
  { name: "curves that cross", moves: { A1: ["x", "400"] }, says: /touch/ },
  { name: "a figure eight", moves: { A1: ["x", "-90"], A2: ["y", "-60"] }, says: /crosses itself|touch/ },
];

test("edits that make curves cross are told, and undone", async (t) => {
  const { page, isUnharmed } = await edited(t);
  for (const { name, moves, says } of MOVES) {
    await t.test(name, async () => {
      for (const [point, [axis, value]] of Object.entries(moves)) {
        await handle(page, point).focus();
        await field(page, axis).fill(value);
        await page.keyboard.press("Enter");
      }
      await eventually(async () => assert.match(await status(page), says));
      for (const _ of Object.keys(moves)) await page.locator("[data-action=undo]").click();
      await page.waitForSelector("#status[data-verdict=verified]");
      await eventually(isUnharmed);
    });
  }
});

test("wrong numbers in fields are told beside the field and change nothing", async (t) => {
  const { page, isUnharmed } = await edited(t);
  for (const text of ["NaN", "1e300", "Infinity", "", "12abc", "0x10", "1e999", "--4"]) {
    await field(page, "x").fill(text);
    await page.keyboard.press("Enter");
    const message = page.locator("#error-x");
    if (text !== "") assert.match((await message.textContent()) ?? "", /number/, text);
    if (text !== "") assert.equal(await field(page, "x").getAttribute("aria-invalid"), "true", text);
    await page.keyboard.press("Escape");
    await isUnharmed();
  }
});
