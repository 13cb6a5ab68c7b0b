import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { join } from "node:path";
import { test } from "node:test";
import { load } from "directrix";
import { readLink, writeLink } from "directrix/link";
import { PNG } from "pngjs";
import { root } from "../../../scripts/lib/paths.mjs";
import { fitted, rayAt, seenAt, STANDARD } from "../../../www/src/space/camera.js";
import { labsOf, srgbOf } from "../../../www/src/space/colors.js";
import { firstHit } from "../../../www/src/space/pick.js";
import { triples } from "../../../www/src/space/vector.js";
import { audit } from "../support/axe.js";
import { SOFTWARE } from "../support/browser.js";
import { screenshot } from "../support/screenshot.js";
import { PHONE } from "./drawing.js";
import { openExport } from "./exporting.js";
import { openPage } from "./open.js";
import { hashOf, offered, share } from "./sharing.js";
import { documentOf, drag, drawn, eventually, field, handle, middle, pick, spoken, status } from "./workbench.js";

/**
 * @import { Page } from "playwright-core"
 * @import { TestContext } from "node:test"
 * @import { Solid, SolidOptions } from "directrix"
 * @import { Picture } from "../support/screenshot.js"
 * @import { Point } from "../../../www/src/types.js"
 */

/** Rows of the mesh that the page asks for with 5 stages. */
const ROWS = 25;

const dx = await load();
const amoeba = JSON.parse(await readFile(join(root, "www/presets/amoeba.json"), "utf8"));
/** The first preset with its inner curve raised, as the page proposes it. */
const high = { ...amoeba, curves: amoeba.curves.map((/** @type {any} */ curve, /** @type {number} */ i) => (i === 0 ? { ...curve, height: 50 } : curve)) };

/** @param {TestContext} t @param {import("./open.js").Options} [options] */
const open = (t, options) => openPage(t, { allow: SOFTWARE, viewport: { width: 920, height: 560 }, ...options });

/** Waits until the solid of the open document is drawn. @param {Page} page */
async function shown(page) {
  await page.locator("[data-solid=shown]").waitFor({ state: "attached" });
  await drawn(page);
}

/**
 * The colour that the kernel gives a place of the picture, from which the camera looks at the whole from above.
 * @param {Page} page
 * @param {SolidOptions} options
 * @param {(solid: Solid) => number[]} choose a place in space
 */
async function expectedAt(page, options, choose) {
  const solid = dx.solid(high, { stages: ROWS, ...options });
  const box = await page.locator("[data-space]").boundingBox();
  const foot = await page.locator(".solid-foot").boundingBox();
  assert.ok(box && foot);
  const frame = { size: { width: box.width, height: box.height }, top: 44, bottom: foot.height };
  const camera = fitted(STANDARD.top, frame, solid.curves.flatMap(triples));
  const { at } = seenAt(camera, frame, choose(solid));
  const place = /** @type {Point} */ ([Math.round(at[0]) + 0.5, Math.round(at[1]) + 0.5]);
  const hit = firstHit(solid, rayAt(camera, frame, place));
  assert.ok(hit);
  const labs = labsOf(solid.colors);
  const lab = [0, 1, 2].map((k) => hit.weights.reduce((sum, weight, i) => sum + weight * labs[3 * solid.indices[3 * hit.triangle + i] + k], 0));
  return { place, color: srgbOf(lab, 0).map((channel) => Math.round(255 * channel)), s: 1 - hit.point[2] / 50, screen: [box.x + place[0], box.y + place[1]] };
}

/** A place of the wall, at a share of a ruling line. @param {number} line @param {number} s @returns {(solid: Solid) => number[]} */
const onWall = (line, s) => ({ rulings }) => [0, 1, 2].map((axis) => rulings[6 * line + axis] * (1 - s) + rulings[6 * line + 3 + axis] * s);

/** @param {Picture} picture @param {Point} place @param {number[]} color */
function assertColor(picture, [x, y], color) {
  const found = picture.at(x, y);
  const off = Math.max(...color.map((channel, i) => Math.abs(channel - found[i])));
  assert.ok(off <= 3, `${found} instead of ${color} at ${x}, ${y}`);
}

/** A place without a material has a grey of the page. @param {Picture} picture @param {Point} place */
function assertNeutral(picture, [x, y]) {
  const found = picture.at(x, y);
  assert.ok(Math.max(...found) - Math.min(...found) < 14, `${found} at ${x}, ${y}`);
}

