import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { join } from "node:path";
import { test } from "node:test";
import { load } from "directrix";
import { PNG } from "pngjs";
import { root } from "../../../scripts/lib/paths.mjs";
import { audit } from "../support/axe.js";
import { screenshot } from "../support/screenshot.js";
import { PHONE } from "./drawing.js";
import { onOnePage } from "./one-page.js";
import { openPage } from "./open.js";
import { documentOf, eventually, field, handle, pick, spoken, status, uiOf } from "./workbench.js";

/**
 * @import { Page } from "playwright-core"
 * @import { Match } from "directrix"
 */

/** The methods in the order of the pictures, with the settings they are compared with. */
const SETTINGS = /** @type {const} */ ({
  parameter: { method: "parameter", oneToOne: true },
  shift: { method: "shift", shift: "best", oneToOne: true },
  "one-per-vertex": { method: "one-per-vertex", oneToOne: true },
  sum: { method: "exact", objective: "sum", oneToOne: false },
  greedy: { method: "greedy", oneToOne: true },
  exact: { method: "exact", objective: "integral", oneToOne: true },
});
const NAMES = /** @type {(keyof typeof SETTINGS)[]} */ (Object.keys(SETTINGS));

/** @param {Page} page @param {string} name */
const picture = (page, name) => page.locator(`[data-method="${name}"]`);

/** The cell of a measure in the row of a method. @param {Page} page @param {string} measure @param {string} method */
async function cell(page, measure, method) {
  const table = page.locator(`table[data-measures~="${measure}"]`);
  const column = ((await table.getAttribute("data-measures")) ?? "").split(" ").indexOf(measure);
  return (await table.locator(`[data-row="${method}"] .bar-value`).nth(column).innerText()).replace("\u2212", "-");
}

/** Goes to the comparison and waits until every method has been measured. @param {Page} page */
async function compare(page) {
  await pick(page, "mode", "compare");
  await settled(page);
}

/** @param {Page} page */
const settled = (page) =>
  eventually(async () => {
    assert.match(await status(page), /6\s*methods/);
    assert.match((await page.locator("#status").getAttribute("data-verdict")) ?? "", /verified|problems|error/);
    for (const name of NAMES) assert.notEqual(await cell(page, "count", name), "");
  });

/** Opens a preset from the gallery. @param {Page} page @param {string} id */
async function openPreset(page, id) {
  await page.locator("[data-action=gallery]").click();
  await page.locator(`[data-preset=${id}]`).click();
  await page.keyboard.press("Escape");
}

/** @param {string} id @returns {Promise<any>} */
const preset = async (id) => JSON.parse(await readFile(join(root, "www/presets", `${id}.json`), "utf8"));

/**
 * What the kernel says of every method on a document, asked from Node.
 * @param {any} document
 * @returns {Promise<{[method: string]: {match: Match, even: Match}}>} `even`: with one-to-one lines
 */
async function expected(document) {
  const dx = await load();
  return Object.fromEntries(
    NAMES.map((name) => {
      const own = { ...document, matching: { ...document.matching, ...SETTINGS[name] } };
      const even = { ...own, matching: { ...own.matching, oneToOne: true } };
      return [name, { match: dx.match(own), even: dx.match(even) }];
    }),
  );
}

