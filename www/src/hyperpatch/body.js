/**
 * A body as objects of a scene, few however many cells it has: its faces, boundary curves and corners, how its cells continue each
 * other, the chosen cell, and the face that a plane cuts.
 *
 * @import { BodySection, BodySharing, BodySurface } from "../../../js/directrix.js"
 * @import { Space } from "../space/space.js"
 * @import { Plane } from "../space/plane.js"
 * @import { Bounds, Vector } from "../space/vector.js"
 * @import { Shifts } from "./apart.js"
 * @import { Joints } from "./joints.js"
 */
import { BufferAttribute, BufferGeometry, DoubleSide, FrontSide, Mesh } from "three";
import { cuttingPlanes, movePlane } from "../space/cut.js";
import { Lines } from "../space/lines.js";
import { Shadow } from "../space/shadow.js";
import { surfaceMaterial } from "../space/surface.js";
import { add, dot, scaled } from "../space/vector.js";
import { shiftOf, shiftsAlong } from "./apart.js";
import { Dots } from "./dots.js";

/** Triangles above which no shadow is made, since it is painted from all of them. */
const MOST_SHADED = 30000;
/** What of the body stays to be seen where it is most transparent. */
const FAINTEST = 0.1;
/** How dark the boundary curves are, and on what they are light. */
const INK = "#101216";
const PALE = "#f3f4f7";

/**
 * @typedef {object} Drawn A body to be drawn.
 * @property {BodySurface} surface its faces: those of its boundary come first
 * @property {BodySharing} sharing
 * @property {Shifts} shifts
 * @property {number[]} empty indices of materials that are void
 */

export class BodyScene {
  #planes = cuttingPlanes(1);
  /** @type {import("../space/surface.js").Apart} */
  #apart = { value: 0 };
  #surface = new Mesh(new BufferGeometry(), surfaceMaterial(this.#planes, { apart: this.#apart }));
  #face = new Mesh(new BufferGeometry(), surfaceMaterial([], { isFlat: true, apart: this.#apart }));
  #edges = new Lines(this.#planes, { color: INK, width: 0.9, opacity: 0.5, order: 10, apart: this.#apart });
  #joints = new Lines(this.#planes, { width: 2, order: 11, apart: this.#apart });
  #under = new Lines(this.#planes, { color: "#ffffff", width: 4.5, opacity: 0.85, order: 10.5, apart: this.#apart });
  #outline = new Lines([], { color: INK, width: 1.9, order: 12, apart: this.#apart });
  #halo = new Lines([], { color: "#ffffff", width: 5, order: 20, apart: this.#apart });
  #cell = new Lines([], { color: "#4a45c8", width: 2.5, order: 21, apart: this.#apart });
  #wrong = new Lines([], { color: "#b3261e", width: 2.5, order: 22, apart: this.#apart });
  #dots = new Dots(this.#planes, 15, this.#apart);
  #shadow = new Shadow();
  /** @type {Drawn | null} */
  #drawn = null;
  /** Faces of the boundary among those of the surface, and the middle of each. */
  #outer = 0;
  /** @type {Vector[]} */
  #middles = [];
  #order = "";
  /** @type {Joints | null} */
  #joined = null;
  #isApart = false;

