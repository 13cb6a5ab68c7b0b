/**
 * Dots of a size in pixels, hidden by what lies before them and cut by planes as surfaces are: white with a dark ring, or signs of how
 * cells continue each other there.
 *
 * @import { Plane as ClippingPlane } from "three"
 * @import { Apart } from "../space/surface.js"
 */
import { BufferAttribute, BufferGeometry, Points, ShaderMaterial } from "three";

const VERTEX = /* glsl */ `
#include <clipping_planes_pars_vertex>
attribute vec3 shift;
attribute float sign;
uniform float size;
uniform float nearer;
uniform float apart;
varying float vSign;
void main() {
  vec4 mvPosition = modelViewMatrix * vec4(position, 1.0);
  #include <clipping_planes_vertex>
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position + apart * shift, 1.0);
  gl_Position.z -= nearer;
  vSign = sign;
  gl_PointSize = sign > 0.5 ? size * 1.25 : size;
}
`;

const FRAGMENT = /* glsl */ `
#include <clipping_planes_pars_fragment>
uniform float size;
uniform float ring;
varying float vSign;
void main() {
  #include <clipping_planes_fragment>
  vec2 from = abs(gl_PointCoord - 0.5);
  float side = vSign > 0.5 ? size * 1.25 : size;
  // A circle, a square, a diamond: of the same width across.
  float off = side * (vSign < 1.5 ? length(from) : vSign < 2.5 ? max(from.x, from.y) * 1.15 : from.x + from.y);
  if (off > side * 0.5) discard;
  float alpha = 1.0 - smoothstep(side * 0.5 - 1.0, side * 0.5, off);
  float inner = 1.0 - smoothstep(side * 0.5 - ring - 1.0, side * 0.5 - ring, off);
  vec3 ink = vec3(0.063, 0.071, 0.086);
  // Signs that are filled have a white ring, so that they are seen on any colour.
  gl_FragColor = vec4(vSign > 0.5 && vSign < 2.5 ? mix(vec3(1.0), ink, inner) : mix(ink, vec3(1.0), inner), alpha);
}
`;

/** CSS pixels: the radius with its ring, the ring alone, and how much nearer than a surface a dot is. */
const RADIUS = 3.4;
const RING = 1.2;
const NEARER = 10;

export class Dots {
  #material;
  #geometry = new BufferGeometry();

  /** @param {ClippingPlane[]} clippingPlanes @param {number} order dots of a higher one are drawn over those of a lower @param {Apart} apart */
  constructor(clippingPlanes, order, apart) {
    this.#material = new ShaderMaterial({
      vertexShader: VERTEX,
      fragmentShader: FRAGMENT,
      uniforms: { size: { value: 2 * RADIUS }, ring: { value: RING }, nearer: { value: 0 }, apart },
      transparent: true,
      depthWrite: false,
      clipping: true,
      clippingPlanes,
    });
    this.object = new Points(this.#geometry, this.#material);
    this.object.renderOrder = order;
    this.object.frustumCulled = false;
    this.set([], [], []);
  }

  /**
   * @param {number[]} positions three numbers each
   * @param {number[]} shifts three numbers each
   * @param {number[]} signs one each: 0 for a plain dot, 1 a circle, 2 a square, 3 a diamond
   */
  set(positions, shifts, signs) {
    this.#geometry.dispose();
    this.#geometry = new BufferGeometry();
    this.#geometry.setAttribute("position", new BufferAttribute(new Float32Array(positions), 3));
    this.#geometry.setAttribute("shift", new BufferAttribute(new Float32Array(shifts), 3));
    this.#geometry.setAttribute("sign", new BufferAttribute(new Float32Array(signs), 1));
    this.object.geometry = this.#geometry;
    this.#isWanted = positions.length > 0;
  }

  #isWanted = false;

  /** @param {boolean} isShown */
  show(isShown) {
    this.object.visible = isShown && this.#isWanted;
  }

  /** @param {number} depth what one CSS pixel towards the eye is worth @param {number} pixelRatio */
  raise(depth, pixelRatio) {
    const { size, ring, nearer } = this.#material.uniforms;
    size.value = 2 * RADIUS * pixelRatio;
    ring.value = RING * pixelRatio;
    nearer.value = NEARER * depth;
  }

  dispose() {
    this.#geometry.dispose();
    this.#material.dispose();
  }
}
