/**
 * The composition along a line of coefficients from one cell through a corner into the next: as it is, and where it would run with the flat rule,
 * so that the staircase shows against the slope.
 *
 * @import { Material } from "../../types.js"
 * @import { Cell } from "../document.js"
 * @import { Around } from "./around.js"
 */
import { h, svg, write } from "../../dom.js";
import { sampleAt } from "../cell.js";
import { words } from "./words.js";

const said = words.material;
/** CSS pixels, and places computed on each side. */
const WIDTH = 272;
const HEIGHT = 56;
const STEPS = 24;

/** @typedef {NonNullable<ReturnType<Around["neighbourhood"]["joints"]["at"]>>} Joint */

/**
 * Fractions along the edge of a cell that ends at the corner, from the far end to the corner, and their values there.
 * @param {Cell} cell
 * @param {{face: string, corner: readonly number[]}} side
 * @param {number} materials
 * @returns {number[][]}
 */
export function along(cell, { face, corner }, materials) {
  const axis = "uvw".indexOf(face[0]);
  return Array.from({ length: STEPS + 1 }, (_, n) => {
    const t = n / STEPS;
    const uvw = corner.map((end, k) => (k === axis ? (end ? t : 1 - t) : end));
    return sampleAt(cell, uvw, materials).mix;
  });
}

/** The paper's rule between two mixes: 3 t² − 2 t³. @param {readonly number[]} from @param {readonly number[]} to @returns {number[][]} */
export const flat = (from, to) =>
  Array.from({ length: STEPS + 1 }, (_, n) => {
    const share = (n / STEPS) ** 2 * (3 - (2 * n) / STEPS);
    return from.map((fraction, i) => fraction + (to[i] - fraction) * share);
  });

export function profile() {
  const areas = svg("g", {});
  const lines = svg("g", { class: "profile-flat" });
  const middle = svg("path", { class: "profile-middle", d: `M${WIDTH / 2} 0V${HEIGHT}` });
  const picture = svg("svg", { class: "profile", viewBox: `0 0 ${WIDTH} ${HEIGHT}`, role: "img" }, areas, lines, middle);
  const caption = h("p", { class: "body-note" });
  const element = h("figure", { class: "profile-figure", "data-profile": "" }, picture, caption);
  return {
    element,
    /** @param {{cellOf: (id: number) => Cell | undefined}} known @param {Joint | null} joint @param {Material[]} materials */
    render({ cellOf }, joint, materials) {
      const [a, b] = joint?.sides ?? [];
      const [first, second] = [a && cellOf(a.cell), b && cellOf(b.cell)];
      element.hidden = !first || !second;
      if (!joint || !first || !second) return;
      const one = along(first, a, materials.length);
      const two = along(second, b, materials.length).reverse();
      const mixes = [...one, ...two];
      const [start, here, there, end] = [one[0], one[one.length - 1], two[0], two[two.length - 1]];
      const level = [...flat(start, here), ...flat(there, end)];
      const x = (/** @type {number} */ n) => (n <= STEPS ? n / STEPS : (n - 1) / STEPS) * (WIDTH / 2);
      // Fractions lie on each other, the first material at the foot.
      const upTo = (/** @type {number[]} */ mix, /** @type {number} */ i) => mix.slice(0, i).reduce((sum, fraction) => sum + fraction, 0);
      const curve = (/** @type {number[][]} */ list, /** @type {number} */ i) => list.map((mix, n) => `${x(n).toFixed(1)} ${(HEIGHT * (1 - upTo(mix, i))).toFixed(1)}`);
      areas.replaceChildren(
        ...materials.map(({ color }, i) => svg("path", { fill: color, d: `M${[...curve(mixes, i), ...curve(mixes, i + 1).reverse()].join("L")}Z` })),
      );
      lines.replaceChildren(...materials.slice(1).map((_, i) => svg("path", { d: `M${curve(level, i + 1).join("L")}` })));
      picture.setAttribute("aria-label", said.profile(a.cell, b.cell));
      write(caption, `${said.profile(a.cell, b.cell)}. ${said.profileNote}.`);
    },
  };
}
