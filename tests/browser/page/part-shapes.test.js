/** Shapes on the canvas of a part: dragged, moved by keys, put in numbers, drawn. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { audit } from "../support/axe.js";
import { onOnePage } from "./one-page.js";
import { openPage } from "./open.js";
import { documentOf, drag, eventually, field, middle, pick, spoken, uiOf } from "./workbench.js";

/** @import { Page } from "playwright-core" */

const DRAWING = `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 40 40"><circle id="hole" cx="20" cy="20" r="5"/><rect id="plate" x="10" y="12" width="20" height="16"/></svg>`;
const HASH = "#v=1&preset=part-rectangle";

/** @param {Page} page @param {string} name such as `edge A` or `edge A.1` */
const handle = (page, name) => page.locator(`[data-part-point="${name}"]`);
/** @param {Page} page @param {string} name */
const outline = (page, name) => page.locator(`[data-part-shape="${name}"]`);

/** A shape of the open document. @param {Page} page @param {string} name */
async function shape(page, name) {
  return (await documentOf(page)).shapes.find((/** @type {{name: string}} */ each) => each.name === name);
}

/** Waits until a shape is what it should be. @param {Page} page @param {string} name @param {object} expected without its name */
const becomes = (page, name, expected) => eventually(async () => assert.deepEqual(await shape(page, name), { name, ...expected }));

/** Where a place of the plane lies on the screen. @param {Page} page @param {[number, number]} at @returns {Promise<[number, number]>} */
async function onScreen(page, [x, y]) {
  const { view } = await uiOf(page);
  const box = await page.locator(".part-stage").boundingBox();
  assert.ok(box);
  return [box.x + box.width / 2 + (x - view.center[0]) * view.scale, box.y + box.height / 2 - (y - view.center[1]) * view.scale];
}

/** The colour of the picture at a place of the plane, once the open document is painted. @param {Page} page @param {[number, number]} at @returns {Promise<number[]>} */
async function colorAt(page, at) {
  await page.locator(".part-stage:not([data-part=''])").waitFor();
  const [x, y] = await onScreen(page, at);
  return page.evaluate(([px, py]) => {
    const canvas = /** @type {HTMLCanvasElement} */ (document.querySelector(".part-picture"));
    const box = canvas.getBoundingClientRect();
    const ratio = canvas.width / box.width;
    // Read from a copy, because a canvas that is read from often is painted without the graphics card.
    const copy = document.createElement("canvas");
    [copy.width, copy.height] = [1, 1];
    const context = copy.getContext("2d", { willReadFrequently: true });
    context?.drawImage(canvas, -Math.floor((px - box.x) * ratio), -Math.floor((py - box.y) * ratio));
    return [...(context?.getImageData(0, 0, 1, 1).data ?? [])];
  }, [x, y]);
}

/** Chooses a whole shape, and waits until the page shows it. @param {Page} page @param {string} name */
async function choose(page, name) {
  await outline(page, name).focus();
  await eventually(async () => assert.equal(await field(page, "shape-name").inputValue(), name));
}

/** Begins to draw. @param {Page} page @param {string} kind */
async function draw(page, kind) {
  await page.locator("[data-part-draw]").click();
  await page.locator(`[data-item="draw-${kind}"]`).click();
  await page.locator(".draw-keys").waitFor();
}

