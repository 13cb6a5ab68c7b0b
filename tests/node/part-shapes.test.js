/** Edits of the shapes of a part, as the page makes them: what they change, what they leave the same object, and that the kernel reads what comes of them. */
import assert from "node:assert/strict";
import { readFile, readdir } from "node:fs/promises";
import { join } from "node:path";
import { test } from "node:test";
import { load } from "directrix";
import { root } from "../../scripts/lib/paths.mjs";
import { converted, targetsOf, thinned } from "../../www/src/part/edits/convert.js";
import { namedFor, nestingOf, withImported } from "../../www/src/part/edits/imported.js";
import { canRemove, insertPoint, placeAfter, removePoints, whyNotInsert } from "../../www/src/part/edits/points.js";
import {
  addBody,
  addShape,
  bodyShapes,
  copyName,
  deleteShape,
  duplicateShape,
  fillHole,
  freshName,
  makeBody,
  makeHole,
  moveShape,
  moveShapes,
  placeHandle,
  renameShape,
  setAngle,
  setCoordinate,
  setDirection,
  setGeometry,
  setRadius,
  shapeNames,
  shapeOf,
  usedNames,
  usesOf,
  whyNotAdd,
  whyNotName,
} from "../../www/src/part/edits/shapes.js";
import { bodyFor, nameFor, put, shapeFrom, whyNotPut } from "../../www/src/part/shapes/drawing.js";
import { angleOf, areaOf, boxOf, chainOf, fewestOf, handleCount, nearestPiece, pointsOf } from "../../www/src/part/shapes/geometry.js";
import { along, arrowStep, dragged, nudged, rested, restedAngle, restedRadius } from "../../www/src/part/shapes/moves.js";
import { litBy, nearestHandle, outlinePath, rolesOf, under } from "../../www/src/part/shapes/places.js";

/**
 * @typedef {import("../../www/src/part/document.js").WholePart} WholePart
 * @typedef {import("../../www/src/part/shapes/geometry.js").NamedShape} NamedShape
 */

const dx = await load();
const folder = join(root, "www/presets/part");
const presets = await Promise.all(
  (await readdir(folder)).map(async (file) => dx.part(await readFile(join(folder, file), "utf8")).defaults()),
);

/** A part with a shape of every kind, each of them used in one way or another. @type {WholePart} */
const all = dx.part({
  directrix: 1,
  kind: "part",
  materials: [{ name: "a", color: "#000000" }, { name: "b", color: "#ffffff" }],
  shapes: [
    { name: "dot", kind: "point", at: [5, 5] },
    { name: "axis", kind: "line", through: [0, 20], direction: [2, 0] },
    { name: "edge", kind: "segment", from: [0, 0], to: [0, 40] },
    { name: "bore", kind: "circle", center: [30, 20], radius: 6 },
    { name: "plate", kind: "polygon", points: [[0, 0], [60, 0], [60, 40], [0, 40]] },
    { name: "path", kind: "polyline", points: [[5, 5], [20, 10], [30, 5]] },
    { name: "blob", kind: "curve", degree: 3, form: "periodic", points: [[70, 0], [90, 0], [95, 20], [90, 40], [70, 40]] },
    { name: "arc", kind: "curve", degree: 3, form: "open", points: [[5, 35], [15, 38], [25, 30], [35, 38], [45, 35]] },
    { name: "loop", kind: "curve", degree: 2, form: "clamped", points: [[70, 50], [90, 50], [90, 70], [70, 70], [70, 50]] },
  ],
  bodies: [
    {
      name: "plate",
      outline: "plate",
      holes: ["bore"],
      default: [1, 0],
      features: [
        { name: "edge", reference: "edge", to: 10, start: [0, 1] },
        { name: "walls", reference: { boundary: "plate", except: ["edge", "bore"] }, to: 4, start: [0, 1] },
        { name: "both", references: { a: "edge", b: "dot", c: { boundary: "plate", except: ["bore"] } }, distance: "min(a, min(b, c))", to: 3, start: [0.5, 0.5] },
      ],
    },
    { name: "blob", outline: "blob", default: [0, 1], features: [{ name: "far edge", reference: "edge", from: 70, to: 90, start: [1, 0] }] },
  ],
}).defaults();

/** Freezes a document through and through, so that an edit in place throws. @template T @param {T} value @returns {T} */
function frozen(value) {
  if (typeof value === "object" && value !== null) for (const each of Object.values(Object.freeze(value))) frozen(each);
  return value;
}
frozen(all);

