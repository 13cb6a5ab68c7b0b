/**
 * The colours of elements: those of given values, or of what was found; grey where a flux is given.
 *
 * @import { RemoteLaplaceSolution } from "../../../js/directrix.js"
 * @import { Boundary } from "./document.js"
 */
import { srgbOf } from "../space/colors.js";
import { countOf } from "./mesh.js";
import { labOf, labsOfMaterials, mixOf } from "./pixels.js";

/** Oklab of an element with a given flux, of one without any condition. */
const GREY = [0.82, 0, 0];
const NONE = [0.93, 0, 0];

/**
 * Oklab of an element.
 * @param {Boundary} boundary
 * @param {number[][]} labs of the materials
 * @param {RemoteLaplaceSolution | null} solution null for what is given
 * @returns {(element: number) => readonly number[]}
 */
function labBy(boundary, labs, solution) {
  const given = boundary.conditions.map((condition) => {
    const mix = mixOf(condition);
    return mix ? labOf(labs, (material) => mix[material]) : GREY;
  });
  return (element) => (solution ? labOf(labs, (material) => solution.values[material][element]) : (given[boundary.groups[element]] ?? NONE));
}

/**
 * Oklab of the corners of all elements.
 * @param {Boundary} boundary
 * @param {readonly {color: string}[]} materials
 * @param {RemoteLaplaceSolution | null} solution null for what is given
 */
export function elementLabs(boundary, materials, solution) {
  const { dimension } = boundary;
  const by = labBy(boundary, labsOfMaterials(materials), solution);
  const found = new Float32Array(3 * dimension * countOf(boundary));
  for (let element = 0; element < countOf(boundary); element += 1) {
    const lab = by(element);
    for (let k = 0; k < dimension; k += 1) found.set(lab, 3 * (dimension * element + k));
  }
  return found;
}

/** 1 for each corner of an element with a given flux, else 0. @param {Boundary} boundary @param {boolean} isGiven whether what is given is shown */
export function hatchedOf(boundary, isGiven) {
  const isFlux = boundary.conditions.map((condition) => "flux" in condition);
  const { dimension, groups } = boundary;
  return Float32Array.from({ length: dimension * countOf(boundary) }, (_, n) => (isGiven && isFlux[groups[Math.floor(n / dimension)]] ? 1 : 0));
}

/**
 * CSS colours of elements; null of those with a given flux while what is given is shown.
 * @param {Boundary} boundary
 * @param {readonly {color: string}[]} materials
 * @param {RemoteLaplaceSolution | null} solution
 * @returns {(element: number) => string | null}
 */
export function elementColors(boundary, materials, solution) {
  const by = labBy(boundary, labsOfMaterials(materials), solution);
  /** @type {(string | null | undefined)[]} */
  const known = [];
  return (element) => {
    const condition = boundary.conditions[boundary.groups[element]];
    if (!solution && (!condition || "flux" in condition)) return null;
    return (known[element] ??= `rgb(${srgbOf(/** @type {number[]} */ (by(element)), 0).map((channel) => Math.round(255 * channel)).join(" ")})`);
  };
}
