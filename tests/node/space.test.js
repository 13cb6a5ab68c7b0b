/** The mathematics of pictures in three dimensions, without a picture: camera, planes, picking, colours, lines. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { load } from "directrix";
import { axesOf, dragged, eyeOf, FIELD, fitted, middleOf, panned, rayAt, seenAt, STANDARD, turned, zoomed } from "../../www/src/space/camera.js";
import { labsOf, srgbOf } from "../../www/src/space/colors.js";
import { heldAt, onSteps } from "../../www/src/space/gizmo.js";
import { groundStep, moveOf } from "../../www/src/space/keys.js";
import { segmentsOf, thinned } from "../../www/src/space/lines.js";
import { firstHit } from "../../www/src/space/pick.js";
import { cutOf, extentAlong } from "../../www/src/space/plane.js";
import { sectionPlane } from "../../www/src/space/section.js";
import { cornersOf, cross, dot, subtract } from "../../www/src/space/vector.js";
import { readingAt } from "../../www/src/solid/reading.js";
import { heightAt, levelsOf, rowsOf, shareAt, stagesAmong, upToPlane } from "../../www/src/solid/state.js";
import { loop } from "./curves.js";

/** @import { Camera, Frame } from "../../www/src/space/camera.js" */
/** @import { Vector } from "../../www/src/space/vector.js" */

/** @type {Frame} */
const frame = { size: { width: 800, height: 600 }, top: 44, bottom: 76 };
/** @type {Camera} */
const camera = { target: [3, -2, 5], azimuth: -50, elevation: 24, distance: 120 };

/** @param {readonly number[]} a @param {readonly number[]} b @param {number} [tolerance] */
function near(a, b, tolerance = 1e-9) {
  assert.equal(a.length, b.length);
  a.forEach((value, i) => assert.ok(Math.abs(value - b[i]) <= tolerance, `${a} is not ${b}`));
}

test("the axes of a camera are right-handed and of length 1 wherever it stands, straight above as well", () => {
  for (const [azimuth, elevation] of [[0, 0], [-60, 28], [130, -75], [-90, 90], [20, -90]]) {
    const { right, up, back } = axesOf({ azimuth, elevation });
    for (const [a, b] of [[right, up], [up, back], [back, right]]) assert.ok(Math.abs(dot(a, b)) < 1e-12);
    near(cross(right, up), back);
    assert.ok(Math.abs(dot(back, back) - 1) < 1e-12);
  }
  near(axesOf(STANDARD.top).right, [1, 0, 0]);
  near(axesOf(STANDARD.top).up, [0, 1, 0]);
  near(axesOf(STANDARD.front).back, [0, -1, 0]);
  near(axesOf(STANDARD.side).back, [1, 0, 0]);
});

test("a ray through the place where a point is seen meets the point", () => {
  for (const point of /** @type {Vector[]} */ ([[0, 0, 0], [20, -11, 3], [3, -2, 5], [-8, 9, 30]])) {
    const { at, depth } = seenAt(camera, frame, point);
    const { from, along } = rayAt(camera, frame, at);
    near(from, eyeOf(camera));
    near([0, 1, 2].map((axis) => from[axis] + depth * along[axis]), point, 1e-9);
  }
  near(seenAt(camera, frame, camera.target).at, middleOf(frame));
  const { up } = axesOf(camera);
  const top = seenAt(camera, frame, [0, 1, 2].map((axis) => camera.target[axis] + up[axis] * camera.distance * Math.tan((FIELD * Math.PI) / 360)));
  near(top.at, [400, middleOf(frame)[1] - 300], 1e-9);
});

test("a fitted camera sees every corner clear of what is covered, and touches the room in one direction", () => {
  const corners = cornersOf({ min: [-60, -20, 0], max: [10, 90, 40] });
  for (const view of Object.values(STANDARD)) {
    const found = fitted(view, frame, corners);
    const places = corners.map((corner) => seenAt(found, frame, corner).at);
    const [xs, ys] = [0, 1].map((axis) => places.map((place) => place[axis]));
    const room = [800 * 0.06, (600 - 120) * 0.06];
    assert.ok(Math.min(...xs) >= room[0] - 1e-6 && Math.max(...xs) <= 800 - room[0] + 1e-6, `${xs}`);
    assert.ok(Math.min(...ys) >= 44 + room[1] - 1e-6 && Math.max(...ys) <= 600 - 76 - room[1] + 1e-6, `${ys}`);
    const slack = Math.min(Math.min(...xs) - room[0], 800 - room[0] - Math.max(...xs), Math.min(...ys) - 44 - room[1], 524 - room[1] - Math.max(...ys));
    assert.ok(slack < 1e-6, `${slack} pixels left on every side`);
  }
});