/** @param {WholePart} document @param {string} name @returns {NamedShape} */
function need(document, name) {
  const shape = shapeOf(document, name);
  assert.ok(shape, `there is no ${name}`);
  return shape;
}

/** @param {number} a @param {number} b @param {number} by */
const near = (a, b, by) => assert.ok(Math.abs(a - b) <= by, `${a}, not ${b}`);

/** The codes of what the kernel says. @param {WholePart} document */
const codes = (document) => dx.part(document).diagnostics.map(({ code, path }) => `${code} ${path}`);

test("a point, a whole shape and several shapes move, and all else stays the same object", () => {
  const moved = placeHandle(all, "plate", 2, [65, 39.9]);
  assert.deepEqual(pointsOf(need(moved, "plate")), [[0, 0], [60, 0], [65, 39.9], [0, 40]]);
  assert.equal(moved.bodies, all.bodies);
  moved.shapes?.forEach((shape, i) => assert.equal(shape === all.shapes?.[i], shape.name !== "plate"));
  // Points that stay are the same objects as well.
  assert.equal(pointsOf(need(moved, "plate"))[0], pointsOf(need(all, "plate"))[0]);

  for (const name of shapeNames(all)) {
    const before = need(all, name);
    const after = need(moveShape(all, name, [0.1, 0.2]), name);
    const expected = pointsOf(before).map(([x, y]) => [Number((x + 0.1).toPrecision(12)), Number((y + 0.2).toPrecision(12))]);
    assert.deepEqual(pointsOf(after), expected, name);
    assert.equal(moveShape(all, name, [0, 0]), all, "nothing moves by nothing");
    assert.deepEqual(codes(moveShape(all, name, [0.1, 0.2])), []);
  }
  assert.deepEqual(moveShapes(all, ["dot", "bore", "dot"], [1, 2]), moveShape(moveShape(all, "dot", [1, 2]), "bore", [1, 2]));
  assert.equal(moveShape(all, "nothing", [1, 1]), all);
  assert.equal(placeHandle(all, "plate", 2, [60, 40]), all);
});

test("the first point of a clamped curve takes the last along", () => {
  const after = need(placeHandle(all, "loop", 0, [71, 51]), "loop");
  assert.ok(after.kind === "curve");
  assert.deepEqual(after.points, [[71, 51], [90, 50], [90, 70], [70, 70], [71, 51]]);
  assert.equal(handleCount(after), 4);
  assert.deepEqual(codes(placeHandle(all, "loop", 0, [71, 51])), []);
});

test("handles are put in place; rim and direction set a radius and a direction", () => {
  assert.deepEqual(need(placeHandle(all, "bore", 1, [33, 24]), "bore"), { name: "bore", kind: "circle", center: [30, 20], radius: 5 });
  assert.deepEqual(need(placeHandle(all, "bore", 0, [1, 2]), "bore"), { name: "bore", kind: "circle", center: [1, 2], radius: 6 });
  assert.deepEqual(need(placeHandle(all, "axis", 1, [3, 24]), "axis"), { name: "axis", kind: "line", through: [0, 20], direction: [3, 4] });
  assert.equal(placeHandle(all, "bore", 1, [30, 20]), all, "a circle without a radius is none");
  assert.equal(placeHandle(all, "axis", 1, [0, 20]), all, "a line without a direction is none");
  assert.equal(placeHandle(all, "dot", 1, [0, 20]), all);
  assert.deepEqual(need(placeHandle(all, "edge", 1, [0, 50]), "edge"), { name: "edge", kind: "segment", from: [0, 0], to: [0, 50] });
  assert.deepEqual(pointsOf(need(setCoordinate(all, "arc", 2, 1, 31.5), "arc"))[2], [25, 31.5]);
  assert.equal(setCoordinate(all, "arc", 2, 1, 30), all);
  assert.equal(setRadius(all, "bore", -1), all);
  assert.equal(setRadius(all, "plate", 4), all);
  const turned = need(setAngle(all, "axis", 120), "axis");
  assert.ok(turned.kind === "line");
  assert.deepEqual(turned.direction, [-0.5, 0.866025404]);
  assert.equal(angleOf(turned), 120);
  assert.deepEqual(need(setAngle(all, "axis", 90), "axis"), { name: "axis", kind: "line", through: [0, 20], direction: [0, 1] });
  assert.equal(setDirection(all, "axis", [2, 0]), all);
});