onOnePage("the comparison of the first figure", {
  "the bars hold what the kernel says of every method, on one scale, and the best is named": async (page) => {
    const document = await documentOf(page);
    await compare(page);
    const found = await expected(document);
    const power = Math.floor(Math.log10(Math.max(...NAMES.map((name) => found[name].even.totals.pairs?.integral ?? 0))));
    /** @type {[number, number][]} */
    const widths = [];
    for (const name of NAMES) {
      const { match, even } = found[name];
      const shown = match.totals.pairs ?? match.totals.lines;
      assert.ok(shown && even.totals.pairs);
      assert.equal(await cell(page, "eta", name), (even.totals.pairs.eta ?? 0).toFixed(3), name);
      assert.equal(await cell(page, "integral", name), ((even.totals.pairs.integral ?? 0) / 10 ** power).toFixed(2), name);
      assert.equal(await cell(page, "mean", name), ((shown.mean ?? 0) / 10 ** power).toFixed(2), name);
      assert.equal(await cell(page, "count", name), String(shown.count), name);
      assert.equal(await cell(page, "crossings", name), String(shown.crossings), name);
      assert.equal(await cell(page, "blocked", name), String(shown.blocked), name);
      const row = page.locator(`table[data-measures=eta] [data-row="${name}"]`);
      assert.equal(await row.locator(".bars-mark").isVisible(), !match.ok, name);
      const bar = await row.locator(".bar-fill").boundingBox();
      widths.push([even.totals.pairs.eta ?? 0, bar?.width ?? 0]);
      if (!match.ok) {
        const { crossings, blocked } = shown;
        assert.match(await picture(page, name).innerText(), new RegExp(`${crossings} crossings?, ${blocked} blocked: no blend drawn`));
      }
    }
    for (const [eta, width] of widths) {
      assert.ok(Math.abs(width / eta - widths[5][1] / widths[5][0]) < 1.5, `${width} px for ${eta}`);
    }
    const best = found.exact.even.totals.pairs?.eta ?? 0;
    assert.match(await status(page), new RegExp(`best\\s*η\\s*${best.toFixed(3)}, Exact`));
    assert.match(await status(page), /1 of 6 fails its certificate/);
    assert.match(await status(page), /44 : 44/);
  },

  "every time is a median of runs in the worker, and all of them together stand in the status line": async (page) => {
    await compare(page);
    await eventually(async () => {
      assert.match(await page.locator("table[data-measures=time] thead").innerText(), /ms, median of (5|3 to 5)/);
      const times = await Promise.all(NAMES.map(async (name) => Number(await cell(page, "time", name))));
      assert.ok(times.every((each) => each > 0), `${times}`);
      const sum = times.reduce((total, each) => total + each, 0);
      const shown = Number(/(\d+)\s*ms in all/.exec((await status(page)).replace(/\s+/g, " "))?.[1]);
      assert.ok(Math.abs(shown - sum) <= 1, `${shown} for ${times}`);
      assert.ok(times[5] > times[0], "the refined optimum takes longer than counting samples");
    });
  },

  "pictures are the kernel's: blended where the certificate holds, red dashes where it fails": async (page) => {
    await compare(page);
    /** Pixels of a picture: those with a strong colour, and those of the error colour. @param {string} name */
    const pixels = async (name) => {
      const { data } = PNG.sync.read(await picture(page, name).locator("canvas").screenshot());
      let [strong, red] = [0, 0];
      for (let i = 0; i < data.length; i += 4) {
        const [r, g, b] = data.subarray(i, i + 3);
        if (Math.max(r, g, b) - Math.min(r, g, b) > 60) strong += 1;
        if (r > 150 && g < 110 && b < 110) red += 1;
      }
      return { share: strong / (data.length / 4), red };
    };
    const broken = await pixels("parameter");
    assert.ok(broken.share < 0.02 && broken.red > 20, JSON.stringify(broken));
    for (const name of ["shift", "one-per-vertex", "sum", "greedy", "exact"]) {
      const { share, red } = await pixels(name);
      assert.ok(share > 0.15 && red === 0, `${name}: ${share}, ${red}`);
    }
  },

  "one pointer lights the line nearest to it in every picture": async (page) => {
    const document = await documentOf(page);
    await compare(page);
    const found = await expected(document);
    const plot = picture(page, "greedy").locator(".method-frame");
    const box = await plot.boundingBox();
    assert.ok(box);
    /** The lit line of a picture, in pixels. @param {string} name */
    const lit = async (name) => {
      const marks = picture(page, name).locator(".marks");
      assert.ok(await marks.isVisible(), name);
      const d = (await marks.locator(".lit-core").getAttribute("d")) ?? "";
      const numbers = (d.match(/-?[\d.]+/g) ?? []).map(Number);
      return [numbers.slice(0, 2), numbers.slice(2, 4)];
    };
    for (const [fx, fy] of [[0.2, 0.5], [0.5, 0.25], [0.88, 0.6]]) {
      const at = [box.width * fx, box.height * fy];
      await page.mouse.move(box.x + at[0], box.y + at[1]);
      for (const name of NAMES) {
        const { match } = found[name];
        const lines = match.pairs.length
          ? match.pairs.map(({ from, to }) => [from, to])
          : match.lines.map(({ from, to }) => [match.samples[0].points[from], match.samples[1].points[to]]);
        const ends = await lit(name);
        // The view follows from the two ends of any line: its place in the plane is a shift and a scale away.
        const view = await viewOf(page, name, document);
        const onScreen = lines.map((line) => line.map((point) => view(point)));
        const distance = (/** @type {number[][]} */ [a, b]) => {
          let least = Infinity;
          for (let k = 0; k <= 400; k += 1) {
            const [x, y] = [0, 1].map((axis) => a[axis] + ((b[axis] - a[axis]) * k) / 400);
            least = Math.min(least, Math.hypot(x - at[0], y - at[1]));
          }
          return least;
        };
        const least = Math.min(...onScreen.map(distance));
        assert.ok(distance(ends) < least + 0.6, `${name}: ${distance(ends)} px, and another is ${least} px away`);
        const isOne = onScreen.some((line) => line.every(([x, y], i) => Math.hypot(x - ends[i][0], y - ends[i][1]) < 0.2));
        assert.ok(isOne, `${name}: what is lit is one of its lines`);
      }
    }
    await page.mouse.move(box.x + box.width / 2, 20);
    for (const name of NAMES) assert.ok(await picture(page, name).locator(".marks").isHidden(), name);
  },

  "by keyboard: arrows from picture to picture, page keys from line to line, Enter works with one": async (page) => {
    await page.keyboard.press("3");
    await settled(page);
    const group = page.locator(".methods [data-method][tabindex='0']");
    assert.equal(await group.count(), 1, "one tab stop");
    await group.focus();
    await page.keyboard.press("Home");
    await page.keyboard.press("ArrowRight");
    await page.keyboard.press("ArrowDown");
    const focused = () => page.evaluate(() => globalThis.document.activeElement?.getAttribute("data-method"));
    assert.equal(await focused(), "greedy");
    await page.keyboard.press("PageDown");
    await page.keyboard.press("PageDown");
    await eventually(async () => assert.match(await spoken(page), /^Greedy: line 2 of \d+, f /));
    for (const name of NAMES) assert.ok(await picture(page, name).locator(".marks").isVisible(), name);
    await page.keyboard.press("Escape");
    assert.ok(await picture(page, "greedy").locator(".marks").isHidden());
    const name = (await picture(page, "parameter").textContent()) ?? "";
    assert.match(name, /Same parameter η 0\.\d{3}.*blocked: no blend drawn, infeasible, 44 lines/);
    await page.keyboard.press("Delete");
    await page.keyboard.press("Enter");
    await eventually(async () => assert.equal((await documentOf(page)).matching.method, "greedy"));
    const document = await documentOf(page);
    assert.equal(document.curves[1].points.length, 14, "keys of the figure did nothing");
    assert.equal(await page.evaluate(() => globalThis.document.activeElement?.getAttribute("value")), "figure", "the focus goes to the switch");
  },

  "a click goes on working with a method, and undo takes it back": async (page) => {
    const before = await documentOf(page);
    await compare(page);
    await picture(page, "shift").click();
    await eventually(async () => assert.match(await status(page), /Verified/));
    assert.equal((await uiOf(page)).mode, "figure");
    const { matching } = await documentOf(page);
    assert.deepEqual([matching.method, matching.shift, matching.oneToOne], ["shift", "best", true]);
    await eventually(async () => assert.match(await spoken(page), /Working with Best shift/));
    assert.ok(await handle(page, "A1").isVisible());
    await page.keyboard.press("3");
    await eventually(async () => assert.equal(await picture(page, "shift").getAttribute("aria-current"), "true"));
    await page.keyboard.press("1");
    await page.keyboard.press("Control+z");
    assert.deepEqual(await documentOf(page), before);
  },
});

