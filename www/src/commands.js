/**
 * Every command of the page with its name and keys, in one table: the keys that work, the tooltips, the menus and the
 * shortcut sheet all come from here.
 *
 * @import { App } from "./state/app.js"
 * @import { Item } from "./frame/menu.js"
 *
 * @typedef {"document" | "mode" | "view" | "draw" | "select" | "points" | "frame" | "reading" | "fields"} Topic
 *
 * @typedef {object} Command
 * @property {string} name
 * @property {Topic} topic
 * @property {string | ((app: App) => string)} text
 * @property {string} [sheet] the name in the shortcut sheet, where that in a menu depends on the document
 * @property {string[]} [keys] such as `Ctrl+Z`; on a machine of Apple's Ctrl stands for Command
 * @property {(app: App) => string | null} [why] what keeps it from being done now
 * @property {(app: App) => boolean} [on] for a command that switches something on and off
 * @property {(app: App) => unknown} [run] without it the keys belong to what has the focus
 */
import { keyName } from "./frame/key-names.js";
import { strings } from "./strings.js";
import { fit, zoomBy } from "./stage/zoom.js";
import { curveName } from "./state/app.js";
import { canRemovePoints } from "./state/edits.js";
import { hasSpace } from "./state/in-space.js";
import { isHarmonic, lookedAt } from "./state/look.js";
import { isWhole } from "./state/selection.js";

const words = strings.commands;

const curveCommands = () => import("./stage/curve-commands.js");
const stackCommands = () => import("./stack/stack-commands.js");

/** @type {(app: App) => string | null} */
const needsTwo = ({ store }) => (store.document.curves.length > 1 ? null : words.needsTwo);
/** @type {(app: App) => string | null} */
const needsRoom = ({ store }) => (store.document.curves.length < 16 ? null : words.mostCurves);
/** @type {(app: App) => string | null} */
function whyNotInsert(app) {
  const { curves } = app.store.document;
  if (isHarmonic(app.store.document)) return words.sideBySide;
  const next = (app.ui.value.selection?.curve ?? 0) + 1;
  return curves.length < 2 ? words.needsTwo : next < curves.length ? needsRoom(app) : words.lastCurve;
}
/** @type {(app: App) => string | null} */
const needsCurve = ({ ui }) => (ui.value.selection ? null : words.needsCurve);
/** @type {(app: App) => string | null} */
const planeOnly = ({ store }) => (hasSpace(store.document) ? words.planeOnly : null);
/** @type {(app: App) => string | null} */
const needsPoint = ({ ui }) => (ui.value.selection?.points.length ? null : strings.curves.removeNone);

/** @type {(app: App) => string | null} */
function whyNotRemove(app) {
  const { selection } = app.ui.value;
  if (!selection || isWhole(selection)) return strings.curves.removeNone;
  const curve = app.store.document.curves[selection.curve];
  return canRemovePoints(curve, selection.points.length) ? null : strings.handles.tooFew(curve.degree);
}

/** @type {(app: App) => string} */
function duplicateText({ store, ui }) {
  const { selection } = ui.value;
  const { curves } = store.document;
  if (isHarmonic(store.document) && curves.length > 1) return words.duplicateInside;
  const other = selection && curves.length === 2 && curves[1 - selection.curve];
  return other && selection ? words.copyOver(curveName(store.document, 1 - selection.curve)) : words.duplicateCurve;
}

/** @type {(app: App) => string} */
function drawText({ store, ui }) {
  const { curves } = store.document;
  if (curves.length === 0) return words.draw;
  if (isHarmonic(store.document) && curves.length > 1) return words.drawInside;
  return curves.length === 1 ? words.drawSecond : words.drawOver(curveName(store.document, ui.value.selection?.curve ?? 1));
}

/** @type {(app: App) => void} */
function toggleGrid({ ui }) {
  const { layers } = ui.value;
  ui.set({ layers: layers.includes("grid") ? layers.filter((layer) => layer !== "grid") : [...layers, "grid"] });
}

/** @type {(app: App) => void} */
function toggleSnap(app) {
  const snap = !app.ui.value.snap;
  app.ui.set({ snap });
  app.say(snap ? words.snapOn : words.snapOff);
}

/** @param {App} app @param {App["ui"]["value"]["mode"]} mode @param {string} text */
function enter(app, mode, text) {
  app.ui.set({ mode });
  app.say(text);
}

