/** Edits of parts in the page as pure functions, and the plot of a profile beside the kernel's values. */
import assert from "node:assert/strict";
import { readFile, readdir } from "node:fs/promises";
import { join } from "node:path";
import { test } from "node:test";
import { load } from "directrix";
import { root } from "../../scripts/lib/paths.mjs";
import * as blend from "../../www/src/part/edits/blend.js";
import * as bodies from "../../www/src/part/edits/bodies.js";
import * as features from "../../www/src/part/edits/features.js";
import * as materials from "../../www/src/part/edits/materials.js";
import * as rules from "../../www/src/part/edits/rules.js";
import { deleteShape, renameShape, usedNames } from "../../www/src/part/edits/shapes.js";
import { profileOf, throughMiddle } from "../../www/src/part/profile/course.js";
import { expression } from "../../www/src/part/profile/expression.js";

/** @typedef {import("../../js/directrix.js").PartDocument} PartDocument */
/** @typedef {import("../../js/directrix.js").PartFeature} PartFeature */

const dx = await load();
const folder = join(root, "www/presets/part");

/** A preset with every default. @param {string} name @returns {Promise<PartDocument>} */
const preset = async (name) => dx.part(await readFile(join(folder, `${name}.json`), "utf8")).defaults();

const rectangle = await preset("rectangle");
const plate = await preset("heat-plate");
const fillet = await preset("fillet");
const scaffold = await preset("scaffold");
const references = await preset("references");

/** @param {PartDocument} document @param {number} [body] */
const names = ({ bodies: all }, body = 0) => (all[body].features ?? []).map(({ name }) => name);
/** @param {PartDocument} document */
const accepted = (document) => dx.part(document).defaults();
/** @param {PartDocument} document @param {number} feature */
const featureOf = (document, feature) => /** @type {PartFeature} */ (features.featureAt(document, { body: 0, feature }));

test("features come, go, are copied, named, hidden and put elsewhere, and what an edit leaves alone stays the same object", () => {
  const at = { body: 0, feature: 0 };
  const doubled = features.duplicateFeature(rectangle, at);
  assert.deepEqual(names(doubled), ["A", "A 2", "B"]);
  assert.equal(doubled.shapes, rectangle.shapes);
  assert.equal(featureOf(doubled, 2), featureOf(rectangle, 1));
  assert.deepEqual(names(features.duplicateFeature(doubled, at)), ["A", "A 3", "A 2", "B"]);
  assert.deepEqual(names(features.removeFeature(doubled, at)), ["A 2", "B"]);
  assert.equal(features.removeFeature(rectangle, { body: 0, feature: 5 }), rectangle);
  assert.deepEqual(names(features.renameFeature(rectangle, at, "left")), ["left", "B"]);
  assert.equal(features.renameFeature(rectangle, at, "A"), rectangle);
  const hidden = features.hideFeature(rectangle, at, true);
  assert.deepEqual(dx.part(hidden).bodies[0].features.map(({ active }) => active), [false, true]);
  assert.equal(features.hideFeature(hidden, at, true), hidden);
  assert.deepEqual(names(features.moveFeature(rectangle, at, { body: 0, feature: 1 })), ["B", "A"]);
  assert.equal(features.moveFeature(rectangle, at, at), rectangle);
  for (const document of [doubled, hidden]) assert.deepEqual(accepted(document), document);
});

