/**
 * Lines of a width in pixels, as separate segments or as polylines, which planes cut as they cut surfaces.
 *
 * @import { Plane as ClippingPlane } from "three"
 *
 * @typedef {object} LineLook
 * @property {string} [color] CSS; without it the segments have colours of their own
 * @property {number} width CSS pixels
 * @property {number} [opacity]
 * @property {number} order lines of a higher one are drawn over those of a lower
 * @property {import("./surface.js").Apart} [apart] the segments belong to cells that are drawn apart
 */
import { BufferAttribute, BufferGeometry, InterleavedBuffer, InterleavedBufferAttribute, Mesh, ShaderMaterial, Vector2 } from "three";
import { plainColor } from "./colors.js";
import { dot, scaled, subtract } from "./vector.js";

const VERTEX = /* glsl */ `
#include <clipping_planes_pars_vertex>
attribute vec2 corner;
attribute vec3 from;
attribute vec3 to;
attribute vec3 fromColor;
attribute vec3 toColor;
#ifdef IN_CELLS
attribute vec3 shift;
uniform float apart;
#endif
uniform vec2 size;
uniform float width;
uniform float nearer;
varying vec3 vColor;
varying vec2 vOver;
varying float vLength;
void main() {
  vColor = mix(fromColor, toColor, corner.x);
  vec4 a = modelViewMatrix * vec4(from, 1.0);
  vec4 b = modelViewMatrix * vec4(to, 1.0);
  // What is behind the eye has no place in the picture: such a line begins before it.
  float nearest = projectionMatrix[3][2] / (1.0 - projectionMatrix[2][2]);
  if (a.z > nearest && b.z < nearest) a = mix(a, b, (a.z - nearest) / (a.z - b.z));
  else if (b.z > nearest && a.z < nearest) b = mix(b, a, (b.z - nearest) / (b.z - a.z));
  vec4 mvPosition = corner.x < 0.5 ? a : b;
  #include <clipping_planes_vertex>
#ifdef IN_CELLS
  vec4 moved = modelViewMatrix * vec4(apart * shift, 0.0);
  a += moved;
  b += moved;
#endif
  vec4 p = projectionMatrix * a;
  vec4 q = projectionMatrix * b;
  vec2 along = (q.xy / q.w - p.xy / p.w) * size;
  float far = length(along);
  along = far > 1e-6 ? along / far : vec2(1.0, 0.0);
  vec2 across = vec2(-along.y, along.x);
  vec4 place = corner.x < 0.5 ? p : q;
  vec2 by = across * corner.y * width;
#ifdef BROAD
  // Round ends half a width beyond the segment close the gap to its neighbour.
  float side = corner.x * 2.0 - 1.0;
  by += along * side * width;
  vLength = far / width;
  vOver = vec2(corner.x * vLength + side, corner.y);
#endif
  place.xy += by / size * place.w;
  place.z -= nearer;
  gl_Position = place;
}
`;

const FRAGMENT = /* glsl */ `
#include <clipping_planes_pars_fragment>
uniform float opacity;
varying vec3 vColor;
varying vec2 vOver;
varying float vLength;
void main() {
  #include <clipping_planes_fragment>
#ifdef BROAD
  float beyond = max(-vOver.x, vOver.x - vLength);
  if (beyond > 0.0 && beyond * beyond + vOver.y * vOver.y > 1.0) discard;
#endif
  gl_FragColor = vec4(vColor, opacity);
}
`;

/** Pixels that lines are nearer to the eye than what they lie on, besides as many as they are wide: half of them dips into a slanted surface. */
const NEARER = 1.5;
/** Lines from this width on have round ends. */
const BROAD = 1.25;

/** The four corners of a segment, along it from 0 to 1, across it from -1 to 1; and its two triangles. */
const CORNERS = [0, -1, 1, -1, 1, 1, 0, 1];
const FACES = [0, 1, 2, 0, 2, 3];

export class Lines {
  #material;
  #geometry = new BufferGeometry();
  #nearer;
  #count = 0;
  #isWanted = true;

