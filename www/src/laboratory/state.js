/**
 * What the solver laboratory shows besides the document, what is known of its problem, and what its pieces are given.
 *
 * @import { RemoteLaplaceSolution } from "../../../js/directrix.js"
 * @import { App } from "../state/app.js"
 * @import { Size, View } from "../types.js"
 * @import { Bounds, Vector } from "../space/vector.js"
 * @import { Boundary, LaboratoryDocument } from "./document.js"
 * @import { jointsOf, Soup } from "./mesh.js"
 *
 * @typedef {"direction" | "patch"} Picking What a tap on the boundary gives the chosen group: all that face the same way, or the patch round the place.
 *
 * @typedef {object} Shown
 * @property {"solution" | "solvers"} look what the canvas is for
 * @property {"given" | "solved"} color of the boundary
 * @property {boolean} edges of elements
 * @property {boolean} light
 * @property {number | null} isolines index of the material whose lines of equal fraction are shown in the section
 * @property {number | null} group index of the chosen boundary group
 * @property {Picking | null} picking
 *
 * @typedef {object} Known What is known, and of which document.
 * @property {LaboratoryDocument} document
 * @property {Boundary} boundary
 * @property {Mesh} mesh
 * @property {RemoteLaplaceSolution | null} solution
 * @property {string | null} unsolved why there is none
 * @property {Accuracy | null} accuracy where an exact solution is known
 * @property {number} ms from asking to the solution
 *
 * @typedef {object} Mesh What follows from the boundary alone.
 * @property {number} count elements
 * @property {Bounds} bounds
 * @property {Soup | null} soup in space
 * @property {ReturnType<typeof jointsOf>} joints
 *
 * @typedef {{error: number, at: number[], points: number}} Accuracy The largest difference of a fraction from the exact one, where it is, and at how many places it was looked for.
 *
 * @typedef {object} Reading What is read at a place.
 * @property {Vector} point
 * @property {number | null} element of the boundary; null inside
 * @property {number[] | null} fractions
 * @property {number[] | null} exact
 * @property {number[] | null} flux
 *
 * @typedef {object} Now
 * @property {LaboratoryDocument} document as it stands
 * @property {Known | null} known the newest that is known
 * @property {boolean} isCurrent whether it belongs to the problem as it stands
 * @property {Shown} shown
 * @property {View | null} view of the plane
 * @property {Size} size of the picture in CSS pixels
 *
 * @typedef {object} Bench What every piece of the workbench is given.
 * @property {App} app
 * @property {() => Now} now
 * @property {(patch: Partial<Shown>) => void} change chooses and shows
 * @property {(change: (document: LaboratoryDocument) => LaboratoryDocument, run?: string) => void} commit an edit; edits of one run are one entry of the log
 * @property {() => void} endRun
 * @property {(run: string) => void} takeBack
 * @property {() => void} seeAnew a body has taken the place of another: nothing is chosen, and it is seen as a body is first seen
 * @property {() => void} request everything is drawn again
 */

/** @type {Readonly<Shown>} */
export const FIRST_SHOWN = { look: "solution", color: "given", edges: true, light: true, isolines: null, group: null, picking: null };

/** What is chosen and shown, without what the document does not have any more. @param {Shown} shown @param {LaboratoryDocument} document */
export function withoutGone(shown, { groups, materials }) {
  const group = shown.group !== null && groups[shown.group] ? shown.group : null;
  const isolines = shown.isolines !== null && materials[shown.isolines] ? shown.isolines : null;
  const picking = group === null ? null : shown.picking;
  return group === shown.group && isolines === shown.isolines && picking === shown.picking ? shown : { ...shown, group, isolines, picking };
}
