/**
 * A solid as objects of a scene: surface and caps in the colours of the kernel, ruling lines, stages, curves, cuts and shadow.
 *
 * @import { Space } from "../space/space.js"
 * @import { Plane } from "../space/plane.js"
 * @import { SolidLayer, SolidUi, Whole } from "./state.js"
 *
 * @typedef {object} Cuts
 * @property {Plane | null} upTo
 * @property {Plane | null} section
 */
import { BufferAttribute, BufferGeometry, Mesh } from "three";
import { labsOf, plainColor, srgbOf } from "../space/colors.js";
import { Cut, cuttingPlanes } from "../space/cut.js";
import { Lines, segmentsOf, thinned } from "../space/lines.js";
import { cutOf } from "../space/plane.js";
import { Shadow } from "../space/shadow.js";
import { surfaceMaterial } from "../space/surface.js";
import { diagonalOf } from "../space/vector.js";

/** What lines and faces without a colour of their own look like. */
const COLORS = {
  light: { curve: "#17191d", paper: "#f6f6f7", ink: "#b3b7bf", line: "#17191d", cap: "#c9ccd2" },
  dark: { curve: "#f3f4f7", paper: "#1e2025", ink: "#6a707c", line: "#101216", cap: "#4a4e58" },
};
/** How far stages may be off, as a share of the diagonal: a quarter of a pixel. */
const THIN = 3e-4;
const NONE = { positions: [], values: [] };

export class Body {
  #planes = cuttingPlanes(2);
  #cuts = this.#planes.map((plane) => new Cut(plane, this.#planes));
  #attributes = new BufferGeometry();
  #surface = new Mesh(new BufferGeometry(), surfaceMaterial(this.#planes));
  #caps = new Mesh(new BufferGeometry(), surfaceMaterial(this.#planes, { isFlat: true }));
  #rulings = new Lines(this.#planes, { color: "#101216", width: 0.75, opacity: 0.5, order: 10 });
  #stages = new Lines(this.#planes, { color: "#ffffff", width: 1, opacity: 0.8, order: 11 });
  #curves = new Lines(this.#planes, { color: "#17191d", width: 2, order: 12 });
  #edges = new Lines(this.#planes, { color: "#101216", width: 0.5, opacity: 0.4, order: 9 });
  #shadow = new Shadow();
  /** @type {Whole | null} */
  #solid = null;
  /** @type {Float32Array} */
  #labs = new Float32Array(0);
  #hasEdges = false;

