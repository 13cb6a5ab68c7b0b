/**
 * How surfaces look: the colour of the vertices, softly lit from the upper left or not at all, and the faces of a cut.
 *
 * @import { Plane as ClippingPlane } from "three"
 */
import { DoubleSide, ShaderMaterial } from "three";
import { LAB_SHADER } from "./colors.js";

const VERTEX = /* glsl */ `
#include <clipping_planes_pars_vertex>
attribute vec3 lab;
varying vec3 vLab;
varying vec3 vNormal;
varying vec3 vPlace;
void main() {
  vLab = lab;
  vNormal = normalMatrix * normal;
  #include <begin_vertex>
  #include <project_vertex>
  vPlace = mvPosition.xyz;
  #include <clipping_planes_vertex>
}
`;

// The light goes with the camera. Least and most of it, in linear light; the far side of a wall gets less.
const FRAGMENT = /* glsl */ `
#include <clipping_planes_pars_fragment>
uniform float lit;
uniform vec4 plain;
uniform float isFlat;
varying vec3 vLab;
varying vec3 vNormal;
varying vec3 vPlace;
${LAB_SHADER}
const vec3 LIGHT = vec3(-0.42, 0.68, 0.6);
void main() {
  #include <clipping_planes_fragment>
  vec3 light = plain.a > 0.5 ? lightOfSrgb(plain.rgb) : lightOf(vLab);
  // Of the two sides of a triangle the one that is seen is lit.
  vec3 n = isFlat > 0.5 ? cross(dFdx(vPlace), dFdy(vPlace)) : gl_FrontFacing ? vNormal : -vNormal;
  float toLight = 0.5 + 0.5 * dot(normalize(n), normalize(LIGHT));
  float strength = mix(0.42, 1.06, smoothstep(0.05, 0.95, toLight)) * (gl_FrontFacing ? 1.0 : 0.72);
  light = clamp(light * mix(1.0, strength, lit), 0.0, 1.0);
  gl_FragColor = vec4(srgbOf(light), 1.0);
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
 * @param {{isFlat?: boolean}} [options] `isFlat`: lit by its triangles rather than by the normals of its vertices
 */
export function surfaceMaterial(clippingPlanes, { isFlat = false } = {}) {
  return new ShaderMaterial({
    vertexShader: VERTEX,
    fragmentShader: FRAGMENT,
    uniforms: { lit: { value: 1 }, plain: { value: [0, 0, 0, 0] }, isFlat: { value: isFlat ? 1 : 0 } },
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