test("a body gets a blend from its outline and its holes, piece by piece, and loses it again", () => {
  const plain = blend.setBlend(plate, 0, false);
  assert.equal(plain.bodies[0].blend, undefined);
  assert.equal(blend.setBlend(plain, 0, false), plain);
  const blended = blend.setBlend(plain, 0, true);
  assert.deepEqual(blend.boundariesOf(blended.bodies[0]).map(({ on, value }) => [on, value]), [["plate", [1, 0, 0]], ["copper pipe", [0, 1, 0]], ["steel pipe", [0, 0, 1]]]);
  assert.deepEqual(accepted(blended), blended);
  // The foot is a piece of its own; the loops come first, with or without a condition.
  const pieces = blend.piecesOf(plate.bodies[0]).map(({ on, index, isLoop }) => [on, index, isLoop]);
  assert.deepEqual(pieces, [["plate", 0, true], ["copper pipe", 1, true], ["steel pipe", 2, true], ["foot", 3, false]]);
  const less = blend.removePiece(plate, 0, 0);
  assert.deepEqual(blend.piecesOf(less.bodies[0])[0], { on: "plate", index: null, isLoop: true });
  const again = blend.setBoundary(less, 0, "plate", null, { on: "plate", within: 0, flux: [0, 0, 0] });
  assert.equal(blend.boundariesOf(again.bodies[0]).length, 4);
  assert.equal(blend.conditionOf(blend.boundariesOf(again.bodies[0])[3]), "flux");
  assert.deepEqual(accepted(again), again);
  for (const kind of /** @type {const} */ (["insulated", "value", "flux", "body"])) {
    const next = blend.firstCondition(fillet, 1, blend.boundariesOf(fillet.bodies[1])[0], kind);
    assert.equal(blend.conditionOf(next ?? undefined), kind);
    accepted(blend.setBoundary(fillet, 1, "seam", 0, next ?? { on: "seam" }));
  }
  assert.equal(blend.firstCondition(plate, 0, { on: "plate" }, "body"), null);
  assert.equal(blend.firstCondition(plate, 0, { on: "plate" }, "feature"), null);
  assert.deepEqual(blend.withSlope([0, 0, 0], 0, 0.1), [0.1, 0, -0.1]);
});

test("blends follow what they name: shapes, bodies, features and materials", () => {
  const on = (/** @type {PartDocument} */ document, body = 0) => blend.boundariesOf(document.bodies[body]).map((each) => each.on);
  assert.deepEqual(on(renameShape(plate, "foot", "base")), ["plate", "copper pipe", "steel pipe", "base"]);
  assert.deepEqual(on(deleteShape(plate, "foot")), ["plate", "copper pipe", "steel pipe"]);
  assert.deepEqual(on(deleteShape(plate, "steel pipe")), ["plate", "copper pipe", "foot"]);
  assert.ok(usedNames(plate).has("foot"));
  const renamed = bodies.renameBody(fillet, 2, "axle");
  assert.deepEqual(blend.boundariesOf(renamed.bodies[1])[1].from, { body: "axle" });
  assert.deepEqual(bodies.boundaryUsers(fillet, 0), ["fillet"]);
  assert.equal(bodies.removeBody(fillet, 0), fillet);
  assert.deepEqual(accepted(renamed), renamed);
  const own = features.addFeature(fillet, 1, { name: "skin", hidden: true, reference: "shaft", from: 0, to: 5, start: [1, 0, 0], end: [0, 0, 1], course: { kind: "linear" } });
  const from = blend.setBoundary(own, 1, "shaft", 1, { on: "shaft", within: 0, from: { feature: "skin" } });
  const called = features.renameFeature(from, { body: 1, feature: 0 }, "rind");
  assert.deepEqual(blend.boundariesOf(called.bodies[1])[1].from, { feature: "rind" });
  assert.deepEqual(dx.part(called).diagnostics, []);
  const sloped = blend.setBoundary(plate, 0, "plate", 0, { on: "plate", within: 0, flux: [0.1, -0.3, 0.2] });
  const more = materials.addMaterial(sloped, { name: "void", color: "#ffffff", void: true });
  assert.deepEqual(blend.boundariesOf(more.bodies[0])[0].flux, [0.1, -0.3, 0.2, 0]);
  assert.ok(materials.isUsed(plate, 2) && !materials.isUsed(more, 3));
  const fewer = materials.removeMaterial(sloped, 2, 0);
  assert.deepEqual(blend.boundariesOf(fewer.bodies[0]).map(({ flux, value }) => flux ?? value), [[0.3, -0.3], [1, 0], [0, 1], [1, 0]]);
  for (const document of [more, fewer]) assert.deepEqual(accepted(document), document);
});

