/**
 * What a figure of a boundary value problem shows, as meshes for the painter of bodies: the boundary in the colours of its conditions, and the solution on the
 * plane of the section, or of a problem in the plane on the whole of it.
 *
 * @import { Control, LaplaceBoundary, Material, RemoteLaplaceSolution } from "../../directrix.js"
 * @import { Bounds, Vector } from "../../space/vector.js"
 * @import { Cut, Shape } from "../body/picture.js"
 * @import { Plane } from "../body/raster.js"
 */
import { labsOf, plainColor } from "../../space/colors.js";
import { add, cornersOf, cross, dot, scaled, subtract, unit } from "../../space/vector.js";

/** Oklab of an element with a given flux, and of one without any condition. */
const GREY = [0.82, 0, 0];
const NONE = [0.93, 0, 0];

/** Colours of materials in Oklab. @param {readonly Pick<Material, "color">[]} materials */
const labsOfMaterials = (materials) => {
  const labs = labsOf(Uint8Array.from(materials.flatMap(({ color }) => [...plainColor(color).map((channel) => Math.round(255 * channel)), 255])));
  return materials.map((_, k) => [...labs.subarray(3 * k, 3 * k + 3)]);
};

/** The mean in Oklab. @param {number[][]} labs @param {(material: number) => number} fraction */
const mixed = (labs, fraction) => [0, 1, 2].map((channel) => labs.reduce((sum, lab, material) => sum + Math.min(1, Math.max(0, fraction(material))) * lab[channel], 0));

/** A corner of an element; in the plane z is 0. @param {LaplaceBoundary} boundary @param {number} element @param {number} k @returns {Vector} */
function cornerOf({ dimension, elements, vertices }, element, k) {
  const at = dimension * elements[dimension * element + k];
  return [vertices[at], vertices[at + 1], dimension === 3 ? vertices[at + 2] : 0];
}

/** @param {LaplaceBoundary} boundary @returns {Bounds} */
function boundsOf({ dimension, vertices }) {
  /** @type {Bounds} */
  const bounds = { min: [Infinity, Infinity, 0], max: [-Infinity, -Infinity, 0] };
  if (dimension === 3) [bounds.min[2], bounds.max[2]] = [Infinity, -Infinity];
  for (let n = 0; n < vertices.length; n += 1) {
    const axis = n % dimension;
    bounds.min[axis] = Math.min(bounds.min[axis], vertices[n]);
    bounds.max[axis] = Math.max(bounds.max[axis], vertices[n]);
  }
  return bounds;
}

/**
 * The boundary: triangles in the colours of their conditions, or in the plane lines.
 *
 * @param {LaplaceBoundary} boundary
 * @param {readonly Pick<Material, "color">[]} materials
 * @returns {Shape}
 */
export function shapeOf(boundary, materials) {
  const { dimension, elements, groups, conditions } = boundary;
  const count = elements.length / dimension;
  const own = labsOfMaterials(materials);
  const given = conditions.map((condition) => ("value" in condition ? mixed(own, (material) => condition.value[material]) : GREY));
  const isFlat = dimension === 2;
  const size = isFlat ? 0 : 9 * count;
  const [positions, normals, labs] = [new Float32Array(size), new Float32Array(size), new Float32Array(size)];
  const edgePositions = new Float32Array(isFlat ? 6 * count : 0);
  for (let element = 0; element < count; element += 1) {
    const corners = Array.from({ length: dimension }, (_, k) => cornerOf(boundary, element, k));
    if (isFlat) {
      edgePositions.set(corners.flat(), 6 * element);
      continue;
    }
    const normal = unit(cross(subtract(corners[1], corners[0]), subtract(corners[2], corners[0])));
    for (let k = 0; k < 3; k += 1) {
      positions.set(corners[k], 9 * element + 3 * k);
      normals.set(normal, 9 * element + 3 * k);
      labs.set(given[groups[element]] ?? NONE, 9 * element + 3 * k);
    }
  }
  const surface = {
    positions,
    normals,
    indices: Uint32Array.from({ length: size / 3 }, (_, k) => k),
    edges: Array.from({ length: edgePositions.length / 6 }, (_, k) => ({ start: 2 * k, count: 2 })),
    edgePositions,
    corners: [],
  };
  return { surface: /** @type {any} */ (surface), labs, bounds: boundsOf(boundary) };
}

/** The plane that a document cuts by, its normal towards what is kept; null without one. @param {{ section?: { origin: readonly number[], normal: readonly number[] } }} document @returns {Plane | null} */
export function planeOf({ section }) {
  if (!section) return null;
  const normal = unit(/** @type {Vector} */ (section.normal));
  return { normal, offset: dot(normal, /** @type {Vector} */ (section.origin)) };
}

