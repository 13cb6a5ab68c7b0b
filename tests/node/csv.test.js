/** Tables written and read back. */
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { test } from "node:test";
import { load } from "directrix";
import { linesCsv, stagesCsv } from "../../www/src/files/csv.js";

const dx = await load({ module: "figure" });
const preset = JSON.parse(await readFile(new URL("../../www/presets/amoeba.json", import.meta.url), "utf8"));
/** Its lines from sample to sample, as they grow. */
const amoeba = { ...preset, matching: { ...preset.matching, method: "greedy", oneToOne: false } };

/**
 * Rows by the names of the columns.
 * @param {string} text
 * @returns {{[column: string]: string}[]}
 */
function read(text) {
  assert.ok(text.endsWith("\n"));
  const [head, ...rows] = text.slice(0, -1).split("\n").map((line) => line.split(","));
  return rows.map((cells) => {
    assert.equal(cells.length, head.length);
    return Object.fromEntries(cells.map((cell, i) => [head[i], cell]));
  });
}

test("ruling lines come back with every digit, and agree with the probe", () => {
  const document = { ...amoeba, curves: [amoeba.curves[0], { ...amoeba.curves[1], height: 7 }] };
  const match = dx.match(document);
  const rows = read(linesCsv(match, 7));
  assert.equal(rows.length, match.lines.length);
  rows.forEach((row, i) => {
    const { from, to, value, visible } = match.lines[i];
    const [first, second] = match.samples;
    assert.equal(row.line, String(i));
    assert.deepEqual([Number(row.u), Number(row.v)], [first.parameters[from], second.parameters[to]]);
    assert.deepEqual([row.x1, row.y1, row.x2, row.y2].map(Number), [...first.points[from], ...second.points[to]]);
    assert.equal(Number(row.value), value);
    assert.equal(row.visible, String(visible));
    // The value is c / d² here, so that cosine and length can be checked against it.
    assert.ok(Math.abs(Number(row.cosine) / Number(row.length) ** 2 / value - 1) < 1e-12);
  });
  const place = dx.probe(document, [45, 0]);
  assert.ok(place);
  const row = rows[place.line];
  assert.ok(Math.abs(Number(row.cosine) - place.cosine) < 1e-14);
  assert.ok(Math.abs(Number(row.length) - place.length) < 1e-12);
});

test("one-to-one pairs take the place of the lines", () => {
  const match = dx.match({ ...amoeba, matching: { ...amoeba.matching, oneToOne: true } });
  assert.ok(match.pairs.length > 40);
  const rows = read(linesCsv(match, 0));
  assert.equal(rows.length, match.pairs.length);
  rows.forEach((row, i) => {
    const { u, v, value, verified, from, to } = match.pairs[i];
    assert.deepEqual([row.line, row.u, row.v].map(Number), [i, u, v]);
    assert.deepEqual([row.x1, row.y1, row.x2, row.y2, row.value].map(Number), [...from, ...to, value]);
    assert.ok(Math.abs(Number(row.length) - Math.hypot(from[0] - to[0], from[1] - to[1])) < 1e-12);
    assert.deepEqual([row.cosine, row.verified], ["", String(verified)]);
  });
  const odd = { ...match.pairs[0], u: 0.1 + 0.2, v: 1 / 3, value: -1e-300, verified: false };
  const [row] = read(linesCsv({ ...match, pairs: [odd] }, 12));
  assert.deepEqual([row.u, row.v, row.value].map(Number), [0.1 + 0.2, 1 / 3, -1e-300]);
  assert.equal(row.verified, "false");
});

test("stages come back point by point", () => {
  const stages = dx.stages(amoeba, { refine: 2 });
  const rows = read(stagesCsv(stages)).map(({ stage, s, x, y }) => [stage, s, x, y].map(Number));
  assert.deepEqual(rows, stages.flatMap(({ s, points }, i) => points.map(([x, y]) => [i, s, x, y])));
  assert.equal(stagesCsv([]), "stage,s,x,y\n");
});
