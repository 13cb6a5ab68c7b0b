/**
 * The chosen corner, or one of its neighbours: where it is, how it is chosen, and how it is moved, alone or with others.
 *
 * @import { App } from "../state/app.js"
 * @import { Vector } from "../space/vector.js"
 * @import { BodyDocument } from "./document.js"
 * @import { Axis, Place, Side } from "./edits.js"
 * @import { Mirror } from "./editing/mirror.js"
 * @import { Known } from "./runner.js"
 * @import { Shown } from "./state.js"
 */
import { newRun } from "../controls/run.js";
import { coordinate } from "../format.js";
import { add, diagonalOf, middleOf, subtract } from "../space/vector.js";
import { placeOf } from "./cell.js";
import { bodyOf } from "./document.js";
import { mirroredWay, opposite } from "./editing/mirror.js";
import { moved, movedSince, placeOfCorner } from "./edits.js";
import { boundsOf, isSide, neighbour, sharedCorner } from "./state.js";
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

  /** The chosen coefficient where the document has it now, with all cells of its corner. */
  function current() {
    const { known, shown } = now();
    const found = known && sharedCorner(known.sharing, shown.corner);
    if (!found || !shown.corner) return null;
    const place = shown.at ?? placeOfCorner(shown.corner);
    const position = positionOf(place);
    return position ? { position, place, sides: found.sides } : null;
  }

  /** Where a coefficient is once the edits at hand are done. @param {Place} place @returns {Vector | null} */
  function positionOf(place) {
    const { known } = now();
    const [i, j, k] = place.at;
    const coefficient = known?.cellOf(place.cell)?.coefficients[placeOf(i, j, k)];
    return known && coefficient ? add(coefficient.position, movedSince(bodyOf(app), known.document, place)) : null;
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

  /** The mirror plane in force. @returns {Mirror | null} */
  function mirror() {
    const { known, shown } = now();
    if (shown.mirror === "off" || !known) return null;
    const axis = /** @type {Axis} */ ("xyz".indexOf(shown.mirror));
    return { axis, at: shown.isMiddle ? middleOf(boundsOf(known.surface.positions))[axis] : 0 };
  }

  /** What lies opposite of a coefficient of a corner. @param {Side} side @param {Place} place @param {Mirror} plane */
  function across(side, place, plane) {
    const { known } = now();
    return known ? opposite(side, place, plane, { ...known, size: diagonalOf(boundsOf(known.surface.positions)) }) : null;
  }

  /** All that a way moves: what is chosen, corners that move as well, and what lies opposite. @param {Vector} by */
  function movesOf(by) {
    const { shown } = now();
    const { corner, others } = shown;
    if (!corner) return [];
    const plane = mirror();
    const also = shown.at ? [] : others.filter((each) => !isSide(each, corner));
    const targets = [{ side: corner, place: shown.at ?? placeOfCorner(corner) }, ...also.map((side) => ({ side, place: placeOfCorner(side) }))];
    /** @type {Map<string, {place: Place, by: Vector}>} */
    const moves = new Map();
    for (const { side, place } of targets) {
      const other = plane && across(side, place, plane);
      const within = other === "itself" && plane ? /** @type {Vector} */ (by.map((length, k) => (k === plane.axis ? 0 : length))) : by;
      moves.set(keyOf(side, place), { place, by: within });
      if (!plane || !other || other === "itself") continue;
      const key = keyOf({ cell: other.cell, corner: other.at.map((along) => (along > 1 ? 1 : 0)) }, other);
      if (!moves.has(key)) moves.set(key, { place: other, by: mirroredWay(by, plane.axis) });
    }
    return [...moves.values()];
  }

  /** One name for a coefficient, whichever of its cells it is told by. @param {Side} side @param {Place} place */
  function keyOf(side, { cell, at }) {
    const { known } = now();
    const isItself = at.every((along, k) => along === 3 * side.corner[k]);
    const corner = isItself && known ? known.sharing.corners.findIndex(({ sides }) => sides.some((each) => isSide(each, side))) : -1;
    return corner < 0 ? `${cell} ${at.join("")}` : `corner ${corner}`;
  }

  /** @param {Vector} by @param {string} [run] */
  function moveBy(by, run) {
    const { reach } = now().shown;
    const moves = movesOf(by);
    const move = (/** @type {unknown} */ document) => /** @type {any} */ (moved(/** @type {BodyDocument} */ (document), moves, reach, run));
    store.commit({ change: move, ...(run === undefined ? {} : { run }) });
  }

  return {
    current,
    choose,
    moveBy,
    /** What lies opposite of what is chosen: a coefficient, itself, or nothing; null without a mirror. @returns {"partner" | "itself" | "alone" | null} */
    opposite() {
      const { shown } = now();
      const plane = mirror();
      if (!plane || !shown.corner) return null;
      const found = across(shown.corner, shown.at ?? placeOfCorner(shown.corner), plane);
      return found === "itself" ? "itself" : found ? "partner" : "alone";
    },
    /** @param {1 | -1} by */
    chooseNext(by) {
      const { known, shown } = now();
      const next = known && neighbour(known.sharing, shown.corner, by);
      if (next) choose(next);
    },
    /** @param {Axis} axis @param {number} value @param {string} [run] */
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
