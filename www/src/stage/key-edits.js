/**
 * Edits of composition keys, from the curve and from the strip alike: choose, slide, add, remove, by pointer and by key.
 *
 * @import { App } from "../state/app.js"
 * @import { CurvesDocument } from "../types.js"
 *
 * @typedef {{curve: number, index: number}} Key
 */
import { KeyRun, stride } from "../controls/arrows.js";
import { whileHeld } from "../controls/held.js";
import { newRun } from "../controls/run.js";
import { fixed, percent } from "../format.js";
import { curveName } from "../state/app.js";
import { isOpen } from "../spline.js";
import { afterKey, followed, insertKey, removeKey, shortWay, slideKey, wrapped } from "../state/composition.js";
import { strings } from "../strings.js";

/** Part of the domain that an arrow key slides a key. */
const STEP = 0.01;
/** Pixels before a press counts as a drag. */
const DEAD = 3;

const runs = new KeyRun("key");

/** @param {App} app @param {Key} key */
export function choose(app, { curve, index }) {
  const { key } = app.ui.value;
  if (key?.curve !== curve || key.index !== index) app.ui.set({ key: { curve, index } });
}

/**
 * Slides a key and goes on with it where it then stands in the list.
 * @param {App} app
 * @param {Key} key
 * @param {number} by part of the domain
 * @param {string} name of the run
 * @returns {Key}
 */
export function slide(app, { curve, index }, by, name) {
  const before = app.store.document;
  app.store.commit({ run: name, change: (document) => slideKey(document, curve, index, by) });
  const key = { curve, index: followed(before, app.store.document, curve, index) };
  choose(app, key);
  return key;
}

/**
 * Adds a key, or chooses the one that is there.
 * @param {App} app
 * @param {number} curve
 * @param {number} at
 */
export function insert(app, curve, at) {
  const before = app.store.document;
  app.store.commit({ change: (document) => insertKey(document, curve, at) });
  const { document } = app.store;
  const shape = document.curves[curve];
  const ways = shape.composition.map((key) => Math.abs(shortWay(key.at, at, isOpen(shape))));
  const key = { curve, index: ways.indexOf(Math.min(...ways)) };
  choose(app, key);
  if (document !== before) app.say(strings.composition.added(spokenKey(document, key)));
  return key;
}

/** Adds a key half-way to the next. @param {App} app @param {Key} key */
export const insertAfter = (app, { curve, index }) =>
  insert(app, curve, afterKey(app.store.document.curves[curve].composition, index, isOpen(app.store.document.curves[curve])));

/**
 * Removes a key; the last one of a curve stays.
 * @param {App} app
 * @param {Key} key
 * @returns {Key} the one that is chosen then
 */
export function remove(app, { curve, index }) {
  const { composition } = app.store.document.curves[curve];
  if (composition.length < 2) {
    app.say(strings.composition.lastStays);
    return { curve, index };
  }
  app.store.commit({ change: (document) => removeKey(document, curve, index) });
  const next = { curve, index: Math.min(index, composition.length - 2) };
  app.ui.set({ key: next });
  app.say(strings.composition.removed(spokenKey(app.store.document, next)));
  return next;
}

/**
 * What a key on a focused handle does.
 * @param {App} app
 * @param {KeyboardEvent} event
 * @param {Key} key
 * @returns {Key | null} the one that has the focus then, or null when the key means nothing here
 */
export function pressed(app, event, key) {
  if (event.ctrlKey || event.metaKey) return null;
  const { curve, index } = key;
  const count = app.store.document.curves[curve].composition.length;
  const chosen = (/** @type {number} */ to) => ({ curve, index: to });
  switch (event.key) {
    case "ArrowRight":
    case "ArrowUp":
      return slideBy(app, event, key, 1);
    case "ArrowLeft":
    case "ArrowDown":
      return slideBy(app, event, key, -1);
    case "PageDown":
      return chosen((index + 1) % count);
    case "PageUp":
      return chosen((index + count - 1) % count);
    case "Home":
      return chosen(0);
    case "End":
      return chosen(count - 1);
    case "Insert":
      return insertAfter(app, key);
    case "Delete":
    case "Backspace":
      return remove(app, key);
    case "Escape": {
      if (!app.store.cancel(runs.name)) return null;
      runs.renew();
      const back = chosen(Math.min(index, app.store.document.curves[curve].composition.length - 1));
      app.say(spokenKey(app.store.document, back));
      return back;
    }
    default:
      return null;
  }
}

/** @param {App} app @param {KeyboardEvent} event @param {Key} key @param {1 | -1} sign */
function slideBy(app, event, key, sign) {
  const run = runs.press();
  const moved = slide(app, key, sign * STEP * stride(event), run);
  app.say(spokenKey(app.store.document, moved));
  return moved;
}

/**
 * Lets a pressed handle be dragged along its curve until it is let go.
 * @param {App} app
 * @param {PointerEvent} down
 * @param {Key} key
 * @param {(event: PointerEvent) => number} fractionAt the place of the curve under the pointer
 */
export function dragKey(app, down, key, fractionAt) {
  const name = newRun("key drag");
  const composition = () => app.store.document.curves[key.curve].composition;
  const open = isOpen(app.store.document.curves[key.curve]);
  const grip = shortWay(fractionAt(down), composition()[key.index].at, open);
  let held = key;
  let moved = false;
  /** @param {PointerEvent} event */
  const move = (event) => {
    if (!moved && Math.hypot(event.clientX - down.clientX, event.clientY - down.clientY) < DEAD) return;
    moved = true;
    const from = composition()[held.index]?.at;
    if (from !== undefined) held = slide(app, held, shortWay(from, wrapped(fractionAt(event) + grip, open), open), name);
  };
  /** @param {boolean} undo */
  const finish = (undo) => {
    if (undo) app.store.cancel(name);
    app.store.endRun();
    if (moved && !undo) app.say(spokenKey(app.store.document, held));
  };
  whileHeld({ move, finish });
}

/**
 * A mix in words, without what is not in it.
 * @param {CurvesDocument} document
 * @param {number[]} mix
 */
const spokenMix = ({ materials }, mix) =>
  mix.flatMap((part, i) => (part > 0 ? [strings.mixing.share(materials[i]?.name ?? "", percent(part))] : [])).join(", ");

/**
 * @param {CurvesDocument} document
 * @param {Key} key
 */
export function spokenKey(document, { curve, index }) {
  const keys = document.curves[curve].composition;
  const { at, mix } = keys[index];
  const name = strings.composition.key(index + 1, keys.length, curveName(document, curve));
  return strings.composition.spoken(name, fixed(at, 3), spokenMix(document, mix));
}