/** @type {readonly Command[]} */
export const COMMANDS = [
  { name: "new", topic: "document", text: words.new, run: async (app) => (await import("./files/blank.js")).openBlank(app) },
  { name: "open", topic: "document", text: strings.file.open, keys: ["Ctrl+O"] },
  { name: "save", topic: "document", text: strings.file.save, keys: ["Ctrl+S"] },
  { name: "save-copy", topic: "document", text: strings.file.saveCopy, keys: ["Ctrl+Shift+S"] },
  {
    name: "share",
    topic: "document",
    text: words.share,
    keys: ["L"],
    run: async (app) => (await import("./share/share-panel.js")).showShare(app),
  },
  { name: "undo", topic: "document", text: words.undo, keys: ["Ctrl+Z"], run: ({ store }) => store.undo() },
  { name: "redo", topic: "document", text: words.redo, keys: ["Ctrl+Y", "Ctrl+Shift+Z"], run: ({ store }) => store.redo() },
  {
    name: "shortcuts",
    topic: "document",
    text: words.shortcuts,
    keys: ["?"],
    run: async () => (await import("./frame/shortcut-sheet.js")).openShortcuts(),
  },
  { name: "about", topic: "document", text: words.about, run: async (app) => (await import("./frame/about.js")).openAbout(app) },

  { name: "mode-figure", topic: "mode", text: words.figure, keys: ["1"], run: (app) => enter(app, "figure", words.figure) },
  { name: "mode-steps", topic: "mode", text: words.steps, keys: ["2"], run: (app) => enter(app, "steps", words.steps) },
  { name: "mode-compare", topic: "mode", text: words.compare, keys: ["3"], run: (app) => enter(app, "compare", words.compare) },
  { name: "mode-solid", topic: "mode", text: words.solid, keys: ["4"], run: (app) => enter(app, "solid", words.solid) },

  { name: "fit", topic: "view", text: words.fit, keys: ["F"], run: fit },
  { name: "zoom-in", topic: "view", text: words.zoomIn, keys: ["+", "="], run: (app) => zoomBy(app, 1) },
  { name: "zoom-out", topic: "view", text: words.zoomOut, keys: ["-"], run: (app) => zoomBy(app, -1) },
  { name: "pan", topic: "view", text: words.pan, keys: [words.dragCanvas] },
  { name: "wheel", topic: "view", text: words.wheel, keys: [words.turnWheel] },
  {
    name: "grid",
    topic: "view",
    text: words.grid,
    keys: ["G"],
    on: ({ ui }) => ui.value.layers.includes("grid"),
    run: toggleGrid,
  },
  { name: "snap", topic: "view", text: words.snap, keys: ["S", "Shift+G"], on: ({ ui }) => ui.value.snap, run: toggleSnap },
  { name: "snap-invert", topic: "view", text: words.snapInvert, keys: [words.modDrag] },
  { name: "play", topic: "view", text: words.play, keys: ["Space"] },

  {
    name: "draw",
    topic: "draw",
    text: drawText,
    sheet: words.draw,
    keys: ["D"],
    why: (app) => planeOnly(app) ?? (isHarmonic(app.store.document) ? needsRoom(app) : null),
    run: async (app) => (await import("./stage/draw.js")).startDrawing(app),
  },
  { name: "draw-point", topic: "draw", text: words.drawPoint, keys: [words.click, "Space"] },
  { name: "draw-move", topic: "draw", text: words.drawMove, keys: [words.arrows] },
  { name: "draw-back", topic: "draw", text: words.drawBack, keys: ["Backspace"] },
  { name: "draw-close", topic: "draw", text: words.drawClose, keys: ["Enter", words.doubleClick] },
  { name: "draw-cancel", topic: "draw", text: words.drawCancel, keys: ["Escape"] },

  {
    name: "select-all",
    topic: "select",
    text: words.selectAll,
    keys: ["Ctrl+A"],
    why: needsCurve,
    run: async (app) => (await curveCommands()).selectAll(app),
  },
  {
    name: "select-curve",
    topic: "select",
    text: words.selectCurve,
    keys: ["Home"],
    why: needsCurve,
    run: async (app) => (await curveCommands()).selectWhole(app),
  },
  { name: "select-add", topic: "select", text: words.selectAdd, keys: [words.shiftClick] },
  { name: "select-box", topic: "select", text: words.selectBox, keys: [words.shiftDrag] },
  { name: "next-point", topic: "select", text: words.nextPoint, keys: ["PageDown", "PageUp"] },
  { name: "extend", topic: "select", text: words.extend, keys: ["Shift+PageDown", "Shift+PageUp"] },

  { name: "nudge", topic: "points", text: words.nudge, keys: [words.arrows] },
  { name: "nudge-far", topic: "points", text: words.nudgeFar, keys: [`Shift+${words.arrows}`, `Alt+${words.arrows}`] },
  { name: "take-back", topic: "points", text: words.takeBack, keys: ["Escape"] },
  {
    name: "insert-point",
    topic: "points",
    text: words.insertPoint,
    keys: ["Insert", words.doubleClickCurve],
    why: needsCurve,
    run: async (app) => (await curveCommands()).insertPoint(app),
  },
  {
    name: "delete-points",
    topic: "points",
    sheet: words.deletePoints(1),
    text: ({ ui }) => words.deletePoints(Math.max(1, ui.value.selection?.points.length ?? 1)),
    keys: ["Delete", "Backspace"],
    why: whyNotRemove,
    run: async (app) => (await curveCommands()).deletePoints(app),
  },
  {
    name: "duplicate-point",
    topic: "points",
    text: words.duplicatePoint,
    why: needsPoint,
    run: async (app) => (await curveCommands()).duplicatePoints(app),
  },
  {
    name: "duplicate-curve",
    topic: "points",
    text: duplicateText,
    sheet: words.duplicateCurve,
    keys: ["Ctrl+D"],
    why: (app) => needsCurve(app) ?? planeOnly(app),
    run: async (app) => (await curveCommands()).duplicate(app),
  },
  {
    name: "rename-curve",
    topic: "points",
    text: words.rename,
    keys: ["F2"],
    why: needsCurve,
    run: async (app) => (await curveCommands()).rename(app),
  },
  {
    name: "swap-curves",
    topic: "points",
    text: words.swap,
    keys: ["X"],
    why: needsTwo,
    run: async (app) => (await curveCommands()).swap(app),
  },
  {
    name: "reverse-curve",
    topic: "points",
    text: words.reverse,
    keys: ["R"],
    why: needsCurve,
    run: async (app) => (await curveCommands()).reverse(app),
  },
  {
    name: "smooth-curve",
    topic: "points",
    text: words.smooth,
    why: (app) => {
      const { selection } = app.ui.value;
      if (!selection) return words.needsCurve;
      return planeOnly(app) ?? (cornersOf(app, selection.curve) > 0 ? null : words.noCorners);
    },
    run: async (app) => (await curveCommands()).smooth(app),
  },
  {
    name: "add-curve",
    topic: "points",
    text: ({ store }) => (isHarmonic(store.document) ? words.addInside : words.addCurve),
    sheet: words.addCurve,
    why: (app) => (app.store.document.curves.length > 0 ? (planeOnly(app) ?? needsRoom(app)) : words.needsCurve),
    run: async (app) => (await stackCommands()).addCurve(app),
  },
  {
    name: "insert-curve",
    topic: "points",
    text: words.insertCurve,
    why: (app) => planeOnly(app) ?? whyNotInsert(app),
    run: async (app) => (await stackCommands()).insertCurve(app),
  },
  { name: "move-curve", topic: "points", text: words.moveCurve, keys: ["Alt+ArrowUp", "Alt+ArrowDown"] },
  {
    name: "delete-curve",
    topic: "points",
    text: words.deleteCurve,
    keys: ["Shift+Delete"],
    why: needsCurve,
    run: async (app) => (await curveCommands()).removeCurve(app),
  },
  { name: "menu", topic: "points", text: words.menu, keys: [words.rightClick, "Shift+F10"] },

  { name: "frame-scale", topic: "frame", text: words.frameScale, keys: [words.dragHandle, words.arrows] },
  { name: "frame-proportion", topic: "frame", text: words.frameProportion, keys: [words.shiftDrag] },
  { name: "frame-centre", topic: "frame", text: words.frameCentre, keys: [words.altDrag] },
  { name: "frame-turn", topic: "frame", text: words.frameTurn, keys: [words.arrows] },
  { name: "frame-next", topic: "frame", text: words.frameNext, keys: ["PageDown", "PageUp"] },

  { name: "read-line", topic: "reading", text: words.readLine, keys: ["ArrowRight", "ArrowLeft"] },
  { name: "read-along", topic: "reading", text: words.readAlong, keys: ["ArrowUp", "ArrowDown"] },
  { name: "read-explain", topic: "reading", text: words.readExplain, keys: [words.click, "Enter"] },
  { name: "read-close", topic: "reading", text: words.readClose, keys: ["Escape"] },

  { name: "field-step", topic: "fields", text: words.fieldStep, keys: ["ArrowUp", "ArrowDown"] },
  { name: "field-far", topic: "fields", text: words.fieldFar, keys: [`Shift+${words.arrows}`, `Alt+${words.arrows}`] },
  { name: "field-commit", topic: "fields", text: words.fieldCommit, keys: ["Enter"] },
  { name: "field-restore", topic: "fields", text: words.fieldRestore, keys: ["Escape"] },
];