test("drags, pans and zooms move what is under the pointer with it", () => {
  const moved = panned(camera, frame, 30, -20);
  near(seenAt(moved, frame, camera.target).at, [430, middleOf(frame)[1] - 20], 1e-9);
  const { from, along } = rayAt(camera, frame, [500, 200]);
  const under = [0, 1, 2].map((axis) => from[axis] + camera.distance * along[axis]);
  const nearer = zoomed(camera, frame, [500, 200], 2, 120);
  assert.equal(nearer.distance, 60);
  near(seenAt(nearer, frame, under).at, [500, 200], 1e-9);
  assert.ok(zoomed(camera, frame, [0, 0], 1e9, 120).distance > 0);
  assert.ok(zoomed(camera, frame, [0, 0], 1e-9, 120).distance < 120 * 20);
  assert.equal(turned(camera, 0, 500).elevation, 90);
  assert.equal(turned(camera, -200, 0).azimuth, 110);
  assert.ok(dragged(camera, 10, 0).azimuth < camera.azimuth);
});

test("keys move the camera, arrows only on the picture", () => {
  const key = (/** @type {string} */ name, more = {}) => ({ key: name, shiftKey: false, altKey: false, ...more });
  assert.deepEqual(moveOf(key("ArrowLeft"), true), { turn: [-5, 0] });
  assert.deepEqual(moveOf(key("ArrowUp", { altKey: true }), true), { turn: [0, 0.5] });
  assert.deepEqual(moveOf(key("ArrowRight", { shiftKey: true }), true), { pan: [24, -0] });
  assert.equal(moveOf(key("ArrowLeft"), false), null);
  assert.deepEqual(moveOf(key("8"), false), { view: "top" });
  assert.deepEqual(moveOf(key("f"), false), { fit: true });
  assert.equal(moveOf(key("x"), true), null);
});

/** A box of 12 triangles, outwards. @param {Vector} min @param {Vector} max */
function box(min, max) {
  const corners = cornersOf({ min, max });
  const quads = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
  return { positions: new Float32Array(corners.flat()), indices: new Uint32Array(quads.flatMap(([a, b, c, d]) => [a, b, c, a, c, d])) };
}

test("a ray meets the nearest triangle that is kept, from outside or within", () => {
  const mesh = box([0, 0, 0], [4, 2, 1]);
  /** @type {{from: Vector, along: Vector}} */
  const ray = { from: [1, 0.5, 9], along: [0, 0, -1] };
  const first = firstHit(mesh, ray);
  assert.ok(first && first.isFront);
  near(first.point, [1, 0.5, 1]);
  assert.ok(Math.abs(first.weights[0] + first.weights[1] + first.weights[2] - 1) < 1e-12);
  const within = firstHit(mesh, ray, [{ normal: [0, 0, -1], offset: -0.5 }]);
  assert.ok(within && !within.isFront);
  near(within.point, [1, 0.5, 0]);
  assert.equal(firstHit(mesh, { from: [9, 9, 9], along: [0, 0, -1] }), null);
  assert.equal(firstHit(mesh, ray, [], () => false), null);
});

test("a cut through a box is its closed outline, with the values of its edges", () => {
  const mesh = box([0, 0, 0], [4, 2, 1]);
  const heights = mesh.positions.map((_, k) => mesh.positions[3 * Math.floor(k / 3) + 2]);
  const { positions, values } = cutOf(mesh, { normal: [0, 0, 1], offset: 0.25 }, heights);
  let length = 0;
  /** @type {Map<string, number>} */
  const ends = new Map();
  for (let k = 0; k < positions.length; k += 6) {
    length += Math.hypot(...subtract(positions.slice(k + 3, k + 6), positions.slice(k, k + 3)));
    for (const at of [k, k + 3]) {
      const key = positions.slice(at, at + 3).join(" ");
      ends.set(key, (ends.get(key) ?? 0) + 1);
    }
  }
  assert.ok(Math.abs(length - 12) < 1e-6, `${length}`);
  assert.ok([...ends.values()].every((count) => count === 2), "closed, bit by bit");
  assert.ok(values.every((value) => value === 0.25));
  assert.equal(cutOf(mesh, { normal: [0, 0, 1], offset: 3 }, heights).positions.length, 0);
  assert.deepEqual(extentAlong([1, 0, 0], mesh.positions), [0, 4]);
});

