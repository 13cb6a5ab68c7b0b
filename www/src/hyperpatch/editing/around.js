/**
 * What lies round the chosen corner and what would move with what is chosen there: asked of the module whenever either changes.
 *
 * @import { CornerNeighbourhood } from "../../../../js/directrix.js"
 * @import { Known } from "../runner.js"
 * @import { Shown } from "../state.js"
 * @import { Place, Reach, Side } from "../edits.js"
 *
 * @typedef {CornerNeighbourhood["points"][number]} Point
 *
 * @typedef {object} Around
 * @property {Known} known the body that it is about
 * @property {Side} side
 * @property {Place} place the chosen coefficient
 * @property {CornerNeighbourhood} neighbourhood
 * @property {{cell: number, at: [number, number, number], share: number}[]} moves what would move, each with its share of the way
 */
import { Lane } from "../../state/lane.js";
import { placeOfCorner } from "../edits.js";

/** @typedef {{known: Known, side: Side, place: Place, reach: Reach}} Asked */

/**
 * @param {object} of
 * @param {() => {known: Known | null, shown: Shown}} of.now
 * @param {() => void} of.found there is an answer
 */
export function createAround({ now, found }) {
  /** @type {Around | null} */
  let answer = null;
  /** @type {Asked | null} */
  let asked = null;

  /** @type {Lane<Asked, Around>} */
  const lane = new Lane({
    async work({ known, side, place, reach }, signal) {
      const neighbourhood = await known.body.neighbourhood(side.cell, triple(side.corner), { signal });
      const moves = await known.body.moves(place.cell, triple(place.at), reach, { signal });
      return { known, side, place, neighbourhood, moves };
    },
    done(next) {
      answer = next;
      found();
    },
    // A corner that went with its cells is not chosen any more; the next body tells.
    failed() {},
  });

  return {
    /** Asks where something has changed since. */
    request() {
      const { known, shown } = now();
      const { corner: side, at, reach } = shown;
      if (!known || !side) {
        asked = answer = null;
        lane.cancel();
        return;
      }
      const place = at ?? placeOfCorner(side);
      if (asked && asked.known.body === known.body && asked.side === side && asked.reach === reach && isPlace(asked.place, place)) return;
      asked = { known, side, place, reach };
      lane.push(asked);
    },
    /** What is known of the chosen corner; of an earlier body while the next one is asked. */
    current() {
      const { shown } = now();
      return answer && answer.side === shown.corner ? answer : null;
    },
    close: () => lane.cancel(),
  };
}

/** @param {readonly number[]} list */
const triple = (list) => /** @type {[number, number, number]} */ ([...list]);

/** @param {Place} a @param {Place} b */
export const isPlace = (a, b) => a.cell === b.cell && a.at.every((along, k) => along === b.at[k]);

/** The point that a coefficient belongs to. @param {Around} around @param {Place} place */
export const pointOf = ({ neighbourhood }, place) => neighbourhood.points.find(({ users }) => users.some((user) => isPlace(user, place))) ?? null;