test("coordinates end where the format does, and the kernel reads them", () => {
  const far = moveShape(moveShape(all, "dot", [9e8, -9e8]), "dot", [9e8, -9e8]);
  assert.deepEqual(need(far, "dot"), { name: "dot", kind: "point", at: [1e9, -1e9] });
  const wide = setRadius(far, "bore", 1e12);
  assert.equal(/** @type {any} */ (need(wide, "bore")).radius, 1e9);
  assert.doesNotThrow(() => dx.part(wide));
});

test("points come and go, down to what each kind needs", () => {
  const plate = need(all, "plate");
  const more = insertPoint(all, "plate", 4, placeAfter(pointsOf(plate), true, 3));
  assert.deepEqual(pointsOf(need(more, "plate")), [[0, 0], [60, 0], [60, 40], [0, 40], [0, 20]]);
  assert.deepEqual(placeAfter(pointsOf(need(all, "path")), false, 2), [40, 0]);
  assert.deepEqual(removePoints(more, "plate", [4]), all);
  for (const [name, fewest] of [["plate", 3], ["path", 2], ["blob", 4], ["arc", 4], ["loop", 3]]) {
    let now = all;
    assert.equal(fewestOf(need(all, String(name))), fewest);
    while (canRemove(now, String(name))) now = removePoints(now, String(name), [1]);
    assert.equal(handleCount(need(now, String(name))), fewest, `${name} keeps what it needs`);
    assert.equal(removePoints(now, String(name), [0]), now);
    assert.deepEqual(dx.part(now).diagnostics.filter(({ code }) => code === "shape"), [], `${name} is still one`);
  }
  const clamped = need(removePoints(all, "loop", [0]), "loop");
  assert.ok(clamped.kind === "curve");
  assert.deepEqual(clamped.points, [[90, 50], [90, 70], [70, 70], [90, 50]], "it still closes");
  assert.equal(removePoints(all, "plate", [0, 1]), all, "all or none");
  for (const name of ["dot", "axis", "edge", "bore"]) assert.equal(whyNotInsert(all, name), "kind");
  assert.equal(insertPoint(all, "blob", 1, [0, 0]), all, "a point of a curve is for the kernel");
});

test("a shape is renamed wherever it is named, and nowhere else", () => {
  const after = renameShape(all, "edge", "left");
  assert.deepEqual(codes(after), []);
  assert.equal(JSON.stringify(after).replaceAll('"left"', '"edge"'), JSON.stringify(all));
  // The feature of the same name keeps it, and the body of the same name that of its own.
  assert.equal(after.bodies[0].features?.[0].name, "edge");
  const body = renameShape(all, "plate", "sheet");
  assert.deepEqual([body.bodies[0].name, body.bodies[0].outline], ["plate", "sheet"]);
  assert.deepEqual(body.bodies[0].features?.[1].reference, { boundary: "plate", except: ["edge", "bore"] });
  assert.equal(body.bodies[0].features, all.bodies[0].features);
  assert.equal(body.bodies[1], all.bodies[1]);
  assert.deepEqual(codes(renameShape(all, "bore", "b")), []);
  assert.deepEqual(renameShape(renameShape(all, "dot", "x"), "x", "dot"), all);
  for (const [to, why] of [["bore", "taken"], [" ", "empty"], ["n".repeat(101), "long"]]) {
    assert.equal(whyNotName(all, "edge", String(to)), why);
    assert.equal(renameShape(all, "edge", String(to)), all);
  }
  assert.equal(renameShape(all, "edge", "edge"), all);
});

