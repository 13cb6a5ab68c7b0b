/**
 * Unit cells as a table and as JSON. Numbers have all their digits; columns of a measure name its unit.
 *
 * @import { Amounts, UnitCell } from "../types.js"
 */
import { written } from "../files/written.js";
import { square } from "./words.js";

/**
 * One row for each cell: the corners along the line, across to the next line and back, then area, centroid, and the mean fraction of each material.
 * @param {UnitCell[]} cells
 * @param {string[]} materials
 * @param {string} unit
 */
export function cellsCsv(cells, materials, unit) {
  const measured = (/** @type {string} */ name, /** @type {string} */ of) => (of === "" ? name : `${name} [${of}]`);
  const corners = [1, 2, 3, 4].flatMap((k) => [measured(`x${k}`, unit), measured(`y${k}`, unit)]);
  const head = ["line", "stage", ...corners, measured("area", square(unit)), measured("centroid x", unit), measured("centroid y", unit), "folded", ...told(materials)];
  const rows = cells.map(({ line, stage, corners: [a, b, c, d], area, centroid, folded, fractions }) => [
    ...[line, stage, ...a, ...b, ...c, ...d, area, ...centroid, folded, ...fractions],
  ]);
  return [head.map(quoted), ...rows].map((row) => `${row.join(",")}\n`).join("");
}

/**
 * @param {UnitCell[]} cells
 * @param {Amounts} amounts
 * @param {string} title
 */
export function cellsJson(cells, { unit, area, body, error, materials, rise }, title) {
  const names = told(materials.map(({ name }) => name));
  return written({
    ...{ title, unit, area, body, error, rise },
    materials: materials.map((material, k) => ({ ...material, name: names[k] })),
    cells: cells.map(({ fractions, ...cell }) => ({ ...cell, mix: Object.fromEntries(fractions.map((fraction, k) => [names[k], fraction])) })),
  });
}

/** Names that are told apart: of equal ones the later ones are numbered. @param {string[]} names */
function told(names) {
  /** @type {Set<string>} */
  const taken = new Set();
  return names.map((name) => {
    let own = name;
    for (let k = 2; taken.has(own); k += 1) own = `${name} ${k}`;
    taken.add(own);
    return own;
  });
}

/** A cell of a table as RFC 4180 has it. @param {string} text */
function quoted(text) {
  return /[",\r\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
}
