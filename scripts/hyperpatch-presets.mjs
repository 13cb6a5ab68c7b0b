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
/** Emptiness counts as a material: what is left of it is a pore. */
const EMPTY = { name: "empty", color: "#f4f5f7", void: true };

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

/**
 * Unit cubes in a grid.
 *
 * @param {Place} counts along x, y and z
 * @param {(corner: Place) => number[]} mix at a corner of the grid, counted in cells
 * @param {(place: Place) => number[]} [bent] where a control point of the grid lies; where it is by default
 * @returns {Cell[]}
 */
function grid([nx, ny, nz], mix, bent = (place) => place) {
  const cells = [];
  for (let a = 0; a < nx; a++) {
    for (let b = 0; b < ny; b++) {
      for (let c = 0; c < nz; c++) {
        cells.push(cell(([u, v, w]) => bent([a + u, b + v, c + w]), ([u, v, w]) => mix([a + u, b + v, c + w])));
      }
    }
  }
  return cells;
}

/** Eight cubes with one gradient from corner to corner. */
const block = () =>
  grid([2, 2, 2], ([x, y, z]) => {
    const [p, q] = [x / 2, (y / 2 + z / 2) / 2];
    return [(1 - p) * (1 - q), p * (1 - q), q];
  });

/**
 * Four cubes round an edge, or eight round a corner, whose corners there are of another material than all others: by the flat rule the fraction
 * is a product of one smoothstep along each axis, whose levels are close to circles, or spheres, near the middle.
 *
 * @param {1 | 2} height in cells
 */
const round = (height) => grid([2, 2, height], ([x, y, z]) => (x === 1 && y === 1 && (height === 1 || z === 1) ? [0, 1] : [1, 0]));

/** Two cells with one face in common: the material runs on at the corners of the front, and jumps at those behind. */
function seam() {
  const first = cell(([u, v, w]) => [u, v, w], ([u, v]) => [1 - (u * (1 - v)) / 2, (u * (1 - v)) / 2]);
  const second = cell(([u, v, w]) => [1 + u, v, w], ([u, v]) => [v === 1 ? 0 : (1 - u) / 2, v === 1 ? 1 : (1 + u) / 2]);
  return [first, second];
}

/** A stem that is solid above and ever more porous below. */
const stem = () =>
  grid([1, 1, 3], ([, , z]) => [[0.3, 0.5, 0.8, 1][z], [0.7, 0.5, 0.2, 0][z]], ([x, y, z]) => [(2 * x - 1) * (1 + z / 6), (2 * y - 1) * (1 + z / 6), 2 * z]);

/**
 * Two cells with two corners of a face in common, with their blocks. From there the faces part.
 */
function contact() {
  const first = cell(([u, v, w]) => [u, v, w], upwards);
  const second = cell(([u, v, w]) => [1 + u + (v > 0.5 ? 0.6 * (1 - u) * (3 * v - 1) / 2 : 0), v, w], upwards);
  return [first, second];
}

/** Four cells in a row, whose material goes by the flat rule from one station to the next. */
const row = () => grid([4, 1, 1], ([x]) => [1 - x / 4, x / 4]);

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
    cylinder: document("A cylinder of material", two, round(1)),
    // The cell in front is left out, so that the middle is seen.
    sphere: document("A sphere of material", two, round(2).filter((_, n) => n !== 5)),
    seam: document("Half a seam", two, seam()),
    porous: document("Porous stem", [GREEN, EMPTY], stem()),
    contact: document("Corner contact", two, contact()),
    row: document("Four in a row", two, row()),
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