test("a feature goes to the queue of another body, and the list is gone through up and down", () => {
  const at = { body: 0, feature: 0 };
  assert.equal(features.placeBeside(references, at, -1), null);
  assert.deepEqual(features.placeBeside(references, at, 1), { body: 1, feature: 0 });
  assert.deepEqual(features.placeBeside(references, { body: 1, feature: 0 }, -1), { body: 0, feature: 1 });
  const moved = features.moveFeature(references, at, { body: 1, feature: 0 });
  assert.deepEqual([names(moved, 0), names(moved, 1)], [[], ["axis", "surface"]]);
  assert.deepEqual(accepted(moved), moved);
  const full = { ...references, bodies: references.bodies.map((body, k) => (k === 1 ? { ...body, features: Array.from({ length: 32 }, () => ({ ...featureOf(references, 0) })) } : body)) };
  assert.equal(features.moveFeature(full, at, { body: 1, feature: 0 }), full);
  assert.equal(features.addFeature(full, 1, featureOf(references, 0)), full);
  assert.equal(features.placeBeside(full, at, 1), null);
});

test("references go from shapes to boundaries to several and back", () => {
  const at = { body: 0, feature: 0 };
  const boundary = { boundary: "rectangle", except: ["edge B"] };
  const around = features.setReference(rectangle, at, boundary);
  assert.deepEqual(featureOf(around, 0).reference, boundary);
  assert.equal(features.setReference(around, at, { ...boundary }), around);
  const several = features.setReferences(around, at, { a: "edge A", b: "edge B" }, "min(a, b)");
  assert.equal(featureOf(several, 0).reference, undefined);
  assert.deepEqual(accepted(several), several);
  assert.deepEqual(dx.part(several).diagnostics, []);
  const back = features.setReference(several, at, "edge A");
  assert.deepEqual([featureOf(back, 0).references, featureOf(back, 0).distance], [undefined, undefined]);
  assert.deepEqual(featureOf(back, 0), featureOf(rectangle, 0));
});

test("limits keep their order whatever is asked for", () => {
  const at = { body: 0, feature: 0 };
  const limits = (/** @type {PartDocument} */ document) => [featureOf(document, 0).from, featureOf(document, 0).to];
  assert.deepEqual(limits(features.setLimit(rectangle, at, "to", 12.5)), [0, 12.5]);
  assert.deepEqual(limits(features.setLimit(rectangle, at, "from", 10)), [10, 30]);
  assert.equal(features.setLimit(rectangle, at, "from", -5), rectangle);
  assert.equal(features.setLimit(rectangle, at, "to", Number.NaN), rectangle);
  for (const [limit, value] of /** @type {const} */ ([["from", 1e9], ["to", -3], ["to", 0]])) {
    const next = features.setLimit(rectangle, at, limit, value);
    const [from = 0, to = 0] = limits(next);
    assert.ok(from >= 0 && to > from, `${from} to ${to}`);
    assert.deepEqual(dx.part(next).diagnostics.filter(({ skipped }) => skipped), []);
  }
  assert.deepEqual(limits(features.setLimit(rectangle, at, "to", 1e12)), [0, 1e9]);
});

