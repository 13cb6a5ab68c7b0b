/**
 * How surfaces look: the colour of the vertices, softly lit from the upper left or not at all, and the faces of a cut.
 *
 * @import { Plane as ClippingPlane } from "three"
 *
 * @typedef {{value: number}} Apart How far cells are drawn apart, as a share of their shifts; all that belongs to them has it in common.
 */
import { DoubleSide, ShaderMaterial } from "three";
import { LAB_SHADER } from "./colors.js";

const VERTEX = /* glsl */ `
#include <clipping_planes_pars_vertex>
attribute vec3 lab;
#ifdef IN_CELLS
attribute vec3 shift;
attribute float empty;
uniform float apart;
varying float vEmpty;
#endif
varying vec3 vLab;
varying vec3 vNormal;
varying vec3 vPlace;
void main() {
  vLab = lab;
  vNormal = normalMatrix * normal;
  vec4 mvPosition = modelViewMatrix * vec4(position, 1.0);
  // Planes cut the body as it is together.
  #include <clipping_planes_vertex>
#ifdef IN_CELLS
  vEmpty = empty;
  mvPosition = modelViewMatrix * vec4(position + apart * shift, 1.0);
#endif
  vPlace = mvPosition.xyz;
  gl_Position = projectionMatrix * mvPosition;
}
`;

/** Screen pixels from one line of what is left of an empty material to the next. */
const SIEVE = 6;

// The light goes with the camera. Least and most of it, in linear light; the far side of a wall gets less.
const FRAGMENT = /* glsl */ `
#include <clipping_planes_pars_fragment>
uniform float lit;
uniform vec4 plain;
uniform float isFlat;
#ifdef IN_CELLS
uniform float opacity;
uniform float pixelRatio;
varying float vEmpty;
#endif
varying vec3 vLab;
varying vec3 vNormal;
varying vec3 vPlace;
${LAB_SHADER}
const vec3 LIGHT = vec3(-0.42, 0.68, 0.6);
void main() {
  #include <clipping_planes_fragment>
#ifdef IN_CELLS
  // An empty material takes away as large a share of the surface, in stripes that are seen through.
  float across = mod((gl_FragCoord.x + gl_FragCoord.y) / pixelRatio * 0.70710678, ${SIEVE.toFixed(1)}) / ${SIEVE.toFixed(1)};
  if (vEmpty > 0.02 && 1.0 - across < vEmpty * 1.02) discard;
#endif
  vec3 light = plain.a > 0.5 ? lightOfSrgb(plain.rgb) : lightOf(vLab);
  // Of the two sides of a triangle the one that is seen is lit.
  vec3 n = isFlat > 0.5 ? cross(dFdx(vPlace), dFdy(vPlace)) : gl_FrontFacing ? vNormal : -vNormal;
  float toLight = 0.5 + 0.5 * dot(normalize(n), normalize(LIGHT));
  float strength = mix(0.42, 1.06, smoothstep(0.05, 0.95, toLight)) * (gl_FrontFacing ? 1.0 : 0.72);
  light = clamp(light * mix(1.0, strength, lit), 0.0, 1.0);
#ifdef IN_CELLS
  gl_FragColor = vec4(srgbOf(light), opacity);
#else
  gl_FragColor = vec4(srgbOf(light), 1.0);
#endif
}
`;

/** Screen pixels from one line of a hatch to the next. */
const HATCH = 7;

const FLAT_VERTEX = /* glsl */ `
#include <clipping_planes_pars_vertex>
void main() {
  #include <begin_vertex>
  #include <project_vertex>
  #include <clipping_planes_vertex>
}
`;

const HATCH_FRAGMENT = /* glsl */ `
#include <clipping_planes_pars_fragment>
uniform vec3 paper;
uniform vec3 ink;
uniform float pixelRatio;
void main() {
  #include <clipping_planes_fragment>
  float across = mod((gl_FragCoord.x - gl_FragCoord.y) / pixelRatio * 0.70710678, ${HATCH.toFixed(1)});
  float covered = 1.0 - smoothstep(0.0, 1.0 / pixelRatio, abs(across - 1.0) - 0.25);
  gl_FragColor = vec4(mix(paper, ink, covered), 1.0);
}
`;

/**
 * A surface in the colours of its vertices, attribute `lab`, or in one colour where `plain` has the opacity 1.
 * @param {ClippingPlane[]} clippingPlanes
 * @param {object} [options]
 * @param {boolean} [options.isFlat] lit by its triangles rather than by the normals of its vertices
 * @param {Apart} [options.apart] the surface is one of cells: each vertex has the attributes `shift`, by which its cell is drawn away from its
 * place, and `empty`, the fraction of materials that are void
 */
export function surfaceMaterial(clippingPlanes, { isFlat = false, apart } = {}) {
  /** @type {{[uniform: string]: {value: any}}} */
  const cells = apart ? { apart, opacity: { value: 1 }, pixelRatio: { value: 1 } } : {};
  return new ShaderMaterial({
    defines: apart ? { IN_CELLS: "" } : {},
    vertexShader: VERTEX,
    fragmentShader: FRAGMENT,
    uniforms: { lit: { value: 1 }, plain: { value: [0, 0, 0, 0] }, isFlat: { value: isFlat ? 1 : 0 }, ...cells },
    clipping: true,
    clippingPlanes,
    side: DoubleSide,
  });
}

/**
 * The face of a cut of which nothing is known but that it is inside: hatched, as in a drawing.
 * @param {ClippingPlane[]} clippingPlanes those of the other cuts
 */
export function hatchMaterial(clippingPlanes) {
  return new ShaderMaterial({
    vertexShader: FLAT_VERTEX,
    fragmentShader: HATCH_FRAGMENT,
    uniforms: { paper: { value: [1, 1, 1] }, ink: { value: [0, 0, 0] }, pixelRatio: { value: 1 } },
    clipping: true,
    clippingPlanes,
    side: DoubleSide,
  });
}
