/**
 * Boundary value problems of lessons: their documents, what a panel does to a point, the matrix, means and errors. Pure functions.
 *
 * @import { LaplaceBoundary, LaplaceDocument, LaplaceFrame, LaplaceInput, LaplaceSolver, Point } from "../../../js/directrix.js"
 *
 * @typedef {{from: Point, to: Point, middle: Point, normal: Point, length: number}} Panel
 * @typedef {{matrix: Float64Array, count: number, values: boolean[]}} Matrix row by row; `values`: of each panel whether its value is known
 */

/** Places of a circle at which its mean is taken. */
const AROUND = 96;
/** Points at which errors are measured, between a tenth and nine tenths of the box. */
const PROBES = 60;
/** What the residuals of a comparison are followed to, and for how many iterations. */
export const FOLLOWED = { tolerance: 1e-8, restart: 200, maxIterations: 200 };
/** Room round a section, over the size of the body. */
const ROOM = 0.03;
/** The diagonal to which the plane is scaled, where logarithms have no trouble. */
const DIAGONAL = 0.4;

/** What `solveLaplace` takes of a boundary. @param {LaplaceBoundary} boundary @param {LaplaceSolver} [solver] @returns {LaplaceInput} */
export const inputOf = ({ dimension, vertices, elements, groups, conditions, composition, solver: own }, solver = own) => ({ dimension, vertices, elements, groups, conditions, composition, solver });

/** How many steps a body has along its edges. @param {LaplaceDocument} document */
export const stepsOf = ({ model }) => ("segments" in model ? model.segments : "divisions" in model ? model.divisions : undefined) ?? 8;

/** The same body with other steps. @param {LaplaceDocument} document @param {number} steps @returns {LaplaceDocument} */
export const withSteps = (document, steps) => ({ ...document, model: /** @type {any} */ ({ ...document.model, [document.model.kind === "annulus" ? "segments" : "divisions"]: steps }) });

/**
 * The corners of the box of a boundary.
 * @param {Pick<LaplaceBoundary, "dimension" | "vertices">} boundary
 * @returns {[number[], number[]]}
 */
function boxOf({ dimension, vertices }) {
  const [low, high] = [new Array(dimension).fill(Infinity), new Array(dimension).fill(-Infinity)];
  vertices.forEach((x, n) => {
    const axis = n % dimension;
    low[axis] = Math.min(low[axis], x);
    high[axis] = Math.max(high[axis], x);
  });
  return [low, high];
}

const cross = (/** @type {number[]} */ [a, b, c], /** @type {number[]} */ [x, y, z]) => [b * z - c * y, c * x - a * z, a * y - b * x];
const dot = (/** @type {number[]} */ a, /** @type {number[]} */ b) => a.reduce((sum, x, k) => sum + x * b[k], 0);

/**
 * The pixels of a picture of a solution: all of a body in the plane, of one in space the section of its document. Rows run upwards.
 * @param {LaplaceDocument} document
 * @param {LaplaceBoundary} boundary
 * @param {number} longest pixels along the longer side
 * @returns {{frame: Extract<LaplaceFrame, {sides: any}>, box: [Point, Point]}} `box` in the plane of the picture
 */
export function frameOf(document, boundary, longest) {
  const [low, high] = boxOf(boundary);
  const isPlane = boundary.dimension === 2;
  const middle = low.map((x, k) => (x + high[k]) / 2);
  const { origin, normal } = document.section ?? { origin: middle, normal: [0, 1, 0] };
  const u = isPlane ? [1, 0] : unit(cross(normal, Math.abs(normal[2]) > 0.99 * Math.hypot(...normal) ? [0, 1, 0] : [0, 0, 1]));
  const v = isPlane ? [0, 1] : unit(cross(u, normal));
  const corners = Array.from({ length: 2 ** boundary.dimension }, (_, n) => low.map((x, k) => ((n >> k) & 1 ? high[k] : x)));
  const range = (/** @type {number[]} */ way) => [Math.min(...corners.map((corner) => dot(corner, way))), Math.max(...corners.map((corner) => dot(corner, way)))];
  const [[left, right], [bottom, top]] = [range(u), range(v)];
  const room = ROOM * Math.max(right - left, top - bottom);
  const [x, y] = [left - room, bottom - room];
  const [wide, tall] = [right - left + 2 * room, top - bottom + 2 * room];
  const depth = isPlane ? 0 : dot(origin, unit(normal));
  const pixel = Math.max(wide, tall) / longest;
  const at = u.map((each, k) => each * x + v[k] * y + (isPlane ? 0 : unit(normal)[k] * depth));
  const side = (/** @type {number[]} */ way, /** @type {number} */ size) => way.map((each) => each * size);
  return {
    frame: { origin: at, sides: [side(u, wide), side(v, tall)], size: [Math.max(1, Math.round(wide / pixel)), Math.max(1, Math.round(tall / pixel))] },
    box: [[x, y], [x + wide, y + tall]],
  };
}

