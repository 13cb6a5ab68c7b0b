/** Compositions and materials of the page as pure functions: nothing leaves the simplex, and nothing that was undone leaves a trace. */
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { test } from "node:test";
import { load } from "directrix";
import {
  afterKey,
  followed,
  insertKey,
  mixAt,
  removeKey,
  setMix,
  shortWay,
  slideKey,
  wrapped,
} from "../../www/src/state/composition.js";
import {
  addMaterial,
  assignMaterial,
  changeMaterial,
  holds,
  moveMaterial,
  removeMaterial,
  threeMaterials,
} from "../../www/src/state/materials.js";
import { fromTriangle, inTriangle, withFraction, written } from "../../www/src/state/mix.js";
import { Store } from "../../www/src/state/store.js";

/** @import { CurvesDocument } from "../../www/src/types.js" */

const dx = await load({ module: "figure" });
const text = await readFile(new URL("../../www/presets/amoeba.json", import.meta.url), "utf8");
const amoeba = /** @type {CurvesDocument} */ (dx.defaults(text));

/** @param {number[]} mix */
const sum = (mix) => mix.reduce((all, fraction) => all + fraction, 0);

/** @param {number[]} mix */
const inSimplex = (mix) => mix.every((f) => f >= 0 && f <= 1) && Math.abs(sum(mix) - 1) <= 1e-9;

/** @param {number[]} a @param {number[]} b @param {number} within */
const near = (a, b, within) => a.every((value, i) => Math.abs(value - b[i]) <= within);

/** Numbers from 0 to 1 in a fixed order. @param {number} seed */
function random(seed) {
  let state = seed;
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 2 ** 32;
  };
}

test("written fractions have four decimals and the sum 1, the largest takes the rest", () => {
  assert.deepEqual(written([1 / 3, 1 / 3, 1 / 3]), [0.3334, 0.3333, 0.3333]);
  assert.deepEqual(written([2, 2]), [0.5, 0.5]);
  assert.deepEqual(written([-1, 3, Number.NaN]), [0, 1, 0]);
  assert.deepEqual(written([0, 0]), [1, 0]);
  const next = random(1);
  for (let round = 0; round < 500; round += 1) {
    const given = Array.from({ length: 1 + Math.floor(next() * 16) }, () => (next() < 0.3 ? 0 : next()));
    const mix = written(given);
    assert.ok(inSimplex(mix), `${given} gave ${mix}`);
    assert.ok(mix.every((f) => f === Number(f.toFixed(4))));
  }
});

test("one fraction moves and the others follow in proportion", () => {
  assert.deepEqual(withFraction([0.5, 0.3, 0.2], 0, 0.75), [0.75, 0.15, 0.1]);
  assert.deepEqual(withFraction([0.5, 0.3, 0.2], 2, 1), [0, 0, 1]);
  assert.deepEqual(withFraction([1, 0, 0], 0, 0.6), [0.6, 0.2, 0.2], "a rest that nothing has a share in is split");
  assert.deepEqual(withFraction([1, 0, 0], 0, 0.6, [0, 2]), [0.6, 0, 0.4], "or goes where it is told");
  assert.deepEqual(withFraction([0.5, 0.5], 1, 7), [0, 1]);
  assert.deepEqual(withFraction([1], 0, 0.2), [1], "one material is all there is");
});