/** The volume inside binary STL, and its triangles. @param {Buffer} bytes */
function readStl(bytes) {
  const count = bytes.readUInt32LE(80);
  assert.equal(bytes.length, 84 + 50 * count);
  let volume = 0;
  for (let k = 0; k < count; k += 1) {
    const [a, b, c] = [0, 1, 2].map((corner) => [0, 1, 2].map((axis) => bytes.readFloatLE(84 + 50 * k + 12 + 12 * corner + 4 * axis)));
    volume += (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0])) / 6;
  }
  return { count, volume };
}

/** What the export of a format hands out. @param {Page} page @param {string} format */
async function downloaded(page, format) {
  await pick(page, "solid-format", format);
  const download = page.waitForEvent("download");
  await page.locator("[data-solid-export]").click();
  const file = await download;
  assert.equal(file.suggestedFilename(), `amoeba.${format}`);
  return readFile(await file.path());
}

test("a key opens the solid, which says what it needs, shows the kernel's colours, is cut, mapped, read and exported", async (t) => {
  const page = await open(t);
  const fetched = () => page.evaluate(() => performance.getEntriesByType("resource").some(({ name }) => /\/solid-[^/]*\.js$/.test(name)));
  assert.equal(await fetched(), false, "nothing of it is fetched before it is asked for");
  await page.keyboard.press("4");
  const raise = page.locator("[data-solid-raise]");
  await raise.waitFor();
  await eventually(async () => assert.match(await spoken(page), /All curves lie at the height 0/));
  assert.match(await status(page), /Give one of them another/);
  await raise.click();
  await shown(page);
  assert.equal((await documentOf(page)).curves[0].height, 50);
  const solid = dx.solid(high, { stages: ROWS });
  const [twist, flank] = /** @type {const} */ (["twist", "flank"]).map((color) => dx.solid(high, { color }).range?.[1] ?? 0);
  await eventually(async () => {
    const line = (await status(page)).replace(/\s+/g, " ");
    assert.match(line, /Watertight .*volume 2\.36 × 10⁵ mm³/);
    assert.match(line, new RegExp(`twist to ${twist.toFixed(1)}°.*flank angle to ${flank.toFixed(1)}°`));
  });
  assert.match((await page.locator("[data-space]").getAttribute("aria-label")) ?? "", /Amoeba in three dimensions: Watertight, 120\.0 by 87\.0 by 50\.0 mm, volume/);

  // Colours without light and lines, from above.
  for (const name of ["rulings", "stages", "curves", "light"]) await page.locator(`[data-box=solid-${name}]`).uncheck();
  await page.keyboard.press("8");
  await eventually(async () => assert.match(await spoken(page), /Seen from above/));
  const cap = await expectedAt(page, {}, () => [0, 0, 50]);
  assert.deepEqual(cap.color, [0xf0, 0xe4, 0x42]);
  const places = [onWall(3, 0.3), onWall(14, 0.6), onWall(29, 0.85)];
  const walls = await Promise.all(places.map((choose) => expectedAt(page, {}, choose)));
  await eventually(async () => {
    const picture = await screenshot(page.locator("[data-space]"), "solid-top");
    assert.ok(picture.colors() > 1000);
    for (const { place, color } of [cap, ...walls]) assertColor(picture, place, color);
  });

  // What the pointer reads is what the colour says.
  await page.mouse.move(walls[1].screen[0], walls[1].screen[1]);
  const card = page.locator("[data-solid-reading]");
  await card.waitFor();
  await eventually(async () => {
    const read = Number(/s\s+(0\.\d{3})/.exec(await card.innerText())?.[1]);
    // The pointer is within a pixel of the place.
    assert.ok(Math.abs(read - walls[1].s) < 0.015, `${read} instead of ${walls[1].s}`);
  });
  await page.mouse.move(5, 5);

  // Maps of the angles.
  await page.locator("[data-select=solid-color]").selectOption("twist");
  await eventually(async () => assert.equal(await page.locator(".solid-caption").innerText(), `twist, \u2212${twist.toFixed(1)}° to ${twist.toFixed(1)}°`));
  const twisted = await Promise.all(places.map((choose) => expectedAt(page, { color: "twist" }, choose)));
  await eventually(async () => {
    const map = await screenshot(page.locator("[data-space]"), "solid-twist");
    for (const { place, color } of twisted) assertColor(map, place, color);
    assertNeutral(map, cap.place);
  });
  await page.locator("[data-select=solid-color]").selectOption("material");

  // A section: its face is hatched in neutral colours, and the handle moves it.
  await pick(page, "section-axis", "z");
  await eventually(async () => {
    const cut = await screenshot(page.locator("[data-space]"), "solid-section");
    for (const by of [0, 3, 6]) assertNeutral(cut, [cap.place[0] + by, cap.place[1]]);
  });
  assert.equal(await field(page, "section-place").inputValue(), "25.0");
  const handle = page.locator("[data-plane-handle]");
  await handle.focus();
  await page.keyboard.press("Shift+ArrowUp");
  await eventually(async () => assert.equal(await handle.getAttribute("aria-valuetext"), "z = 30.0\u00a0mm"));
  await page.keyboard.press("6");
  await eventually(async () => assert.match(await spoken(page), /Seen from the front/));
  await drawn(page);
  const from = await middle(handle);
  await page.mouse.move(from[0], from[1]);
  await page.mouse.down();
  await page.mouse.move(from[0], from[1] + 30);
  await page.mouse.up();
  await eventually(async () => assert.ok(Number(await field(page, "section-place").inputValue()) < 29.5));
  await pick(page, "section-axis", "off");

  // The keyboard turns, reads and ends the reading; nothing of it is an edit.
  await page.locator("[data-space]").click({ position: { x: 30, y: 100 } });
  await page.keyboard.press("5");
  await page.keyboard.press("ArrowLeft");
  await eventually(async () => assert.match(await spoken(page), /Azimuth \u221265, elevation 28/));
  await page.keyboard.press("Enter");
  await eventually(async () => assert.match(await spoken(page), /^x \S+, y \S+, z \S+, s 0\.\d\d, .*%/));
  await page.keyboard.press("Escape");
  assert.equal((await documentOf(page)).curves[0].height, 50);
  assert.deepEqual(await audit(page), []);

  // The files hold what is shown.
  await openExport(page, /** @type {any} */ ("solid"));
  const { count, volume } = readStl(await downloaded(page, "stl"));
  assert.equal(3 * count, solid.indices.length);
  assert.ok(Math.abs(volume / (solid.volume ?? 0) - 1) < 1e-4, `${volume}`);
  const ply = await downloaded(page, "ply");
  const head = ply.subarray(0, ply.indexOf("end_header")).toString("latin1");
  assert.match(head, /^ply\n/);
  assert.equal(Number(/element face (\d+)/.exec(head)?.[1]), count);
  for (const name of ["red", "green", "blue"]) assert.match(head, new RegExp(`property uchar ${name}\\n`));
  const obj = (await downloaded(page, "obj")).toString("utf8").split("\n");
  const faces = obj.filter((line) => line.startsWith("f ")).map((line) => line.slice(2).split(" ").map((corner) => corner.split("/")[0]));
  assert.equal(faces.length, count);
  const edges = new Set(faces.flatMap(([a, b2, c]) => [`${a} ${b2}`, `${b2} ${c}`, `${c} ${a}`]));
  for (const edge of edges) assert.ok(edges.has(edge.split(" ").reverse().join(" ")), `${edge} has no neighbour`);
  await pick(page, "solid-format", "png");
  await page.locator("[data-box=solid-transparent]").check();
  await field(page, "solid-width").fill("400");
  await field(page, "solid-width").press("Enter");
  await field(page, "solid-height").fill("300");
  await field(page, "solid-height").press("Enter");
  const png = PNG.sync.read(await downloaded(page, "png"));
  assert.deepEqual([png.width, png.height, png.data[3]], [400, 300, 0]);
  assert.equal(png.data[4 * (150 * 400 + 200) + 3], 255);
  await page.context().grantPermissions(["clipboard-read", "clipboard-write"]);
  await page.locator("[data-solid-copy]").click();
  await eventually(async () => assert.match(await spoken(page), /The picture is copied/));
  assert.deepEqual(await page.evaluate(async () => (await navigator.clipboard.read()).flatMap(({ types }) => types)), ["image/png"]);
  await page.keyboard.press("Escape");

  // Heights and undo move the body; without a height there is none.
  await field(page, "solid-height-1").fill("10");
  await field(page, "solid-height-1").press("Enter");
  await eventually(async () => assert.match(await page.locator("[data-fact=size]").innerText(), /× 40\.0\smm/));
  await page.keyboard.press("Control+z");
  await page.keyboard.press("Control+z");
  await raise.waitFor();
});