test("a result that breaks a constraint is never the best, however large its value", async (t) => {
  const page = await openPage(t);
  await openPreset(page, "closed-pocket");
  await compare(page);
  const found = await expected(await preset("closed-pocket"));
  const best = NAMES.filter((name) => found[name].match.ok);
  assert.equal(best.length, 0, "the pocket cannot be matched");
  const pairs = found["one-per-vertex"].even.totals.pairs;
  assert.ok((pairs?.eta ?? 0) > 0.9, "and yet one method has a large value");
  assert.match(await status(page), /no method keeps its constraints/);
  assert.match(await status(page), /6 of 6 fail their certificates/);
  for (const name of NAMES) assert.ok((await page.locator(`[data-row="${name}"].broken`).count()) > 0, name);
  assert.equal(await cell(page, "eta", "greedy"), "\u2013");
  assert.match(await picture(page, "greedy").innerText(), /\d+ \+ \d+ vertices not covered: no blend drawn/);
});

/**
 * The map from the plane to the pixels of a picture, from the samples of the curves: they fill it but for a margin.
 * @param {Page} page
 * @param {string} name
 * @param {any} document
 */
async function viewOf(page, name, document) {
  const dx = await load();
  const many = dx.match({ ...document, sampling: { scheme: "parameter", counts: [800, 800] }, matching: { method: "parameter" } });
  const points = many.samples.flatMap((each) => each.points);
  const [width, height] = await picture(page, name)
    .locator(".method-frame")
    .evaluate((element) => [element.clientWidth, element.clientHeight]);
  const span = [0, 1].map((axis) => points.map((point) => point[axis])).map((values) => [Math.min(...values), Math.max(...values)]);
  const scale = Math.min((width - 28) / (span[0][1] - span[0][0]), (height - 28) / (span[1][1] - span[1][0]));
  const middle = span.map(([low, high]) => (low + high) / 2);
  return (/** @type {number[]} */ [x, y]) => [width / 2 + (x - middle[0]) * scale, height / 2 - (y - middle[1]) * scale];
}