onOnePage(
  "shapes of a part",
  {
    "a handle is dragged, document and picture follow, and one step of undo brings the very document back": async (page) => {
      const before = await documentOf(page);
      await page.locator(".part-stage[data-part=measured]").waitFor();
      assert.deepEqual(await audit(page, [".part-stage", "[data-group=shape]"]), []);
      await choose(page, "edge A");
      const yellow = await colorAt(page, [60, 55]);
      const [x, y] = await middle(handle(page, "edge A.1"));
      const [tx, ty] = await onScreen(page, [60, 60]);
      await drag(page, [x, y], [tx - x, ty - y]);
      await eventually(async () => {
        const { to } = await shape(page, "edge A");
        assert.ok(Math.hypot(to[0] - 60, to[1] - 60) < 1, `${to}`);
      });
      await eventually(async () => assert.notDeepEqual(await colorAt(page, [60, 55]), yellow, "the picture follows"));
      await eventually(async () => assert.match(await spoken(page), /^edge A, point 2, x (60|59)\.\d\d, y /));
      await page.locator("[data-action=undo]").click();
      await eventually(async () => assert.deepEqual(await documentOf(page), before));
      await eventually(async () => assert.deepEqual(await colorAt(page, [60, 55]), yellow));
    },

    "an outline is dragged as a whole, by whole steps of the grid where that is on; Escape takes a drag back": async (page) => {
      await page.locator(".part-stage [data-zoom=snap]").click();
      const from = await onScreen(page, [70, 60]);
      await drag(page, from, [0, -70]);
      await eventually(async () => {
        const { points } = await shape(page, "rectangle");
        const by = points[0][1];
        assert.ok(by > 0 && Math.abs(by - Math.round(by)) < 1e-9, `moved by ${by}`);
        assert.deepEqual(points, [[0, by], [100, by], [100, 60 + by], [0, 60 + by]]);
      });
      await page.locator("[data-action=undo]").click();
      await becomes(page, "rectangle", { kind: "polygon", points: [[0, 0], [100, 0], [100, 60], [0, 60]] });
      await page.locator(".part-stage [data-zoom=snap]").click();
      await drag(page, await onScreen(page, [70, 60]), [0, -70], { release: false });
      await eventually(async () => assert.notEqual((await shape(page, "rectangle")).points[0][1], 0));
      await page.keyboard.press("Escape");
      await becomes(page, "rectangle", { kind: "polygon", points: [[0, 0], [100, 0], [100, 60], [0, 60]] });
      await page.mouse.up();
    },

    "keys go from point to point and move them; Insert and Delete change their number": async (page) => {
      await choose(page, "rectangle");
      await page.keyboard.press("PageDown");
      await eventually(async () => assert.equal(await page.evaluate(() => document.activeElement?.getAttribute("data-part-point")), "rectangle.0"));
      await page.keyboard.press("ArrowRight");
      await eventually(async () => assert.match(await spoken(page), /^rectangle, point 1, x 1\.00, y 0\.00/));
      await page.keyboard.press("Shift+ArrowUp");
      await page.keyboard.press("Alt+ArrowUp");
      await becomes(page, "rectangle", { kind: "polygon", points: [[1, 10.1], [100, 0], [100, 60], [0, 60]] });
      await page.keyboard.press("Escape");
      await becomes(page, "rectangle", { kind: "polygon", points: [[0, 0], [100, 0], [100, 60], [0, 60]] });
      await page.keyboard.press("Insert");
      await becomes(page, "rectangle", { kind: "polygon", points: [[0, 0], [50, 0], [100, 0], [100, 60], [0, 60]] });
      await eventually(async () => assert.equal(await page.evaluate(() => document.activeElement?.getAttribute("data-part-point")), "rectangle.1"));
      await page.keyboard.press("Delete");
      await becomes(page, "rectangle", { kind: "polygon", points: [[0, 0], [100, 0], [100, 60], [0, 60]] });
      await page.keyboard.press("Home");
      await eventually(async () => assert.equal(await page.evaluate(() => document.activeElement?.getAttribute("data-part-shape")), "rectangle"));
      await page.keyboard.press("ArrowUp");
      await becomes(page, "rectangle", { kind: "polygon", points: [[0, 1], [100, 1], [100, 61], [0, 61]] });
      await page.locator("[data-box=shape-along]").check();
      await outline(page, "rectangle").focus();
      await page.keyboard.press("ArrowUp");
      await becomes(page, "rectangle", { kind: "polygon", points: [[0, 2], [100, 2], [100, 62], [0, 62]] });
      await becomes(page, "edge A", { kind: "segment", from: [0, 1], to: [0, 61] });
      await page.locator("[data-box=shape-along]").uncheck();
    },

    "numbers, another name, another kind, a copy, and what is left when a shape goes": async (page) => {
      await choose(page, "edge A");
      await field(page, "shape-x2").fill("20");
      await field(page, "shape-x2").press("Enter");
      await becomes(page, "edge A", { kind: "segment", from: [0, 0], to: [20, 60] });
      await field(page, "shape-name").fill("edge B");
      await field(page, "shape-name").press("Enter");
      await eventually(async () => assert.match(await page.locator("[data-group=shape] .field-error:visible").innerText(), /Another shape/));
      await field(page, "shape-name").fill("left");
      await field(page, "shape-name").press("Enter");
      await eventually(async () => assert.equal((await documentOf(page)).bodies[0].features[0].reference, "left"));
      await eventually(async () => assert.equal(await field(page, "shape-name").inputValue(), "left"));
      assert.equal(await page.locator("[data-shape-use=reference]").innerText(), "rectangle: A");

      await choose(page, "rectangle");
      await page.locator("[data-select=shape-turn]").selectOption("control");
      await eventually(async () => assert.equal((await shape(page, "rectangle")).kind, "curve"));
      await eventually(async () => assert.ok((await colorAt(page, [1, 1]))[3] < 128 || (await colorAt(page, [1, 1])).join() !== (await colorAt(page, [50, 20])).join()));
      // A point more leaves the curve as it is, which then has a knot more.
      const round = await outline(page, "rectangle").boundingBox();
      await outline(page, "rectangle").focus();
      await page.keyboard.press("Insert");
      await eventually(async () => {
        const { points, knots } = await shape(page, "rectangle");
        assert.deepEqual([points.length, knots?.length > 5], [5, true]);
      });
      const after = await outline(page, "rectangle").boundingBox();
      assert.ok(round && after && Math.abs(round.width - after.width) < 1 && Math.abs(round.height - after.height) < 1);
      const { width, height } = after;
      await page.mouse.dblclick(after.x + width / 2, after.y + height - 7);
      await eventually(async () => assert.equal((await shape(page, "rectangle")).points.length, 6));
      await page.locator("[data-shape-act=duplicate]").click();
      await eventually(async () => assert.equal(await field(page, "shape-name").inputValue(), "rectangle 2"));
      await page.locator("[data-shape-act=hole]").waitFor();
      await page.locator("[data-shape-act=delete]").click();
      await eventually(async () => assert.equal(await shape(page, "rectangle 2"), undefined));

      await choose(page, "left");
      await page.locator("[data-shape-act=delete]").click();
      await eventually(async () => assert.match(await spoken(page), /^Deleted left, which 1 place still names/));
      await page.locator("[data-problem=skipped]").waitFor();
      await page.locator("[data-action=undo]").click();
      await choose(page, "left");
      await page.locator("[data-shape-act=delete-all]").click();
      await eventually(async () => assert.deepEqual((await documentOf(page)).bodies[0].features.map((/** @type {{name: string}} */ { name }) => name), ["B"]));
    },

    "every kind is drawn by clicks, a body and a hole among them": async (page) => {
      const click = async (/** @type {[number, number]} */ at) => page.mouse.click(...(await onScreen(page, at)));
      /** @type {[string, [number, number][], string, string][]} */
      const drawn = [
        ["point", [[20, 40]], "point 1", "point"],
        ["segment", [[10, 50], [30, 50]], "segment 1", "segment"],
        ["line", [[40, 10], [60, 10]], "line 1", "line"],
        ["polyline", [[60, 40], [70, 50], [80, 40]], "polyline 1", "polyline"],
        ["open", [[60, 20], [70, 30], [80, 20]], "curve 1", "curve"],
        ["closed", [[40, 30], [50, 25], [55, 35], [45, 40]], "curve 2", "curve"],
      ];
      for (const [kind, places, name, expected] of drawn) {
        await draw(page, kind);
        for (const at of places) await click(at);
        // A click on the first point closes.
        if (kind === "closed") await click(places[0]);
        else if (places.length > 2) await page.keyboard.press("Enter");
        await eventually(async () => assert.equal((await shape(page, name))?.kind, expected, name));
        await eventually(async () => assert.equal(await field(page, "shape-name").inputValue(), name));
      }
      await draw(page, "circle");
      await pick(page, "draw-as", "hole");
      await drag(page, await onScreen(page, [85, 25]), [40, 0]);
      await eventually(async () => assert.deepEqual((await documentOf(page)).bodies[0].holes, ["hole 1"]));
      await eventually(async () => assert.match(await spoken(page), /^Drew hole 1, cut out of rectangle/));
      await draw(page, "polygon");
      await pick(page, "draw-as", "body");
      for (const at of /** @type {[number, number][]} */ ([[30, 20], [40, 20], [35, 30]])) await click(at);
      // Enter closes it, although the choice of what it is for had the focus before.
      await page.keyboard.press("Enter");
      await eventually(async () => assert.deepEqual((await documentOf(page)).bodies.map((/** @type {{name: string}} */ { name }) => name), ["rectangle", "body 1"]));
      await eventually(async () => assert.equal(await field(page, "shape-name").inputValue(), "polygon 1"));
      // What is being measured is dim.
      await page.locator(".part-stage[data-part=measured]").waitFor();
      assert.deepEqual(await audit(page, [".part-stage", "[data-group=shape]"]), []);
    },

    "shapes of a drawing come in as a body with its hole": async (page) => {
      await page.evaluate((text) => {
        const data = new DataTransfer();
        data.setData("text/plain", text);
        document.body.dispatchEvent(new ClipboardEvent("paste", { clipboardData: data, bubbles: true, cancelable: true }));
      }, DRAWING);
      await page.locator("[data-panel=import] [data-import=add]:not([disabled])").waitFor();
      await pick(page, "import-use", "body");
      await pick(page, "import-as", "curve");
      await page.locator("[data-import=add]:not([disabled])").click();
      await eventually(async () => {
        const { bodies, shapes } = await documentOf(page);
        assert.deepEqual(bodies.map((/** @type {any} */ { name, holes }) => [name, holes]), [["rectangle", []], ["plate", ["hole"]]]);
        // In the middle of the part, as large as it was drawn.
        const xs = shapes.at(-2).points.map((/** @type {number[]} */ [x]) => x);
        assert.ok(Math.abs(Math.min(...xs) - 40) < 0.1 && Math.abs(Math.max(...xs) - 60) < 0.1, `${xs}`);
      });
      await page.locator(".part-stage[data-part=measured]").waitFor();
    },

    "a polygon is drawn by the keyboard alone, and a closed curve in one stroke": async (page) => {
      await page.locator("[data-part-draw]").focus();
      await page.keyboard.press("Enter");
      await page.locator('[data-item="draw-polygon"]').waitFor();
      await page.keyboard.press("Enter");
      await page.locator(".draw-keys").waitFor();
      await pick(page, "draw-as", "reference");
      await page.locator(".draw-keys").focus();
      for (const key of ["Space", "Shift+ArrowRight", "Space", "Shift+ArrowUp", "Space"]) {
        await page.keyboard.press(key);
        await eventually(async () => assert.match(await spoken(page), /^(Point \d, )?x /));
      }
      await eventually(async () => assert.equal(await page.locator(".draw-dot, .draw-first").count(), 3));
      await page.keyboard.press("Enter");
      await eventually(async () => assert.equal((await shape(page, "polygon 1"))?.points.length, 3));

      await draw(page, "closed");
      const [cx, cy] = await onScreen(page, [50, 30]);
      await page.mouse.move(cx + 90, cy);
      await page.mouse.down();
      for (let i = 1; i <= 40; i += 1) await page.mouse.move(cx + 90 * Math.cos((i * Math.PI) / 20), cy - 70 * Math.sin((i * Math.PI) / 20));
      await page.mouse.up();
      const curve = await eventually(async () => {
        const found = await shape(page, "curve 1");
        assert.equal(found?.form, "periodic");
        return found;
      });
      assert.ok(curve.points.length < 30);
      await draw(page, "line");
      await page.keyboard.press("Escape");
      await eventually(async () => assert.equal(await page.locator(".draw-bar").count(), 0));
      assert.equal(await shape(page, "line 1"), undefined);
    },
  },
  { viewport: { width: 1100, height: 700 }, hash: HASH },
);

