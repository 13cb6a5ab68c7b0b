/**
 * What every part of the page is given: the document store, what is shown besides it, and the results.
 *
 * @import { CurvesDocument, Kernel, LayerName, Match, Picture, Point, Problem, Reading, Selection, Size, View } from "../types.js"
 *
 * @typedef {object} Note A sentence in the status line that stands until the next edit.
 * @property {"plain" | "error"} tone
 * @property {string} text
 * @property {{name: string, text: string, act: () => void}} [command] what can be done about it
 *
 * @typedef {object} Ui
 * @property {"figure" | "steps" | "compare" | "solid"} mode what the canvas is for
 * @property {import("../solid/state.js").SolidUi | null} solid what the picture of the solid shows; null until something is chosen there
 * @property {import("../hyperpatch/seen.js").Seen | null} [body] how the picture of a body was left
 * @property {import("../part/seen.js").Seen | null} [part] how the picture of a part was left
 * @property {import("../laboratory/seen.js").Seen | null} [lab] how the picture of a problem was left
 * @property {"curves" | "lessons"} workbench follows the address
 * @property {number} span the span of a stack that the modes `steps` and `compare` look at
 * @property {number} step the step of the greedy growth that the mode `steps` shows or would show
 * @property {Selection | null} selection read and made by the functions of selection.js
 * @property {View | null} view null until the first fit
 * @property {boolean} fitted the view follows the size of the window
 * @property {number} fitScale the scale that counts as 100 %
 * @property {Size} size of the canvas
 * @property {LayerName[]} layers
 * @property {number} isoMaterial index of the material whose lines of equal fraction are shown
 * @property {boolean} patterns hatches stand in for the colours of the materials
 * @property {"ruled" | "harmonic" | null} look the blend that two closed curves are seen with, without a change of the document; null: its own
 * @property {boolean} stageLabels whether the in-betweens have names
 * @property {boolean} composing whether composition keys stand on the curves in place of the control points
 * @property {{curve: number, index: number} | null} key the chosen composition key
 * @property {number} s place of the current in-between, 0 on the first curve
 * @property {boolean} playing
 * @property {import("../morph/motion.js").Motion} motion how the place moves when it plays
 * @property {boolean} unkept the browser's storage did not take the document
 * @property {"light" | "dark"} theme
 * @property {Reading | null} probe
 * @property {number | null} line the ruling line that is explained
 * @property {number | null} pin the chosen pin
 * @property {Point | null} witness a place the person asked to see
 * @property {Note | null} note
 * @property {string[]} open names of the open groups
 * @property {string} tab the group shown on a phone
 * @property {boolean} snap dragged points rest on the grid
 * @property {boolean} drawing a tool has the canvas, and the handles stand back
 *
 * @typedef {object} Results
 * @property {CurvesDocument | null} matched the document that `match` or `problem` belongs to
 * @property {Match | null} match
 * @property {Problem | null} problem why there is no match
 * @property {Picture | null} picture
 * @property {number | null} ms from the edit to its picture
 * @property {boolean} slow work runs for longer than a moment
 * @property {number} progress share of the running work that is done, 0 to 1
 *
 * @typedef {object} App
 * @property {import("./store.js").Store} store
 * @property {import("./record.js").Record<Ui>} ui
 * @property {import("./record.js").Record<Results>} results
 * @property {Kernel} kernel
 * @property {import("../storage/keeper.js").Keeper} keeper
 * @property {(text: string) => void} say speaks through the live region
 * @property {() => void} retry asks for the picture again
 * @property {() => void} cancel gives up running work
 * @property {Tool | null} tool what has the canvas instead of the handles
 *
 * @typedef {object} Tool
 * @property {(at: Point | null) => void} hover CSS pixels, null when the pointer leaves
 * @property {(at: Point, event: PointerEvent) => void} tap a press and release in one place
 * @property {(at: Point) => Stroke | null} stroke what a press begins that moves on; null to pan
 * @property {() => void} render
 * @property {() => void} close gives up
 *
 * @typedef {object} Stroke
 * @property {(at: Point) => void} to
 * @property {() => void} end
 * @property {() => void} undo
 */
import { strings } from "../strings.js";
import { seen } from "./in-space.js";
import { isHarmonic, lookedAt } from "./look.js";

/** Layers in the order of the panel, with the ones shown at first. */
export const LAYERS = /** @type {const} */ ([
  "material",
  "rulingLines",
  "inBetweens",
  "samples",
  "controlPoints",
  "normals",
  "grid",
  "value",
  "unitCells",
  "unconnected",
  "isoComposition",
  "difference",
]);

/** @type {readonly LayerName[]} */
export const FIRST_LAYERS = ["material", "rulingLines", "inBetweens", "samples", "unconnected", "controlPoints", "grid"];

/** @type {Readonly<Results>} */
export const NO_RESULTS = {
  matched: null,
  match: null,
  problem: null,
  picture: null,
  ms: null,
  slow: false,
  progress: 0,
};

/**
 * The name of a curve as a person reads it: its own, or by which one lies outside.
 * @param {CurvesDocument} document
 * @param {number} index
 */
export function curveName(document, index) {
  const own = document.curves[index]?.name;
  if (own) return own;
  if (document.curves.length < 2) return strings.curves.one;
  const isBlend = isHarmonic(document);
  if (document.curves.length > 2 && !isBlend) return strings.curves.nth(letterOf(index));
  const reach = document.curves.map((curve) => {
    const { points } = seen(curve);
    const xs = points.map((p) => p[0]);
    const ys = points.map((p) => p[1]);
    return (Math.max(...xs) - Math.min(...xs)) * (Math.max(...ys) - Math.min(...ys));
  });
  // Of a harmonic blend the outer curve contains all others, and its box is the largest.
  if (index === reach.lastIndexOf(Math.max(...reach))) return strings.curves.outer;
  return document.curves.length > 2 ? strings.curves.nthInner(letterOf(index)) : strings.curves.inner;
}

/** The letter of a curve: A is the first. @param {number} curve */
export const letterOf = (curve) => String.fromCharCode(65 + curve);

/** A span of a stack by the letters of its curves. @param {number} span */
export const spanName = (span) => `${letterOf(span)}\u2013${letterOf(span + 1)}`;

/**
 * The short name of a control point: A1 on the first curve, B1 on the second.
 * @param {number} curve
 * @param {number} point
 */
export function pointName(curve, point) {
  return `${letterOf(curve)}${point + 1}`;
}

/**
 * The part of the results that belongs to the document as it stands now and is looked at.
 * @param {App} app
 */
export function currentMatch(app) {
  const { match, matched } = app.results.value;
  return matched === lookedAt(app) ? match : null;
}
