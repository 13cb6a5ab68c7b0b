/**
 * Tables of a matching as CSV: a header row, a dot for the decimal point, lines that end in a line feed, and every number with
 * all the digits it has, so that reading them gives the same numbers back.
 *
 * @import { Match, Point } from "../types.js"
 */

const COLUMNS = ["line", "u", "v", "x1", "y1", "x2", "y2", "value", "cosine", "length"];

/**
 * The ruling lines, or the one-to-one pairs where the matching has them; those have no normals, and the cell of their cosine is
 * empty.
 * @param {Pick<Match, "samples" | "lines" | "pairs">} match
 * @param {number} rise the difference of the heights of the curves, which counts in lengths
 */
export function linesCsv(match, rise) {
  const { head, rows } = linesOf(match, rise);
  return table(head, rows);
}

/**
 * The lines of all spans of a stack, each with the number of its span.
 * @param {Pick<Match, "samples" | "lines" | "pairs">[]} spans
 * @param {number[]} heights of the curves
 */
export function stackCsv(spans, heights) {
  const tables = spans.map((span, k) => linesOf(span, heights[k + 1] - heights[k]));
  return table(["span", ...(tables[0]?.head ?? [])], tables.flatMap(({ rows }, k) => rows.map((cells) => [k, ...cells])));
}

/**
 * @param {Pick<Match, "samples" | "lines" | "pairs">} match
 * @param {number} rise
 * @returns {{head: string[], rows: (number | boolean | undefined)[][]}}
 */
function linesOf({ samples: [first, second], lines, pairs }, rise) {
  if (pairs.length > 0) {
    const rows = pairs.map(({ u, v, value, verified, from, to }, i) => [
      ...[i, u, v, ...from, ...to, value, undefined, distance(from, to, rise), verified],
    ]);
    return { head: [...COLUMNS, "verified"], rows };
  }
  const rows = lines.map(({ from, to, value, visible }, i) => {
    const [p, n] = /** @type {[Point, Point]} */ ([first.points[from], first.normals[from]]);
    const [q, m] = /** @type {[Point, Point]} */ ([second.points[to], second.normals[to]]);
    const [u, v] = [first.parameters[from], second.parameters[to]];
    return [i, u, v, ...p, ...q, value, n[0] * m[0] + n[1] * m[1], distance(p, q, rise), visible];
  });
  return { head: [...COLUMNS, "visible"], rows };
}

/**
 * The in-between curves, point by point; each is closed, and its first point is not repeated.
 * @param {{s: number, points: Point[]}[]} stages
 */
export function stagesCsv(stages) {
  return table(["stage", "s", "x", "y"], stages.flatMap(({ s, points }, i) => points.map(([x, y]) => [i, s, x, y])));
}

/**
 * The lines along the gradient of a harmonic blend, point by point from the inner curve to the outer one.
 * @param {Pick<import("../../../js/directrix.js").Harmonic, "lines" | "lineCurves" | "lineParameters">} blend
 */
export function gradientCsv({ lines, lineCurves, lineParameters }) {
  const rows = lines.flatMap((flat, i) => pairsOf(flat).map(([x, y]) => [i, lineCurves[i], lineParameters[2 * i], lineParameters[2 * i + 1], x, y]));
  return table(["line", "curve", "u", "v", "x", "y"], rows);
}

/**
 * The level curves of a harmonic blend, loop by loop; each is closed, and its first point is not repeated.
 * @param {Pick<import("../../../js/directrix.js").Harmonic, "levels">} blend
 */
export function levelsCsv({ levels }) {
  const rows = levels.flatMap(({ value, loops }, i) => loops.flatMap((flat, k) => pairsOf(flat).map(([x, y]) => [i + 1, value, k, x, y])));
  return table(["stage", "s", "loop", "x", "y"], rows);
}

/** @param {Float64Array} flat @returns {Point[]} */
const pairsOf = (flat) => Array.from({ length: flat.length / 2 }, (_, k) => [flat[2 * k], flat[2 * k + 1]]);

/** @param {Point} p @param {Point} q @param {number} rise */
function distance([x1, y1], [x2, y2], rise) {
  return Math.hypot(x2 - x1, y2 - y1, rise);
}

/** @param {string[]} head @param {(number | boolean | undefined)[][]} rows */
function table(head, rows) {
  return [head, ...rows].map((cells) => `${cells.map((cell) => cell ?? "").join(",")}\n`).join("");
}