test("where a shape is used is known, and deleting it leaves or takes what uses it", () => {
  assert.deepEqual(usesOf(all, "edge"), [
    { as: "reference", body: 0, feature: 0 },
    { as: "except", body: 0, feature: 1 },
    { as: "reference", body: 0, feature: 2 },
    { as: "reference", body: 1, feature: 0 },
  ]);
  assert.deepEqual(usesOf(all, "bore"), [{ as: "hole", body: 0, feature: null }, { as: "except", body: 0, feature: 1 }, { as: "except", body: 0, feature: 2 }]);
  assert.deepEqual([...usedNames(all)].sort(), ["blob", "bore", "dot", "edge", "plate"]);

  const left = deleteShape(all, "edge");
  assert.deepEqual(codes(left), [
    "unknown-name bodies[0].features[0].reference",
    "unknown-name bodies[0].features[2].references.a",
    "unknown-name bodies[1].features[0].reference",
  ]);
  assert.deepEqual(left.bodies[0].features?.[1].reference, { boundary: "plate", except: ["bore"] });
  // Another shape of that name takes its place.
  assert.deepEqual(codes(addShape(left, { name: "edge", kind: "point", at: [0, 0] })), []);

  const gone = deleteShape(all, "edge", { withUses: true });
  assert.deepEqual(codes(gone), []);
  assert.deepEqual(gone.bodies.map(({ features }) => features?.map(({ name }) => name)), [["walls"], []]);

  const filled = deleteShape(all, "bore");
  assert.deepEqual([filled.bodies[0].holes, codes(filled)], [[], []]);
  const bodiless = deleteShape(all, "blob", { withUses: true });
  assert.deepEqual([bodiless.bodies.map(({ name }) => name), codes(bodiless)], [["plate"], []]);
  assert.deepEqual(codes(deleteShape(all, "blob")), ["unknown-name bodies[1].outline"]);
  assert.equal(deleteShape(all, "nothing"), all);
});

test("shapes, bodies and holes are added under names of their own, up to the limits", () => {
  assert.equal(freshName(["a", "a 2"], "a"), "a 3");
  assert.equal(freshName(["circle 1"], "circle", 1), "circle 2");
  assert.equal(freshName([], "circle", 1), "circle 1");
  assert.ok(freshName(["n".repeat(100)], "n".repeat(100)).length <= 100);
  assert.deepEqual([copyName(["pore 1", "pore 2"], "pore 1"), copyName(["rim"], "rim"), copyName(["a 9"], "a 9")], ["pore 3", "rim 2", "a 10"]);
  const cut = duplicateShape(all, "bore", "bore 2", [20, 0]);
  assert.deepEqual(need(cut, "bore 2"), { name: "bore 2", kind: "circle", center: [50, 20], radius: 6 });
  assert.equal(duplicateShape(all, "bore", "dot", [1, 1]), all);
  assert.deepEqual([cut.bodies[0].holes, codes(cut)], [["bore", "bore 2"], []], "the copy of a hole is one");
  const copy = fillHole(cut, 0, "bore 2");
  assert.deepEqual(makeHole(copy, 0, "bore 2"), cut);
  assert.equal(makeBody(copy, "edge", "no ring"), copy);
  assert.deepEqual(codes(makeBody(copy, "loop", "loop")), []);
  for (const same of [makeHole(cut, 0, "bore 2"), makeHole(cut, 0, "plate"), makeHole(cut, 9, "bore"), makeHole(cut, 0, "none"), fillHole(cut, 1, "bore")]) assert.equal(same, cut);

  const disc = addBody(all, { name: "disc", kind: "circle", center: [30, 60], radius: 5 }, "disc");
  assert.deepEqual(codes(disc), []);
  assert.equal(dx.part(disc).probe([30, 60])?.body, 2);
  assert.deepEqual(dx.part(disc).probe([30, 60])?.fractions, [1, 0]);
  assert.deepEqual(dx.part(disc).defaults(), disc, "every default is written out");
  assert.equal(addBody(all, { name: "disc", kind: "circle", center: [0, 0], radius: 1 }, "plate"), all);
  assert.equal(addShape(all, { name: "bore", kind: "point", at: [0, 0] }), all);

  const many = { ...all, shapes: Array.from({ length: 500 }, (_, i) => /** @type {NamedShape} */ ({ name: `p ${i}`, kind: "point", at: [i, 0] })) };
  assert.equal(whyNotAdd(many, [{ kind: "point", at: [0, 0] }]), "shapes");
  assert.equal(addShape(many, { name: "one more", kind: "point", at: [0, 0] }), many);
  const long = Array.from({ length: 9_990 }, (_, i) => /** @type {[number, number]} */ ([i, i % 2]));
  assert.equal(whyNotAdd(all, [{ kind: "polyline", points: long }]), "points");
  const full = { ...all, shapes: [...(all.shapes ?? []).slice(0, 4), /** @type {NamedShape} */ ({ name: "long", kind: "polyline", points: [...long, [0, 0], [1, 1]] })] };
  assert.doesNotThrow(() => dx.part(full));
  assert.equal(whyNotInsert(full, "long"), "points");
});