test("by touch a tap chooses, a finger drags, and targets are large enough", async (t) => {
  const page = await openPage(t, { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true, hash: HASH });
  await page.locator(".part-stage:not([data-part=''])").waitFor();
  await page.touchscreen.tap(...(await onScreen(page, [70, 60])));
  await eventually(async () => assert.equal(await handle(page, "rectangle.2").count(), 1));
  const box = await handle(page, "rectangle.2").boundingBox();
  assert.ok(box && box.width >= 44 && box.height >= 44);
  const before = (await shape(page, "rectangle")).points;
  const [x, y] = await middle(handle(page, "rectangle.2"));
  const client = await page.context().newCDPSession(page);
  const send = (/** @type {"touchStart" | "touchMove" | "touchEnd"} */ type, /** @type {{x: number, y: number}[]} */ touchPoints) => client.send("Input.dispatchTouchEvent", { type, touchPoints });
  await send("touchStart", [{ x, y }]);
  for (const by of [8, 16, 24, 32]) await send("touchMove", [{ x: x - by, y: y + by }]);
  await send("touchEnd", []);
  await eventually(async () => {
    const { points } = await shape(page, "rectangle");
    assert.ok(points[2][0] < before[2][0] - 1 && points[2][1] < before[2][1] - 1, `${points[2]}`);
    assert.deepEqual(points.toSpliced(2, 1), before.toSpliced(2, 1));
  });
  await page.locator(".part-stage[data-part=measured]").waitFor();
  assert.deepEqual(await audit(page, [".part-stage", "[data-group=shape]"]), []);
});
