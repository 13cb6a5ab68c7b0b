/**
 * What the workbench Part shows besides the document, what is known of the part, and what its pieces are given.
 *
 * @import { Isoline, PartRaster, RemotePart } from "../../../js/directrix.js"
 * @import { App } from "../state/app.js"
 * @import { Point, Size, View } from "../types.js"
 * @import { WholePart } from "./document.js"
 *
 * @typedef {object} Shown One thing is chosen at a time; a chosen shape leaves body and feature as they are.
 * @property {number | null} body index of the chosen body
 * @property {number | null} feature index of the chosen feature in the queue of that body
 * @property {string | null} shape name of the chosen shape
 * @property {number | null} point index of the chosen point of that shape
 * @property {number | null} rule index of the chosen design rule
 * @property {number | null} isolines index of the material whose lines of equal fraction are shown
 * @property {boolean} violations whether broken design rules are hatched
 * @property {boolean} leaves whether the picture has the leaves of the subdivision in place of the colours
 * @property {Leaf | null} leaf the leaf that is lit
 * @property {boolean} shapes whether reference shapes and outlines are drawn
 * @property {boolean} compare whether the three rules for overlaps stand side by side
 * @property {string | null} lit name of the shape that is lit, because what is said of a boundary is looked at
 * @property {Point | null} witness a place that shows what is wrong with what is chosen
 * @property {boolean} difference whether a body by the rule `printed` shows what it differs by from `repaired`
 *
 * @typedef {{body: number, leaf: number}} Leaf Of a body the features that hold a place, by bits.
 *
 * @typedef {object} Known What is known, and of which document.
 * @property {WholePart} document
 * @property {RemotePart} part
 * @property {PartRaster} raster of the visible box, or of the whole part where a body needs voxels
 * @property {Isoline[] | null} isolines of the material that was asked for
 * @property {Violations | null} violations in the pixels of the raster; null where they were not asked for
 * @property {PartRaster | null} reference the same pixels by the rule `repaired`, where the difference is shown
 * @property {Measured | null} measured of the whole part; null until the document rests
 * @property {boolean} isFine whether it has the pixels of the screen
 * @property {number} ms that the pixels took
 *
 * @typedef {Awaited<ReturnType<RemotePart["violations"]>>} Violations
 * @typedef {Awaited<ReturnType<RemotePart["leaves"]>>[number]} LeafRow
 *
 * @typedef {object} Measured
 * @property {number} area
 * @property {number[]} amounts area of each material
 * @property {LeafRow[]} leaves
 * @property {number} overlap share of the area where two features or more act, 0 to 1
 * @property {number} sumError largest distance of a sum of fractions from 1
 * @property {number} clamped pixels with a fraction outside 0 to 1
 * @property {Violations["rules"]} rules how many pixels break each design rule, and their area
 * @property {number} pixels of the body that were evaluated for it
 *
 * @typedef {object} Now
 * @property {WholePart} document as it stands
 * @property {Known | null} known the newest that is known
 * @property {boolean} isCurrent whether it belongs to the document as it stands
 * @property {Shown} shown
 * @property {View | null} view null until the part is fitted into the picture
 * @property {Size} size of the picture in CSS pixels
 *
 * @typedef {object} Bench What every piece of the workbench is given.
 * @property {App} app
 * @property {() => Now} now
 * @property {(patch: Partial<Shown>) => void} change chooses and shows
 * @property {(change: (document: WholePart) => WholePart, run?: string) => void} commit an edit; edits of one run are one entry of the log
 * @property {() => void} endRun
 * @property {() => number | null} step of the grid that places come to rest on, in document units; null where they do not
 * @property {() => void} request everything is drawn again
 */
import { gridStep } from "../view.js";
import { boxOf } from "./shapes/geometry.js";

/** @type {Readonly<Shown>} */
export const FIRST_SHOWN = {
  body: null,
  feature: null,
  shape: null,
  point: null,
  rule: null,
  isolines: null,
  violations: true,
  leaves: false,
  leaf: null,
  shapes: true,
  compare: false,
  difference: false,
  lit: null,
  witness: null,
};

/** What is chosen in a document that has just been opened: its first body with a blend, else its first feature, which are then there to be seen. @param {WholePart} document */
export function firstChoice({ bodies }) {
  const blended = bodies.findIndex(({ blend }) => blend !== undefined);
  if (blended >= 0) return { body: blended, feature: null };
  const body = bodies.findIndex(({ features = [] }) => features.length > 0);
  return body < 0 ? {} : { body, feature: 0 };
}

/** The step of the grid in a view, which also holds what is snapped. @param {View | null} view @param {boolean} snaps */
export const stepIn = (view, snaps) => (view && snaps ? gridStep(view.scale) : null);

/**
 * What is chosen and shown, without what the document does not have any more.
 * @param {Shown} shown
 * @param {WholePart} document
 * @returns {Shown} the same object where nothing is gone
 */
export function withoutGone(shown, { bodies, shapes = [], rules = [], materials = [] }) {
  const body = shown.body !== null && bodies[shown.body] ? shown.body : null;
  const feature = body !== null && shown.feature !== null && bodies[body].features?.[shown.feature] ? shown.feature : null;
  const shape = shapes.find(({ name }) => name === shown.shape);
  const point = shape && shown.point !== null && shown.point < countOf(shape) ? shown.point : null;
  const rule = shown.rule !== null && rules[shown.rule] ? shown.rule : null;
  const isolines = shown.isolines !== null && materials[shown.isolines] ? shown.isolines : null;
  const next = { ...shown, body, feature, shape: shape?.name ?? null, point, rule, isolines };
  const keys = /** @type {(keyof Shown)[]} */ (Object.keys(next));
  return keys.every((key) => next[key] === shown[key]) ? shown : next;
}

/** How many points a shape is given by. @param {NonNullable<WholePart["shapes"]>[number]} shape */
export const countOf = (shape) => ("points" in shape ? shape.points.length : shape.kind === "point" ? 1 : 2);

/**
 * The box of everything that is drawn: the points of all shapes, and circles as a whole.
 * @param {WholePart} document
 * @returns {[Point, Point] | null} lower left and upper right corner; null of a document without shapes
 */
export function extentOf({ shapes = [] }) {
  const [first, ...others] = shapes.map((shape) => (shape.kind === "line" ? /** @type {[Point, Point]} */ ([shape.through, shape.through]) : boxOf(shape)));
  if (!first) return null;
  return others.reduce(
    ([low, high], [least, most]) => [
      [Math.min(low[0], least[0]), Math.min(low[1], least[1])],
      [Math.max(high[0], most[0]), Math.max(high[1], most[1])],
    ],
    first,
  );
}