test("a polygon and a curve become each other, and the kernel makes what comes of it", () => {
  const area = (/** @type {WholePart} */ document) => dx.part(document).amounts({ size: [500, 500] }).bodies[1].area;
  for (const name of shapeNames(all)) {
    for (const target of targetsOf(need(all, name))) {
      const geometry = converted(need(all, name), target);
      assert.ok(geometry, `${name} as ${target}`);
      assert.deepEqual(dx.part(setGeometry(all, name, geometry)).diagnostics.filter(({ code }) => code === "shape" || code === "self-intersection"), [], `${name} as ${target}`);
    }
  }
  const outlined = converted(need(all, "blob"), "outline");
  assert.ok(outlined?.kind === "polygon" && outlined.points.length < 120);
  // Chords lie inside, by a thousandth of half the diagonal at most.
  const [was, is] = [area(all), area(setGeometry(all, "blob", outlined))];
  assert.ok(Math.abs(was - is) / was < 4e-3, `${was}, ${is}`);
  const chain = chainOf(need(all, "blob"));
  for (const at of outlined.points) assert.ok(nearestPiece(chain, true, at).distance < 1e-9);
  for (const at of chain) assert.ok(nearestPiece(outlined.points, true, at).distance < 1.05e-3 * Math.hypot(25, 40) * 0.5);

  const control = converted(need(all, "blob"), "control");
  assert.deepEqual(control, { kind: "polygon", points: pointsOf(need(all, "blob")) });
  assert.deepEqual(converted(/** @type {any} */ (control), "control"), { kind: "curve", degree: 3, form: "periodic", points: pointsOf(need(all, "blob")) });

  // A curve through the points of a polygon passes them, and one through 16 points of a circle is round.
  const fitted = converted(need(all, "plate"), "curve");
  assert.ok(fitted);
  for (const at of pointsOf(need(all, "plate"))) assert.ok(nearestPiece(chainOf(fitted), true, at).distance < 1e-3);
  const round = converted(need(all, "bore"), "curve");
  assert.ok(round);
  for (const [x, y] of chainOf(round)) assert.ok(Math.abs(Math.hypot(x - 30, y - 20) - 6) < 6 * 1e-4);
  assert.ok(Math.abs(areaOf(round) - Math.PI * 36) < 0.2);
  assert.deepEqual(converted(need(all, "edge"), "polyline"), { kind: "polyline", points: [[0, 0], [0, 40]] });
  assert.equal(converted(need(all, "dot"), "curve"), null);
  assert.equal(converted({ kind: "polygon", points: [[0, 0], [1, 1], [2, 2]] }, "curve"), null, "points on one line have no closed curve");
  assert.deepEqual(thinned([[0, 0], [1, 0.001], [2, 0], [2, 1]], 0.01), [[0, 0], [2, 0], [2, 1]]);
});

test("what is drawn is the shape of its points, as a reference, a body or a hole", () => {
  /** @type {[number, number][]} */
  const places = [[0, 0], [30, 0], [30, 40]];
  assert.deepEqual(shapeFrom("circle", [[0, 0], [3, 4]]), { kind: "circle", center: [0, 0], radius: 5 });
  assert.deepEqual(shapeFrom("line", [[1, 1], [1, 5]]), { kind: "line", through: [1, 1], direction: [0, 1] });
  assert.deepEqual(shapeFrom("segment", places.slice(0, 2)), { kind: "segment", from: [0, 0], to: [30, 0] });
  assert.deepEqual(shapeFrom("polyline", places), { kind: "polyline", points: places });
  for (const kind of /** @type {const} */ (["closed", "open"])) {
    const curve = shapeFrom(kind, places);
    assert.ok(curve?.kind === "curve" && (curve.form === "open") === (kind === "open"));
    for (const at of places) assert.ok(nearestPiece(chainOf(curve), kind === "closed", at).distance < 1e-3, kind);
  }
  for (const same of /** @type {const} */ (["circle", "line", "segment"])) assert.equal(shapeFrom(same, [[1, 1], [1, 1]]), null);
  assert.equal(shapeFrom("polygon", places.slice(0, 2)), null);
  assert.equal(shapeFrom("closed", [[0, 0], [1, 1], [2, 2]]), null);

  const disc = /** @type {Extract<import("directrix").PartShape, {kind: "circle"}>} */ ({ kind: "circle", center: [45, 30], radius: 2 });
  assert.equal(bodyFor(all, null, disc), 0, "the body that it lies in");
  assert.equal(bodyFor(all, 1, disc), 1, "the chosen one");
  assert.equal(bodyFor(all, null, { ...disc, center: [500, 0] }), 1, "the uppermost");
  assert.equal(bodyFor({ ...all, bodies: [] }, null, disc), null);
  assert.equal(nameFor(all, "circle", "reference"), "circle 1");
  assert.equal(nameFor(put(all, "hole 1", disc, "hole", 0), "circle", "hole"), "hole 2");
  const cut = put(all, "hole 1", disc, "hole", 0);
  assert.deepEqual([cut.bodies[0].holes, codes(cut), dx.part(cut).probe([45, 30])], [["bore", "hole 1"], [], null]);
  assert.deepEqual(put(all, "circle 1", disc, "body", null).bodies.at(-1)?.name, "body 1");
  assert.equal(put(all, "circle 1", disc, "reference", null).bodies, all.bodies);
  assert.equal(whyNotPut({ ...all, bodies: [] }, disc, "hole", null), "noBody");
  assert.equal(whyNotPut({ ...all, bodies: Array(64).fill(all.bodies[0]) }, disc, "body", null), "mostBodies");
  assert.equal(whyNotPut(all, disc, "body", null), null);
});

