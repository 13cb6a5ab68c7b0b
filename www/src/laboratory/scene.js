/**
 * A boundary as objects of a scene: its elements, their edges, the face of the section, what is chosen and what is wrong.
 *
 * @import { Space } from "../space/space.js"
 * @import { Plane } from "../space/plane.js"
 * @import { FaceFrame } from "./section-state.js"
 * @import { Mesh } from "./state.js"
 */
import { BufferAttribute, BufferGeometry, Mesh as Drawn } from "three";
import { Cut, cuttingPlanes } from "../space/cut.js";
import { Lines } from "../space/lines.js";
import { cutOf } from "../space/plane.js";
import { Shadow } from "../space/shadow.js";
import { elementMaterial, FaceLook } from "./looks.js";
import { edgesOf } from "./mesh.js";

/** What lines and the empty face look like. */
const COLORS = {
  light: { paper: "#ebecee", ink: "#b3b7bf", line: "#101216", accent: "#4a45c8", halo: "#ffffff", error: "#b3261e" },
  dark: { paper: "#24272d", ink: "#6a707c", line: "#101216", accent: "#a8a4ff", halo: "#0e0f12", error: "#ff8d85" },
};

export class LaboratoryScene {
  #planes = cuttingPlanes(1);
  #face = new FaceLook();
  #cut = new Cut(this.#planes[0], this.#planes, this.#face.material);
  #surface = new Drawn(new BufferGeometry(), elementMaterial(this.#planes));
  #edges = new Lines(this.#planes, { color: "#101216", width: 0.75, opacity: 0.32, order: 9 });
  #isolines = new Lines([], { color: "#000000", width: 1, opacity: 0.55, order: 22 });
  #halo = new Lines(this.#planes, { color: "#ffffff", width: 5, order: 23 });
  #chosen = new Lines(this.#planes, { color: "#4a45c8", width: 2.5, order: 24 });
  #wrong = new Lines([], { color: "#b3261e", width: 2.5, order: 25 });
  #shadow = new Shadow();
  /** @type {Mesh | null} */
  #mesh = null;
  #hasEdges = false;

  /** @param {Space} space */
  constructor(space) {
    this.#surface.frustumCulled = false;
    space.add(this.#shadow.object, this.#surface, ...this.#lines.map(({ object }) => object), ...this.#cut.objects);
  }

  get #lines() {
    return [this.#edges, this.#isolines, this.#halo, this.#chosen, this.#wrong];
  }

  /** @param {Mesh} mesh of a problem in space */
  set(mesh) {
    const { soup, bounds } = mesh;
    this.#mesh = mesh;
    this.#hasEdges = false;
    this.#surface.geometry.dispose();
    const geometry = (this.#surface.geometry = new BufferGeometry());
    if (!soup) return;
    geometry.setAttribute("position", new BufferAttribute(soup.positions, 3));
    geometry.setAttribute("normal", new BufferAttribute(soup.normals, 3));
    this.#cut.setBody(geometry);
    this.#edges.set([]);
    this.#shadow.set(facesAbove(soup), bounds);
  }

  /** @param {Float32Array} labs three numbers a corner @param {Float32Array} hatched one a corner, 1 where the element is hatched */
  paint(labs, hatched) {
    this.#surface.geometry.setAttribute("lab", new BufferAttribute(labs, 3));
    this.#surface.geometry.setAttribute("hatched", new BufferAttribute(hatched, 1));
  }

  /** @param {Plane | null} plane null to cut nothing */
  cut(plane) {
    const mesh = this.#mesh;
    if (!mesh?.soup) return;
    const outline = plane ? cutOf(mesh.soup, plane, new Float32Array(mesh.soup.positions.length)).positions : [];
    this.#cut.set(plane, mesh.bounds, { positions: outline, values: [] }, true);
    if (!plane) this.face(null);
  }

  /** @param {{pixels: Uint8ClampedArray, size: [number, number], frame: FaceFrame} | null} picture */
  face(picture) {
    if (picture) this.#face.set(picture.pixels, picture.size, picture.frame);
    else this.#face.clear();
  }

  /** @param {number[]} segments six numbers each */
  isolines(segments) {
    this.#isolines.set(segments);
  }

  /** @param {number[]} chosen rim of the chosen group @param {number[]} wrong that of elements at fault */
  mark(chosen, wrong) {
    this.#halo.set([...chosen, ...wrong]);
    this.#chosen.set(chosen);
    this.#wrong.set(wrong);
  }

  /**
   * @param {{edges: boolean, light: boolean}} shown
   * @param {"light" | "dark"} theme
   * @param {Space} space
   */
  look({ edges, light }, theme, { pixelRatio, pixelDepth }) {
    const colors = COLORS[theme];
    const { uniforms } = this.#surface.material;
    uniforms.lit.value = light ? 1 : 0;
    uniforms.pixelRatio.value = pixelRatio;
    if (edges && !this.#hasEdges && this.#mesh) {
      this.#edges.set(edgesOf(this.#mesh.joints));
      this.#hasEdges = true;
    }
    this.#edges.show(edges);
    for (const lines of [...this.#lines, this.#cut]) lines.raise(pixelDepth);
    this.#cut.paint(colors, pixelRatio);
    this.#chosen.paint(colors.accent);
    this.#halo.paint(colors.halo);
    this.#wrong.paint(colors.error);
  }

  /** @param {boolean} isAbove whether the eye is above the ground @param {boolean} isCut whether part of the body is taken away */
  stand(isAbove, isCut) {
    this.#shadow.show(isAbove, isCut);
  }

  dispose() {
    this.#surface.geometry.dispose();
    this.#surface.material.dispose();
    for (const lines of this.#lines) lines.dispose();
    this.#cut.dispose();
    this.#face.dispose();
    this.#shadow.dispose();
  }
}

/** The triangles that look up, as outlines wound the same way. @param {import("./mesh.js").Soup} soup */
function facesAbove({ positions, normals }) {
  /** @type {Float32Array[]} */
  const found = [];
  for (let k = 0; k < positions.length; k += 9) if (normals[k + 2] > 0) found.push(positions.subarray(k, k + 9));
  return found;
}