  /** @param {Space} space */
  constructor(space) {
    this.#surface.frustumCulled = false;
    this.#caps.frustumCulled = false;
    space.add(
      this.#shadow.object,
      this.#surface,
      this.#caps,
      ...[this.#edges, this.#rulings, this.#stages, this.#curves].map(({ object }) => object),
      ...this.#cuts.flatMap(({ objects }) => objects),
    );
  }

  /**
   * @param {Whole} solid
   * @param {boolean} isClosed whether its curves are
   * @param {Float32Array[]} stages the in-between curves that are shown
   */
  set(solid, isClosed, stages) {
    this.#solid = solid;
    this.#labs = labsOf(solid.colors);
    this.#attributes.dispose();
    this.#attributes = new BufferGeometry();
    this.#attributes.setAttribute("position", new BufferAttribute(solid.positions, 3));
    this.#attributes.setAttribute("normal", new BufferAttribute(solid.normals, 3));
    this.#attributes.setAttribute("lab", new BufferAttribute(this.#labs, 3));
    this.#attributes.setIndex(new BufferAttribute(solid.indices, 1));
    for (const cut of this.#cuts) cut.setBody(this.#attributes);
    for (const [mesh, name] of /** @type {const} */ ([[this.#surface, "surface"], [this.#caps, "cap"]])) {
      const groups = solid.groups.filter((group) => group.name === name);
      const start = groups[0]?.start ?? 0;
      mesh.geometry.dispose();
      mesh.geometry = new BufferGeometry();
      for (const each of ["position", "normal", "lab"]) mesh.geometry.setAttribute(each, this.#attributes.getAttribute(each));
      mesh.geometry.setIndex(this.#attributes.getIndex());
      mesh.geometry.setDrawRange(start, groups.reduce((sum, { count }) => sum + count, 0));
    }
    this.#rulings.set(solid.rulings);
    const tolerance = THIN * diagonalOf(solid.bounds);
    this.#stages.set(segmentsOf(stages.map((points) => thinned(points, tolerance)), isClosed));
    this.#curves.set(segmentsOf(solid.curves, isClosed));
    this.#hasEdges = false;
    this.#shadow.set(isClosed ? solid.curves : [], solid.bounds);
  }

  /** Whether a cut has a face: the body is closed, and its caps are shown. @param {SolidLayer[]} layers */
  hasFace = (layers) => this.#solid !== null && this.#solid.watertight && layers.includes("caps");

  /**
   * @param {Pick<SolidUi, "layers" | "color">} shown
   * @param {"light" | "dark"} theme
   * @param {Space} space
   */
  look({ layers, color }, theme, { pixelRatio, pixelDepth }) {
    const has = (/** @type {SolidLayer} */ layer) => layers.includes(layer);
    this.#rulings.show(has("rulings"));
    this.#stages.show(has("stages"));
    this.#curves.show(has("curves"));
    this.#caps.visible = has("caps");
    if (has("wireframe") && !this.#hasEdges && this.#solid) {
      this.#edges.set(edgesOf(this.#solid));
      this.#hasEdges = true;
    }
    this.#edges.show(has("wireframe"));
    for (const { material } of [this.#surface, this.#caps]) material.uniforms.lit.value = has("light") ? 1 : 0;
    // Ruling lines have angles, caps have none.
    const isPlain = color === "twist" || color === "flank";
    this.#caps.material.uniforms.plain.value = [...plainColor(COLORS[theme].cap), isPlain ? 1 : 0];
    for (const each of [this.#rulings, this.#stages, this.#curves, this.#edges, ...this.#cuts]) each.raise(pixelDepth);
    this.#curves.paint(COLORS[theme].curve);
    for (const cut of this.#cuts) cut.paint(COLORS[theme], pixelRatio);
  }

  /** @param {Cuts} cuts @param {SolidLayer[]} layers */
  cut({ upTo, section }, layers) {
    const solid = this.#solid;
    if (!solid) return;
    const hasCaps = layers.includes("caps");
    const end = hasCaps ? solid.indices.length : (solid.groups.find(({ name }) => name === "cap")?.start ?? solid.indices.length);
    [upTo, section].forEach((plane, i) => {
      const outline = plane ? cutOf(solid, plane, this.#labs, end) : NONE;
      const colors = outline.values.flatMap((_, k) => (k % 3 === 0 ? srgbOf(outline.values, k) : []));
      this.#cuts[i].set(plane, solid.bounds, { positions: outline.positions, values: colors }, this.hasFace(layers));
    });
  }

  /**
   * @param {boolean} isAbove whether the eye is above the ground
   * @param {boolean} isCut whether part of the body is taken away
   */
  stand(isAbove, isCut) {
    this.#shadow.show(isAbove, isCut);
  }

  dispose() {
    this.#attributes.dispose();
    for (const mesh of [this.#surface, this.#caps]) {
      mesh.geometry.dispose();
      mesh.material.dispose();
    }
    for (const lines of [this.#rulings, this.#stages, this.#curves, this.#edges]) lines.dispose();
    for (const cut of this.#cuts) cut.dispose();
    this.#shadow.dispose();
  }
}

/** Every edge of a mesh once, as segments. @param {Pick<Whole, "positions" | "indices">} mesh */
function edgesOf({ positions, indices }) {
  const count = positions.length / 3;
  /** @type {Set<number>} */
  const known = new Set();
  /** @type {number[]} */
  const segments = [];
  for (let k = 0; k < indices.length; k += 1) {
    const [a, b] = [indices[k], indices[k % 3 === 2 ? k - 2 : k + 1]];
    const key = Math.min(a, b) * count + Math.max(a, b);
    if (known.has(key)) continue;
    known.add(key);
    segments.push(...positions.subarray(3 * a, 3 * a + 3), ...positions.subarray(3 * b, 3 * b + 3));
  }
  return segments;
}