test("leaving gives the graphics context back; a lost one is waited for; a link and a reload come back to the solid", async (t) => {
  const page = await open(t, {
    viewport: { width: 640, height: 440 },
    hash: writeLink({ document: { ...high, sampling: { scheme: "arc-length", counts: [16, 16] } }, view: "solid" }),
    init: `
      const contexts = (window.contexts = []);
      const { getContext } = HTMLCanvasElement.prototype;
      HTMLCanvasElement.prototype.getContext = function (kind, ...rest) {
        const context = getContext.call(this, kind, ...rest);
        if (kind === "webgl2" && context && !contexts.includes(context)) contexts.push(context);
        return context;
      };`,
  });
  await shown(page);
  const live = () => page.evaluate(() => /** @type {any} */ (window).contexts.map((/** @type {WebGL2RenderingContext} */ gl) => !gl.isContextLost()));
  const left = await page.evaluate(async () => {
    const { contexts } = /** @type {any} */ (window);
    const until = async (/** @type {() => boolean} */ holds) => {
      const end = performance.now() + 10_000;
      while (!holds()) {
        if (performance.now() > end) throw new Error(`waited in vain for ${holds}`);
        await new Promise((done) => setTimeout(done, 10));
      }
    };
    const enter = (/** @type {string} */ mode) =>
      /** @type {HTMLElement} */ (document.querySelector(`[data-segment=mode] input[value=${mode}]`)).click();
    const counts = [];
    for (let turn = 1; turn <= 10; turn += 1) {
      enter("figure");
      await until(() => contexts.every((/** @type {WebGL2RenderingContext} */ gl) => gl.isContextLost()));
      counts.push(contexts.length);
      enter("solid");
      await until(() => document.querySelector("[data-solid=shown]") !== null);
    }
    return counts;
  });
  assert.deepEqual(left, [1, 2, 3, 4, 5, 6, 7, 8, 9, 10]);
  assert.deepEqual(await live(), [...Array(10).fill(false), true]);

  const message = page.locator(".space-message");
  await page.evaluate(() => {
    const { contexts } = /** @type {any} */ (window);
    /** @type {any} */ (window).losing = contexts.at(-1).getExtension("WEBGL_lose_context");
    /** @type {any} */ (window).losing.loseContext();
  });
  await eventually(async () => assert.match(await message.innerText(), /comes back/));
  await page.evaluate(() => /** @type {any} */ (window).losing.restoreContext());
  await message.waitFor({ state: "hidden" });
  await drawn(page);
  assert.ok((await screenshot(page.locator("[data-space]"), "solid-restored")).colors() > 1000);

  await page.keyboard.press("7");
  await page.locator("[data-slider=up-to]").fill("0.4");
  const view = (await screenshot(page.locator("[data-space]"), "solid-kept")).colors();
  await page.reload();
  await shown(page);
  const slider = page.locator("[data-slider=up-to]");
  await eventually(async () => assert.equal(await slider.getAttribute("aria-valuetext"), "s 0.40, stage 2 of 5"));
  const again = (await screenshot(page.locator("[data-space]"), "solid-again")).colors();
  assert.ok(Math.abs(again - view) < 0.02 * view, `${again} colours, ${view} before`);
});