test("the mode is kept over a reload, and the figure comes back as it was", async (t) => {
  const page = await openPage(t);
  const view = (await uiOf(page)).view;
  await compare(page);
  assert.equal((await uiOf(page)).mode, "compare");
  assert.ok(await handle(page, "A1").isHidden());
  await page.reload();
  await page.waitForSelector("html[data-ready=true]");
  await settled(page);
  assert.match((await picture(page, "exact").innerText()).replace(/\s+/g, " "), /Exact η 0\.\d{3}/);
  await pick(page, "mode", "figure");
  await eventually(async () => assert.match(await status(page), /Verified/));
  await eventually(async () => {
    const now = (await uiOf(page)).view;
    assert.ok(Math.abs(now.scale / view.scale - 1) < 1e-6, "fitted as before");
  });
});

test("the comparison follows undo, redo, presets and the theme, and the last one wins", async (t) => {
  const page = await openPage(t);
  await field(page, "distanceWeight").fill("1");
  await page.keyboard.press("Enter");
  const changed = await documentOf(page);
  await compare(page);
  const eta = async (/** @type {any} */ document) =>
    ((await expected(document)).exact.even.totals.pairs?.eta ?? 0).toFixed(3);
  assert.equal(await cell(page, "eta", "exact"), await eta(changed));
  for (let i = 0; i < 3; i += 1) {
    await page.keyboard.press("Control+z");
    await page.keyboard.press("Control+y");
  }
  await page.keyboard.press("Control+z");
  const before = await documentOf(page);
  assert.notEqual(await eta(before), await eta(changed));
  await eventually(async () => assert.equal(await cell(page, "eta", "exact"), await eta(before)));
  assert.match(await status(page), /weights\s*1, 2/);
  await openPreset(page, "u-in-oval");
  const oval = await eta(await preset("u-in-oval"));
  await eventually(async () => assert.equal(await cell(page, "eta", "exact"), oval));
  assert.equal((await uiOf(page)).mode, "compare");
  const corner = async () => {
    const { data } = PNG.sync.read(await picture(page, "exact").locator("canvas").screenshot());
    return [...data.subarray(0, 3)];
  };
  await page.locator("[data-action=theme]").click();
  await eventually(async () => assert.deepEqual(await corner(), [14, 15, 18]));
});