/** @param {number[]} vector */
function unit(vector) {
  const size = Math.hypot(...vector);
  return vector.map((x) => x / size);
}

/** Coordinates of points of a circle. @param {Point} center @param {number} radius */
export const circleOf = ([x, y], radius) =>
  Array.from({ length: AROUND }, (_, n) => [x + radius * Math.cos((2 * Math.PI * n) / AROUND), y + radius * Math.sin((2 * Math.PI * n) / AROUND)]).flat();

/** The mean, the least and the greatest of one material. @param {ArrayLike<number>} values point after point @param {number} materials @param {number} material */
export function summed(values, materials, material) {
  const own = Array.from({ length: values.length / materials }, (_, n) => values[n * materials + material]);
  return { mean: own.reduce((sum, x) => sum + x, 0) / own.length, least: Math.min(...own), greatest: Math.max(...own) };
}

/** Points spread evenly inside the unit square or cube, coordinate after coordinate. @param {number} dimension */
export const probes = (dimension) =>
  Array.from({ length: PROBES * dimension }, (_, n) => 0.1 + 0.8 * ((Math.floor(n / dimension) * [0.7548776662, 0.5698402910, 0.3819660113][n % dimension] + 0.5) % 1));

/** The largest difference of two lists. @param {ArrayLike<number>} a @param {ArrayLike<number>} b */
export const farthest = (a, b) => Array.from(a).reduce((most, x, n) => Math.max(most, Math.abs(x - b[n])), 0);

/** The panels of a boundary in the plane, in its own coordinates. @param {LaplaceBoundary} boundary @returns {Panel[]} */
export function panelsOf({ vertices, elements }) {
  return Array.from({ length: elements.length / 2 }, (_, n) => {
    const [from, to] = [0, 1].map((k) => /** @type {Point} */ ([vertices[2 * elements[2 * n + k]], vertices[2 * elements[2 * n + k] + 1]]));
    const [dx, dy] = [to[0] - from[0], to[1] - from[1]];
    const length = Math.hypot(dx, dy);
    return { from, to, middle: [(from[0] + to[0]) / 2, (from[1] + to[1]) / 2], normal: [dy / length, -dx / length], length };
  });
}

/**
 * What a panel does to a point, exactly: the integral of -ln r / 2π over it, and the angle under which the point sees it over 2π.
 * @param {Panel} panel
 * @param {Point} point
 */
export function influence({ from, to, normal }, [x, y]) {
  const along = [-normal[1], normal[0]];
  const [a, b] = [from, to].map((end) => (end[0] - x) * along[0] + (end[1] - y) * along[1]);
  const height = (from[0] - x) * normal[0] + (from[1] - y) * normal[1];
  const angle = height === 0 ? 0 : Math.atan(b / height) - Math.atan(a / height);
  // x ln x is 0 at 0, where the point is an end of the panel.
  const part = (/** @type {number} */ s) => (s === 0 && height === 0 ? 0 : (s * Math.log(s * s + height * height)) / 2 - s);
  return { single: -(part(b) - part(a) + height * angle) / (2 * Math.PI), double: angle / (2 * Math.PI) };
}

/** The panels in the coordinates in which they are computed, and lengths there over those of the body. @param {LaplaceBoundary} boundary */
export function scaledPanels(boundary) {
  const [low, high] = boxOf(boundary);
  const scale = DIAGONAL / Math.hypot(...high.map((x, k) => x - low[k]));
  return { panels: panelsOf({ ...boundary, vertices: boundary.vertices.map((x, n) => (x - (low[n % 2] + high[n % 2]) / 2) * scale) }), scale };
}

/**
 * The matrix of a problem in the plane: a row for the equation in the middle of each panel, a column for what is unknown on each.
 * @param {LaplaceBoundary} boundary
 * @returns {Matrix}
 */
export function matrixOf(boundary) {
  const { panels } = scaledPanels(boundary);
  const count = panels.length;
  const values = panels.map((_, n) => "value" in boundary.conditions[boundary.groups[n]]);
  const matrix = new Float64Array(count * count);
  panels.forEach(({ middle }, i) => {
    panels.forEach((panel, j) => {
      const { single, double } = influence(panel, middle);
      matrix[i * count + j] = values[j] ? single : i === j ? -0.5 : double;
    });
  });
  return { matrix, count, values };
}
