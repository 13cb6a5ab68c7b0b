/**
 * A boundary as a mesh: its triangles for a picture, the edges between elements, and sets of elements that are chosen by where they lie.
 *
 * @import { Boundary } from "./document.js"
 * @import { Bounds, Vector } from "../space/vector.js"
 *
 * @typedef {Pick<Boundary, "dimension" | "vertices" | "elements">} Elements
 *
 * @typedef {object} Soup Triangles with corners of their own, so that each has its own colour.
 * @property {Float32Array} positions nine numbers an element
 * @property {Float32Array} normals the same, of length 1, outward
 * @property {Uint32Array} indices
 */
import { cross, dot, subtract, unit } from "../space/vector.js";

/** How many elements a boundary has. @param {Elements} mesh */
export const countOf = ({ dimension, elements }) => elements.length / dimension;

/** A vertex as a point; of the plane its third coordinate is 0. @param {Elements} mesh @param {number} vertex @returns {Vector} */
export function pointOf({ dimension, vertices }, vertex) {
  const k = dimension * vertex;
  return [vertices[k], vertices[k + 1], dimension === 3 ? vertices[k + 2] : 0];
}

/** The corners of an element. @param {Elements} mesh @param {number} element @returns {Vector[]} */
export function cornersOf(mesh, element) {
  const { dimension, elements } = mesh;
  return Array.from({ length: dimension }, (_, k) => pointOf(mesh, elements[dimension * element + k]));
}

/** The middle of an element. @param {Elements} mesh @param {number} element @returns {Vector} */
export function centreOf(mesh, element) {
  const corners = cornersOf(mesh, element);
  return /** @type {Vector} */ ([0, 1, 2].map((axis) => corners.reduce((sum, corner) => sum + corner[axis], 0) / corners.length));
}

/** The outward normal of an element, of length 1: segments have the material on their left. @param {Elements} mesh @param {number} element @returns {Vector} */
export function normalOf(mesh, element) {
  const [a, b, c] = cornersOf(mesh, element);
  const along = subtract(b, a);
  return unit(mesh.dimension === 3 ? cross(along, subtract(c, a)) : [along[1], -along[0], 0]);
}

/** The box of all vertices. @param {Elements} mesh @returns {Bounds} */
export function boundsOf(mesh) {
  /** @type {Bounds} */
  const bounds = { min: [Infinity, Infinity, Infinity], max: [-Infinity, -Infinity, -Infinity] };
  for (let vertex = 0; vertex < mesh.vertices.length / mesh.dimension; vertex += 1) {
    const point = pointOf(mesh, vertex);
    for (const axis of /** @type {const} */ ([0, 1, 2])) {
      bounds.min[axis] = Math.min(bounds.min[axis], point[axis]);
      bounds.max[axis] = Math.max(bounds.max[axis], point[axis]);
    }
  }
  return bounds;
}

/** The triangles of a boundary in space. @param {Elements} mesh @returns {Soup} */
export function soupOf(mesh) {
  const count = countOf(mesh);
  const [positions, normals] = [new Float32Array(9 * count), new Float32Array(9 * count)];
  for (let element = 0; element < count; element += 1) {
    const normal = normalOf(mesh, element);
    cornersOf(mesh, element).forEach((corner, k) => {
      positions.set(corner, 9 * element + 3 * k);
      normals.set(normal, 9 * element + 3 * k);
    });
  }
  return { positions, normals, indices: Uint32Array.from({ length: 3 * count }, (_, k) => k) };
}

/**
 * The elements at each edge of a boundary in space, or at each vertex of one in the plane. Vertices at one place are one.
 * @param {Elements} mesh
 * @returns {Map<string, {ends: Vector[], elements: number[]}>}
 */
export function jointsOf(mesh) {
  /** @type {Map<string, {ends: Vector[], elements: number[]}>} */
  const joints = new Map();
  const names = namesOf(mesh);
  const { dimension, elements } = mesh;
  for (let element = 0; element < countOf(mesh); element += 1) {
    for (let k = 0; k < dimension; k += 1) {
      const ends = [elements[dimension * element + k], ...(dimension === 3 ? [elements[dimension * element + ((k + 1) % 3)]] : [])];
      const key = ends.map((end) => names[end]).sort((a, b) => a - b).join(" ");
      const joint = joints.get(key);
      if (joint) joint.elements.push(element);
      else joints.set(key, { ends: ends.map((end) => pointOf(mesh, end)), elements: [element] });
    }
  }
  return joints;
}

/** For each vertex the first one at its place. @param {Elements} mesh @returns {Uint32Array} */
function namesOf({ dimension, vertices }) {
  /** @type {Map<string, number>} */
  const first = new Map();
  return Uint32Array.from({ length: vertices.length / dimension }, (_, n) => {
    const key = vertices.subarray(dimension * n, dimension * (n + 1)).join(" ");
    const found = first.get(key);
    if (found === undefined) first.set(key, n);
    return found ?? n;
  });
}

/** Every edge once, six numbers each. @param {ReturnType<typeof jointsOf>} joints */
export const edgesOf = (joints) => [...joints.values()].flatMap(({ ends }) => (ends.length === 2 ? ends.flat() : []));

/**
 * The edges between elements of a set and others.
 * @param {ReturnType<typeof jointsOf>} joints
 * @param {(element: number) => boolean} isIn
 * @returns {number[]} six numbers an edge
 */
export function rimOf(joints, isIn) {
  const segments = [];
  for (const { ends, elements } of joints.values()) {
    const inside = elements.filter(isIn).length;
    if (ends.length === 2 && inside > 0 && inside < Math.max(2, elements.length)) segments.push(...ends.flat());
  }
  return segments;
}

/**
 * The patch round an element: what is reached from it over joints where the normals turn by no more than an angle.
 * @param {Elements} mesh
 * @param {ReturnType<typeof jointsOf>} joints
 * @param {number} start
 * @param {number} angle degrees
 * @returns {number[]} ascending
 */
export function grown(mesh, joints, start, angle) {
  /** @type {number[][]} */
  const neighbours = Array.from({ length: countOf(mesh) }, () => []);
  for (const { elements } of joints.values()) {
    for (const a of elements) for (const b of elements) if (a !== b) neighbours[a].push(b);
  }
  const least = Math.cos((Math.min(180, angle + 1e-7) * Math.PI) / 180);
  const normals = neighbours.map((_, element) => normalOf(mesh, element));
  const found = new Set([start]);
  const open = [start];
  for (let at = open.pop(); at !== undefined; at = open.pop()) {
    for (const next of neighbours[at]) {
      if (found.has(next) || dot(normals[at], normals[next]) < least) continue;
      found.add(next);
      open.push(next);
    }
  }
  return [...found].sort((a, b) => a - b);
}

/** Ascending numbers as runs from the first to the last of each. @param {readonly number[]} numbers @returns {[number, number][]} */
export function runsOf(numbers) {
  /** @type {[number, number][]} */
  const runs = [];
  for (const number of numbers) {
    const last = runs.at(-1);
    if (last && last[1] === number - 1) last[1] = number;
    else runs.push([number, number]);
  }
  return runs;
}
