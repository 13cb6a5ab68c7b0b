/** What the workbench Part computes beside the kernel: pixels, frames, readings, estimates of files, what a diagnostic chooses. */
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { join } from "node:path";
import { test } from "node:test";
import { load } from "directrix";
import { root } from "../../scripts/lib/paths.mjs";
import { estimated, fileOptions, memoryOf, MOST_MEMORY, MOST_PIXELS, MOST_VOXELS, pixelsOf } from "../../www/src/part/files.js";
import { brokenPixels, countOf, differencesOf, leafColor, leafPixels } from "../../www/src/part/pixels.js";
import { choiceOf } from "../../www/src/part/problems.js";
import { coarsePixels, thinned, visibleFrame, wholeFrame } from "../../www/src/part/raster.js";
import { pixelAt, readingOf } from "../../www/src/part/reading.js";
import { checked, repaired } from "../../www/src/part/runner.js";
import { extentOf, FIRST_SHOWN, firstChoice, stepIn, withoutGone } from "../../www/src/part/state.js";

const dx = await load();
/** @type {any} */
const rectangle = JSON.parse(await readFile(join(root, "www/presets/part/rectangle.json"), "utf8"));
/** @type {[[number, number], [number, number]]} */
const BOX = [[0, 0], [100, 60]];

test("frames keep to the box and to the number of pixels", () => {
  const view = { center: /** @type {[number, number]} */ ([50, 30]), scale: 4 };
  const frame = visibleFrame(view, { width: 400, height: 240 }, 2, Infinity);
  assert.deepEqual(frame, { box: [[0, 0], [100, 60]], size: [800, 480] });
  // What lies beyond the coordinates of a document is not evaluated, in pixels of the same size.
  const far = visibleFrame({ center: [1e9 - 50, 30], scale: 4 }, { width: 800, height: 240 }, 1, Infinity);
  assert.deepEqual(far, { box: [[1e9 - 150, 0], [1e9, 60]], size: [600, 240] });
  assert.equal(visibleFrame({ center: [2e9, 0], scale: 4 }, { width: 800, height: 240 }, 1, Infinity), null);
  const few = visibleFrame(view, { width: 400, height: 240 }, 2, 10_000);
  assert.ok(frame && few);
  assert.deepEqual(few.box, frame.box);
  assert.ok(few.size[0] * few.size[1] <= 10_000 && few.size[0] * few.size[1] > 9_500, String(few.size));
  assert.deepEqual(wholeFrame(BOX, 1000).size, [1000, 600]);
  assert.deepEqual(wholeFrame([[0, 0], [1, 1000]], 100).size, [1, 100]);
  const thin = thinned({ box: BOX, size: [1000, 600] }, 60_000).size;
  assert.ok(thin[0] * thin[1] <= 60_000 && Math.abs(thin[0] / thin[1] - 5 / 3) < 0.02, String(thin));
  // As many pixels as their time allows, within limits.
  assert.equal(coarsePixels(1e9), 160_000);
  assert.equal(coarsePixels(0), 16_000);
  assert.equal(coarsePixels(5000), 60_000);
});

test("a raster is read at its pixels, and a place by the rule as printed has the fractions of its pixel", () => {
  const part = dx.part(rectangle);
  const raster = part.evaluate({ size: [100, 60] });
  const read = pixelAt(raster, [12.5, 45.5]);
  const exact = part.probe([12.5, 45.5]);
  assert.ok(read && exact?.fractions);
  read.fractions.forEach((fraction, k) => assert.ok(Math.abs(fraction - (exact.fractions?.[k] ?? NaN)) < 1e-6));
  assert.equal(read.leaf, exact.leaf);
  assert.equal(pixelAt(raster, [-0.1, 5]), null);
  assert.equal(pixelAt(raster, [100.1, 5]), null);

  const printed = dx.part({ ...rectangle, bodies: [{ ...rectangle.bodies[0], rule: "printed" }] });
  const voxels = printed.evaluate({ size: [100, 60] });
  const place = readingOf(printed.probe([80.5, 0.5]), voxels, [80.5, 0.5]);
  assert.ok(place?.isVoxel && place.fractions);
  assert.deepEqual(place.fractions, voxels.fractions.map((list) => list[59 * 100 + 80]));
  assert.equal(readingOf(null, voxels, [0, 0]), null);
});