test("without WebGL the page says so in place of the picture, and all else works", async (t) => {
  const page = await open(t, {
    hash: writeLink({ document: high, view: "solid" }),
    init: `
      const { getContext } = HTMLCanvasElement.prototype;
      HTMLCanvasElement.prototype.getContext = function (kind, ...rest) {
        return kind.startsWith("webgl") ? null : getContext.call(this, kind, ...rest);
      };`,
  });
  await page.locator("[data-solid=shown]").waitFor({ state: "attached" });
  assert.match(await page.locator(".space-message").innerText(), /WebGL 2 is missing/);
  await eventually(async () => assert.match(await status(page), /Watertight/));
  assert.deepEqual(await audit(page, [".mode-stage", ".mode-aside", "#status"]), []);
  await openExport(page, /** @type {any} */ ("solid"));
  assert.ok(readStl(await downloaded(page, "stl")).count > 1000);
  await pick(page, "solid-format", "png");
  await page.locator("[data-solid-export]").click();
  await eventually(async () => assert.match(await page.locator("[data-message=solid]").innerText(), /no WebGL 2/));
  await page.keyboard.press("Escape");
  await page.keyboard.press("1");
  await page.waitForSelector("#status[data-verdict=verified] [data-total=eta]");
});

test("curves in space are shown as they are matched, dragged in that plane, raised by a field, and shared", async (t) => {
  const branch = JSON.parse(await readFile(join(root, "www/presets/pipe-branch.json"), "utf8"));
  const page = await open(t, { viewport: { width: 1200, height: 760 }, hash: writeLink({ document: branch }) });
  await page.waitForSelector("#status[data-verdict=verified] [data-total=eta]");
  const first = (await documentOf(page)).curves[0].points.map((/** @type {Point} */ point) => [...point]);
  const normal = /** @type {number[]} */ (dx.match(branch).projection?.normal);
  const above = (/** @type {number[]} */ at) => at.reduce((sum, value, axis) => sum + value * normal[axis], 0);
  const from = await middle(handle(page, "A3"));
  await drag(page, from, [-36, 18]);
  const dragged = await eventually(async () => {
    const [curve] = (await documentOf(page)).curves;
    assert.notDeepEqual(curve.points[2], first[2]);
    return curve.points;
  });
  assert.equal(dragged[2].length, 3);
  assert.ok(Math.hypot(...[0, 1, 2].map((axis) => dragged[2][axis] - first[2][axis])) > 2);
  // The plane follows the curves a little while one of them moves.
  assert.ok(Math.abs(above(dragged[2]) - above(first[2])) < 0.5);
  assert.deepEqual(dragged.toSpliced(2, 1), first.toSpliced(2, 1));
  await eventually(async () => {
    const [x, y] = await middle(handle(page, "A3"));
    assert.ok(Math.hypot(x - from[0] + 36, y - from[1] - 18) < 1.5, "the handle is where the pointer left it");
  });

  assert.match(await page.locator("[data-assumed]").innerText(), /In space: matched as seen along .* off its plane, and lengths count the mean gap of \d/);
  assert.ok(await field(page, "height").isHidden());
  await field(page, "space-z").focus();
  await field(page, "space-z").fill("3");
  await page.keyboard.press("Enter");
  await eventually(async () => assert.deepEqual((await documentOf(page)).curves[0].points[2], [dragged[2][0], dragged[2][1], 3]));
  assert.deepEqual(await audit(page, ["#inspector"]), []);
  await share(page);
  const { document: shared } = readLink(hashOf(await offered(page, /#/)));
  assert.deepEqual(/** @type {any} */ (shared).curves[0].points, (await documentOf(page)).curves[0].points);
  await page.keyboard.press("Escape");
  for (const before of [dragged, first]) {
    await page.locator("[data-action=undo]").click();
    await eventually(async () => assert.deepEqual((await documentOf(page)).curves[0].points, before));
  }

  await page.keyboard.press("4");
  await shown(page);
  await eventually(async () => assert.match(await status(page), /matched in the best-fit plane, curves up to 10\.0\smm off it/));
  await page.keyboard.press("1");
  await page.waitForSelector("#status[data-verdict=verified] [data-total=eta]");
  await page.keyboard.press("d");
  await eventually(async () => assert.match(await status(page), /Not with curves in space/));
  await page.locator('[data-action="insert-curve"]').waitFor();
  assert.ok(await page.locator('[data-action="insert-curve"]').isDisabled());
});

test("on a phone the solid is turned by a finger, with targets of 44 pixels", async (t) => {
  const page = await open(t, { ...PHONE, colorScheme: "dark", hash: writeLink({ document: high, view: "solid" }) });
  await shown(page);
  await page.locator(".solid-groups [data-tab=section]").click();
  await pick(page, "section-axis", "x");
  await drawn(page);
  const small = await page.evaluate(() =>
    [...document.querySelectorAll(".mode-stage button, .mode-aside :is(button, select, .segment label, .box), .modes .segment label")]
      .filter((each) => each.checkVisibility())
      .map((each) => ({ name: each.textContent || each.getAttribute("aria-label"), box: each.getBoundingClientRect() }))
      .filter(({ box }) => box.width > 0 && (box.height < 32 || box.width < 24))
      .map(({ name, box }) => `${name} ${box.width} x ${box.height}`),
  );
  assert.deepEqual(small, []);
  const handle = await page.locator("[data-plane-handle]").boundingBox();
  assert.ok(handle && handle.width >= 44 && handle.height >= 44);
  const before = await screenshot(page.locator("[data-space]"), "solid-phone");
  const [x, y] = await middle(page.locator("[data-space]"));
  const session = await page.context().newCDPSession(page);
  const touch = (/** @type {"touchStart" | "touchMove" | "touchEnd"} */ type, /** @type {number} */ by) =>
    session.send("Input.dispatchTouchEvent", { type, touchPoints: type === "touchEnd" ? [] : [{ x: x - 60 + by, y: y + 40 }] });
  await touch("touchStart", 0);
  for (const by of [20, 50, 80]) await touch("touchMove", by);
  await touch("touchEnd", 0);
  await drawn(page);
  await eventually(async () => assert.ok((await screenshot(page.locator("[data-space]"), "solid-phone-turned")).difference(before) > 0.05));
  assert.deepEqual(await audit(page, [".mode-stage", ".mode-aside", "#status"]), []);
});
