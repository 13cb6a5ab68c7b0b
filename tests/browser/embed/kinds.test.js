/** Figures of other documents than curves: bodies, parts and boundary value problems. */
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { audit } from "../support/axe.js";
import { launch } from "../support/browser.js";
import { colors, eventually, linked, preset, stage, standing, stateOf, visit } from "./host.js";

/** @type {import("playwright-core").Browser} */
let browser;
/** @type {import("./host.js").Stage} */
let host;

before(async () => {
  [browser, host] = await Promise.all([launch(), stage()]);
});
after(() => Promise.all([browser.close(), host.close()]));

test("bodies stand beside curves on one page: turned once entered, cut, checked, and linked", async () => {
  const head = `<style>directrix-figure { display: block; aspect-ratio: 16 / 10; margin-bottom: 8px }</style><script type="module" src="${host.app}element.js"></script>`;
  const body = `<directrix-figure preset="hyperpatch-ring" controls="full" theme="light">Ring</directrix-figure>
    <directrix-figure preset="hyperpatch-invalid" controls="minimal" theme="dark">Cube</directrix-figure>
    <directrix-figure preset="amoeba">Amoeba</directrix-figure><p style="height: 2000px">After</p>`;
  await visit(browser, host.page(body, { head }), { viewport: { width: 700, height: 900 } }, async (page) => {
    /** @type {string[]} */
    const asked = [];
    page.on("request", (request) => asked.push(request.url().slice(host.app.length)));
    for (const k of [0, 1, 2]) await standing(page, k);
    await eventually(async () => assert.deepEqual([(await stateOf(page)).result.brief, (await stateOf(page)).result.verified], ["8 cells, verified", true]));
    await eventually(async () => assert.match((await stateOf(page, 1)).label ?? "", /^Folded inside\. 1 cell, invalid/));
    assert.equal((await stateOf(page, 2)).result.lines, 44);
    assert.equal((await stateOf(page)).runsIn, "blob worker");
    assert.ok(!asked.some((url) => /three|space/.test(url)), asked.join());
    assert.ok((await colors(page)) > 500);
    assert.ok(await page.locator("directrix-figure").first().locator(".layers").isHidden());
    assert.deepEqual(await audit(page), []);

    const figure = page.locator("directrix-figure").first();
    const orbit = figure.locator(".orbit");
    const box = await orbit.boundingBox();
    assert.ok(box);
    const shown = () => figure.locator("canvas").evaluate((/** @type {HTMLCanvasElement} */ canvas) => canvas.toDataURL().length + canvas.toDataURL().slice(-2000));
    const before = await shown();
    await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
    await page.mouse.wheel(0, 120);
    await eventually(async () => assert.ok((await page.evaluate(() => scrollY)) > 60));
    await page.evaluate(() => scrollTo(0, 0));
    assert.equal(await shown(), before, "the wheel is the page's");
    await page.mouse.down();
    await page.mouse.move(box.x + box.width / 2 + 60, box.y + box.height / 2 + 10, { steps: 4 });
    await page.mouse.up();
    await eventually(async () => assert.notEqual(await shown(), before));
    const dragged = await shown();
    await orbit.press("ArrowRight");
    await eventually(async () => assert.match((await figure.locator(".spoken[aria-live]").textContent()) ?? "", /^Seen from -?\d+°|^Seen from −\d+°/));
    await eventually(async () => assert.notEqual(await shown(), dragged));
    await orbit.press("5");
    await figure.getByRole("button", { name: "The whole body" }).click();
    await eventually(async () => assert.equal(await shown(), before));

    const slider = figure.getByRole("slider", { name: "Section" });
    await slider.fill("0.5");
    await eventually(async () => assert.match((await slider.getAttribute("aria-valuetext")) ?? "", /^Cut at y 0\.00$/));
    // The first of the two faces is all of the second material, unlit.
    await eventually(async () => assert.ok((await figure.locator("canvas").evaluate(greens)) > 1000));
    assert.equal((await stateOf(page)).s, 0.5);
    await eventually(async () => assert.deepEqual(linked((await stateOf(page)).href), await preset("hyperpatch/ring")));

    await figure.evaluate((/** @type {any} */ element) => (element.document = { ...element.document, title: "<b>Mine</b>" }));
    await eventually(async () => assert.match((await stateOf(page)).label ?? "", /^<b>Mine<\/b>\. 8 cells/));
    const refused = await figure.evaluate((/** @type {any} */ element) => {
      const bad = element.document;
      bad.operations[0].cells[0].coefficients.pop();
      return new Promise((done) => {
        element.addEventListener("error", (/** @type {CustomEvent} */ { detail }) => done(detail), { once: true });
        element.document = bad;
      });
    });
    assert.equal(refused.path, "operations[0].cells[0].coefficients");
    await figure.evaluate((element) => element.setAttribute("preset", "kidney"));
    await eventually(async () => assert.equal((await stateOf(page)).result.lines > 10, true));
    assert.equal(await orbit.count(), 0, "curves again, without a camera");
    await figure.locator(".handle").first().waitFor();
  });
});