test("what is held rests on the grid, on points of other shapes, or on what can be aimed at", () => {
  const view = { center: /** @type {[number, number]} */ ([50, 30]), scale: 10 };
  const size = { width: 1000, height: 600 };
  /** @param {number | null} step @returns {any} */
  const bench = (step) => ({ now: () => ({ document: all, view, size }), step: () => step });
  assert.deepEqual(rested(bench(null), [12.3456, 7.8912], false), [12.35, 7.89]);
  assert.deepEqual(rested(bench(5), [12.3, 22.8], false), [10, 25]);
  assert.deepEqual(rested(bench(5), [12.3, 22.8], true), [12.3, 22.8], "Control turns it round");
  assert.deepEqual(rested(bench(null), [12.3, 22.8], true), [10, 25]);
  assert.deepEqual(rested(bench(5), [15.4, 37.7], false), [15, 38], "a point of the arc is nearer than the grid");
  assert.deepEqual(rested(bench(5), [15.4, 37.7], false, "arc"), [15, 40]);
  assert.deepEqual([restedRadius(bench(5), 1, false), restedRadius(bench(null), 0.001, false)], [5, 0.1], "a radius stays above 0");
  assert.deepEqual([restedAngle(bench(5), 37, false), restedAngle(bench(null), 37.04, false)], [30, 37]);

  const bore = need(all, "bore");
  const at = (/** @type {WholePart} */ document) => need(document, "bore");
  assert.deepEqual(at(dragged(bench(5), all, { shape: "bore", point: null }, [7, -4], false)(all)), { ...bore, center: [35, 15] });
  assert.deepEqual(at(dragged(bench(null), all, { shape: "bore", point: 1 }, [30, 23], false)(all)), { ...bore, radius: 3 });
  assert.equal(dragged(bench(5), all, { shape: "bore", point: null }, [2, -2], false)(all), all, "less than a step is no edit");
  // Every step of a drag starts from the shape as it was.
  const twice = dragged(bench(5), all, { shape: "bore", point: null }, [5, 0], false)(dragged(bench(5), all, { shape: "bore", point: null }, [50, 0], false)(all));
  assert.deepEqual(at(twice), { ...bore, center: [35, 20] });

  assert.deepEqual(bodyShapes(all, "plate"), ["plate", "bore", "edge", "dot"]);
  assert.deepEqual(bodyShapes(all, "path"), ["path"]);
  along.isOn = true;
  const whole = dragged(bench(5), all, { shape: "plate", point: null }, [6, 4], false)(all);
  assert.deepEqual(whole, moveShapes(all, ["plate", "bore", "edge", "dot"], [5, 5]));
  assert.deepEqual(nudged(whole, { shape: "plate", point: null }, [-1, 0], 5), moveShapes(all, ["plate", "bore", "edge", "dot"], [0, 5]));
  along.isOn = false;

  assert.equal(arrowStep(all), 1);
  assert.deepEqual(at(nudged(all, { shape: "bore", point: 0 }, [1, 0], 10)), { ...bore, center: [40, 20] });
  assert.deepEqual(at(nudged(all, { shape: "bore", point: 1 }, [0, 1], 0.1)), { ...bore, radius: 6.1 });
  assert.equal(at(nudged(all, { shape: "bore", point: 1 }, [-1, 0], 10)), bore, "no circle without a radius");
  const axis = need(nudged(all, { shape: "axis", point: 1 }, [0, 1], 1), "axis");
  assert.ok(axis.kind === "line" && angleOf(axis) === 1);
  const full = [...Array(360)].reduce((document) => nudged(document, { shape: "axis", point: 1 }, [0, 1], 1), all);
  assert.deepEqual(/** @type {any} */ (need(full, "axis")).direction, [1, 0], "all the way round");
});