test("colours come back from Oklab as the bytes they were", () => {
  const bytes = Uint8Array.from([0xf0, 0xe4, 0x42, 255, 0, 0x72, 0xb2, 255, 255, 255, 255, 255, 0, 0, 0, 255]);
  const labs = labsOf(bytes);
  for (let i = 0; i < 4; i += 1) near(srgbOf(labs, 3 * i).map((channel) => Math.round(255 * channel)), [...bytes.slice(4 * i, 4 * i + 3)], 0);
});

test("polylines become segments, and lose points that lie on their chords", () => {
  const square = new Float32Array([0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0]);
  assert.equal(segmentsOf([square], true).length, 4 * 6);
  assert.equal(segmentsOf([square], false).length, 3 * 6);
  const repeated = new Float32Array([...square, 0, 0, 0]);
  assert.equal(segmentsOf([repeated], true).length, 4 * 6);
  const arc = Float32Array.from({ length: 3 * 200 }, (_, k) => {
    const t = (Math.PI * Math.floor(k / 3)) / 199;
    return [Math.cos(t), Math.sin(t), 0][k % 3];
  });
  const few = thinned(arc, 1e-3);
  assert.ok(few.length < arc.length / 2 && few.length >= 3 * 20, `${few.length / 3} points`);
  for (let k = 0; k < few.length - 3; k += 3) {
    const middle = Math.hypot((few[k] + few[k + 3]) / 2, (few[k + 1] + few[k + 4]) / 2);
    assert.ok(1 - middle < 1.01e-3, `${1 - middle} off the arc`);
  }
});

test("planes of sections and of the build-up keep the side they should", () => {
  const positions = box([-2, -1, 0], [2, 1, 6]).positions;
  const x = sectionPlane({ axis: "x", at: 0.75, flipped: false }, positions, [0, -1, 0]);
  assert.deepEqual(x?.extent, [-2, 2]);
  near([...(x?.plane.normal ?? []), x?.plane.offset ?? NaN], [-1, 0, 0, -1]);
  const other = sectionPlane({ axis: "x", at: 0.75, flipped: true }, positions, [0, -1, 0]);
  near([...(other?.plane.normal ?? []), other?.plane.offset ?? NaN], [1, 0, 0, 1]);
  const view = sectionPlane({ axis: "view", at: 0.5, flipped: false }, positions, [0, 0, 1]);
  near([...(view?.plane.normal ?? []), view?.plane.offset ?? NaN], [0, 0, -1, -3]);
  assert.equal(sectionPlane({ axis: "off", at: 0.5, flipped: false }, positions, [0, 0, 1]), null);
  const levels = [0, 10, 40];
  for (const s of [0, 0.2, 0.5, 0.75, 1]) assert.ok(Math.abs(shareAt(levels, heightAt(levels, s)) - s) < 1e-12);
  assert.equal(heightAt(levels, 0.75), 25);
  assert.deepEqual(upToPlane([50, 0], 0.4), { normal: [0, 0, 1], offset: 30 });
  assert.deepEqual(upToPlane([0, 50], 0.4), { normal: [0, 0, -1], offset: -20 });
  assert.equal(upToPlane([0, 50], 1), null);
  assert.equal(upToPlane(null, 0.4), null);
});

