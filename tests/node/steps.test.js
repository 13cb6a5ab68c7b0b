/** The steps of the greedy growth: replayed they lead to what `match` gives, and the sets agree with them at every step. */
import assert from "node:assert/strict";
import { readFile, readdir } from "node:fs/promises";
import { test } from "node:test";
import { DirectrixError, load } from "directrix";

/**
 * @import { CurvesDocument, Point, Steps } from "directrix"
 */

const folder = new URL("../../www/presets/", import.meta.url);
const dx = await load();
/** @param {string} name @returns {Promise<CurvesDocument>} */
const read = async (name) => JSON.parse(await readFile(new URL(name, folder), "utf8"));
const presets = (await readdir(folder)).filter((name) => name.endsWith(".json") && name !== "index.json");
const amoeba = await read("amoeba.json");

/** @param {{from: number, to: number}} line */
const name = ({ from, to }) => `${from} ${to}`;

/**
 * The lines after the growth and the removal, and the ends of the lines after the passes.
 * @param {Steps} steps
 */
function replay({ growth, removed, inserted, samples }) {
  const gone = new Set(removed);
  const lines = growth.filter((_, k) => !gone.has(k));
  let ends = lines.map((line) => ({ line, from: samples[0].points[line.from], to: samples[1].points[line.to], moved: false }));
  for (const { curve, vertex, at } of inserted) {
    const movable = ends.filter(({ line, moved }) => !moved && (curve === 0 ? line.to : line.from) === vertex);
    assert.equal(movable.length, 1, "one line is there to be moved");
    ends = ends.map((end) => (end === movable[0] ? { ...end, [curve === 0 ? "from" : "to"]: at, moved: true } : end));
  }
  return { lines, ends };
}

/** @param {{from: Point, to: Point}} line */
const place = ({ from, to }) => [...from, ...to].map((value) => value.toPrecision(12)).join(" ");

test("replayed, the steps of every preset lead to the lines and the pairs of the greedy method", async () => {
  let whole = 0;
  for (const file of presets) {
    const document = await read(file);
    if (document.curves.length > 2 || document.blend?.kind === "harmonic") continue;
    const matching = { ...document.matching, method: /** @type {const} */ ("greedy"), oneToOne: true };
    const steps = dx.steps(document);
    const match = dx.match({ ...document, matching });
    const { lines, ends } = replay(steps);
    assert.deepEqual(lines.map(name).sort(), match.lines.map(name).sort(), file);
    assert.equal(steps.growth.length, match.totals.growth?.count, file);
    assert.deepEqual([steps.ok, steps.gap, steps.pairs], [match.ok, match.gap, match.pairs], file);
    if (match.pairs.length === 0) {
      assert.deepEqual(steps.inserted, [], file);
      continue;
    }
    assert.equal(ends.length, match.pairs.length, file);
    if (match.diagnostics.some(({ code }) => code === "unverified-gap")) continue;
    assert.deepEqual(ends.map(place).sort(), match.pairs.map(place).sort(), file);
    const values = new Set(match.pairs.map(({ value }) => value));
    assert.ok(steps.inserted.every(({ value }) => values.has(value)), file);
    whole += 1;
  }
  assert.ok(whole > 15, `${whole} presets whose every gap takes its lines`);
});

test("each accepted line is the best candidate of both its ends, and what is passed over crosses a line", () => {
  const { growth, rejected, samples } = dx.steps(amoeba);
  for (const [step, { from, to }] of growth.entries()) {
    for (const [curve, vertex, end] of /** @type {const} */ ([[0, from, to], [1, to, from]])) {
      const { visible, valid, best } = dx.sets(amoeba, { step, curve, vertex });
      assert.equal(best, end, `step ${step}, curve ${curve}`);
      const candidates = visible.filter(({ candidate }) => candidate);
      assert.ok(candidates.every(({ vertex }) => valid.includes(vertex)));
      assert.ok(visible.every(({ value }, k) => k === 0 || value <= visible[k - 1].value * (1 + 1e-9)));
      if (step === 0) assert.equal(valid.length, samples[1 - curve].points.length);
    }
  }
  const [first] = growth;
  assert.ok(growth.every(({ value }) => value <= first.value), "the best line of all comes first");
  assert.ok(rejected.length > 0);
  for (const { from, to, step, by } of rejected) {
    assert.ok(by < step);
    const seen = dx.sets(amoeba, { step, vertex: from }).visible.find(({ vertex }) => vertex === to);
    assert.equal(seen?.candidate, false);
  }
  assert.equal(dx.sets(amoeba, { step: growth.length, vertex: 0 }).visible.length > 0, true);
});

test("the method, pins, order rules and view of the document make no difference; the weights do", () => {
  const { growth } = dx.steps(amoeba);
  const other = /** @type {CurvesDocument} */ ({
    ...amoeba,
    view: { s: 0.2 },
    matching: { ...amoeba.matching, method: "exact", objective: "sum", pins: [{ u: 0.1, v: 0.2 }], printed: ["stop", "order", "removal"] },
  });
  assert.deepEqual(dx.steps(other).growth, growth);
  assert.deepEqual(dx.steps(JSON.stringify(amoeba)).growth, growth);
  const weighed = dx.steps({ ...amoeba, matching: { ...amoeba.matching, distanceWeight: 1 } });
  assert.notDeepEqual(weighed.growth, growth);
  const job = dx.job(amoeba, { greedy: true });
  while (!job.step(1).done);
  assert.deepEqual(dx.steps(amoeba).growth, growth);
});

test("what is no document or no vertex is refused by name, and a drawing in progress has no steps", () => {
  const refused = (/** @type {() => unknown} */ call, /** @type {string} */ code, /** @type {string} */ path) =>
    assert.throws(call, (error) => error instanceof DirectrixError && error.code === code && error.path === path);
  const { growth } = dx.steps(amoeba);
  const step = growth.length;
  refused(() => dx.sets(amoeba, { step: step + 1, vertex: 0 }), "range", "options.step");
  refused(() => dx.sets(amoeba, { step, vertex: 44 }), "range", "options.vertex");
  refused(() => dx.sets(amoeba, { step, curve: /** @type {any} */ (2), vertex: 0 }), "range", "options.curve");
  refused(() => dx.sets(amoeba, { step: -1, vertex: 0 }), "type", "options.step");
  refused(() => dx.sets(amoeba, { step, vertex: 0.5 }), "type", "options.vertex");
  refused(() => dx.sets(amoeba, /** @type {any} */ (undefined)), "type", "options.step");
  refused(() => dx.steps(/** @type {any} */ ({ ...amoeba, matching: { method: "greedy", oops: 1 } })), "unknown-field", "matching.oops");
  refused(() => dx.steps("{"), "syntax", "");
  const steps = dx.steps({ ...amoeba, curves: amoeba.curves.slice(0, 1) });
  assert.deepEqual([steps.ok, steps.growth, steps.rejected, steps.removed, steps.inserted], [false, [], [], [], []]);
  assert.equal(steps.diagnostics[0].code, "incomplete");
  refused(() => dx.sets({ ...amoeba, curves: [] }, { step: 0, vertex: 0 }), "range", "options.step");
});