  /** @param {ClippingPlane[]} clippingPlanes @param {LineLook} look */
  constructor(clippingPlanes, { color, width, opacity = 1, order, apart }) {
    this.#nearer = NEARER + 1.5 * width;
    this.#material = new ShaderMaterial({
      defines: { ...(width < BROAD ? {} : { BROAD: "" }), ...(apart ? { IN_CELLS: "" } : {}) },
      vertexShader: VERTEX,
      fragmentShader: color === undefined ? FRAGMENT : FRAGMENT.replace("varying vec3 vColor", "uniform vec3 color").replace("vColor", "color"),
      uniforms: { size: { value: new Vector2(1, 1) }, width: { value: width }, nearer: { value: 0 }, opacity: { value: opacity }, color: { value: [0, 0, 0] }, ...(apart ? { apart } : {}) },
      transparent: true,
      depthWrite: false,
      clipping: true,
      clippingPlanes,
    });
    if (color !== undefined) this.paint(color);
    this.object = new Mesh(this.#geometry, this.#material);
    this.object.renderOrder = order;
    this.object.frustumCulled = false;
    this.object.onBeforeRender = (renderer) => void renderer.getSize(this.#material.uniforms.size.value);
    this.set([]);
  }

  /**
   * @param {Float32Array | number[]} segments six numbers each
   * @param {Float32Array | number[]} [colors] six numbers a segment, sRGB from 0 to 1
   * @param {Float32Array | number[]} [shifts] three numbers a segment, where they belong to cells
   */
  set(segments, colors, shifts) {
    // A geometry of another length is another one to the graphics card.
    this.#geometry.dispose();
    this.#geometry = new BufferGeometry();
    this.#count = segments.length / 6;
    // Four vertices each rather than an instance: drivers without a graphics card take longer for an instance than for all its vertices.
    const corners = new Int8Array(8 * this.#count);
    const faces = new Uint32Array(6 * this.#count);
    for (let k = 0; k < this.#count; k += 1) {
      corners.set(CORNERS, 8 * k);
      for (let i = 0; i < 6; i += 1) faces[6 * k + i] = 4 * k + FACES[i];
    }
    this.#geometry.setAttribute("corner", new BufferAttribute(corners, 2));
    this.#geometry.setIndex(new BufferAttribute(faces, 1));
    this.#put(["from", "to"], segments);
    if (colors) this.#put(["fromColor", "toColor"], colors);
    if (shifts) {
      const four = new Float32Array(12 * this.#count);
      for (let k = 0; k < four.length; k += 1) four[k] = shifts[3 * Math.floor(k / 12) + (k % 3)];
      this.#geometry.setAttribute("shift", new BufferAttribute(four, 3));
    }
    this.object.geometry = this.#geometry;
    this.show(this.#isWanted);
  }

  /** @param {string[]} names of the first and the second end @param {Float32Array | number[]} values three numbers for each end in turn */
  #put(names, values) {
    const four = new Float32Array(4 * values.length);
    for (let k = 0; k < values.length; k += 1) {
      const start = 24 * Math.floor(k / 6) + (k % 6);
      for (let corner = 0; corner < 4; corner += 1) four[start + 6 * corner] = values[k];
    }
    const buffer = new InterleavedBuffer(four, 6);
    names.forEach((name, i) => this.#geometry.setAttribute(name, new InterleavedBufferAttribute(buffer, 3, 3 * i)));
  }

  /** @param {boolean} isWanted */
  show(isWanted) {
    this.#isWanted = isWanted;
    this.object.visible = isWanted && this.#count > 0;
  }

  /** @param {number} depth what one CSS pixel towards the eye is worth, see `Space` */
  raise(depth) {
    this.#material.uniforms.nearer.value = this.#nearer * depth;
  }

  /** @param {string} css */
  paint(css) {
    this.#material.uniforms.color.value = plainColor(css);
  }

  dispose() {
    this.#geometry.dispose();
    this.#material.dispose();
  }
}

/**
 * Polylines as segments.
 * @param {Float32Array[]} polylines three numbers a point
 * @param {boolean} closed whether the last point is joined to the first, where it does not repeat it
 */
export function segmentsOf(polylines, closed) {
  /** @type {number[]} */
  const segments = [];
  for (const points of polylines) {
    const count = points.length / 3;
    if (count < 2) continue;
    for (let i = 0; i < count; i += 1) {
      const [a, b] = [3 * i, 3 * ((i + 1) % count)];
      const isLast = i === count - 1;
      const isSame = points[a] === points[b] && points[a + 1] === points[b + 1] && points[a + 2] === points[b + 2];
      if (isLast && (!closed || isSame)) continue;
      segments.push(points[a], points[a + 1], points[a + 2], points[b], points[b + 1], points[b + 2]);
    }
  }
  return segments;
}

/**
 * A polyline with fewer points: those left out lie within a tolerance of the chord between the ones that stay (D. H. Douglas and T. K.
 * Peucker, Cartographica 10, 1973).
 * @param {Float32Array} points three numbers a point
 * @param {number} tolerance document units
 */
export function thinned(points, tolerance) {
  const last = points.length / 3 - 1;
  if (last < 2) return points;
  const kept = new Uint8Array(last + 1);
  kept[0] = kept[last] = 1;
  const open = [[0, last]];
  for (let range = open.pop(); range; range = open.pop()) {
    const [a, b] = range;
    let [farthest, at] = [tolerance, -1];
    for (let i = a + 1; i < b; i += 1) {
      const distance = distanceToChord(points, i, a, b);
      if (distance > farthest) [farthest, at] = [distance, i];
    }
    if (at < 0) continue;
    kept[at] = 1;
    open.push([a, at], [at, b]);
  }
  const found = [];
  for (let i = 0; i <= last; i += 1) if (kept[i]) found.push(points[3 * i], points[3 * i + 1], points[3 * i + 2]);
  return new Float32Array(found);
}

/** @param {Float32Array} points @param {number} i @param {number} a @param {number} b */
function distanceToChord(points, i, a, b) {
  const at = (/** @type {number} */ k) => [points[3 * k], points[3 * k + 1], points[3 * k + 2]];
  const [from, chord] = [at(a), subtract(at(b), at(a))];
  const off = subtract(at(i), from);
  const length = dot(chord, chord);
  const t = length > 0 ? Math.min(1, Math.max(0, dot(off, chord) / length)) : 0;
  return Math.hypot(...subtract(off, scaled(chord, t)));
}
