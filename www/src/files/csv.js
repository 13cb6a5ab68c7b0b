/**
 * Tables of a matching as CSV: a header row, a dot for the decimal point, lines that end in a line feed, and every number with
 * all the digits it has, so that reading them gives the same numbers back.
 *
 * @import { Match, Point } from "../types.js"
 *
 * @typedef {{u: number, v: number, value: number, verified: boolean, from?: Point, to?: Point, cosine?: number}} Pair
 */

const COLUMNS = ["line", "u", "v", "x1", "y1", "x2", "y2", "value", "cosine", "length"];

/**
 * The ruling lines, or the one-to-one pairs where the matching has them. A cell is empty where the matching does not say.
 * @param {Pick<Match, "samples" | "lines"> & {pairs: Pair[]}} match
 * @param {number} rise the difference of the heights of the curves, which counts in lengths
 */
export function linesCsv({ samples: [first, second], lines, pairs }, rise) {
  if (pairs.length > 0) {
    return table([...COLUMNS, "verified"], pairs.map(({ u, v, value, verified, from = [], to = [], cosine }, i) => [
      ...[i, u, v, from[0], from[1], to[0], to[1], value, cosine, distance(from, to, rise), verified],
    ]));
  }
  return table([...COLUMNS, "visible"], lines.map(({ from, to, value, visible }, i) => {
    const [p = [], q = []] = [first.points[from], second.points[to]];
    const [n = [], m = []] = [first.normals[from], second.normals[to]];
    const cosine = (n[0] ?? NaN) * (m[0] ?? NaN) + (n[1] ?? NaN) * (m[1] ?? NaN);
    const ends = [first.parameters[from], second.parameters[to], p[0], p[1], q[0], q[1]];
    return [i, ...ends, value, cosine, distance(p, q, rise), visible];
  }));
}

/**
 * The in-between curves, point by point; each is closed, and its first point is not repeated.
 * @param {{s: number, points: Point[]}[]} stages
 */
export function stagesCsv(stages) {
  return table(["stage", "s", "x", "y"], stages.flatMap(({ s, points }, i) => points.map(([x, y]) => [i, s, x, y])));
}

/** @param {number[]} p @param {number[]} q @param {number} rise */
function distance([x1, y1], [x2, y2], rise) {
  if (x1 === undefined || y1 === undefined || x2 === undefined || y2 === undefined) return undefined;
  return Math.hypot(x2 - x1, y2 - y1, rise);
}

/** @param {string[]} head @param {(number | boolean | undefined)[][]} rows */
function table(head, rows) {
  return [head, ...rows].map((cells) => `${cells.map((cell) => cell ?? "").join(",")}\n`).join("");
}