test("keys of a piecewise course stay in order; the last one stays", () => {
  const at = { body: 0, feature: 0 };
  const { plain } = profileOf(featureOf(rectangle, 0), [0, 0, 1]);
  const keyed = features.setCourse(rectangle, at, features.firstCourse("piecewise", featureOf(rectangle, 0), plain));
  const places = (/** @type {PartDocument} */ document) => features.keysOf(features.featureAt(document, at)).map((key) => key.at);
  assert.deepEqual(places(keyed), [0, 0.5, 1]);
  assert.deepEqual(features.keysOf(features.featureAt(keyed, at))[1].mix, [0.5, 0, 0.5]);
  assert.deepEqual(places(features.setKey(keyed, at, 1, { at: 2 })), [0, 0.999, 1]);
  assert.deepEqual(places(features.setKey(keyed, at, 0, { at: 0.9 })), [0.499, 0.5, 1]);
  const { document: more, index } = features.addKey(keyed, at, 0.25, plain(0.25));
  assert.deepEqual([places(more), index], [[0, 0.25, 0.5, 1], 1]);
  assert.equal(features.addKey(more, at, 0.25, plain(0.25)).index, null);
  assert.deepEqual(places(features.removeKey(more, at, 0)), [0.25, 0.5, 1]);
  const one = features.removeKey(features.removeKey(keyed, at, 0), at, 0);
  assert.equal(features.removeKey(one, at, 0), one);
  assert.deepEqual(accepted(one), one);
  const mixed = features.setKey(keyed, at, 1, { mix: [0.2, 0.3, 0.5] });
  assert.deepEqual(accepted(mixed), mixed);
});

test("a body is renamed wherever it is named, and goes only when nothing is measured to it", () => {
  const renamed = bodies.renameBody(scaffold, 0, "sponge");
  assert.deepEqual(featureOf(renamed, 0).reference, { boundary: "sponge", except: ["block"] });
  assert.equal(featureOf(renamed, 1), featureOf(scaffold, 1));
  assert.deepEqual(dx.part(renamed).diagnostics, []);
  assert.equal(bodies.renameBody(references, 0, "by its surface"), references);
  const several = features.setReferences(scaffold, { body: 0, feature: 1 }, { a: { boundary: "scaffold", except: [] } }, "a");
  assert.deepEqual(featureOf(bodies.renameBody(several, 0, "sponge"), 1).references, { a: { boundary: "sponge", except: [] } });
  const two = bodies.addBody(rectangle, "rectangle");
  assert.deepEqual(two.bodies.map(({ name }) => name), ["rectangle", "rectangle 2"]);
  assert.deepEqual(accepted(two), two);
  const leaning = features.addFeature(two, 1, { reference: { boundary: "rectangle", except: [] }, to: 5, start: [1, 0, 0], name: "skin" });
  assert.equal(bodies.removeBody(leaning, 0), leaning);
  assert.deepEqual(bodies.boundaryUsers(leaning, 0), ["skin"]);
  assert.deepEqual(bodies.removeBody(leaning, 1).bodies, rectangle.bodies);
  assert.equal(bodies.removeBody(rectangle, 0), rectangle);
  assert.deepEqual(bodies.moveBody(two, 0, 1).bodies.map(({ name }) => name), ["rectangle 2", "rectangle"]);
});

test("features that end at the default follow it", () => {
  const next = bodies.setDefault(rectangle, 0, [0, 0.5, 0.5]);
  assert.deepEqual([featureOf(next, 0).end, featureOf(next, 1).end], [[0, 0.5, 0.5], [0, 0.5, 0.5]]);
  const other = features.setEnd(rectangle, { body: 0, feature: 0 }, "end", [0, 1, 0]);
  assert.deepEqual(featureOf(bodies.setDefault(other, 0, [1, 0, 0]), 0).end, [0, 1, 0]);
  assert.equal(bodies.setDefault(rectangle, 0, [0, 0, 1]), rectangle);
});

test("materials come and go with every mix and every design rule", () => {
  const more = materials.addMaterial(rectangle, { name: "blue", color: "#0072b2" });
  assert.deepEqual(featureOf(more, 0).start, [1, 0, 0, 0]);
  assert.deepEqual(accepted(more).bodies, more.bodies);
  assert.deepEqual(materials.removeMaterial(more, 3).bodies, rectangle.bodies);
  assert.equal(materials.removeMaterial(rectangle, 0), rectangle);
  const merged = materials.removeMaterial(rectangle, 0, 2);
  assert.deepEqual([featureOf(merged, 0).start, featureOf(merged, 1).start, merged.bodies[0].default], [[0, 1], [1, 0], [0, 1]]);
  assert.equal(rules.rulesOf(merged)[0].material, 1);
  assert.deepEqual(accepted(merged), merged);
  assert.equal(materials.changeMaterial(rectangle, 0, { name: "red" }), rectangle);
  assert.equal(materials.materialsOf(materials.changeMaterial(rectangle, 0, { color: "#000000" }))[0].color, "#000000");
});

