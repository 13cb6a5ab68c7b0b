/**
 * Keys on shapes and their handles: arrows move, page keys go from point to point, Insert and Delete change their number.
 *
 * @import { Point } from "../../types.js"
 * @import { Bench } from "../state.js"
 * @import { Held } from "./places.js"
 */
import { ARROWS, KeyRun, stride } from "../../controls/arrows.js";
import { pointBy } from "../../stage/point-keys.js";
import { shapeNames, shapeOf } from "../edits/shapes.js";
import { handleCount } from "./geometry.js";
import { heldBy } from "./handles.js";
import { insertAfter, removePoint, removeShape } from "./insert.js";
import { nudged, spokenPlace } from "./moves.js";

/**
 * @param {Bench} bench
 * @param {ReturnType<typeof import("./handles.js").createHandles>} handles
 */
export function listenToKeys(bench, handles) {
  const runs = new KeyRun("shape keys");

  handles.element.addEventListener("focusin", (event) => {
    const held = heldBy(event.target);
    if (!held) return;
    runs.renew();
    const { shape, point } = bench.now().shown;
    if (shape !== held.shape || point !== held.point) bench.change(held);
  });

  handles.element.addEventListener("keydown", (event) => {
    const held = heldBy(event.target);
    if (!held || event.ctrlKey || event.metaKey) return;
    if (handle(event, held)) {
      event.preventDefault();
      event.stopPropagation();
    }
  });

  /**
   * @param {KeyboardEvent} event
   * @param {Held} held
   * @returns {boolean} whether the key meant something
   */
  function handle(event, held) {
    const { shape: name, point } = held;
    const shape = shapeOf(bench.now().document, name);
    if (!shape) return false;
    const arrow = ARROWS[event.key];
    if (arrow) {
      move(held, arrow, event);
      return true;
    }
    const next = pointBy(event.key, point, handleCount(shape));
    if (next !== undefined) {
      go(name, next);
      return true;
    }
    switch (event.key) {
      case "Insert":
        void insertAfter(bench, name, point ?? 0).then(refocus);
        return true;
      case "Delete":
      case "Backspace":
        if (point === null) dropWhole(name);
        else {
          removePoint(bench, name, point);
          refocus();
        }
        return true;
      case "Escape":
        if (!bench.app.store.cancel(runs.name)) return false;
        runs.renew();
        speak(held);
        return true;
      default:
        return false;
    }
  }

  /** @param {Held} held @param {Point} arrow @param {KeyboardEvent} event */
  function move(held, arrow, event) {
    const run = runs.press();
    bench.commit((document) => nudged(document, held, arrow, stride(event)), run);
    speak(held);
  }

  /** Deletes a shape, and goes on with the one that takes its place in the order. @param {string} name */
  function dropWhole(name) {
    const index = shapeNames(bench.now().document).indexOf(name);
    removeShape(bench, name);
    const names = shapeNames(bench.now().document);
    const next = names[Math.min(index, names.length - 1)];
    handles.render();
    if (next !== undefined) handles.focus({ shape: next, point: null });
  }

  /** @param {string} shape @param {number | null} point */
  function go(shape, point) {
    bench.change({ shape, point });
    handles.render();
    handles.focus({ shape, point });
  }

  function refocus() {
    handles.render();
    const { shape, point } = bench.now().shown;
    if (shape !== null) handles.focus({ shape, point });
  }

  /** @param {Held} held */
  function speak({ shape: name, point }) {
    const shape = shapeOf(bench.now().document, name);
    if (shape) bench.app.say(spokenPlace(shape, point));
  }
}
