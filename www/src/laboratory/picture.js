/**
 * What the workbench has for elsewhere: its picture, the solution on elements and that on the section. The panel Export asks for it.
 *
 * @import { PictureWanted } from "../files/picture-rows.js"
 * @import { Size } from "../types.js"
 * @import { Face } from "./face.js"
 * @import { Known } from "./state.js"
 *
 * @typedef {object} Offer
 * @property {Size} size of the picture on the screen
 * @property {(wanted: PictureWanted) => OffscreenCanvas | null} picture null where there is none of that size
 * @property {() => Known | null} known
 * @property {() => Face | null} face
 */
import { centreOf, cornersOf } from "./mesh.js";
import { cross, subtract } from "../space/vector.js";
import { words } from "./words.js";

/** @type {Offer | null} */
let current = null;

/** @param {Offer | null} next null where nothing is shown any more */
export function offer(next) {
  current = next;
}

/** What is shown now; null where nothing is. */
export const offered = () => current;

/**
 * The picture as a PNG.
 * @param {PictureWanted} wanted
 * @throws {Error} where there is none, or none of that size
 */
export async function problemPicture(wanted) {
  const canvas = current?.picture(wanted);
  if (!canvas) throw new Error(current ? words.exports.tooLarge : words.exports.noPicture);
  return canvas.convertToBlob({ type: "image/png" });
}

/**
 * The solution on the boundary as rows of a file.
 * @param {Offer | null} from
 * @returns {(string | number)[][]}
 * @throws {Error} where there is no solution
 */
export function elementRows(from) {
  const known = from?.known();
  if (!known?.solution) throw new Error(words.exports.noSolution);
  const { boundary, document, mesh, solution } = known;
  const axes = ["x", "y", "z"].slice(0, boundary.dimension);
  const names = document.materials.map(({ name }) => name);
  const rows = Array.from({ length: mesh.count }, (_, element) => [
    element,
    ...centreOf(boundary, element).slice(0, boundary.dimension),
    sizeOf(boundary, element),
    boundary.sets[boundary.members[element]]?.name ?? "",
    ...solution.values.map((values) => values[element]),
    ...solution.fluxes.map((fluxes) => fluxes[element]),
  ]);
  return [["element", ...axes, boundary.dimension === 3 ? "area" : "length", "group", ...names, ...names.map((name) => `flux ${name}`)], ...rows];
}

/** Area or length of an element. @param {import("./mesh.js").Elements} mesh @param {number} element */
function sizeOf(mesh, element) {
  const [a, b, c] = cornersOf(mesh, element);
  return mesh.dimension === 3 ? Math.hypot(...cross(subtract(b, a), subtract(c, a))) / 2 : Math.hypot(...subtract(b, a));
}

/**
 * The solution on the pixels of the section that are inside, as rows of a file.
 * @param {Offer | null} from
 * @returns {(string | number)[][]}
 * @throws {Error} where there is none
 */
export function sectionRowsOf(from) {
  const [known, face] = [from?.known(), from?.face()];
  if (!known || !face) throw new Error(words.exports.noSolution);
  const { frame, size, values } = face;
  const { dimension } = known.boundary;
  const rows = [];
  for (let j = 0; j < size[1]; j += 1) {
    for (let i = 0; i < size[0]; i += 1) {
      const n = j * size[0] + i;
      if (Number.isNaN(values[0][n])) continue;
      const at = [0, 1, 2].map((axis) => frame.origin[axis] + ((i + 0.5) / size[0]) * frame.sides[0][axis] + ((j + 0.5) / size[1]) * frame.sides[1][axis]);
      rows.push([...at.slice(0, dimension), ...values.map((list) => list[n])]);
    }
  }
  return [[...["x", "y", "z"].slice(0, dimension), ...known.document.materials.map(({ name }) => name)], ...rows];
}