test("a material that only mixes without a say hold is no longer in use, and what is left sums to 1", () => {
  const keyed = features.setCourse(rectangle, { body: 0, feature: 1 }, { kind: "piecewise", keys: [{ at: 0, mix: [0, 0, 1] }] });
  assert.equal(materials.isUsed(keyed, 1), false);
  const without = materials.removeMaterial(keyed, 1);
  assert.deepEqual(accepted(without), without);
});

test("bounds of a design rule keep their order", () => {
  const more = rules.addRule(rectangle, "Rule");
  assert.deepEqual(accepted(more), more);
  const bounds = (/** @type {PartDocument} */ document) => [rules.rulesOf(document)[1].least, rules.rulesOf(document)[1].most];
  const least = rules.changeRule(more, 1, { least: 0.6 });
  assert.deepEqual(bounds(rules.changeRule(least, 1, { most: 0.4 })), [0.4, 0.4]);
  assert.deepEqual(bounds(rules.changeRule(least, 1, { least: 7 })), [1, 1]);
  assert.deepEqual(bounds(rules.changeRule(rules.changeRule(more, 1, { of: "gradient", most: 20 }), 1, { of: "fraction" })), [0, 1]);
  assert.deepEqual(rules.removeRule(more, 1), rectangle);
  assert.equal(rules.changeRule(rectangle, 0, { material: 0 }), rectangle);
});

/** @type {PartFeature[]} */
const PROFILES = [
  { to: 30, start: [1, 0, 0], end: [0, 0, 1] },
  { to: 20, from: 5, start: [0.2, 0.3, 0.5], end: [0, 1, 0], course: { kind: "power", power: 2.5 } },
  { to: 25, start: [1, 0, 0], end: [0, 0.5, 0.5], course: { kind: "exponential", rate: -4 } },
  { to: 25, from: 10, start: [0, 0, 1], end: [0, 1, 0], course: { kind: "smoothstep" } },
  { to: 30, start: [1, 0, 0], end: [0, 0, 1], course: { kind: "periodic", waves: 3 } },
  { to: 30, start: [1, 0, 0], end: [0, 0, 1], course: { kind: "piecewise", keys: [{ at: 0.25, mix: [1, 0, 0] }, { at: 0.5, mix: [0, 1, 0] }, { at: 0.9, mix: [0.1, 0.2, 0.7] }] } },
  ...["1 - exp(-d / 3)", "smoothstep(0.2, .8, t) ^ 2 ^ 0.5", "-t^2 + 1.5e0*t", "clamp(sin(pi * t) * 2, 0.1, max(0.9, t))", "min(1, abs(t - 0.5) * 2) / 1E0", "ln(1 + d) / e - sqrt(t)"].map(
    (text) => /** @type {PartFeature} */ ({ to: 30, start: [1, 0, 0], end: [0, 0, 1], course: { kind: "expression", text } }),
  ),
];

test("the plot of a profile has the kernel's values, led to the default where it does not meet it", () => {
  for (const profile of PROFILES) {
    const feature = { ...profile, name: "A", reference: "edge A" };
    const document = { ...rectangle, rules: [], bodies: [{ ...rectangle.bodies[0], features: [feature] }] };
    const part = dx.part(document);
    assert.deepEqual(part.diagnostics, [], JSON.stringify(profile));
    const count = 401;
    const { fractions } = part.along([[0, 30], [40, 30]], count);
    const { alone } = profileOf(feature, [0, 0, 1]);
    for (let n = 0; n < count; n += 1) {
      const distance = (40 * n) / (count - 1);
      alone(distance).forEach((fraction, k) => {
        assert.ok(Math.abs(fraction - fractions[k][n]) < 1e-9, `${JSON.stringify(profile.course)} at ${distance}: ${fraction}, and ${fractions[k][n]}`);
      });
    }
  }
});

