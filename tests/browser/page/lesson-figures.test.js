/** Figures of lessons that are not of curves: cells and bodies, parts and grids, boundary value problems. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { SOFTWARE } from "../support/browser.js";
import { cell, control, first, goTo, lit, named, shows, term } from "./lesson.js";
import { openPage } from "./open.js";
import { documentOf, drag, eventually, field, middle, spoken } from "./workbench.js";

const [validity, corner, material, profiles, transform, overlaps, voxels, heat, elements, precondition] = ["cell-validity", "corner-continuity", "material-continuity", "distance-profiles", "distance-transform", "overlaps", "voxel-error", "heat", "boundary-elements", "why-precondition"].map(named);

test("a cell by hand: what is summed at a place, what rides along when a coefficient moves, and J inside", async (t) => {
  // The workbench of bodies draws without a graphics card here, which the driver remarks on.
  const page = await openPage(t, { allow: SOFTWARE });
  const value = (/** @type {string} */ name) => control(page, name).innerText();
  const slide = (/** @type {string} */ name, /** @type {string} */ to) => page.locator(`[data-slider=lesson-${name}]`).fill(to);
  await goTo(page, cell, 2);
  assert.match((await page.locator(".cell-reading tbody tr").first().innerText()).replace(/\s+/g, " "), /^\(0, 1, 3\) 0\.113 /);
  assert.match((await page.locator(".cell-reading .sum").innerText()).replace(/\s+/g, " "), /^Sum of all 64 1\.000 \(−0\.24, −0\.56, 1\.60\)$/);
  for (const name of ["u", "v", "w"]) await slide(name, "0");
  assert.match((await page.locator(".cell-reading tbody tr").first().innerText()).replace(/\s+/g, " "), /^\(0, 0, 0\) 1\.000 /);
  await term(page, "through").hover();
  await eventually(async () => assert.equal(await lit(page, "strokes"), 3));

  await goTo(page, cell, 3);
  const place = await value("place");
  assert.equal(await value("mix-1"), "84.4\u00a0%");
  await drag(page, await middle(control(page, "coefficient")), [-60, -30]);
  await eventually(async () => assert.notEqual(await value("place"), place));
  assert.equal(await value("mix-1"), "84.4\u00a0%", "the material rides along");
  const dragged = await control(page, "coefficient").getAttribute("aria-label");
  await control(page, "coefficient").focus();
  await page.keyboard.press("Shift+ArrowUp");
  await eventually(async () => assert.equal(await spoken(page), await control(page, "coefficient").getAttribute("aria-label")));
  assert.notEqual(await spoken(page), dragged);
  assert.equal(new URL(page.url()).hash, `#lesson=${cell.name}&step=3`, "arrows belong to the coefficient");
  const handle = await middle(control(page, "coefficient"));
  const orbit = page.locator(".lesson-picture .orbit");
  await orbit.focus();
  await page.keyboard.press("ArrowRight");
  await eventually(async () => assert.notDeepEqual(await middle(control(page, "coefficient")), handle));
  await page.locator(".lesson h1").focus();
  await page.keyboard.press("r");
  await eventually(async () => assert.equal(await value("place"), place));

  await goTo(page, cell, 4);
  assert.equal(await value("verdict"), "invalid");
  assert.equal(await value("jacobian-corners"), "1.000");
  await slide("u", "0.5");
  assert.equal(await value("jacobian"), "−0.350");

  await t.test("a certificate is found by halving, and a twist is valid without being regular", async () => {
    await goTo(page, validity, 3);
    assert.equal(await value("least-number"), "−0.810");
    assert.equal(await value("settled"), "not settled yet");
    await slide("halvings", "8");
    assert.deepEqual([await value("least-number"), await value("settled")], ["0.030", "positive, proven"]);
    await goTo(page, validity, 4);
    assert.equal(await value("margin"), "0.000");
    await slide("twist", "150");
    await eventually(async () => assert.deepEqual([await value("margin"), await value("verdict")], ["−0.743", "valid"]));
    await slide("twist", "60");
    await eventually(async () => assert.deepEqual([await value("margin"), await value("verdict")], ["0.403", "regular"]));
  });

  await t.test("Eq. 8 on one pair breaks a corner, and the repaired rule keeps it, by pointer and by keys", async () => {
    await goTo(page, corner, 4);
    await eventually(async () => assert.deepEqual([await value("moving"), await value("smooth-shape")], ["2", "4"]));
    await page.locator("[data-select=lesson-reach]").selectOption("block");
    await eventually(async () => assert.deepEqual([await value("moving"), await value("smooth-shape")], ["18", "12"]));
    const own = () => control(page, "coefficient").getAttribute("aria-label");
    const before = await own();
    await control(page, "coefficient").focus();
    await page.keyboard.press("ArrowDown");
    await eventually(async () => assert.notEqual(await own(), before));
    const lower = await own();
    await drag(page, await middle(control(page, "coefficient")), [20, 12]);
    await eventually(async () => assert.notEqual(await own(), lower));
    await eventually(async () => assert.equal(await value("smooth-shape"), "12"));
    await page.locator("[data-select=lesson-coefficient]").selectOption({ label: "(2, 2, 2) of cell 0" });
    await eventually(async () => assert.equal(await value("moving"), "8"));
    await control(page, "reset").click();
    await eventually(async () => assert.deepEqual([await value("moving"), await value("smooth-shape")], ["2", "4"]));
    await goTo(page, corner, 1);
    assert.equal(await value("ratio-3"), "3.93");
  });

  await t.test("a joint whose reflection is no composition has a kink, and other rules have none", async () => {
    await goTo(page, material, 1);
    await eventually(async () => assert.match(await value("joint"), /kink/));
    assert.equal(await value("mix-beyond"), "(−0.10, 1.10), no composition");
    await slide("at", "0.75");
    await eventually(async () => assert.match(await value("joint"), /smooth/));
    await slide("at", "0.9");
    await eventually(async () => assert.match(await value("joint"), /kink/));
    await page.locator("[data-segment=lesson-rule] label").nth(2).click();
    await eventually(async () => assert.match(await value("joint"), /smooth/));
    assert.ok(await page.locator("[data-slider=lesson-before]").isHidden());
    await goTo(page, material, 5);
    await eventually(async () => assert.equal(await value("amount-1"), "11.40 (30.0\u00a0%)"));
    assert.equal(await value("here-1"), "70.0\u00a0%");
  });

  await t.test("a place of a part is read, its limit dragged, and three rules stand beside each other", async () => {
    await goTo(page, profiles, 1);
    await eventually(async () => assert.deepEqual([await value("mix-0"), await value("distance")], ["0.600", "20.00 mm"]));
    await slide("limit", "25.3");
    await eventually(async () => assert.equal(await value("mix-0"), "0.209"));
    await control(page, "place").focus();
    const spot = await control(page, "place").getAttribute("aria-label");
    await page.keyboard.press("Shift+ArrowLeft");
    await eventually(async () => assert.notEqual(await control(page, "place").getAttribute("aria-label"), spot));
    await eventually(async () => assert.ok(Number(await value("mix-0")) > 0.4));
    await goTo(page, profiles, 2);
    await eventually(async () => assert.equal(await value("mix-0"), "0.500"));
    await page.locator("[data-select=lesson-course]").selectOption("power");
    await eventually(async () => assert.equal(await value("mix-0"), "0.875"));
    await goTo(page, overlaps, 2);
    await eventually(async () => assert.deepEqual([await value("here-repaired"), await value("here-printed")], ["0.993", "0.490"]));
    await page.locator("[data-segment=lesson-overlap] label").nth(2).click();
    await eventually(async () => assert.notEqual(await value("mix-1"), "0.993"));
    await control(page, "reset").click();
    await eventually(async () => assert.equal(await value("mix-1"), "0.993"));
  });

  await t.test("the transform goes from row to row and from column to column; errors of voxels keep their bound", async () => {
    await goTo(page, transform, 1);
    await eventually(async () => assert.equal(await value("pass"), "features"));
    await slide("pass", "12");
    await eventually(async () => assert.equal(await value("pass"), "row 12 of 12"));
    await slide("pass", "18");
    await eventually(async () => assert.deepEqual([await value("parabolas"), await value("corners")], ["5", "4"]));
    await goTo(page, transform, 4);
    await eventually(async () => assert.deepEqual([await value("allowed"), await value("compared")], ["43", "23"]));
    await goTo(page, voxels, 1);
    await eventually(async () => assert.match(await value("worst"), /^1\.211 /));
    await page.locator("[data-segment=lesson-where] label").first().click();
    await eventually(async () => assert.match(await value("worst"), /^0\.646 /));
  });

  await t.test("means, panels, the matrix and residuals are solved as they are shown", async () => {
    await goTo(page, heat, 2);
    await eventually(async () => assert.deepEqual([await value("own"), await value("mean")], ["0.4336", "0.4336"]));
    await control(page, "place").focus();
    await page.keyboard.press("Shift+ArrowDown");
    await eventually(async () => assert.notEqual(await value("own"), "0.4336"));
    await eventually(async () => assert.ok(Math.abs(Number(await value("own")) - Number(await value("mean"))) < 1e-3));
    await slide("radius", "0.5");
    await eventually(async () => assert.match(await page.locator(".cell-reading").innerText(), /leaves the body/));
    await goTo(page, elements, 3);
    await eventually(async () => assert.deepEqual([await value("size"), await value("zeros")], ["256", "0"]));
    await slide("steps", "6");
    await eventually(async () => assert.deepEqual([await value("size"), await value("panels")], ["576", "24 panels"]));
    await goTo(page, precondition, 4);
    await eventually(async () => assert.ok(Number(await value("iterations-ssor")) > Number(await value("iterations-none"))));
    const before = Number(await value("iterations-ssor"));
    await slide("omega", "1");
    await eventually(async () => assert.ok(Number(await value("iterations-ssor")) > before));
  });

  await goTo(page, cell, 5);
  await eventually(async () => assert.equal(await value("verdict"), "valid"));
  // A field shows every digit once it has the focus.
  await field(page, "lesson-x").focus();
  await field(page, "lesson-x").fill("2");
  await page.keyboard.press("Enter");
  await eventually(async () => assert.equal(await value("verdict"), "invalid"));
  await eventually(async () => assert.match(await value("jacobian-least"), /^−0\.0/));
  await control(page, "open").click();
  await page.locator(".body-stage[data-body=checked]").waitFor();
  const opened = /** @type {any} */ (await documentOf(page));
  assert.deepEqual(opened.operations[0].cells[0].coefficients[21].position, [2, 0.333333333, 0.333333333]);
  // From a body back to lessons of curves, which cannot show it.
  await page.getByRole("link", { name: "Lessons" }).click();
  await shows(page, cell, 5);
  await goTo(page, first, 4);
  await control(page, "mine").click();
  await eventually(async () => assert.match(await page.locator(".lesson-message").innerText(), /^Your document is a body/));
});
