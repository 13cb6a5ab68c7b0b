/**
 * Shapes from elsewhere, by button, paste and drop: choosing, fitting, opening and replacing; and files that hold none.
 *
 * @import { Page } from "playwright-core"
 */
import assert from "node:assert/strict";
import { test } from "node:test";
import { audit } from "../support/axe.js";
import { SOFTWARE } from "../support/browser.js";
import { newDocument, PHONE } from "./drawing.js";
import { idle } from "./idle.js";
import { onOnePage } from "./one-page.js";
import { openPage } from "./open.js";
import { documentOf, eventually, handle, status } from "./workbench.js";

const DRAWING = `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 200 200">
  <title>Washers</title>
  <circle id="hole" cx="100" cy="100" r="30"/>
  <rect id="plate" x="20" y="20" width="160" height="160"/>
  <path id="tooth" d="M30 30h20v20z"/>
  <path id="stroke" d="M0 0L50 50"/>
</svg>`;

/** @param {number} count @param {number} rx @param {number} ry */
const ellipse = (count, rx, ry) =>
  Array.from({ length: count }, (_, i) => {
    const angle = (2 * Math.PI * i) / count;
    return [rx * Math.cos(angle), ry * Math.sin(angle)].map((v) => v.toFixed(4));
  });

/** @param {string[][]} points */
const csv = (points) => `x;y\n${points.map(([x, y]) => `${x.replace(".", ",")};${y.replace(".", ",")}`).join("\n")}`;

const POINTS = `${csv(ellipse(24, 20, 12))}\n\n${csv(ellipse(40, 50, 40))}\n`;

const CORNERS = ["0 0 0", "40 0 0", "0 30 0", "0 0 60"];
const TETRAHEDRON = `solid own\n${[[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]]
  .map((face) => `facet normal 0 0 0\nouter loop\n${face.map((k) => `vertex ${CORNERS[k]}\n`).join("")}endloop\nendfacet\n`)
  .join("")}endsolid own\n`;

/** @param {Page} page @param {string} name @param {string | Buffer} content */
const choose = (page, name, content) =>
  page.locator("[data-file]").setInputFiles({ name, mimeType: "text/plain", buffer: Buffer.from(content) });

/** @param {Page} page @param {{name: string, content: string}[]} files */
const drop = (page, files) =>
  page.evaluate((dropped) => {
    const data = new DataTransfer();
    for (const { name, content } of dropped) data.items.add(new File([content], name));
    window.dispatchEvent(new DragEvent("drop", { dataTransfer: data, bubbles: true, cancelable: true }));
  }, files);

/** @param {Page} page @param {string} text @param {string} [selector] of what is pasted into */
const paste = (page, text, selector = "body") =>
  page.evaluate(
    ([content, target]) => {
      const data = new DataTransfer();
      data.setData("text/plain", content);
      document.querySelector(target)?.dispatchEvent(new ClipboardEvent("paste", { clipboardData: data, bubbles: true, cancelable: true }));
    },
    [text, selector],
  );

/** @param {Page} page */
const panel = (page) => page.locator("[data-panel=import]");

/** @param {Page} page @param {string} name */
const command = (page, name) => page.locator(`[data-import="${name}"]`);

/** The names of the shapes that are chosen. @param {Page} page */
const chosen = (page) =>
  page.locator("[data-shape]:has(input:checked)").evaluateAll((all) => all.map((each) => each.querySelector("label")?.textContent));

/** What is said of each chosen shape, once both are fitted. @param {Page} page @returns {Promise<string[]>} */
const results = async (page) => {
  await idle(page);
  return eventually(async () => {
    const found = await page.locator("[data-shape]:has(input:checked) .import-result").allTextContents();
    assert.ok(found.length > 0 && found.every((text) => /control points?, (error|exact)/.test(text)), found.join("; "));
    return found;
  });
};

/** @param {string} text */
const countIn = (text) => Number(/(\d+) control/.exec(text)?.[1]);