test("the plots of all presets have the kernel's values where one feature acts", async () => {
  let compared = 0;
  for (const file of await readdir(folder)) {
    const document = dx.part(await readFile(join(folder, file), "utf8")).defaults();
    const part = dx.part(document);
    if (!part.box) continue;
    const [[left, low], [right, high]] = part.box;
    for (let n = 0; n < 400; n += 1) {
      const place = part.probe([left + (right - left) * ((n * 0.618) % 1), low + (high - low) * ((n + 0.5) / 400)]);
      const acting = place?.distances.filter(({ holds }) => holds) ?? [];
      if (!place?.fractions || acting.length !== 1) continue;
      const [{ feature, distance }] = acting;
      const profile = features.featureAt(document, { body: place.body, feature });
      assert.ok(profile);
      const { alone } = profileOf(profile, features.defaultOf(document, place.body));
      alone(distance).forEach((fraction, k) => assert.ok(Math.abs(fraction - /** @type {number[]} */ (place.fractions)[k]) < 1e-9, file));
      compared += 1;
    }
  }
  assert.ok(compared > 500, `${compared} places`);
});

test("texts are expressions here where they are for the kernel", () => {
  const texts = ["", "d", "2 +", "(d", "d)", "sin d", "sin(d)", "min(1)", "min(1,2)", "clamp(1,2)", "clamp(d,0,1)", "1e3", "1e", "1e+", "2e-1*t", "1.2.3", "x", "-", "--d", "2^-1", "2 2", "pi e", "π", "d % 2", "smoothstep(0, 1, t", "abs()", ".5", "."];
  for (const text of texts) {
    const feature = { name: "A", reference: "edge A", to: 30, start: [1, 0, 0], course: { kind: /** @type {const} */ ("expression"), text } };
    const { diagnostics } = dx.part({ ...rectangle, bodies: [{ ...rectangle.bodies[0], features: [feature] }] });
    const isKnown = !diagnostics.some(({ character }) => character !== undefined);
    assert.equal(expression(text, ["d", "t"]) !== null, isKnown, `"${text}"`);
  }
});

test("the middle of a profile sets its power or its rate", () => {
  for (const kind of /** @type {const} */ (["power", "exponential"])) {
    for (const share of [0.1, 0.25, 0.5, 0.8]) {
      const course = throughMiddle(kind === "power" ? { kind, power: 1 } : { kind, rate: 1 }, share);
      assert.ok(course);
      const [fraction] = profileOf({ to: 8, start: [0, 1], end: [1, 0], course }, [1, 0]).plain(0.5);
      assert.ok(Math.abs(fraction - share) < 0.01, `${JSON.stringify(course)} has ${fraction}`);
    }
    for (const share of [0, 1, -3, 9]) {
      const course = throughMiddle(kind === "power" ? { kind, power: 1 } : { kind, rate: 1 }, share);
      const document = features.setCourse(rectangle, { body: 0, feature: 0 }, /** @type {import("../../js/directrix.js").PartCourse} */ (course));
      assert.deepEqual(dx.part(document).diagnostics, [], JSON.stringify(course));
    }
  }
  assert.deepEqual(throughMiddle({ kind: "linear" }, 0.25), { kind: "power", power: 2 });
  assert.equal(throughMiddle({ kind: "smoothstep" }, 0.25), null);
});

test("a profile whose limits are in the wrong order has the default everywhere, and no place without a mix", () => {
  for (const to of [5, 10]) {
    const { alone } = profileOf({ from: 10, to, start: [0, 1], end: [1, 0] }, [1, 0]);
    for (const distance of [0, 5, 7, 10, 12]) assert.deepEqual(alone(distance), [1, 0], `${distance} within 10 to ${to}`);
  }
});
