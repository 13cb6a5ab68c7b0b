/**
 * What a mix goes to, as pure functions.
 *
 * @import { Shown } from "../state.js"
 */
import { placeOfCorner } from "../edits.js";

/** All coefficients of cells, a corner's block in all its cells or in chosen ones, or one coefficient. */
export const MODES = /** @type {const} */ (["cells", "corner", "within", "at"]);

/** @typedef {typeof MODES[number]} Mode */

/**
 * What a mix goes to; null where what it needs is not chosen.
 * @param {Mode} mode
 * @param {Pick<Shown, "cells" | "corner" | "at">} shown
 */
export function mixTarget(mode, { cells, corner, at }) {
  if (mode === "cells") return cells.length > 0 ? { cells: [...cells] } : null;
  if (!corner) return null;
  const { cell, corner: ends } = corner;
  if (mode === "at") {
    const place = at ?? placeOfCorner(corner);
    return { cell: place.cell, at: triple(place.at) };
  }
  if (mode === "corner") return { cell, corner: triple(ends) };
  return cells.length > 0 ? { cell, corner: triple(ends), within: [...cells] } : null;
}

/** A mean in whole percents, whose sum stays 1. @param {readonly number[]} mix */
export function wholePercents(mix) {
  const parts = mix.map((fraction) => Math.round(fraction * 100));
  parts[parts.indexOf(Math.max(...parts))] += 100 - parts.reduce((sum, part) => sum + part, 0);
  return parts.map((part) => part / 100);
}

/** @param {readonly number[]} list */
export const triple = (list) => /** @type {[number, number, number]} */ ([...list]);