test("what is read on a cone is what the kernel says of the place", async () => {
  const dx = await load();
  const ring = (/** @type {number} */ radius, /** @type {number} */ height, /** @type {number[]} */ mix) => ({
    degree: 3,
    form: "periodic",
    points: loop(32, radius),
    height,
    composition: [{ at: 0, mix }],
  });
  const materials = [{ name: "a", color: "#f0e442" }, { name: "b", color: "#0072b2" }];
  const curves = [ring(10, 0, [1, 0]), ring(4, 12, [0, 1])];
  const document = /** @type {any} */ ({ directrix: 1, kind: "curves", materials, curves, matching: { method: "exact", oneToOne: true, lines: 96 } });
  // A uniform cubic curve lies that much inside of its control points.
  const shrunk = (2 + Math.cos(Math.PI / 16)) / 3;
  const whole = /** @type {any} */ (dx.defaults(document));
  const solid = dx.solid(document, { stages: rowsOf(whole) });
  assert.ok(solid.ok && solid.bounds);
  assert.equal(stagesAmong(whole, solid.stages).length, whole.blend.stages - 1);
  const levels = levelsOf(solid);
  assert.ok(levels);
  near(levels, [0, 12], 1e-6);
  const shown = { planes: [], hasCaps: true, hasFace: true };
  // At a quarter of the way up the wall is 8.5 from the axis.
  const side = readingAt(solid, { from: [-50, 0, 3], along: [1, 0, 0] }, shown);
  assert.ok(side && side !== "inside");
  near(side.point, [-8.5 * shrunk, 0, 3], 0.02);
  assert.ok(Math.abs((side.s ?? 0) - 0.25) < 1e-6);
  near(side.fractions, [0.75, 0.25], 1e-3);
  const top = readingAt(solid, { from: [0, 1, 50], along: [0, 0, -1] }, shown);
  assert.ok(top && top !== "inside");
  assert.equal(top.cap, 1);
  near(top.fractions, [0, 1], 1e-6);
  const cut = { ...shown, planes: [{ normal: /** @type {Vector} */ ([0, 0, -1]), offset: -6 }] };
  assert.equal(readingAt(solid, { from: [0, 1, 50], along: [0, 0, -1] }, cut), "inside");
  assert.equal(readingAt(solid, { from: [20, 20, 50], along: [0, 0, -1] }, shown), null);
});

test("a gizmo moves a point along what it is held by, under the pointer", () => {
  /** @type {Frame} */
  const frame = { size: { width: 800, height: 600 }, top: 0, bottom: 0 };
  const camera = { target: /** @type {Vector} */ ([1, 2, 3]), azimuth: -50, elevation: 25, distance: 9 };
  const { back } = axesOf(camera);
  const start = /** @type {Vector} */ ([0.5, 2.2, 2.7]);
  for (const [part, goal] of /** @type {const} */ ([
    ["x", [1.7, 2.2, 2.7]],
    ["y", [0.5, 1.1, 2.7]],
    ["z", [0.5, 2.2, 3.9]],
    ["xy", [0.1, 2.9, 2.7]],
    ["xz", [1.3, 2.2, 3.1]],
    ["yz", [0.5, 2.6, 2]],
  ])) {
    // The pointer goes where the goal is seen.
    const found = heldAt(part, start, back, rayAt(camera, frame, seenAt(camera, frame, goal).at));
    assert.ok(found && Math.hypot(...subtract(found, goal)) < 1e-9, part);
  }
  const aside = heldAt("view", start, back, rayAt(camera, frame, [300, 200]));
  assert.ok(aside && Math.abs(dot(subtract(aside, start), back)) < 1e-9, "across the view");
  // An axis that is seen from its end tells nothing.
  assert.equal(heldAt("x", start, [1, 0, 0], { from: [9, 2, 3], along: [-1, 0, 0] }), null);
  assert.deepEqual(onSteps([0.52, 2.2, 2.81], [0.5, 2.2, 2.7], 0.25), [0.5, 2.2, 2.75]);
});

test("arrow keys move over the ground as it is seen, Home and End up and down", () => {
  assert.deepEqual(groundStep("ArrowRight", STANDARD.front.azimuth), [1, 0, 0]);
  assert.deepEqual(groundStep("ArrowUp", STANDARD.front.azimuth), [0, 1, 0]);
  assert.deepEqual(groundStep("ArrowRight", STANDARD.side.azimuth), [0, 1, 0]);
  assert.deepEqual(groundStep("ArrowUp", STANDARD.side.azimuth), [-1, 0, 0]);
  assert.deepEqual([groundStep("Home", 33), groundStep("End", 33), groundStep("a", 33)], [[0, 0, 1], [0, 0, -1], null]);
  for (let azimuth = -180; azimuth <= 180; azimuth += 7) {
    const { right, back } = axesOf({ azimuth, elevation: 30 });
    const [across, away] = [groundStep("ArrowRight", azimuth), groundStep("ArrowUp", azimuth)];
    assert.ok(across && away && dot(across, away) === 0);
    assert.ok(dot(across, right) > 0.7 && dot(away, back) < -0.6, `${azimuth}`);
  }
});