const NAMED = new Map(COMMANDS.map((command) => [command.name, command]));

/** @param {string} name @returns {Command} */
export function commandNamed(name) {
  const command = NAMED.get(name);
  if (!command) throw new Error(`there is no command ${name}`);
  return command;
}

/**
 * The name of a command as it stands on a button or in a menu.
 * @param {App} app
 * @param {string} name
 */
export function commandText(app, name) {
  const { text } = commandNamed(name);
  return typeof text === "string" ? text : text(app);
}

/**
 * A tooltip: the name with the first key, or why the command is not to be had.
 * @param {App} app
 * @param {string} name
 */
export function commandTitle(app, name) {
  const { keys = [], why } = commandNamed(name);
  const text = commandText(app, name);
  const reason = why?.(app);
  if (reason) return `${text}: ${reason}`;
  return keys[0] ? `${text} (${shownKey(keys[0])})` : text;
}

/**
 * What keeps a command from being done, or null.
 * @param {App} app
 * @param {string} name
 */
export const commandReason = (app, name) => commandNamed(name).why?.(app) ?? null;

/**
 * @param {App} app
 * @param {string} name
 * @returns {boolean} whether it could be done
 */
export function runCommand(app, name) {
  const { run } = commandNamed(name);
  if (!run) return false;
  const reason = commandReason(app, name);
  if (reason) {
    app.ui.set({ note: { tone: "plain", text: reason } });
    app.say(reason);
    return false;
  }
  void run(app);
  return true;
}

