/**
 * Writes the presets of hyperpatches, `www/presets/hyperpatch/`: their coefficients follow from a few numbers each.
 *
 *     node scripts/hyperpatch-presets.mjs
 */
import { writeFile } from "node:fs/promises";
import { pathToFileURL } from "node:url";

/** @typedef {[number, number, number]} Place */
/** @typedef {{ coefficients: { position: number[], mix: number[] }[] }} Cell */

const THIRDS = [0, 1 / 3, 2 / 3, 1];

/** Yellow, green, blue: told apart by colour-blind readers, and clean where two of them mix. */
const YELLOW = { name: "polymer", color: "#f0e442" };
const GREEN = { name: "titanium", color: "#009e73" };
const BLUE = { name: "ceramic", color: "#0072b2" };

/**
 * A cell from a function of its parameters that is tricubic at most between thirds, as control points.
 *
 * @param {(place: Place) => number[]} position of the control point at parameters in steps of a third
 * @param {(corner: Place, place: Place) => number[]} mix at a corner, each coordinate 0 or 1: the 8 coefficients of its block have it, unless it
 *   depends on their place, too
 * @returns {Cell}
 */
function cell(position, mix) {
  const coefficients = [];
  for (let i = 0; i < 4; i++) {
    for (let j = 0; j < 4; j++) {
      for (let k = 0; k < 4; k++) {
        const corner = /** @type {Place} */ ([i, j, k].map((n) => (n < 2 ? 0 : 1)));
        const place = /** @type {Place} */ ([THIRDS[i], THIRDS[j], THIRDS[k]]);
        coefficients.push({ position: position(place).map(rounded), mix: mix(corner, place).map(rounded) });
      }
    }
  }
  return { coefficients };
}

/** To nine decimals: far below what counts as one point, and short to read. @param {number} x */
const rounded = (x) => Math.round(x * 1e9) / 1e9 + 0;

/**
 * Control points of a cube turned about its axis by an angle that grows with height.
 *
 * @param {number} degrees from the bottom to the top
 * @returns {(place: Place) => number[]}
 */
function twisted(degrees) {
  return ([u, v, w]) => {
    const angle = (degrees * w * Math.PI) / 180;
    const [x, y] = [2 * u - 1, 2 * v - 1];
    return [x * Math.cos(angle) - y * Math.sin(angle), x * Math.sin(angle) + y * Math.cos(angle), 2 * w];
  };
}

/** A cell whose four upper corners are of the second of two materials. @param {Place} corner */
const upwards = ([, , w]) => [1 - w, w];

/**
 * A cube whose eight inner coefficients are moved along u, against each other: its edges stay straight, and the determinant is 1 at all corners. It
 * is least in the middle, 1 - 27/32 of the shift.
 *
 * @param {number} shift 0 leaves the cube as it is
 * @returns {(place: Place) => number[]}
 */
function folded(shift) {
  return ([u, v, w]) => {
    const isInside = [u, v, w].every((t) => t > 0 && t < 1);
    return [isInside ? u + shift * (u < 0.5 ? 1 : -1) : u, v, w];
  };
}

/**
 * A thin bar along u that runs round a loop and through itself. No part of it is folded: only the whole is wrong.
 *
 * @returns {(place: Place) => number[]}
 */
function crossing() {
  const path = [[0, 0], [12, 8], [-6, 8], [6, 0]];
  const sides = [[-0.55, 0.83], [-1, -0.9], [1, -0.9], [0.55, 0.83]];
  return ([u, v, w]) => {
    const n = Math.round(3 * u);
    return [path[n][0] + sides[n][0] * 0.2 * (v - 0.5), path[n][1] + sides[n][1] * 0.2 * (v - 0.5), 0.2 * w];
  };
}

/**
 * A cell of a ring about the z axis: u turns about it, v goes from the outside inwards, w upwards.
 *
 * @param {number} count of cells of the ring
 * @param {number} index
 * @returns {(place: Place) => number[]}
 */
