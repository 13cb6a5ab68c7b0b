/**
 * How a boundary and the face of its section look: elements in one colour each, hatched where a flux is given, and the picture of the solution on the plane.
 *
 * @import { Plane as ClippingPlane } from "three"
 */
import { DataTexture, DoubleSide, LinearFilter, RGBAFormat, ShaderMaterial, UnsignedByteType, Vector3 } from "three";
import { LAB_SHADER } from "../space/colors.js";

/** Screen pixels from one line of a hatch to the next. */
const HATCH = 6;

const VERTEX = /* glsl */ `
#include <clipping_planes_pars_vertex>
attribute vec3 lab;
attribute float hatched;
varying vec3 vLab;
varying float vHatched;
varying vec3 vNormal;
void main() {
  vLab = lab;
  vHatched = hatched;
  vNormal = normalMatrix * normal;
  vec4 mvPosition = modelViewMatrix * vec4(position, 1.0);
  #include <clipping_planes_vertex>
  gl_Position = projectionMatrix * mvPosition;
}
`;

// Lit as other bodies are, see space/surface.js.
const FRAGMENT = /* glsl */ `
#include <clipping_planes_pars_fragment>
uniform float lit;
uniform float pixelRatio;
varying vec3 vLab;
varying float vHatched;
varying vec3 vNormal;
${LAB_SHADER}
const vec3 LIGHT = vec3(-0.42, 0.68, 0.6);
void main() {
  #include <clipping_planes_fragment>
  vec3 light = lightOf(vLab);
  if (vHatched > 0.5) {
    float across = mod((gl_FragCoord.x - gl_FragCoord.y) / pixelRatio * 0.70710678, ${HATCH.toFixed(1)});
    light *= mix(1.0, 0.52, 1.0 - smoothstep(0.0, 1.0 / pixelRatio, abs(across - 1.0) - 0.35));
  }
  vec3 n = gl_FrontFacing ? vNormal : -vNormal;
  float toLight = 0.5 + 0.5 * dot(normalize(n), normalize(LIGHT));
  float strength = mix(0.42, 1.06, smoothstep(0.05, 0.95, toLight)) * (gl_FrontFacing ? 1.0 : 0.72);
  light = clamp(light * mix(1.0, strength, lit), 0.0, 1.0);
  gl_FragColor = vec4(srgbOf(light), 1.0);
}
`;

/** @param {ClippingPlane[]} clippingPlanes */
export const elementMaterial = (clippingPlanes) =>
  new ShaderMaterial({
    vertexShader: VERTEX,
    fragmentShader: FRAGMENT,
    uniforms: { lit: { value: 1 }, pixelRatio: { value: 1 } },
    clipping: true,
    clippingPlanes,
    side: DoubleSide,
  });

const FACE_VERTEX = /* glsl */ `
varying vec3 vWorld;
void main() {
  vec4 place = modelMatrix * vec4(position, 1.0);
  vWorld = place.xyz;
  gl_Position = projectionMatrix * viewMatrix * place;
}
`;

const FACE_FRAGMENT = /* glsl */ `
uniform sampler2D picture;
uniform vec3 origin;
uniform vec3 right;
uniform vec3 up;
uniform vec3 paper;
uniform float has;
varying vec3 vWorld;
void main() {
  vec3 by = vWorld - origin;
  vec2 place = vec2(dot(by, right) / dot(right, right), dot(by, up) / dot(up, up));
  vec4 color = texture2D(picture, place);
  gl_FragColor = vec4(mix(paper, color.rgb / max(color.a, 1.0 / 255.0), has * step(1.0 / 255.0, color.a)), 1.0);
}
`;

/** The face of a section, which shows a picture once it has one. */
export class FaceLook {
  #texture = new DataTexture(new Uint8Array(4), 1, 1, RGBAFormat, UnsignedByteType);

  constructor() {
    this.material = new ShaderMaterial({
      vertexShader: FACE_VERTEX,
      fragmentShader: FACE_FRAGMENT,
      uniforms: {
        picture: { value: this.#texture },
        origin: { value: new Vector3() },
        right: { value: new Vector3(1, 0, 0) },
        up: { value: new Vector3(0, 1, 0) },
        paper: { value: [1, 1, 1] },
        has: { value: 0 },
      },
      side: DoubleSide,
    });
  }

  /**
   * @param {Uint8ClampedArray} pixels with what is clear premultiplied: it has no colour
   * @param {[number, number]} size
   * @param {import("./section-state.js").FaceFrame} frame
   */
  set(pixels, [wide, tall], { origin, sides }) {
    this.#texture.dispose();
    this.#texture = new DataTexture(new Uint8Array(pixels), wide, tall, RGBAFormat, UnsignedByteType);
    Object.assign(this.#texture, { magFilter: LinearFilter, minFilter: LinearFilter, unpackAlignment: 1, needsUpdate: true });
    const { uniforms } = this.material;
    uniforms.picture.value = this.#texture;
    uniforms.origin.value.set(...origin);
    uniforms.right.value.set(...sides[0]);
    uniforms.up.value.set(...sides[1]);
    uniforms.has.value = 1;
  }

  /** Nothing is known of the face. */
  clear() {
    this.material.uniforms.has.value = 0;
  }

  /** The material is disposed of by the cut that has it. */
  dispose() {
    this.#texture.dispose();
  }
}