test("parts are read place by place, brought nearer, and lead to the editor as they are", async () => {
  const body = `<directrix-figure preset="part-rectangle" controls="full" theme="light">Rectangle</directrix-figure>
    <directrix-figure preset="part-tool" controls="minimal" theme="dark" alt="A tool">Tool</directrix-figure>`;
  await visit(browser, host.page(body), {}, async (page) => {
    const figures = page.locator("directrix-figure");
    const [first, second] = [figures.nth(0), figures.nth(1)];
    const label = (/** @type {import("playwright-core").Locator} */ figure) => figure.locator("canvas").getAttribute("aria-label");
    await eventually(async () => assert.match((await label(first)) ?? "", /^Rectangle of two profiles\. 1 body, 2 features, red 12\.\d %/));
    await eventually(async () => assert.match((await label(second)) ?? "", /^A tool\. 1 body, 3 features/));
    const result = await second.evaluate((/** @type {any} */ element) => element.result);
    assert.deepEqual([result.part.skipped, result.verified], [0, true]);
    assert.ok(Math.abs(result.part.fractions.reduce((/** @type {number} */ a, /** @type {number} */ b) => a + b, 0) - 1) < 1e-3);
    const places = first.locator(".places");
    const card = first.locator(".card");
    const box = await places.boundingBox();
    assert.ok(box);
    await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
    await eventually(async () => assert.match(await card.innerText(), /yellow\s+100\.0 %[^]*A\s+50\.00 mm/));
    await places.focus();
    await page.keyboard.press("Shift+ArrowDown");
    const live = () => first.locator(".spoken[aria-live]").innerText();
    await eventually(async () => assert.match(await live(), /^x 50\.\d\d, y \d+\.\d\d: rectangle, yellow/));
    await page.keyboard.press("+");
    await eventually(async () => assert.equal(await live(), "Zoom 150 %"));
    await first.getByRole("button", { name: "The whole part" }).click();
    await eventually(async () => assert.equal(await live(), "The whole part"));
    assert.equal(await first.getByRole("slider").count(), 0, "nothing to be played");
    await eventually(async () => assert.deepEqual(linked((await stateOf(page)).href), await preset("part/rectangle")));
    assert.deepEqual(await audit(page), []);
    await first.evaluate((element) => element.setAttribute("preset", "kidney"));
    await eventually(async () => assert.equal((await stateOf(page)).result.lines > 10, true));
    assert.equal(await places.count(), 0, "curves again");
  });
});

test("boundary value problems are solved in figures, and say whether they lie in the plane or are the section of one in space", async () => {
  const body = `<directrix-figure preset="laplace-cube" controls="full" theme="light">Cube</directrix-figure>
    <directrix-figure preset="laplace-annulus" controls="full" theme="dark">Ring</directrix-figure>`;
  await visit(browser, host.page(body), {}, async (page) => {
    const figures = page.locator("directrix-figure");
    const [cube, ring] = [figures.nth(0), figures.nth(1)];
    const label = (/** @type {import("playwright-core").Locator} */ figure) => figure.locator("canvas").getAttribute("aria-label");
    await eventually(async () => assert.match((await label(cube)) ?? "", /Section of a solution in space, 768 triangles, solved, \d+ iterations/));
    await eventually(async () => assert.match((await label(ring)) ?? "", /Problem in the plane, 192 segments, solved/));
    assert.equal((await cube.evaluate((/** @type {any} */ element) => element.result)).verified, true);
    assert.equal(await cube.getByRole("slider").count(), 0, "nothing to be played");
    assert.match(await ring.locator(".key").innerText(), /^Problem in the plane$/);
    await cube.locator(".orbit").focus();
    await page.keyboard.press("6");
    await eventually(async () => assert.match(await cube.locator(".spoken[aria-live]").innerText(), /^Seen from/));
    assert.deepEqual(await audit(page), []);
  });
});

/** Pixels of a canvas that have the colour of the second material. @param {HTMLCanvasElement} canvas */
function greens(canvas) {
  const copy = document.createElement("canvas");
  [copy.width, copy.height] = [canvas.width, canvas.height];
  const context = /** @type {CanvasRenderingContext2D} */ (copy.getContext("2d", { willReadFrequently: true }));
  context.drawImage(canvas, 0, 0);
  const { data } = context.getImageData(0, 0, copy.width, copy.height);
  let count = 0;
  for (let n = 0; n < data.length; n += 4) count += Number(Math.abs(data[n]) <= 3 && Math.abs(data[n + 1] - 158) <= 3 && Math.abs(data[n + 2] - 115) <= 3);
  return count;
}

test("a finger scrolls over a body until it is tapped, and then turns it", async () => {
  const body = `<directrix-figure preset="hyperpatch-cell" theme="dark"></directrix-figure><p style="height: 3000px">Below</p>`;
  await visit(browser, host.page(body), { hasTouch: true, viewport: { width: 390, height: 700 } }, async (page) => {
    const figure = await standing(page);
    const orbit = figure.locator(".orbit");
    const action = () => orbit.evaluate((element) => getComputedStyle(element).touchAction);
    assert.equal(await action(), "auto");
    await orbit.tap();
    await eventually(async () => assert.equal(await action(), "none"));
    const shown = () => figure.locator("canvas").evaluate((/** @type {HTMLCanvasElement} */ canvas) => canvas.toDataURL());
    const before = await shown();
    const box = await orbit.boundingBox();
    assert.ok(box);
    const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
    const client = await page.context().newCDPSession(page);
    await client.send("Input.dispatchTouchEvent", { type: "touchStart", touchPoints: [{ x, y }] });
    for (let k = 1; k <= 4; k++) await client.send("Input.dispatchTouchEvent", { type: "touchMove", touchPoints: [{ x: x + 10 * k, y: y + 10 * k }] });
    await client.send("Input.dispatchTouchEvent", { type: "touchEnd", touchPoints: [] });
    await eventually(async () => assert.notEqual(await shown(), before));
    assert.equal(await page.evaluate(() => scrollY), 0);
    await page.evaluate(() => /** @type {HTMLElement} */ (document.querySelector("directrix-figure")?.shadowRoot?.activeElement)?.blur());
    await eventually(async () => assert.equal(await action(), "auto"));
    assert.deepEqual(await audit(page), []);
  });
});