/**
 * The solution on a plane, or on the whole of a problem in the plane: a square for each pixel inside, and the line in which the plane cuts the boundary.
 *
 * @param {RemoteLaplaceSolution} solution
 * @param {object} of
 * @param {LaplaceBoundary} of.boundary
 * @param {readonly Pick<Material, "color">[]} of.materials
 * @param {Plane | null} of.plane null in the plane
 * @param {number} longest pixels along the longer side
 * @param {Control} control
 * @returns {Promise<Cut>}
 */
export async function faceOf(solution, { boundary, materials, plane }, longest, control) {
  const bounds = boundsOf(boundary);
  const { normal, offset } = plane ?? { normal: [0, 0, 1], offset: 0 };
  const along = /** @type {Vector} */ (normal);
  const axes = plane ? axesOf(along) : /** @type {[Vector, Vector]} */ ([[1, 0, 0], [0, 1, 0]]);
  const reach = axes.map((axis) => {
    const offsets = cornersOf(bounds).map((corner) => dot(axis, corner));
    return [Math.min(...offsets), Math.max(...offsets)];
  });
  const origin = add(scaled(along, offset), add(scaled(axes[0], reach[0][0]), scaled(axes[1], reach[1][0])));
  const lengths = reach.map(([low, high]) => high - low);
  const sides = axes.map((axis, k) => scaled(axis, lengths[k]));
  const pixel = Math.max(...lengths) / longest;
  const size = /** @type {[number, number]} */ (lengths.map((length) => Math.min(longest, Math.max(1, Math.round(length / pixel)))));
  const own = (/** @type {readonly number[]} */ vector) => vector.slice(0, boundary.dimension);
  const found = await solution.section({ origin: own(origin), sides: [own(sides[0]), own(sides[1])], size }, control);
  const labs = labsOfMaterials(materials);
  /** @type {{ positions: number[], labs: number[], indices: number[], outline: number[] }} */
  const face = { positions: [], labs: [], indices: [], outline: [] };
  for (let n = 0; n < size[0] * size[1]; n += 1) {
    if (Number.isNaN(found.values[0][n])) continue;
    const [i, j] = [n % size[0], Math.floor(n / size[0])];
    const first = face.positions.length / 3;
    const lab = mixed(labs, (material) => found.values[material][n]);
    for (const [u, v] of [[i, j], [i + 1, j], [i + 1, j + 1], [i, j + 1]]) {
      face.positions.push(...add(origin, add(scaled(sides[0], u / size[0]), scaled(sides[1], v / size[1]))));
      face.labs.push(...lab);
    }
    face.indices.push(first, first + 1, first + 2, first, first + 2, first + 3);
  }
  for (const point of plane ? lineOf(boundary, along, offset) : endsOf(boundary)) {
    face.outline.push(face.positions.length / 3);
    face.positions.push(...point);
    face.labs.push(0, 0, 0);
  }
  const section = { positions: Float32Array.from(face.positions), indices: Uint32Array.from(face.indices), outline: Uint32Array.from(face.outline) };
  return { plane: { normal, offset }, section: /** @type {any} */ (section), labs: Float32Array.from(face.labs) };
}

/** Two directions that make a right-handed frame with a normal. @param {Vector} normal @returns {[Vector, Vector]} */
function axesOf(normal) {
  const right = unit(cross(Math.abs(normal[2]) < 0.9 ? [0, 0, 1] : [0, 1, 0], normal));
  return [right, cross(normal, right)];
}

/** The ends of the segments of a boundary in the plane. @param {LaplaceBoundary} boundary */
const endsOf = (boundary) => Array.from({ length: boundary.elements.length }, (_, k) => cornerOf(boundary, Math.floor(k / 2), k % 2));

/** The ends of the segments in which a plane cuts triangles. @param {LaplaceBoundary} boundary @param {Vector} normal @param {number} offset */
function lineOf(boundary, normal, offset) {
  /** @type {Vector[]} */
  const ends = [];
  for (let element = 0; element < boundary.elements.length / 3; element += 1) {
    const corners = [0, 1, 2].map((k) => cornerOf(boundary, element, k));
    const heights = corners.map((corner) => dot(normal, corner) - offset);
    for (let k = 0; k < 3; k += 1) {
      const [a, b] = [heights[k], heights[(k + 1) % 3]];
      if (a >= 0 !== b >= 0) ends.push(add(corners[k], scaled(subtract(corners[(k + 1) % 3], corners[k]), a / (a - b))));
    }
  }
  return ends;
}