function ringCell(count, index) {
  const angle = (2 * Math.PI) / count;
  const handle = (4 / 3) * Math.tan(angle / 4);
  const [start, end] = [index, index + 1].map((n) => [Math.cos(angle * n), Math.sin(angle * n)]);
  const arc = [
    start,
    [start[0] - handle * start[1], start[1] + handle * start[0]],
    [end[0] + handle * end[1], end[1] - handle * end[0]],
    end,
  ];
  return ([u, v, w]) => {
    const [x, y] = arc[Math.round(3 * u)];
    const radius = 2 - v;
    return [x * radius, y * radius, w];
  };
}

/** @param {number} index @param {number} count */
function share(index, count) {
  const part = (1 - Math.cos((2 * Math.PI * index) / count)) / 2;
  return [1 - part, part];
}

/**
 * Two cells with a common face. Below they run on smoothly in shape, above there is a kink; the material runs on at two corners, has a kink at one
 * and a jump at the last.
 */
function pair() {
  const first = cell(([u, v, w]) => [u, v, w], ([u, v]) => [1 - u, u * v, u * (1 - v)]);
  const second = cell(
    ([u, v, w]) => [1 + u, v, w + (w > 0.5 ? 0.9 * u * (1 - u / 2) : 0)],
    ([u, v, w], place) => {
      if (u === 0 && v === 0 && w === 0) return [1, 0, 0];
      const isBent = v === 1 && w === 1 && place[0] > 0;
      return u === 1 || isBent ? [0.5, v / 2, (1 - v) / 2] : [0, v, 1 - v];
    },
  );
  return [first, second];
}

/** Eight cubes with one gradient from corner to corner. */
function block() {
  const cells = [];
  for (let a = 0; a < 2; a++) {
    for (let b = 0; b < 2; b++) {
      for (let c = 0; c < 2; c++) {
        const mix = (/** @type {Place} */ [u, v, w]) => {
          const [p, q] = [(a + u) / 2, ((b + v) / 2 + (c + w) / 2) / 2];
          return [(1 - p) * (1 - q), p * (1 - q), q];
        };
        cells.push(cell(([u, v, w]) => [a + u, b + v, c + w], mix));
      }
    }
  }
  return cells;
}

/**
 * The presets by name, in the order in which they are shown.
 *
 * @returns {Record<string, object>}
 */
export function presets() {
  const document = (/** @type {string} */ title, /** @type {object[]} */ materials, /** @type {Cell[]} */ cells) => ({
    directrix: 1,
    kind: "hyperpatch",
    title,
    unit: "mm",
    materials,
    operations: [{ op: "cells", cells }],
  });
  const two = [YELLOW, GREEN];
  const three = [YELLOW, GREEN, BLUE];
  return {
    cell: document("One cell", two, [cell(([u, v, w]) => [2 * u - 1, 2 * v - 1, 2 * w], upwards)]),
    twisted: document("Twisted", two, [cell(twisted(60), upwards)]),
    "nearly-invalid": document("Nearly invalid", two, [cell(folded(1.15), upwards)]),
    invalid: document("Folded inside", two, [cell(folded(1.6), upwards)]),
    crossing: document("Through itself", two, [cell(crossing(), ([u]) => [1 - u, u])]),
    pair: document("Two cells, mixed continuity", three, pair()),
    block: document("Block of eight", three, block()),
    ring: document(
      "Ring of eight",
      two,
      Array.from({ length: 8 }, (_, n) => cell(ringCell(8, n), ([u]) => share(n + u, 8))),
    ),
  };
}

/**
 * A document with a coefficient in each line: short enough to read and to compare.
 *
 * @param {any} document
 */
export function textOf({ operations, ...rest }) {
  const cell = (/** @type {Cell} */ { coefficients }) =>
    `    { "coefficients": [\n${coefficients.map((one) => `      ${JSON.stringify(one)}`).join(",\n")}\n    ] }`;
  const head = Object.entries(rest).map(([name, value]) => `  "${name}": ${JSON.stringify(value)},\n`);
  const [{ cells }] = operations;
  return `{\n${head.join("")}  "operations": [{ "op": "cells", "cells": [\n${cells.map(cell).join(",\n")}\n  ] }]\n}\n`;
}

if (process.argv[1] && import.meta.url === pathToFileURL(process.argv[1]).href) {
  for (const [name, document] of Object.entries(presets())) {
    await writeFile(new URL(`../www/presets/hyperpatch/${name}.json`, import.meta.url), textOf(document));
  }
}