  /** @param {Space} space */
  constructor(space) {
    for (const mesh of [this.#surface, this.#face]) mesh.frustumCulled = false;
    this.#face.material.uniforms.lit.value = 0;
    this.#face.visible = false;
    // The frame of the plane lies in the face itself, which is to be seen as it is.
    Object.assign(this.#face.material, { polygonOffset: true, polygonOffsetFactor: -1, polygonOffsetUnits: -4 });
    space.add(this.#shadow.object, this.#surface, this.#face, ...this.#lines.map(({ object }) => object), this.#dots.object);
  }

  get #lines() {
    return [this.#edges, this.#under, this.#joints, this.#outline, this.#halo, this.#cell, this.#wrong];
  }

  /** @param {Drawn} drawn @param {Bounds} bounds */
  set(drawn, bounds) {
    const { surface, sharing, shifts, empty } = drawn;
    this.#drawn = drawn;
    this.#surface.geometry.dispose();
    this.#surface.geometry = meshOf(surface, shifts, empty, surface.normals);
    const inner = new Set(sharing.faces.filter(({ sides }) => sides.length > 1).flatMap(({ sides }) => sides.map(({ cell, face }) => `${cell} ${face}`)));
    const first = surface.patches.findIndex(({ cell, face }) => inner.has(`${cell} ${face}`));
    this.#outer = first < 0 ? surface.patches.length : first;
    this.#middles = surface.patches.map(({ vertexStart, vertexCount }) => middleOf(surface.positions, vertexStart, vertexCount));
    this.#order = "";
    this.#joined = null;
    this.#trace();
    const { length } = surface.indices;
    this.#shadow.set(length > 3 * MOST_SHADED ? [] : shade(surface), bounds);
  }

  /** Where the indices of the boundary end among those of the surface. */
  get end() {
    const patch = this.#drawn?.surface.patches[this.#outer - 1];
    return patch ? patch.start + patch.count : 0;
  }

  /** Boundary curves and corners: each once, or of every cell where they are drawn apart. */
  #trace() {
    const drawn = this.#drawn;
    if (!drawn) return;
    const { surface, sharing, shifts } = drawn;
    const sides = new Map(!this.#isApart ? [] : sharing.edges.flatMap((edge) => edge.sides.map((side) => [edgeKey(side), edge.sides])));
    /** @type {number[]} */
    const segments = [];
    /** @type {number[]} */
    const moved = [];
    for (const edge of surface.edges) {
      const users = this.#isApart ? (sides.get(edgeKey(edge)) ?? [edge]) : [edge];
      for (const { cell } of users) {
        const by = shiftOf(shifts, cell);
        for (let n = edge.start; n + 1 < edge.start + edge.count; n += 1) {
          segments.push(...surface.edgePositions.subarray(3 * n, 3 * n + 6));
          moved.push(...by);
        }
      }
    }
    this.#edges.set(segments, undefined, moved);
    this.mark(this.#joined);
  }

  /** @param {Float32Array} labs of the surface */
  paintSurface(labs) {
    this.#surface.geometry.setAttribute("lab", new BufferAttribute(labs, 3));
  }

  /** How cells continue each other, by lines and by the signs of corners. @param {Joints | null} joints null to show corners alone */
  mark(joints) {
    this.#joined = joints;
    const drawn = this.#drawn;
    if (!drawn) return;
    const all = joints ? joints.lines.filter(({ isFirst }) => this.#isApart || isFirst) : [];
    const shiftsAt = (/** @type {number} */ cell) => [...shiftOf(drawn.shifts, cell)];
    const points = all.flatMap((line) => line.points);
    const shifts = all.flatMap(({ cell }) => shiftsAt(cell));
    this.#joints.set(points, all.flatMap(({ color }) => [...color, ...color]), shifts);
    this.#under.set(points, undefined, shifts);
    const corners = cornersOf(drawn, this.#isApart);
    this.#dots.set(
      corners.flatMap(({ position }) => position),
      corners.flatMap(({ cell }) => shiftsAt(cell)),
      corners.map(({ nth }) => joints?.signs[nth] ?? 0),
    );
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
    const drawn = this.#drawn;
    this.#face.geometry = section && drawn ? meshOf(section, drawn.shifts, drawn.empty) : new BufferGeometry();
    const vertices = section ? Array.from(section.outline) : [];
    this.#outline.set(
      vertices.flatMap((vertex) => [...(section?.positions.subarray(3 * vertex, 3 * vertex + 3) ?? [])]),
      undefined,
      vertices.flatMap((vertex, n) => (n % 2 === 0 && drawn ? [...shiftOf(drawn.shifts, section?.cells[vertex] ?? -1)] : [])),
    );
  }

  /** @param {Float32Array} labs of the face */
  paintFace(labs) {
    this.#face.geometry.setAttribute("lab", new BufferAttribute(labs, 3));
  }

  /**
   * Marks cells and faces by their boundary curves.
   * @param {{cell: number, segments: number[]}[]} chosen
   * @param {{cell: number, segments: number[]}[]} wrong those that are invalid
   */
  choose(chosen, wrong) {
    const set = (/** @type {Lines[]} */ all, /** @type {typeof chosen} */ marked) => {
      const segments = marked.flatMap((each) => each.segments);
      const shifts = marked.flatMap((each) => Array.from({ length: each.segments.length / 6 }, () => shiftOf(this.#drawn?.shifts ?? new Map(), each.cell)).flat());
      for (const lines of all) lines.set(segments, undefined, shifts);
    };
    set([this.#halo], [...chosen, ...wrong]);
    set([this.#cell], chosen);
    set([this.#wrong], wrong);
  }

  /**
   * @param {{edges: boolean, corners: boolean, light: boolean, apart: number, transparency: number}} shown
   * @param {Vector} back from the body to the eye
   * @param {"light" | "dark"} theme
   * @param {Space} space
   */
  look({ edges, corners, light, apart, transparency }, back, theme, { pixelRatio, pixelDepth }) {
    this.#apart.value = apart;
    if (apart > 0 !== this.#isApart) {
      this.#isApart = apart > 0;
      this.#trace();
    }
    const { material } = this.#surface;
    const isClear = transparency > 0;
    material.uniforms.opacity.value = 1 - transparency * (1 - FAINTEST);
    if (material.transparent !== isClear) {
      Object.assign(material, { transparent: isClear, depthWrite: !isClear });
      material.needsUpdate = true;
    }
    // Of whole cells no more than the side towards the eye is seen.
    const isWhole = !isClear && !this.#face.visible && this.#drawn?.empty.length === 0;
    const side = isWhole && apart > 0 ? FrontSide : DoubleSide;
    if (material.side !== side) Object.assign(material, { side, needsUpdate: true });
    this.#arrange(isClear ? back : apart > 0 ? scaled(back, -1) : null);
    this.#edges.show(edges);
    this.#dots.show(corners);
    material.uniforms.lit.value = light ? 1 : 0;
    for (const mesh of [this.#surface, this.#face]) mesh.material.uniforms.pixelRatio.value = pixelRatio;
    this.#edges.paint(theme === "dark" && transparency > 0.4 ? PALE : INK);
    this.#cell.paint(theme === "dark" ? "#a8a4ff" : "#4a45c8");
    this.#wrong.paint(theme === "dark" ? "#ff8d85" : "#b3261e");
    this.#halo.paint(theme === "dark" ? "#0e0f12" : "#ffffff");
    for (const lines of this.#lines) lines.raise(pixelDepth);
    this.#dots.raise(pixelDepth, pixelRatio);
  }

  /**
   * Faces in the order of drawing: where they are seen through, from the farthest to the nearest; of many cells that hide each other the
   * other way, so that little is coloured in vain.
   * @param {Vector | null} along the direction in which they follow each other; null for any
   */
  #arrange(along) {
    const drawn = this.#drawn;
    if (!drawn) return;
    const { value: apart } = this.#apart;
    const key = JSON.stringify([along, apart > 0, along && apart]);
    if (key === this.#order) return;
    this.#order = key;
    const { surface, shifts } = drawn;
    const patches = surface.patches.slice(0, this.#isApart ? undefined : this.#outer);
    const places = patches.map((patch, n) => ({ patch, depth: along ? dot(add(this.#middles[n], scaled(shiftOf(shifts, patch.cell), apart)), along) : n }));
    if (along) places.sort((a, b) => a.depth - b.depth);
    const index = this.#surface.geometry.getIndex();
    if (!index) return;
    let end = 0;
    for (const { patch } of places) {
      /** @type {Uint32Array} */ (index.array).set(surface.indices.subarray(patch.start, patch.start + patch.count), end);
      end += patch.count;
    }
    index.needsUpdate = true;
    this.#surface.geometry.setDrawRange(0, end);
  }

  /** @param {boolean} isAbove whether the eye is above the ground @param {boolean} isThin whether part of the body is taken away or seen through */
  stand(isAbove, isThin) {
    this.#shadow.show(isAbove && !this.#isApart, isThin);
  }

  dispose() {
    for (const mesh of [this.#surface, this.#face]) {
      mesh.geometry.dispose();
      mesh.material.dispose();
    }
    for (const lines of this.#lines) lines.dispose();
    this.#dots.dispose();
    this.#shadow.dispose();
  }
}

/**
 * Corners as they are drawn: each once, or of every cell where they are drawn apart.
 * @param {Pick<Drawn, "surface" | "sharing">} drawn
 * @param {boolean} isApart
 * @returns {{nth: number, cell: number, corner: readonly number[], position: Vector}[]} `nth`: among the shared corners
 */
export function cornersOf({ surface, sharing }, isApart) {
  const shown = new Set(surface.corners.map(cornerKey));
  return sharing.corners.flatMap(({ position, sides }, nth) => {
    if (!sides.some((side) => shown.has(cornerKey(side)))) return [];
    return (isApart ? sides : sides.slice(0, 1)).map(({ cell, corner }) => ({ nth, cell, corner, position: /** @type {Vector} */ (position) }));
  });
}

/** @param {{cell: number, corner: readonly number[]}} side */
const cornerKey = ({ cell, corner }) => `${cell} ${corner.join("")}`;

/** @param {{cell: number, axis: string, ends: readonly number[]}} side */
const edgeKey = ({ cell, axis, ends }) => `${cell} ${axis}${ends.join("")}`;

/**
 * @param {{positions: Float32Array, indices: Uint32Array, cells: Uint32Array, fractions: Float32Array}} mesh
 * @param {Shifts} shifts
 * @param {number[]} empty indices of materials
 * @param {Float32Array} [normals]
 */
function meshOf({ positions, indices, cells, fractions }, shifts, empty, normals) {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(positions, 3));
  if (normals) geometry.setAttribute("normal", new BufferAttribute(normals, 3));
  geometry.setAttribute("shift", new BufferAttribute(shiftsAlong(cells, shifts), 3));
  const materials = cells.length > 0 ? fractions.length / cells.length : 0;
  const nothing = Float32Array.from(cells, (_, n) => empty.reduce((sum, material) => sum + fractions[n * materials + material], 0));
  geometry.setAttribute("empty", new BufferAttribute(nothing, 1));
  geometry.setIndex(new BufferAttribute(indices.slice(), 1));
  return geometry;
}

/** The mean of some vertices. @param {Float32Array} positions @param {number} start @param {number} count @returns {Vector} */
function middleOf(positions, start, count) {
  /** @type {Vector} */
  const sum = [0, 0, 0];
  for (let n = start; n < start + count; n += 1) {
    for (const k of /** @type {const} */ ([0, 1, 2])) sum[k] += positions[3 * n + k] / count;
  }
  return sum;
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
