/**
 * The steps one after the other: the growth line by line, the removal of redundant lines, the two passes of insertion, and the result. Pure
 * functions of the trace.
 *
 * @import { InsertedEnd, Steps } from "../../../js/directrix.js"
 * @import { Point } from "../types.js"
 *
 * @typedef {"start" | "growth" | "removal" | "first" | "second" | "end"} Phase
 *
 * @typedef {object} Line
 * @property {number | null} from vertex of the first curve, null for one that was inserted
 * @property {number | null} to vertex of the second curve
 * @property {[Point, Point]} ends
 * @property {number} value
 *
 * @typedef {object} Scene One step as it is shown.
 * @property {Phase} phase
 * @property {number} code the line of the pseudo-code at work, from 0
 * @property {Line[]} lines there are, without the chosen one
 * @property {Line[]} redundant those of `lines` whose two ends have another; while they are removed
 * @property {Line | null} chosen the line that is accepted, removed or moved in this step
 * @property {Line | null} left where a moved line was
 * @property {[number[], number[]]} degrees lines at each vertex, with the chosen one
 * @property {Point[]} inserted vertices
 */

/** Lines of the pseudo-code, from 0. */
export const CODE = { start: 0, ask: 1, growth: 4, accept: 5, removal: 8, first: 9, second: 10, end: 11 };

/** @param {Steps} steps */
export function lengths({ growth, removed, inserted }) {
  const first = inserted.filter(({ curve }) => curve === 0).length;
  return { growth: growth.length, removal: removed.length, first, second: inserted.length - first };
}

/** Number of the last step; the start is step 0. @param {Steps} steps */
export function totalOf(steps) {
  return steps.growth.length + steps.removed.length + steps.inserted.length + 1;
}

/**
 * @param {Steps} steps
 * @param {number} at
 * @returns {{phase: Phase, index: number}} the index within the phase, from 0
 */
export function phaseAt(steps, at) {
  if (at === 0) return { phase: "start", index: 0 };
  let index = at - 1;
  for (const [phase, count] of Object.entries(lengths(steps))) {
    if (index < count) return { phase: /** @type {Phase} */ (phase), index };
    index -= count;
  }
  return { phase: "end", index: 0 };
}

/**
 * The value that each step from 1 on has above the scrubber: f of the line it is about. The result has none.
 * @param {Steps} steps
 */
export function values({ growth, removed, inserted }) {
  return [...growth.map(({ value }) => value), ...removed.map((k) => growth[k]?.value ?? 0), ...inserted.map(({ value }) => value)];
}

/**
 * @param {Steps} steps
 * @param {number} at
 * @returns {Scene}
 */
export function sceneAt(steps, at) {
  const { growth, removed, inserted } = steps;
  const { phase, index } = phaseAt(steps, at);
  /** @type {Scene} */
  const scene = { phase, code: CODE[phase], lines: [], redundant: [], chosen: null, left: null, degrees: [[], []], inserted: [] };
  if (phase === "growth" || phase === "start") {
    const all = growth.slice(0, at).map((line) => between(steps, line));
    if (phase === "growth") scene.chosen = all.pop() ?? null;
    scene.lines = all;
  } else if (phase === "removal") {
    const gone = new Set(removed.slice(0, index));
    const chosen = removed[index];
    const all = growth.flatMap((line, k) => (gone.has(k) ? [] : [{ k, line: between(steps, line) }]));
    scene.lines = all.filter(({ k }) => k !== chosen).map(({ line }) => line);
    scene.chosen = all.find(({ k }) => k === chosen)?.line ?? null;
  } else if (phase === "end") {
    scene.lines = finished(steps);
    scene.inserted = scene.lines.flatMap(({ from, to, ends: [p, q] }) => [...(from === null ? [p] : []), ...(to === null ? [q] : [])]);
  } else {
    const first = phase === "second" ? lengths(steps).first : 0;
    const done = inserted.slice(0, first + index + 1);
    const moved = move(steps, done);
    scene.chosen = moved.chosen;
    scene.left = moved.left;
    scene.lines = moved.lines.filter((line) => line !== moved.chosen);
    scene.inserted = done.map(({ at }) => at);
  }
  scene.degrees = degreesOf(steps, scene.chosen ? [...scene.lines, scene.chosen] : scene.lines);
  if (phase === "removal") {
    const [p, q] = scene.degrees;
    scene.redundant = scene.lines.filter(({ from, to }) => (p[from ?? -1] ?? 0) > 1 && (q[to ?? -1] ?? 0) > 1);
  }
  return scene;
}

/** @param {Steps} steps @param {{from: number, to: number, value: number}} line @returns {Line} */
function between({ samples }, { from, to, value }) {
  return { from, to, value, ends: [pointOf(samples[0], from), pointOf(samples[1], to)] };
}

/** @param {import("../../../js/directrix.js").Samples | undefined} samples @param {number} vertex @returns {Point} */
function pointOf(samples, vertex) {
  return samples?.points[vertex] ?? [0, 0];
}

/** What is left at the end: the pairs, with the vertices they end in, or the lines without the redundant. @param {Steps} steps @returns {Line[]} */
function finished(steps) {
  if (steps.pairs.length === 0) return steps.lines.map((line) => between(steps, line));
  const known = steps.samples.map(({ points }) => new Map(points.map((point, k) => [String(point), k])));
  return steps.pairs.map(({ from, to, value }) => ({
    from: known[0]?.get(String(from)) ?? null,
    to: known[1]?.get(String(to)) ?? null,
    value,
    ends: [from, to],
  }));
}

/**
 * The lines without the redundant, after some steps of the two passes.
 * @param {Steps} steps
 * @param {InsertedEnd[]} done
 */
function move(steps, done) {
  const lines = steps.lines.map((line) => between(steps, line));
  /** @type {Line | null} */
  let chosen = null;
  /** @type {Line | null} */
  let left = null;
  for (const { curve, vertex, at, value } of done) {
    const k = lines.findIndex(({ from, to }) => (curve === 0 ? to === vertex && from !== null : from === vertex && to !== null));
    const line = lines[k];
    if (!line) continue;
    const [p, q] = line.ends;
    left = line;
    chosen = curve === 0 ? { ...line, from: null, ends: [at, q], value } : { ...line, to: null, ends: [p, at], value };
    lines[k] = chosen;
  }
  return { lines, chosen, left };
}

/** @param {Steps} steps @param {Line[]} lines @returns {[number[], number[]]} */
function degreesOf({ samples }, lines) {
  const [p, q] = [0, 1].map((k) => new Array(samples[k]?.points.length ?? 0).fill(0));
  for (const { from, to } of lines) {
    if (from !== null && p) p[from] += 1;
    if (to !== null && q) q[to] += 1;
  }
  return [p ?? [], q ?? []];
}

/** The name of a vertex: p on the first curve, q on the second. @param {number} curve @param {number | null} vertex */
export function vertexName(curve, vertex) {
  return vertex === null ? "" : `${curve === 0 ? "p" : "q"}${vertex}`;
}

/** @param {{from: number | null, to: number | null}} line */
export function lineName({ from, to }) {
  return [vertexName(0, from), vertexName(1, to)].filter(Boolean).join(" \u2013 ");
}