test("curves that cannot be matched, or are not there, are said so", async (t) => {
  const page = await openPage(t);
  const { curves } = await documentOf(page);
  const [x, y] = curves[1].points[7];
  await handle(page, "B1").focus();
  for (const [name, value] of /** @type {const} */ ([["x", x * 1.6], ["y", y * 1.6]])) {
    await field(page, name).fill(String(value));
    await page.keyboard.press("Enter");
  }
  await page.waitForSelector("#status[data-verdict=error]");
  await pick(page, "mode", "compare");
  await eventually(async () => assert.match(await status(page), /crosses itself|curves touch/));
  await eventually(async () => assert.match(await picture(page, "exact").innerText(), /crosses itself|curves touch/));
  await page.locator("[data-action=file]").click();
  await page.locator("[data-item=new]").click();
  await eventually(async () => assert.ok(await page.locator(".methods-empty").isVisible()));
  assert.match(await status(page), /No curve yet/);
  assert.ok(await picture(page, "exact").isHidden());
});

test("long work is shown and can be cancelled, and numbers of another document do not stay", async (t) => {
  const page = await openPage(t);
  await compare(page);
  await page.keyboard.press("1");
  await page.locator("[data-group-button=sampling]").click();
  for (const name of ["count-0", "count-1"]) {
    await field(page, name).fill("1000");
    await page.keyboard.press("Enter");
  }
  await pick(page, "mode", "compare");
  await page.locator("[data-command=cancel]").click();
  await eventually(async () => assert.match(await status(page), /Cancelled/));
  await new Promise((done) => setTimeout(done, 300));
  assert.equal(await cell(page, "eta", "exact"), "", "it had not come to the last method");
  assert.equal(await page.locator("#progress.shown").count(), 0);
  await pick(page, "mode", "figure");
  await page.keyboard.press("Control+z");
  await page.keyboard.press("Control+z");
  await compare(page);
  assert.match(await cell(page, "eta", "exact"), /^0\.9\d\d$/);
});

test("on a phone the pictures stand in two columns, the bars in the sheet, and a tap works with one", async (t) => {
  const page = await openPage(t, PHONE);
  await page.locator("[data-segment=mode] input[value=compare]").tap({ force: true });
  await settled(page);
  const boxes = await Promise.all(NAMES.map(async (name) => await picture(page, name).boundingBox()));
  assert.deepEqual(new Set(boxes.map((box) => Math.round(box?.x ?? -1))).size, 2);
  for (const box of boxes) assert.ok(box && box.width > 160 && box.height > 160, JSON.stringify(box));
  const sheet = await page.locator("#inspector").boundingBox();
  const bars = await page.locator("table[data-measures=eta]").boundingBox();
  assert.ok(sheet && bars && bars.y > sheet.y && bars.x >= 0 && bars.x + bars.width <= 390);
  assert.ok((await page.evaluate(() => document.documentElement.scrollWidth)) <= 390);
  const switches = await page.locator("[data-segment=mode] label").evaluateAll((all) => all.map((each) => each.getBoundingClientRect().height));
  assert.ok(switches.every((height) => height >= 44), `${switches}`);
  await screenshot(page, "compare-phone");
  assert.deepEqual(await audit(page), []);
  await picture(page, "greedy").scrollIntoViewIfNeeded();
  await picture(page, "greedy").tap();
  await eventually(async () => assert.equal((await documentOf(page)).matching.method, "greedy"));
  assert.equal((await uiOf(page)).mode, "figure");
});

for (const colorScheme of /** @type {const} */ (["light", "dark"])) {
  test(`axe finds nothing wrong with the comparison, ${colorScheme}`, async (t) => {
    const page = await openPage(t, { colorScheme });
    await compare(page);
    assert.deepEqual(await audit(page), []);
    const shown = await screenshot(page, `compare-${colorScheme}`);
    assert.ok(shown.colors() > 1000);
    const cut = await page.evaluate(() =>
      [...document.querySelectorAll(".bars-table :is(th, td), .method-head > *, .method-line, .bars-head > *")]
        .filter((each) => each.scrollWidth > each.clientWidth + 1 && each.clientWidth > 0)
        .map((each) => each.textContent),
    );
    assert.deepEqual(cut, []);
  });
}
