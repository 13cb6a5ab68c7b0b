/** Results in words: the sentences hold the numbers of the results, and say what is missing. */
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { test } from "node:test";
import { describe, describeCurves, load } from "directrix";

const preset = async (/** @type {string} */ name) =>
  JSON.parse(await readFile(new URL(`../../www/presets/${name}.json`, import.meta.url), "utf8"));
const dx = await load({ module: "full" });
const amoeba = await preset("amoeba");

test("a verified result states its lines and eta", () => {
  const match = dx.match(amoeba);
  const { count, eta } = match.totals.pairs ?? assert.fail();
  assert.equal(describe(match), `${count} lines, none crossing, none blocked, eta ${eta?.toFixed(3)}`);
});

test("a heuristic states how far it falls short, failures are counted", () => {
  const greedy = dx.match({ ...amoeba, matching: { method: "greedy" } });
  assert.ok(greedy.gap !== null && greedy.gap > 5e-4);
  assert.match(describe(greedy), new RegExp(`, ${(greedy.gap * 100).toFixed(1)} % below the optimum$`));
  const shift = dx.match({ ...amoeba, matching: { method: "parameter" } });
  const totals = shift.totals.lines ?? assert.fail();
  assert.match(describe(shift), new RegExp(`^${totals.count} lines, ${totals.crossings || "none"} crossing, ${totals.blocked || "none"} blocked`));
});

test("bare samples, lines through a curve and their numbers are said", async () => {
  const pocket = await preset("closed-pocket");
  const strict = dx.match({ ...pocket, matching: { ...pocket.matching, policy: "strict" } });
  const bare = strict.totals.lines?.uncovered.flat().length ?? 0;
  assert.ok(bare > 0);
  assert.match(describe(strict), new RegExp(`, ${bare} samples? without a line`));
  const repaired = dx.match({ ...pocket, matching: { ...pocket.matching, policy: "repair" } });
  const through = repaired.diagnostics.find(({ code }) => code === "occluded")?.lines?.length;
  assert.match(describe(repaired), new RegExp(`, ${through} more lines? pass(es)? through a curve`));
});

test("drawings in progress and curves without any line are named as such", () => {
  const some = (/** @type {number} */ count) => dx.match({ ...amoeba, curves: amoeba.curves.slice(0, count) });
  assert.equal(describe(some(0)), "No curve yet");
  assert.equal(describe(some(1)), "One curve, not matched yet");
});

test("one of a thing is not several", () => {
  const one = dx.match(amoeba);
  const totals = { ...(one.totals.pairs ?? assert.fail()), count: 1, crossings: 0, blocked: 1, eta: null };
  const text = describe({ ...one, totals: { ...one.totals, pairs: { ...totals, uncovered: [[3], []] } } });
  assert.equal(text, "1 line, none crossing, 1 blocked, 1 sample without a line");
});

test("curves are described by degree, points, size and materials", () => {
  const text = describeCurves({
    ...amoeba,
    unit: "cm",
    materials: [{ name: "steel", color: "#000000" }, { name: "air", color: "#ffffff" }, { name: "gold", color: "#ffff00" }],
    curves: [
      { degree: 2, form: "periodic", points: [[0, 0], [4, 0], [4, 3.3333], [0, 3]], composition: [{ at: 0, mix: [1, 0, 0] }, { at: 0.5, mix: [0, 0, 1] }] },
      { name: "Outer", degree: 3, form: "periodic", points: [[-9, 0], [0, -9], [9, 0], [0, 9]] },
    ],
  });
  assert.equal(
    text,
    "First curve: degree 2, 4 control points within 4 by 3.33 cm, of steel and gold. " +
      "Outer: degree 3, 4 control points within 18 by 18 cm.",
  );
  assert.equal(describeCurves({ ...amoeba, curves: [] }), "");
});

test("an SVG holds title and the same sentence", () => {
  const svg = dx.svg(amoeba, { width: 400, height: 300 });
  assert.ok(svg.includes(`<title>${amoeba.title}</title>`), svg.slice(0, 400));
  assert.ok(svg.includes(`<desc>${describe(dx.match(amoeba))}</desc>`), svg.slice(0, 400));
  assert.ok(dx.svg({ ...amoeba, title: "<b>&" }, { width: 40, height: 30 }).includes("<title>&lt;b&gt;&amp;</title>"));
});