test("what two rules differ by is the largest difference of a fraction, and repaired differs from itself by nothing", () => {
  const printed = { ...rectangle, bodies: [{ ...rectangle.bodies[0], rule: "printed" }] };
  const [a, b] = [dx.part(printed), dx.part(repaired(printed))].map((part) => part.evaluate({ size: [100, 60] }));
  const { differences, most } = differencesOf(a, b);
  const at = 59 * 100 + 99;
  const expected = Math.max(...a.fractions.map((list, k) => Math.abs(list[at] - b.fractions[k][at])));
  assert.ok(Math.abs(differences[at] - expected) < 1e-7);
  assert.ok(Math.abs(Math.max(...differences) - most) < 1e-6 && most > 0.5, String(most));
  assert.equal(differencesOf(b, b).most, 0);
});

test("pixels of leaves and of broken rules are where the raster has them", () => {
  const part = dx.part(rectangle);
  const raster = part.evaluate({ size: [100, 60] });
  const pixels = leafPixels(raster, null);
  const color = (/** @type {number} */ n) => [...pixels.subarray(4 * n, 4 * n + 3)];
  assert.deepEqual(color(0), leafColor({ body: 0, leaf: 1 }));
  assert.deepEqual(color(59 * 100), leafColor({ body: 0, leaf: 3 }));
  assert.deepEqual(color(99), leafColor({ body: 0, leaf: 0 }));
  assert.equal(new Set([0, 1, 2, 3].map((leaf) => String(leafColor({ body: 0, leaf })))).size, 4);
  assert.equal(countOf(0b1011), 3);
  assert.equal(countOf(2 ** 31), 1);
  const lit = leafPixels(raster, { body: 0, leaf: 3 });
  assert.equal(lit[4 * 5900 + 3], 255);
  assert.ok(lit[3] < 128);

  const violations = part.violations({ size: [100, 60] });
  const hatched = brokenPixels(violations, null);
  assert.equal(hatched.filter((_, k) => k % 4 === 3).filter((alpha) => alpha === 255).length, violations.rules[0].count);
  assert.ok(violations.rules[0].count > 0);
  assert.ok(brokenPixels(violations, 1).every((byte) => byte === 0));
});

test("sums and limits of fractions are checked over the pixels of bodies alone", () => {
  const { pixels, sumError, clamped } = checked(dx.part(rectangle).evaluate({ box: [[-50, 0], [100, 60]], size: [150, 60] }));
  assert.deepEqual([pixels, clamped], [6000, 0]);
  assert.ok(sumError < 1e-6);
  const bad = { body: new Uint8Array([0, 1, 1]), fractions: [new Float32Array([9, 1.5, 0.5]), new Float32Array([9, -0.5, 0.25])] };
  assert.deepEqual(checked(bad), { pixels: 2, sumError: 0.25, clamped: 1 });
});

