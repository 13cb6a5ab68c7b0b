/**
 * Dots of a size in pixels, white with a dark ring, hidden by what lies before them and cut by planes as surfaces are.
 *
 * @import { Plane as ClippingPlane } from "three"
 */
import { BufferAttribute, BufferGeometry, Points, ShaderMaterial } from "three";

const VERTEX = /* glsl */ `
#include <clipping_planes_pars_vertex>
uniform float size;
uniform float nearer;
void main() {
  #include <begin_vertex>
  #include <project_vertex>
  gl_Position.z -= nearer;
  gl_PointSize = size;
  #include <clipping_planes_vertex>
}
`;

const FRAGMENT = /* glsl */ `
#include <clipping_planes_pars_fragment>
uniform float size;
uniform float ring;
void main() {
  #include <clipping_planes_fragment>
  float off = length(gl_PointCoord - 0.5) * size;
  if (off > size * 0.5) discard;
  float alpha = 1.0 - smoothstep(size * 0.5 - 1.0, size * 0.5, off);
  float white = 1.0 - smoothstep(size * 0.5 - ring - 1.0, size * 0.5 - ring, off);
  gl_FragColor = vec4(mix(vec3(0.063, 0.071, 0.086), vec3(1.0), white), alpha);
}
`;

/** CSS pixels: the radius with its ring, the ring alone, and how much nearer than a surface a dot is. */
const RADIUS = 3.6;
const RING = 1.2;
const NEARER = 10;

export class Dots {
  #material;
  #geometry = new BufferGeometry();

  /** @param {ClippingPlane[]} clippingPlanes @param {number} order dots of a higher one are drawn over those of a lower */
  constructor(clippingPlanes, order) {
    this.#material = new ShaderMaterial({
      vertexShader: VERTEX,
      fragmentShader: FRAGMENT,
      uniforms: { size: { value: 2 * RADIUS }, ring: { value: RING }, nearer: { value: 0 } },
      transparent: true,
      depthWrite: false,
      clipping: true,
      clippingPlanes,
    });
    this.object = new Points(this.#geometry, this.#material);
    this.object.renderOrder = order;
    this.object.frustumCulled = false;
    this.set(new Float32Array(0));
  }

  /** @param {Float32Array} positions three numbers each */
  set(positions) {
    this.#geometry.dispose();
    this.#geometry = new BufferGeometry();
    this.#geometry.setAttribute("position", new BufferAttribute(positions, 3));
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
