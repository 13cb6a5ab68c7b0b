/**
 * Colours of a body that are not those of its materials: the scale viridis (Nathaniel Smith and Stefan van der Walt, 2015) over fractions
 * or over the least Jacobian of each cell.
 *
 * @import { BodySection, BodySurface, CellVerdict } from "../../../js/directrix.js"
 */
import { labsOf, plainColor } from "../space/colors.js";

/** The scale in ten even steps, as the legend has it. */
const VIRIDIS = ["#440154", "#482878", "#3e4989", "#31688e", "#26828e", "#1f9e89", "#35b779", "#6ece58", "#b5de2b", "#fde725"].map(plainColor);

/** @param {number} share 0 to 1, and what lies beyond counts as the end @returns {number[]} bytes of sRGB */
export function viridis(share) {
  const place = Math.min(1, Math.max(0, share)) * (VIRIDIS.length - 1);
  const k = Math.min(VIRIDIS.length - 2, Math.floor(place));
  return [0, 1, 2].map((channel) => Math.round(255 * (VIRIDIS[k][channel] + (place - k) * (VIRIDIS[k + 1][channel] - VIRIDIS[k][channel]))));
}

/**
 * The certified least Jacobian of a cell as a share of its mean, which is the volume: the parameters of a cell have the volume 1.
 * @param {Pick<CellVerdict, "leastJacobianBound">} verdict
 * @param {number} volume of the cell
 */
export const relativeJacobian = ({ leastJacobianBound }, volume) => (volume === 0 ? 0 : leastJacobianBound / Math.abs(volume));

/**
 * Oklab of every vertex.
 * @param {Pick<BodySurface | BodySection, "colors" | "fractions" | "cells">} mesh
 * @param {{color: "material"} | {color: "fraction", material: number} | {color: "jacobian", values: Map<number, number>}} how `values`: of each cell
 * @returns {Float32Array}
 */
export function labsFor({ colors, fractions, cells }, how) {
  if (how.color === "material") return labsOf(colors);
  const count = cells.length;
  const materials = count > 0 ? fractions.length / count : 0;
  const bytes = new Uint8Array(4 * count);
  for (let n = 0; n < count; n += 1) {
    const share = how.color === "fraction" ? fractions[n * materials + how.material] : (how.values.get(cells[n]) ?? 0);
    bytes.set(viridis(share), 4 * n);
  }
  return labsOf(bytes);
}