onOnePage("shapes from elsewhere", {
  "one shape replaces a curve, which keeps its material, and undo takes it back": async (page) => {
    const before = await documentOf(page);
    await drop(page, [{ name: "points.csv", content: POINTS }]);
    await panel(page).waitFor();
    assert.deepEqual(await chosen(page), ["list 1", "list 2"]);
    assert.ok(await command(page, "place-0").isDisabled());
    await page.locator("[data-box=import-1]").uncheck();
    await page.locator("[data-box=import-through]").check();
    await eventually(async () => assert.equal(countIn((await results(page))[0]), 24, "a knot at every point"));
    await command(page, "place-0").click();
    const after = await documentOf(page);
    assert.equal(after.curves[0].points.length, 24);
    assert.deepEqual(after.curves[0].composition, before.curves[0].composition);
    assert.equal(after.curves[0].name, before.curves[0].name);
    assert.deepEqual(after.curves[1], before.curves[1]);
    await page.keyboard.press("Control+z");
    await eventually(async () => assert.deepEqual(await documentOf(page), before));
  },

  "another pair may be chosen, three shapes are a harmonic blend, and corners may go": async (page) => {
    await choose(page, "washers.svg", DRAWING);
    await results(page);
    await page.locator("[data-box=import-2]").check();
    assert.deepEqual(await chosen(page), ["hole", "plate", "tooth"]);
    assert.match(await page.locator("[data-import-hint]").innerText(), /harmonic blend, with the largest one outside/);
    await page.locator("[data-box=import-2]").uncheck();
    const kept = await results(page);
    await page.locator("[data-segment=import-corners] label").nth(1).click();
    const smooth = await eventually(async () => {
      const found = await results(page);
      assert.notEqual(found[1], kept[1]);
      return found;
    });
    assert.ok(countIn(smooth[1]) > 12, smooth[1]);
    // A coarser tolerance takes fewer points.
    const slider = page.locator("[data-slider=import-tolerance]");
    await slider.focus();
    await page.keyboard.press("End");
    await eventually(async () => assert.ok(countIn((await results(page))[1]) < countIn(smooth[1])));
    assert.match(await slider.getAttribute("aria-valuetext") ?? "", /^5/);
    await page.keyboard.press("Escape");
    assert.equal(await panel(page).count(), 0);
  },

  "of several files the first is opened, and the page says so": async (page) => {
    await drop(page, [
      { name: "first.svg", content: DRAWING },
      { name: "second.svg", content: DRAWING },
    ]);
    await panel(page).waitFor();
    assert.match(await panel(page).locator("h2").textContent() ?? "", /first\.svg/);
    await eventually(async () => assert.match(await status(page), /2 files were dropped; only first\.svg was opened/));
  },

  "a drawing opens as a document from the button, with its two nested shapes chosen": async (page) => {
    await choose(page, "washers.svg", DRAWING);
    await panel(page).waitFor();
    assert.equal(await page.locator("[data-shape]").count(), 3);
    assert.deepEqual(await chosen(page), ["hole", "plate"]);
    const [hole, plate] = await results(page);
    assert.ok(countIn(hole) <= 16, hole);
    assert.equal(countIn(plate), 12, "four straight sides that meet in corners");
    assert.match(await panel(page).locator("details").textContent() ?? "", /stroke: it is open: its ends are 70\.7107 apart/);
    assert.match(await panel(page).textContent() ?? "", /160 × 160/);
    assert.deepEqual(await audit(page), []);

    await command(page, "open").click();
    const document = await eventually(async () => {
      const found = await documentOf(page);
      assert.equal(found.title, "washers");
      return found;
    });
    assert.equal(await panel(page).count(), 0);
    assert.deepEqual(document.curves.map((/** @type {any} */ curve) => curve.name), ["hole", "plate"]);
    const reach = (/** @type {number} */ k) => document.curves[1].points.map((/** @type {number[]} */ p) => p[k]);
    assert.ok(Math.abs(Math.max(...reach(0)) - 80) < 1e-6 && Math.abs(Math.min(...reach(1)) + 80) < 1e-6, "centred at the origin");
    await page.waitForSelector("#status[data-verdict=verified]");
  },

  "three shapes open as a harmonic blend, and another one comes inside where there is room": async (page) => {
    await choose(page, "cores.svg", DRAWING);
    await page.locator("[data-box=import-2]").check();
    await results(page);
    await command(page, "open").click();
    await eventually(async () => assert.equal((await documentOf(page)).title, "cores"));
    const { blend, curves } = await documentOf(page);
    assert.equal(blend.kind, "harmonic");
    assert.deepEqual(
      curves.map((/** @type {any} */ curve) => [curve.name, curve.composition[0].mix]),
      [["tooth", [1, 0]], ["hole", [1, 0]], ["plate", [0, 1]]],
    );
    await page.waitForSelector("#status[data-verdict=verified]");
    await choose(page, "more.csv", POINTS);
    await results(page);
    await page.locator("[data-box=import-1]").uncheck();
    await page.locator("[data-box=import-center]").check();
    await eventually(async () => assert.ok(await command(page, "inside").isEnabled()));
    assert.deepEqual(await audit(page), []);
    await command(page, "inside").click();
    await eventually(async () => assert.equal((await documentOf(page)).curves.length, 4));
    await idle(page);
    await page.waitForSelector("#status[data-verdict=verified]");
    assert.equal((await documentOf(page)).curves[3].name, "list 1");
    await page.keyboard.press("Control+z");
    await eventually(async () => assert.deepEqual((await documentOf(page)).curves, curves));
  },

  "text is pasted anywhere but into a field, and documents as well as points": async (page) => {
    await paste(page, "[[0, 0], [10, 0], [10, 10]]", "input[data-field=title]");
    assert.equal(await panel(page).count(), 0);
    await paste(page, JSON.stringify([ellipse(12, 3, 2), ellipse(12, 9, 8)].map((ring) => ring.map((at) => at.map(Number)))));
    await panel(page).waitFor();
    assert.equal(await page.locator("[data-shape]").count(), 2);
    const document = await documentOf(page);
    await paste(page, JSON.stringify({ ...document, title: "From the clipboard" }));
    await eventually(async () => assert.equal((await documentOf(page)).title, "From the clipboard"));
  },

  "a new document takes shapes one by one": async (page) => {
    await newDocument(page);
    await paste(page, DRAWING);
    await results(page);
    await page.locator("[data-box=import-1]").uncheck();
    await eventually(async () => assert.ok(await command(page, "place-0").isEnabled()));
    assert.ok(await command(page, "place-1").isHidden());
    await command(page, "place-0").click();
    await eventually(async () => assert.equal((await documentOf(page)).curves[0]?.name, "hole"));
    await paste(page, DRAWING);
    await results(page);
    await page.locator("[data-box=import-0]").uncheck();
    await eventually(async () => assert.ok(await command(page, "place-1").isEnabled()));
    await command(page, "place-1").click();
    await eventually(async () => assert.equal((await documentOf(page)).curves[1]?.name, "plate"));
    await page.waitForSelector("#status[data-verdict=verified]");
  },

  "an STL is opened as a boundary value problem with conditions at two ends, and what is none changes nothing": async (page) => {
    const before = await documentOf(page);
    await choose(page, "none.stl", "no solid at all");
    await eventually(async () => assert.match(await status(page), /Could not open none\.stl: .*The open document is unchanged/s));
    assert.deepEqual(await documentOf(page), before);
    await choose(page, "own.stl", TETRAHEDRON);
    await eventually(async () => assert.equal((await documentOf(page)).title, "own"));
    const { kind, groups } = await documentOf(page);
    assert.deepEqual([kind, groups.length], ["laplace", 2]);
    await eventually(async () => assert.match(await status(page), /^Solved\s+4\s+triangles[^]*A first problem is set/));
  },
}, { allow: SOFTWARE });