test("places of the triangle are mixes, and places outside go to its border", () => {
  for (const mix of [[1, 0, 0], [0, 1, 0], [0, 0, 1], [0.2, 0.3, 0.5]]) {
    assert.ok(near(fromTriangle(inTriangle(mix)), mix, 1e-12), String(mix));
  }
  assert.deepEqual(fromTriangle([0.5, -3]), [0.5, 0.5, 0]);
  assert.deepEqual(fromTriangle([-4, -4]), [1, 0, 0]);
  assert.deepEqual(fromTriangle([0.5, 40]), [0, 0, 1]);
  const next = random(2);
  for (let round = 0; round < 300; round += 1) {
    const place = /** @type {[number, number]} */ ([next() * 3 - 1, next() * 3 - 1]);
    const found = fromTriangle(place);
    assert.ok(inSimplex(found));
    // No corner and no point of a grid of the triangle is nearer than the one found.
    const distance = (/** @type {number[]} */ mix) => {
      const [x, y] = inTriangle(mix);
      return Math.hypot(x - place[0], y - place[1]);
    };
    for (let i = 0; i <= 10; i += 1) {
      for (let j = 0; j <= 10 - i; j += 1) {
        assert.ok(distance(found) <= distance([(10 - i - j) / 10, i / 10, j / 10]) + 1e-4);
      }
    }
  }
});

test("the profile is that of the kernel", () => {
  const { composition } = amoeba.curves[1];
  assert.ok(near(mixAt(composition, 0.67), [0, 0.5, 0.5], 1e-12));
  assert.ok(near(mixAt(composition, 0.04), [0, 0.5, 0.5], 1e-12), "over the seam");
  assert.deepEqual(mixAt([{ at: 0.4, mix: [0, 1] }], 0.1), [0, 1]);
  const grown = { ...amoeba, matching: { ...amoeba.matching, method: /** @type {const} */ ("greedy"), oneToOne: false } };
  const { lines, samples } = dx.match(grown);
  for (const line of lines.slice(0, 12)) {
    const point = samples[1].points[line.to];
    const inside = samples[0].points[line.from];
    const at = /** @type {[number, number]} */ ([0, 1].map((k) => point[k] + (inside[k] - point[k]) * 1e-7));
    const place = dx.probe(grown, at);
    const expected = mixAt(composition, samples[1].parameters[line.to]);
    assert.ok(place && near(place.fractions, expected, 1e-5), `${place?.fractions} for ${expected}`);
  }
});

test("keys slide between their neighbours and round the seam", () => {
  const at = (/** @type {CurvesDocument} */ document) => document.curves[1].composition.map((key) => key.at);
  assert.deepEqual(at(slideKey(amoeba, 1, 0, 0.1)), [0.24, 0.58, 0.76, 0.94]);
  const stopped = slideKey(amoeba, 1, 0, 0.7);
  assert.deepEqual(at(stopped), [0.579999, 0.58, 0.76, 0.94]);
  assert.equal(slideKey(stopped, 1, 0, 0.1), stopped, "no farther, and no entry in the log");
  const round = slideKey(amoeba, 1, 0, -0.17);
  assert.deepEqual(at(round), [0.58, 0.76, 0.94, 0.97]);
  assert.equal(followed(amoeba, round, 1, 0), 3);
  assert.deepEqual(at(slideKey(round, 1, 3, 0.17)), at(amoeba));
  assert.equal(slideKey(amoeba, 0, 0, 0.35).curves[0].composition[0].at, 0.35, "a single key goes anywhere");
  assert.equal(wrapped(0.99999999), 0);
  assert.equal(wrapped(-0.25), 0.75);
  assert.ok(Math.abs(shortWay(0.9, 0.1) - 0.2) < 1e-12 && Math.abs(shortWay(0.1, 0.9) + 0.2) < 1e-12);
});

test("a key that is added keeps the profile", () => {
  const before = amoeba.curves[1].composition;
  const after = insertKey(amoeba, 1, afterKey(before, 3));
  assert.equal(after.curves[1].composition.length, 5);
  for (let i = 0; i < 100; i += 1) {
    assert.ok(near(mixAt(after.curves[1].composition, i / 100), mixAt(before, i / 100), 1e-4));
  }
  assert.equal(insertKey(amoeba, 1, 0.58), amoeba, "there is one already");
  assert.equal(removeKey(amoeba, 0, 0), amoeba, "the last one stays");
  assert.equal(removeKey(amoeba, 1, 2).curves[1].composition.length, 3);
});