/**
 * Entries of a menu. Commands that cannot be done are left out, except those whose reason helps.
 * @param {App} app
 * @param {(string | "line")[]} names
 * @returns {(Item | "line")[]}
 */
export function commandItems(app, names) {
  return names.map((name) => {
    if (name === "line") return "line";
    const { keys = [], why, on } = commandNamed(name);
    const reason = why?.(app) ?? null;
    return {
      name,
      text: commandText(app, name),
      act: () => void runCommand(app, name),
      ...(keys[0] ? { keys: keys[0] } : {}),
      ...(reason ? { line: reason, disabled: true } : {}),
      ...(on ? { checked: on(app) } : {}),
    };
  });
}

/** Corners that the result found on a curve. @param {App} app @param {number} curve */
export function cornersOf(app, curve) {
  const { match, matched } = app.results.value;
  if (!match || matched !== lookedAt(app)) return 0;
  return match.diagnostics.filter((each) => each.code === "corner" && each.curve === curve).length;
}

/** A key as it is written on the keyboard. @param {string} key */
export function shownKey(key) {
  if (key === "-") return "\u2212";
  return keyName(key.replace(/(Arrow|Page)\w+|Escape/, (name) => KEY_NAMES[name] ?? name));
}

/** @type {{[key: string]: string}} */
const KEY_NAMES = {
  ArrowUp: "\u2191",
  ArrowDown: "\u2193",
  ArrowLeft: "\u2190",
  ArrowRight: "\u2192",
  PageUp: "Page up",
  PageDown: "Page down",
  Escape: "Esc",
};

/**
 * The command that a key press means on the page as a whole.
 * @param {KeyboardEvent} event
 * @returns {Command | null}
 */
export function commandOf(event) {
  const letter = event.key.length === 1;
  const key = event.key === " " ? "Space" : letter ? event.key.toUpperCase() : event.key;
  const shift = event.shiftKey && (!letter || /\p{L}/u.test(key));
  const name = `${event.ctrlKey || event.metaKey ? "Ctrl+" : ""}${event.altKey ? "Alt+" : ""}${shift ? "Shift+" : ""}${key}`;
  return COMMANDS.find(({ keys, run }) => run && keys?.includes(name)) ?? null;
}