test("estimates of files are what the kernel makes and refuses", () => {
  /** @type {import("../../www/src/part/files.js").Wanted} */
  const wanted = { format: "png", by: "longer", longer: 200, pitch: 0.3, material: null, dither: "none" };
  const part = dx.part(rectangle);
  const widthOf = (/** @type {Uint8Array} */ png) => [new DataView(png.buffer, png.byteOffset).getUint32(16), new DataView(png.buffer, png.byteOffset).getUint32(20)];
  for (const by of /** @type {const} */ (["longer", "pitch"])) {
    assert.deepEqual(widthOf(part.file(fileOptions(BOX, { ...wanted, by }))), pixelsOf(BOX, { ...wanted, by }), by);
  }
  assert.deepEqual(pixelsOf(BOX, { ...wanted, by: "pitch" }), [334, 200]);
  assert.equal(estimated(rectangle, BOX, wanted).excess, null);

  // One pixel more than the limit is refused by both.
  const most = estimated(rectangle, BOX, { ...wanted, longer: 4000 });
  assert.deepEqual([most.excess, most.most], ["pixels", MOST_PIXELS]);
  assert.throws(() => part.file(fileOptions(BOX, { ...wanted, longer: 4000 })), { code: "limit" });
  const printed = { ...rectangle, bodies: [{ ...rectangle.bodies[0], rule: "printed" }] };
  assert.deepEqual([estimated(printed, BOX, { ...wanted, longer: 1400 }).excess, estimated(printed, BOX, { ...wanted, longer: 1400 }).most], ["pixels", MOST_VOXELS]);
  assert.throws(() => dx.part(printed).file(fileOptions(BOX, { ...wanted, longer: 1400 })), { code: "limit" });

  // 20 materials on many pixels take more memory than there may be.
  const many = { ...rectangle, materials: Array.from({ length: 16 }, (_, k) => ({ name: `m${k}`, color: "#888888" })) };
  const pixels = estimated(many, BOX, { ...wanted, longer: 2600 });
  assert.equal(pixels.memory, memoryOf(many, pixels.pixels));
  assert.equal(pixels.excess, pixels.memory > MOST_MEMORY ? "memory" : null);
});

test("a diagnostic chooses what it is about", () => {
  const choices = (/** @type {any} */ document) => dx.part(document).diagnostics.map((diagnostic) => ({ code: diagnostic.code, choice: choiceOf(document, diagnostic) }));
  const limits = structuredClone(rectangle);
  limits.bodies[0].features[1].from = 40;
  limits.rules.push({ name: "empty", material: 0, least: 0.9, most: 0.1 });
  assert.deepEqual(
    choices(limits).map(({ code, choice: { body, feature, rule } }) => [code, body ?? null, feature ?? null, rule ?? null]),
    [["limits", 0, 1, null], ["limits", null, null, 1]],
  );
  const crossing = structuredClone(rectangle);
  crossing.shapes[0].points = [[0, 0], [100, 60], [100, 0], [0, 60]];
  const [{ code, choice }] = choices(crossing);
  assert.deepEqual([code, choice.shape], ["self-intersection", "rectangle"]);
  assert.ok(choice.witness && Math.hypot(choice.witness[0] - 50, choice.witness[1] - 30) < 1e-6, JSON.stringify(choice));
});

test("what is chosen goes with what it was of", () => {
  const shown = { ...FIRST_SHOWN, body: 0, feature: 1, shape: "edge A", point: 1, rule: 0, isolines: 2 };
  assert.equal(withoutGone(shown, rectangle), shown);
  const fewer = { ...rectangle, shapes: rectangle.shapes.slice(0, 1), rules: [], materials: rectangle.materials.slice(0, 2) };
  assert.deepEqual(withoutGone(shown, fewer), { ...shown, shape: null, point: null, rule: null, isolines: null });
  assert.deepEqual(firstChoice(rectangle), { body: 0, feature: 0 });
  assert.deepEqual(firstChoice({ ...rectangle, bodies: [] }), {});
  assert.deepEqual(extentOf(rectangle), [[0, 0], [100, 60]]);
  assert.equal(extentOf({ ...rectangle, shapes: [] }), null);
  assert.deepEqual(extentOf({ ...rectangle, shapes: [{ name: "c", kind: "circle", center: [1, 2], radius: 3 }] }), [[-2, -1], [4, 5]]);
  assert.equal(stepIn({ center: [0, 0], scale: 10 }, false), null);
  assert.equal(stepIn({ center: [0, 0], scale: 10 }, true), 5);
});
