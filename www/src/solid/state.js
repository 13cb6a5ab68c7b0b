/**
 * What the picture of the solid shows besides the document: kept with the page, never in the document.
 *
 * @import { App } from "../state/app.js"
 * @import { CurvesDocument } from "../types.js"
 * @import { Camera } from "../space/camera.js"
 * @import { Section } from "../space/section.js"
 * @import { Plane } from "../space/plane.js"
 * @import { Solid, SolidOptions } from "../../../js/directrix.js"
 *
 * @typedef {Solid & {bounds: NonNullable<Solid["bounds"]>}} Whole A solid that is there.
 * @typedef {"rulings" | "stages" | "curves" | "caps" | "light" | "wireframe"} SolidLayer
 * @typedef {"material" | "fraction" | "twist" | "flank"} SolidColor
 *
 * @typedef {object} SolidUi
 * @property {{camera: Camera, of: string} | null} seen from where, and which opening of a document that was; null for the first view
 * @property {SolidColor} color
 * @property {number} material index of the material whose fraction is shown
 * @property {SolidLayer[]} layers
 * @property {Section} section
 * @property {number} upTo how much of the body stands, 0 to 1
 */
import { extentAlong } from "../space/plane.js";
import { AXES } from "../space/section.js";
import { segmentsOf } from "../state/stages.js";

export const SOLID_LAYERS = /** @type {const} */ (["rulings", "stages", "curves", "caps", "light", "wireframe"]);

/** @type {Readonly<SolidUi>} */
const FIRST = {
  seen: null,
  color: "material",
  material: 0,
  layers: ["rulings", "stages", "curves", "caps", "light"],
  section: { axis: "off", at: 0.5, flipped: false },
  upTo: 1,
};

/** @param {App} app @returns {Readonly<SolidUi>} */
export const solidUi = ({ ui }) => ui.value.solid ?? FIRST;

/** @param {App} app @param {Partial<SolidUi>} patch */
export function changeSolid(app, patch) {
  app.ui.set({ solid: { ...solidUi(app), ...patch } });
}

/**
 * The colours that the kernel is asked for.
 * @param {SolidUi} shown
 * @param {number} materials how many there are
 * @returns {SolidOptions["color"]}
 */
export function colorOf({ color, material }, materials) {
  return color === "fraction" ? { material: Math.min(material, materials - 1) } : color;
}

/** Rows of the mesh from curve to curve at least, so that the surface looks smooth. */
const ROWS = 24;
/** Rows that the kernel makes at most. */
const MOST_ROWS = 200;

/** Rows of the mesh of a document: a multiple of its stages, each of which is a row. @param {CurvesDocument} document */
export function rowsOf(document) {
  const stages = segmentsOf(document);
  return Math.min(MOST_ROWS, stages * Math.ceil(ROWS / stages));
}

/**
 * The in-between curves of a document among the rows of its mesh.
 * @param {CurvesDocument} document
 * @param {Float32Array[]} rows the first and the last of which are curves
 */
export function stagesAmong(document, rows) {
  const every = rowsOf(document) / segmentsOf(document);
  return rows.slice(1, -1).filter((_, i) => (i + 1) % every === 0);
}

/**
 * Heights of the first and the last curve where every curve lies at one height and these rise or fall all the way; null else.
 * @param {Pick<Solid, "curves">} solid
 * @returns {number[] | null} of all curves
 */
export function levelsOf({ curves }) {
  const levels = curves.map((points) => {
    const [low, high] = extentAlong(AXES.z, points);
    return { level: points[2], isFlat: high - low <= 1e-6 * Math.max(Math.abs(high), Math.abs(low), 1e-30) };
  });
  const heights = levels.map(({ level }) => level);
  const steps = heights.slice(1).map((height, i) => Math.sign(height - heights[i]));
  const isEven = steps.length > 0 && steps.every((step) => step !== 0 && step === steps[0]);
  return isEven && levels.every(({ isFlat }) => isFlat) ? heights : null;
}

/**
 * The height at a share of the way through all curves; every curve begins an equal share.
 * @param {number[]} levels
 * @param {number} s 0 to 1
 */
export function heightAt(levels, s) {
  const parts = levels.length - 1;
  const k = Math.min(parts - 1, Math.floor(s * parts));
  return levels[k] + (s * parts - k) * (levels[k + 1] - levels[k]);
}

/**
 * The share of the way at a height: the inverse of `heightAt`.
 * @param {number[]} levels
 * @param {number} height
 */
export function shareAt(levels, height) {
  const parts = levels.length - 1;
  const isRising = levels[parts] > levels[0];
  const within = (/** @type {number} */ level) => (isRising ? height <= level : height >= level);
  const found = levels.slice(1).findIndex(within);
  const k = found < 0 ? parts - 1 : found;
  const s = (k + (height - levels[k]) / (levels[k + 1] - levels[k])) / parts;
  return Math.min(1, Math.max(0, s));
}

/**
 * The plane above which nothing stands yet while the body is built up.
 * @param {number[] | null} levels
 * @param {number} upTo
 * @returns {Plane | null}
 */
export function upToPlane(levels, upTo) {
  if (!levels || upTo >= 1) return null;
  const height = heightAt(levels, upTo);
  const isRising = levels[levels.length - 1] > levels[0];
  return isRising ? { normal: [0, 0, -1], offset: -height } : { normal: [0, 0, 1], offset: height };
}
