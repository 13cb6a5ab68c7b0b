/**
 * What moving the sides of the box of the chosen group does, in space and in the plane, and what is said of it.
 *
 * @import { BoxMoves, Side } from "../space/box-mark.js"
 * @import { Bounds } from "../space/vector.js"
 * @import { createPreview } from "./preview.js"
 * @import { Bench } from "./state.js"
 */
import { fixed } from "../format.js";
import { decimalsOf, placeOfSide, stepped, wayOf, withSide } from "./box-edit.js";
import { withGroup } from "./edits.js";
import { words } from "./words.js";

/**
 * @param {Bench} bench
 * @param {ReturnType<typeof createPreview>} preview
 * @param {object} acts
 * @param {() => void} acts.begun a side is dragged
 * @param {(text: string) => void} acts.told what is to be said of an edit
 */
export function createBoxMoves(bench, preview, { begun, told }) {
  /** The box, the body, and the index of the group. */
  function now() {
    const { document, known, shown } = bench.now();
    const at = shown.group;
    const box = at === null ? undefined : document.groups[at]?.where.box;
    return at !== null && box && known && box[0].length === known.boundary.dimension ? { at, box, bounds: known.mesh.bounds } : null;
  }

  /** @param {(box: number[][], bounds: Bounds) => number[][]} change @param {string} [run] */
  function moveSide(change, run) {
    const found = now();
    if (!found) return;
    const { at, bounds } = found;
    bench.commit((document) => {
      const { where } = document.groups[at];
      return where.box ? withGroup(document, at, { where: { ...where, box: change(where.box, bounds) } }) : document;
    }, run);
  }

  /** Says where a side stands, and what the group has of the boundary. @param {Side} side */
  function tell(side) {
    const found = now();
    if (!found) return;
    const { at, box, bounds } = found;
    const { known, isCurrent } = bench.now();
    const answered = isCurrent ? (known?.boundary.sets[at]?.count ?? null) : null;
    told(words.box.said(side, fixed(placeOfSide(box, side, bounds), decimalsOf(bounds)), preview.count(at) ?? answered));
  }

  /** @type {BoxMoves} */
  const moves = {
    move(side, place, run) {
      begun();
      moveSide((box, bounds) => withSide(box, side, place, bounds), run);
    },
    end(side) {
      bench.endRun();
      tell(side);
    },
    undo: bench.takeBack,
    step(side, steps) {
      moveSide((box, bounds) => stepped(box, side, steps, bounds));
      tell(side);
    },
  };

  return {
    moves,
    /** Where each side stands on its way; null where there is no box. */
    describe() {
      const found = now();
      if (!found) return null;
      const { box, bounds } = found;
      return (/** @type {Side} */ side) => {
        const place = placeOfSide(box, side, bounds);
        return { text: words.box.value(side, fixed(place, decimalsOf(bounds))), now: place, extent: wayOf(box, side, bounds) };
      };
    },
  };
}
