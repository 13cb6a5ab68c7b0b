/**
 * Colours of a body that are not those of its materials: the scale viridis (Nathaniel Smith and Stefan van der Walt, 2015) over fractions
 * or over the least Jacobian of each cell.
 *
 * @import { BodySection, BodySurface, CellVerdict } from "../../../js/directrix.js"
 * @import { Known } from "./runner.js"
 * @import { Shown } from "./state.js"
 *
 * @typedef {{color: "material"} | {color: "fraction", material: number} | {color: "jacobian", values: Map<number, number>}} Coloring
 * `values`: of each cell.
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
 * @param {Coloring} how
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

/** The least of the cells' least Jacobians, each as a share of the mean of its cell; null without cells. @param {Pick<Known, "cells" | "verdicts">} known */
export function leastOf({ cells, verdicts }) {
  const volumes = new Map(cells.map(({ id, volume }) => [id, volume]));
  return verdicts.length === 0 ? null : Math.min(...verdicts.map((verdict) => relativeJacobian(verdict, volumes.get(verdict.cell) ?? 0)));
}

/** The ends of the scale of Jacobians: from the least of all cells, but 0 at most, to 1. @param {Known | null} known @returns {[number, number] | null} */
export function rangeOf(known) {
  const least = known && leastOf(known);
  return least === null ? null : [Math.min(0, least), 1];
}

/**
 * What the colours are, for surfaces and faces alike.
 * @param {Pick<Shown, "color" | "material">} shown
 * @param {Known | null} known
 * @param {number} materials how many there are
 * @returns {Coloring}
 */
export function coloringOf({ color, material }, known, materials) {
  if (color === "fraction") return { color, material: Math.min(material, materials - 1) };
  if (color === "material" || !known) return { color: "material" };
  const [low, high] = rangeOf(known) ?? [0, 1];
  const volumes = new Map(known.cells.map(({ id, volume }) => [id, volume]));
  const values = new Map(known.verdicts.map((verdict) => [verdict.cell, (relativeJacobian(verdict, volumes.get(verdict.cell) ?? 0) - low) / (high - low)]));
  return { color, values };
}
