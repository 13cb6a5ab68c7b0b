/**
 * A body as objects of a scene: its boundary, boundary curves and corners, the chosen cell, and the face that a plane cuts.
 *
 * @import { BodySection, BodySurface } from "../../../js/directrix.js"
 * @import { Space } from "../space/space.js"
 * @import { Plane } from "../space/plane.js"
 * @import { Bounds } from "../space/vector.js"
 */
import { BufferAttribute, BufferGeometry, Mesh } from "three";
import { cuttingPlanes, movePlane } from "../space/cut.js";
import { Lines } from "../space/lines.js";
import { Shadow } from "../space/shadow.js";
import { surfaceMaterial } from "../space/surface.js";
import { Dots } from "./dots.js";

/** Triangles above which no shadow is made, since it is painted from all of them. */
const MOST_SHADED = 30000;

export class BodyScene {
  #planes = cuttingPlanes(1);
  #surface = new Mesh(new BufferGeometry(), surfaceMaterial(this.#planes));
  #face = new Mesh(new BufferGeometry(), surfaceMaterial([], { isFlat: true }));
  #edges = new Lines(this.#planes, { color: "#101216", width: 0.9, opacity: 0.5, order: 10 });
  #outline = new Lines([], { color: "#101216", width: 1.9, order: 12 });
  #halo = new Lines([], { color: "#ffffff", width: 5, order: 20 });
  #cell = new Lines([], { color: "#4a45c8", width: 2.5, order: 21 });
  #dots = new Dots(this.#planes, 15);
  #shadow = new Shadow();

  /** @param {Space} space */
  constructor(space) {
    for (const mesh of [this.#surface, this.#face]) mesh.frustumCulled = false;
    this.#face.material.uniforms.lit.value = 0;
    // The frame of the plane lies in the face itself, which is to be seen as it is.
    Object.assign(this.#face.material, { polygonOffset: true, polygonOffsetFactor: -1, polygonOffsetUnits: -4 });
    const lines = [this.#edges, this.#outline, this.#halo, this.#cell].map(({ object }) => object);
    space.add(this.#shadow.object, this.#surface, this.#face, ...lines, this.#dots.object);
  }

  /** @param {BodySurface} surface @param {Bounds} bounds */
  set(surface, bounds) {
    const { geometry } = this.#surface;
    geometry.dispose();
    this.#surface.geometry = meshOf(surface, surface.normals);
    this.#edges.set(segmentsAlong(surface));
    this.#dots.set(new Float32Array(surface.corners.flatMap(({ position }) => position)));
    this.#shadow.set(surface.indices.length > 3 * MOST_SHADED ? [] : shade(surface), bounds);
  }

  /** @param {Float32Array} labs of the surface */
  paintSurface(labs) {
    this.#surface.geometry.setAttribute("lab", new BufferAttribute(labs, 3));
  }

  /**
   * The cut and its face, which belong together.
   * @param {Plane | null} plane null to cut nothing
   * @param {BodySection | null} section
   */
  cut(plane, section) {
    movePlane(this.#planes[0], plane);
    this.#face.visible = section !== null;
    this.#face.geometry.dispose();
    this.#face.geometry = section ? meshOf(section) : new BufferGeometry();
    this.#outline.set(section ? Array.from(section.outline).flatMap((vertex) => [...section.positions.subarray(3 * vertex, 3 * vertex + 3)]) : []);
  }

  /** @param {Float32Array} labs of the face */
  paintFace(labs) {
    this.#face.geometry.setAttribute("lab", new BufferAttribute(labs, 3));
  }

  /** Marks a cell by its boundary curves. @param {number[]} segments none for no cell */
  choose(segments) {
    this.#halo.set(segments);
    this.#cell.set(segments);
  }

  /**
   * @param {{edges: boolean, corners: boolean, light: boolean}} shown
   * @param {"light" | "dark"} theme
   * @param {Space} space
   */
  look({ edges, corners, light }, theme, { pixelRatio, pixelDepth }) {
    this.#edges.show(edges);
    this.#dots.show(corners);
    this.#surface.material.uniforms.lit.value = light ? 1 : 0;
    this.#cell.paint(theme === "dark" ? "#a8a4ff" : "#4a45c8");
    this.#halo.paint(theme === "dark" ? "#0e0f12" : "#ffffff");
    for (const lines of [this.#edges, this.#outline, this.#halo, this.#cell]) lines.raise(pixelDepth);
    this.#dots.raise(pixelDepth, pixelRatio);
  }

  /** @param {boolean} isAbove whether the eye is above the ground @param {boolean} isCut whether part of the body is taken away */
  stand(isAbove, isCut) {
    this.#shadow.show(isAbove, isCut);
  }

  dispose() {
    for (const mesh of [this.#surface, this.#face]) {
      mesh.geometry.dispose();
      mesh.material.dispose();
    }
    for (const lines of [this.#edges, this.#outline, this.#halo, this.#cell]) lines.dispose();
    this.#dots.dispose();
    this.#shadow.dispose();
  }
}

/** @param {{positions: Float32Array, indices: Uint32Array}} mesh @param {Float32Array} [normals] */
function meshOf({ positions, indices }, normals) {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(positions, 3));
  if (normals) geometry.setAttribute("normal", new BufferAttribute(normals, 3));
  geometry.setIndex(new BufferAttribute(indices, 1));
  return geometry;
}

/** The boundary curves as separate segments. @param {Pick<BodySurface, "edges" | "edgePositions">} surface */
export function segmentsAlong({ edges, edgePositions }) {
  /** @type {number[]} */
  const segments = [];
  for (const { start, count } of edges) {
    for (let n = start; n + 1 < start + count; n += 1) segments.push(...edgePositions.subarray(3 * n, 3 * n + 6));
  }
  return segments;
}

/** What the body covers from above: the triangles that look up. @param {BodySurface} surface */
function shade({ positions, indices }) {
  /** @type {Float32Array[]} */
  const triangles = [];
  for (let k = 0; k < indices.length; k += 3) {
    const [a, b, c] = [3 * indices[k], 3 * indices[k + 1], 3 * indices[k + 2]];
    const area = (positions[b] - positions[a]) * (positions[c + 1] - positions[a + 1]) - (positions[c] - positions[a]) * (positions[b + 1] - positions[a + 1]);
    if (area > 0) triangles.push(new Float32Array([a, b, c].flatMap((at) => [...positions.subarray(at, at + 3)])));
  }
  return triangles;
}