test("a material that goes leaves its fractions to another", () => {
  const mixed = setMix(amoeba, 1, 0, [0.2, 0.5, 0.3]);
  assert.equal(removeMaterial(mixed, 1), mixed, "not without a choice");
  const gone = removeMaterial(mixed, 1, 2);
  assert.deepEqual(gone.materials.map(({ name }) => name), ["Polymer", "Titanium"]);
  assert.deepEqual(gone.curves[1].composition[0].mix, [0.2, 0.8]);
  assert.equal(removeMaterial(addMaterial(amoeba, { name: "x", color: "#000000" }), 3).materials.length, 3);
  const moved = moveMaterial(mixed, 0, 2);
  assert.deepEqual(moved.materials.map(({ name }) => name), ["Ceramic", "Titanium", "Polymer"]);
  assert.deepEqual(moved.curves[1].composition[0].mix, [0.5, 0.3, 0.2]);
  assert.deepEqual(threeMaterials(amoeba), [0, 1, 2]);
  assert.equal(threeMaterials(gone), null);
});

test("no sequence of edits leaves the simplex or the format, and undo gives the bytes back", () => {
  for (let seed = 1; seed <= 40; seed += 1) {
    const next = random(seed);
    const pick = (/** @type {number} */ count) => Math.floor(next() * count);
    const store = new Store(amoeba);
    const log = [JSON.stringify(amoeba)];
    for (let step = 0; step < 60; step += 1) {
      const before = store.document;
      const curve = pick(2);
      const count = before.materials.length;
      const keys = before.curves[curve].composition.length;
      const key = pick(keys);
      const mix = before.curves[curve].composition[key].mix;
      /** @type {((document: CurvesDocument) => CurvesDocument)[]} */
      const edits = [
        (d) => slideKey(d, curve, key, next() * 2 - 1),
        (d) => slideKey(d, curve, key, (next() - 0.5) * 1e-5),
        (d) => insertKey(d, curve, next() * 3 - 1),
        (d) => insertKey(d, curve, afterKey(d.curves[curve].composition, key)),
        (d) => removeKey(d, curve, key),
        (d) => setMix(d, curve, key, withFraction(mix, pick(count), next() * 1.4 - 0.2)),
        (d) => setMix(d, curve, key, Array.from({ length: count }, () => next() - 0.3)),
        (d) => addMaterial(d, { name: `m${step}`, color: "#123456", void: next() < 0.5 }),
        (d) => removeMaterial(d, pick(count), pick(count)),
        (d) => moveMaterial(d, pick(count), pick(count)),
        (d) => changeMaterial(d, pick(count), { name: `n${step}` }),
        (d) => (next() < 0.1 ? assignMaterial(d, curve, pick(count)) : d),
      ];
      store.commit({ change: edits[pick(edits.length)] });
      if (store.document === before) continue;
      log.push(JSON.stringify(store.document));
      for (const { composition } of store.document.curves) {
        assert.ok(composition.length > 0);
        composition.forEach(({ at, mix: fractions }, i) => {
          assert.ok(inSimplex(fractions), `seed ${seed}, step ${step}: ${fractions}`);
          assert.equal(fractions.length, store.document.materials.length);
          assert.ok(at >= 0 && at < 1 && (i === 0 || at > composition[i - 1].at), `seed ${seed}: ${at}`);
        });
      }
    }
    assert.doesNotThrow(() => dx.fit(store.document, { width: 100, height: 100 }), "the kernel takes it");
    assert.ok(holds(store.document.curves[0], store.document.curves[0].composition[0].mix.findIndex((f) => f > 0)));
    for (let i = log.length - 1; i > 0; i -= 1) {
      assert.equal(JSON.stringify(store.document), log[i]);
      store.undo();
    }
    assert.equal(JSON.stringify(store.document), log[0]);
  }
});