const random = Buffer.from(Array.from({ length: 3000 }, (_, i) => (i * 7919 + (i * i) % 251) % 256));

const UNFIT = [
  { name: "empty.svg", content: "", says: /the text is empty/ },
  { name: "wrong.json", content: '[[1, 2], [3, "x"], [5, 6]]', says: /\[1\]\[1\]: the text "x" was found; expected a number/ },
  { name: "no-paths.svg", content: "<svg xmlns='http://www.w3.org/2000/svg'><text>word</text></svg>", says: /no shape was found/ },
  { name: "open.svg", content: "<svg><path d='M0 0L50 50'/><path d='M0 0L5 9'/></svg>", says: /no closed shape: path 1: it is open.*1 more/ },
  { name: "broken.svg", content: "<svg>\n<path d='M0 0'></svg>", says: /line 2: .*not SVG/ },
  { name: "many.csv", content: "1.5,2.5\n".repeat(100_000), says: /line 20001: more than 20000 points/ },
  { name: "huge.csv", content: "0,0\n1e300,0\n5,5\n", says: /line 2, x: .*expected a number from/ },
  { name: "words.txt", content: "only words\nand more words", says: /no points were found/ },
  { name: "random.bin", content: random, says: /Could not open random\.bin/ },
];

onOnePage("the open document and its history survive", Object.fromEntries(UNFIT.map(({ name, content, says }) => [name, async (page) => {
  const first = await documentOf(page);
  await handle(page, "B2").focus();
  await page.keyboard.press("ArrowUp");
  const before = await documentOf(page);
  assert.notDeepEqual(before, first);
  await choose(page, name, content);
  await eventually(async () => {
    assert.match(await status(page), new RegExp(`Could not open ${name}`));
    assert.match(await status(page), says);
  });
  assert.equal(await panel(page).count(), 0);
  assert.deepEqual(await documentOf(page), before);
  await page.keyboard.press("Control+z");
  await eventually(async () => assert.deepEqual(await documentOf(page), first));
}])));

test("on a phone the panel takes the screen and opens the drawing", async (t) => {
  const page = await openPage(t, { ...PHONE, colorScheme: "dark" });
  await choose(page, "washers.svg", DRAWING);
  await results(page);
  const box = await panel(page).boundingBox();
  assert.ok(box && box.width > 370 && box.x >= 0 && box.x + box.width <= 390);
  assert.deepEqual(await audit(page), []);
  await command(page, "open").tap();
  await eventually(async () => assert.equal((await documentOf(page)).title, "washers"));
});
