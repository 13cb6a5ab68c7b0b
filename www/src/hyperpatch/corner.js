/**
 * The chosen corner: where it is, how it is chosen, and how it is moved.
 *
 * @import { App } from "../state/app.js"
 * @import { Vector } from "../space/vector.js"
 * @import { BodyDocument } from "./document.js"
 * @import { Side } from "./edits.js"
 * @import { Known } from "./runner.js"
 * @import { Shown } from "./state.js"
 */
import { newRun } from "../controls/run.js";
import { coordinate } from "../format.js";
import { subtract } from "../space/vector.js";
import { placeOf } from "./cell.js";
import { bodyOf, cellsOf } from "./document.js";
import { moveCorner } from "./edits.js";
import { neighbour, sharedCorner } from "./state.js";
import { words } from "./words.js";

/**
 * @param {App} app
 * @param {object} of
 * @param {() => {known: Known | null, shown: Shown}} of.now `known`: null while it belongs to another document
 * @param {(corner: Side) => void} of.chosen another one is
 */
export function createCorner(app, { now, chosen }) {
  const { store } = app;
  let pressed = newRun("corner");

  /** The chosen corner where the document has it now, with all its cells. */
  function current() {
    const { known, shown } = now();
    const found = known && sharedCorner(known.sharing, shown.corner);
    if (!found) return null;
    const [{ cell, corner }] = found.sides;
    const [i, j, k] = corner.map((end) => 3 * end);
    const position = cellsOf(bodyOf(app))[cell]?.coefficients[placeOf(i, j, k)].position;
    return position ? { position, sides: found.sides } : null;
  }

  /** @param {Side} side */
  function choose(side) {
    // What moves another corner is another entry of the log.
    pressed = newRun("corner");
    chosen(side);
    const { known } = now();
    const corner = current();
    if (!corner || !known) return;
    const { corners } = known.sharing;
    const index = corners.findIndex((each) => each === sharedCorner(known.sharing, side));
    const cells = new Set(corner.sides.map(({ cell }) => cell)).size;
    app.say(words.corner.chosen(index + 1, corners.length, placeText(corner.position), words.corner.shared(cells)));
  }

  /** @param {Vector} by @param {string} [run] */
  function moveBy(by, run) {
    const corner = current();
    if (!corner) return;
    const { reach } = now().shown;
    const move = (/** @type {unknown} */ document) => /** @type {any} */ (moveCorner(/** @type {BodyDocument} */ (document), corner.sides, by, reach));
    store.commit({ change: move, ...(run === undefined ? {} : { run }) });
  }

  return {
    current,
    choose,
    moveBy,
    /** @param {1 | -1} by */
    chooseNext(by) {
      const { known, shown } = now();
      const next = known && neighbour(known.sharing, shown.corner, by);
      if (next) choose(next);
    },
    /** @param {0 | 1 | 2} axis @param {number} value @param {string} [run] */
    moveTo(axis, value, run) {
      const corner = current();
      if (!corner) return;
      /** @type {Vector} */
      const by = [0, 0, 0];
      by[axis] = value - corner.position[axis];
      moveBy(by, run);
    },
    /** Moves to a place. @param {Vector} place @param {string} run */
    dragTo(place, run) {
      const corner = current();
      if (corner) moveBy(subtract(place, corner.position), run);
    },
    /** Moves by keys, all presses in one run. @param {Vector} by */
    press(by) {
      moveBy(by, pressed);
      const corner = current();
      if (corner) app.say(words.corner.moved(placeText(corner.position)));
    },
    /** No more presses of this run. */
    release() {
      pressed = newRun("corner");
      store.endRun();
    },
  };
}

/** @param {readonly number[]} place */
const placeText = (place) => `x ${coordinate(place[0])}, y ${coordinate(place[1])}, z ${coordinate(place[2])}`;