test("the pointer finds handles before outlines, and of outlines in one place points before pieces before rings", () => {
  const view = { center: /** @type {[number, number]} */ ([50, 30]), scale: 10 };
  const size = { width: 1000, height: 600 };
  const screen = (/** @type {number} */ x, /** @type {number} */ y) => /** @type {[number, number]} */ ([500 + (x - 50) * 10, 300 - (y - 30) * 10]);
  assert.deepEqual(under(all, view, size, screen(0, 30), 7), ["edge", "plate"]);
  assert.deepEqual(under(all, view, size, screen(5, 5), 7).slice(0, 2), ["dot", "path"]);
  assert.deepEqual(under(all, view, size, screen(300, 20.3), 7), ["axis"], "a line has no ends");
  assert.deepEqual(under(all, view, size, screen(30, 26.5), 7), ["bore"]);
  assert.deepEqual(under(all, view, size, screen(10, 28), 7), []);
  assert.equal(nearestHandle(view, size, need(all, "plate"), screen(59, 40.5), 12), 2);
  assert.equal(nearestHandle(view, size, need(all, "bore"), screen(36, 20), 12), 1);
  assert.equal(nearestHandle(view, size, need(all, "bore"), screen(30, 26), 12, Math.PI / 2), 1, "where it was dragged to");
  assert.equal(nearestHandle(view, size, need(all, "plate"), screen(30, 20), 12), null);
  // The path of a line leaves the window on both sides.
  const [[ax], [bx]] = [...outlinePath(view, size, need(all, "axis")).matchAll(/(-?[\d.]+) (-?[\d.]+)/g)].map((pair) => [Number(pair[1]), Number(pair[2])]);
  assert.ok(ax < 0 && bx > size.width, `${ax}, ${bx}`);
  const role = rolesOf(all);
  assert.deepEqual(["plate", "bore", "edge", "path"].map(role), ["boundary", "boundary", "reference", "unused"]);
  assert.deepEqual([...litBy(all, 0, 1)], ["plate"], "a boundary lights what is left of it");
  assert.deepEqual([...litBy(all, 0, 2)].sort(), ["dot", "edge", "plate"]);
  assert.equal(litBy(all, 0, null).size, 0);
});

test("imported shapes get names of their own; those that lie in others become their holes, and those in holes bodies again", () => {
  const square = (/** @type {number} */ low, /** @type {number} */ high) => ({
    kind: /** @type {const} */ ("polygon"),
    points: /** @type {[number, number][]} */ ([[low, low], [high, low], [high, high], [low, high]]),
  });
  const read = [{ name: "plate", shape: square(-50, -10) }, { name: "", shape: square(-40, -20) }, { name: "bore", shape: square(-35, -25) }, { name: "plate", shape: square(-33, -30) }];
  const named = namedFor(all, read);
  assert.deepEqual(named.map(({ name }) => name), ["plate 2", "shape", "bore 2", "plate 3"]);
  assert.deepEqual(nestingOf(named), [{ depth: 0, within: null }, { depth: 1, within: 0 }, { depth: 2, within: 1 }, { depth: 3, within: 2 }]);
  const bodies = withImported(all, named, "body", null);
  assert.deepEqual(bodies.bodies.slice(2).map(({ name, outline, holes }) => [name, outline, holes]), [["plate 2", "plate 2", ["shape"]], ["bore 2", "bore 2", ["plate 3"]]]);
  assert.deepEqual(codes(bodies), []);
  const areas = dx.part(bodies).amounts({ box: [[-51, -51], [-9, -9]], size: [420, 420] }).bodies.map(({ area }) => area);
  near(areas[2], 1600 - 400, 12);
  near(areas[3], 100 - 9, 12);
  assert.deepEqual(withImported(all, named, "reference", null).bodies, all.bodies);
  assert.deepEqual(withImported(all, named.slice(2, 3), "hole", 0).bodies[0].holes, ["bore", "bore 2"]);
});

test("shapes of the presets have boxes, chains and handles, and every one moves and comes back", () => {
  for (const document of presets) {
    for (const name of shapeNames(document)) {
      const shape = need(document, name);
      assert.ok(boxOf(shape).flat().every(Number.isFinite) && chainOf(shape).flat().every(Number.isFinite), name);
      assert.ok(handleCount(shape) >= pointsOf(shape).length);
      assert.deepEqual(moveShape(moveShape(document, name, [0.5, -0.25]), name, [-0.5, 0.25]), document, name);
    }
  }
});

test("edits in any order equal building afresh", () => {
  const seed = Number(process.env.SEED ?? Math.floor(Math.random() * 2 ** 31));
  let state = seed;
  const random = () => {
    // Mulberry32 (T. Ettinger).
    state = (state + 0x6d2b79f5) | 0;
    let t = Math.imul(state ^ (state >>> 15), 1 | state);
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
    return ((t ^ (t >>> 14)) >>> 0) / 2 ** 32;
  };
  const value = () => Number((random() * 8 - 4).toFixed(2));
  const [ax, ay, bx, by, cx, dy] = Array.from({ length: 6 }, value);
  const radius = 3 + Number(random().toFixed(2));
  const angle = Math.round(random() * 180);
  /** Edits of different things, none of which names what another one renames. @type {((document: WholePart) => WholePart)[]} */
  const edits = [
    (document) => setCoordinate(document, "plate", 1, 0, 60 + ax),
    (document) => setCoordinate(document, "plate", 1, 1, ay),
    (document) => placeHandle(document, "plate", 2, [60 + bx, 40 + by]),
    (document) => moveShape(document, "blob", [cx, 0]),
    (document) => moveShape(document, "blob", [0, dy]),
    (document) => setRadius(document, "bore", radius),
    (document) => placeHandle(document, "bore", 0, [28, 18]),
    (document) => setAngle(document, "axis", angle),
    (document) => setCoordinate(document, "edge", 0, 0, 1),
    (document) => renameShape(document, "dot", "spot"),
    (document) => removePoints(document, "path", [1]),
    (document) => addShape(document, { name: "slot", kind: "circle", center: [12, 12], radius: 2 }),
    (document) => deleteShape(document, "loop", { withUses: true }),
  ];
  const direction = /** @type {any} */ (need(setAngle(all, "axis", angle), "axis")).direction;
  const tidy = (/** @type {number} */ x) => Number(x.toPrecision(12));
  const fresh = dx.part({
    ...all,
    shapes: [
      { name: "spot", kind: "point", at: [5, 5] },
      { name: "axis", kind: "line", through: [0, 20], direction },
      { name: "edge", kind: "segment", from: [1, 0], to: [0, 40] },
      { name: "bore", kind: "circle", center: [28, 18], radius },
      { name: "plate", kind: "polygon", points: [[0, 0], [tidy(60 + ax), tidy(ay)], [tidy(60 + bx), tidy(40 + by)], [0, 40]] },
      { name: "path", kind: "polyline", points: [[5, 5], [30, 5]] },
      { .../** @type {any} */ (need(all, "blob")), points: pointsOf(need(all, "blob")).map(([x, y]) => [tidy(x + cx), tidy(y + dy)]) },
      { .../** @type {any} */ (need(all, "arc")) },
      { name: "slot", kind: "circle", center: [12, 12], radius: 2 },
    ],
    bodies: JSON.parse(JSON.stringify(all.bodies).replaceAll('"dot"', '"spot"')),
  });
  const box = /** @type {import("directrix").Box} */ ([[-5, -5], [105, 75]]);
  const picture = (/** @type {import("directrix").Part} */ part) => part.evaluate({ box, size: [110, 80], colors: true });
  const expected = picture(fresh);
  for (let round = 0; round < 12; round += 1) {
    const order = edits.map((edit) => ({ edit, key: random() })).sort((a, b) => a.key - b.key);
    const edited = order.reduce((document, { edit }) => edit(document), all);
    assert.deepEqual(edited, fresh.defaults(), `seed ${seed}, round ${round}`);
    const found = picture(dx.part(edited));
    assert.ok(Buffer.from(found.colors ?? []).equals(Buffer.from(expected.colors ?? [])), `seed ${seed}, round ${round}: the picture`);
    assert.deepEqual(found.leaves, expected.leaves);
  }
});
