/**
 * Keeps what is known of a part up with the document and the view: coarse pixels while something moves, all pixels of the screen and the measures of the
 * whole part when it rests. Whatever is known names the document that it belongs to.
 *
 * @import { Control } from "../../../js/directrix.js"
 * @import { App } from "../state/app.js"
 * @import { Problem, Size, View } from "../types.js"
 * @import { WholePart } from "./document.js"
 * @import { Frame } from "./raster.js"
 * @import { Known, Measured, Shown } from "./state.js"
 *
 * @typedef {object} Wanted
 * @property {string} of the opening of the document
 * @property {WholePart} document
 * @property {View} view
 * @property {Size} size
 * @property {number} ratio device pixels for one of CSS
 * @property {Pick<Shown, "isolines" | "violations" | "difference">} shown
 *
 * @typedef {Wanted & {isFine: boolean}} Job
 */
import { problem } from "../painter.js";
import { Lane } from "../state/lane.js";
import { coarsePixels, FINE, LINES, MEASURED, needsVoxels, thinned, visibleFrame, VOXELS, wholeFrame } from "./raster.js";

/** Milliseconds of rest before all pixels are evaluated. */
const REST = 180;
/** Share of a new measurement in the mean speed. */
const FOLLOW = 0.4;
/** What is evaluated where nothing is seen. @type {Frame} */
const NOTHING = { size: [1, 1], box: [[0, 0], [1, 1]] };
/** Lines of equal fraction every tenth, and every fifth while something moves. */
const LEVELS = { fine: [0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9], coarse: [0.2, 0.4, 0.6, 0.8] };

/**
 * @param {App} app
 * @param {object} listeners
 * @param {(known: Known) => void} listeners.changed
 * @param {(error: Problem) => void} listeners.refused the part cannot be read or evaluated
 * @param {(error: Problem) => void} listeners.interrupted the person cancelled, or the module stopped
 */
export function createRunner(app, { changed, refused, interrupted }) {
  const { kernel, results, store } = app;
  /** @type {Wanted | null} */
  let newest = null;
  /** @type {Known | null} */
  let latest = null;
  /** What the newest pixels of a page at rest are of. @type {Wanted | null} */
  let fineOf = null;
  /** Pixels evaluated for a millisecond, lately. @type {number | null} */
  let rate = null;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let timer;
  /** Whether what runs is for a page at rest, and whether it is given up for something newer, of which nobody is told. */
  let isFineRunning = false;
  let isSuperseded = false;

  /** @type {Lane<Job, Known>} */
  const lane = new Lane({
    async work(job, signal) {
      [isSuperseded, isFineRunning] = [false, job.isFine];
      /** @type {Control} */
      const control = { signal, onprogress: (progress) => results.set({ progress }) };
      const { document } = job;
      const part = latest?.document === document ? latest.part : await kernel.part(document, control);
      const found = await look(part, job, control);
      /** @type {Known} */
      const known = { document, part, ...found, measured: latest?.document === document ? latest.measured : null, isFine: job.isFine };
      if (job.isFine) fineOf = job;
      if (!job.isFine || known.measured) return known;
      // The picture does not wait for the measures.
      if (document === newest?.document) tell(known);
      return { ...known, measured: await measure(part, document, control) };
    },
    done(known, { isFine, of }) {
      // A picture that an edit has overtaken is shown all the same, because in a drag all of them are; one of another opening is not.
      if (of !== newest?.of) return;
      tell(known);
      if (!isFine && !lane.waits) rest();
    },
    failed(error, { document }) {
      const reason = problem(error);
      if (document !== newest?.document || (reason.name === "AbortError" && isSuperseded)) return;
      if (reason.name === "AbortError" || reason.code === "trap") interrupted(reason);
      else refused(reason);
    },
    slow: (slow) => results.set(slow ? { slow } : { slow, progress: 0 }),
  });

  /** The pixels of a job. @param {Known["part"]} part @param {Job} job @returns {Frame | null} */
  function frameOf(part, { document, view, size, ratio, isFine }) {
    if (needsVoxels(document)) return part.box && wholeFrame(part.box, isFine ? VOXELS.fine : VOXELS.coarse);
    return visibleFrame(view, size, ratio, isFine ? FINE : coarsePixels(rate));
  }

  /**
   * The picture: colours, lines and broken rules in the same pixels, so that each is evaluated once.
   * @param {Known["part"]} part
   * @param {Job} job
   * @param {Control} control
   */
  async function look(part, job, control) {
    const frame = frameOf(part, job);
    const { shown, isFine, document } = job;
    const started = performance.now();
    const at = frame ?? NOTHING;
    // Of a part with voxels, and where only lines or hatching are asked for, the same pixels are there already.
    const same = latest?.document === document && isSame(latest.raster, at) ? latest : null;
    const raster = same?.raster ?? (await part.evaluate({ ...at, colors: true }, control));
    const ms = same?.ms ?? performance.now() - started;
    if (!same && !isFine && !needsVoxels(document)) rate = smoothed(rate, (raster.size[0] * raster.size[1]) / Math.max(1, ms));
    const violations = shown.violations && (document.rules ?? []).length > 0 ? (same?.violations ?? (await part.violations(at, control))) : null;
    const isolines =
      shown.isolines === null ? null : await part.isolines({ ...thinned(at, LINES), material: shown.isolines, levels: LEVELS[isFine ? "fine" : "coarse"] }, control);
    const reference = shown.difference && needsVoxels(document) ? (same?.reference ?? (await (await kernel.part(repaired(document), control)).evaluate(at, control))) : null;
    return { raster, ms, violations, isolines, reference };
  }

  /** @param {Known["part"]} part @param {WholePart} document @param {Control} control @returns {Promise<Measured>} */
  async function measure(part, document, control) {
    const none = { area: 0, amounts: (document.materials ?? []).map(() => 0), leaves: [], overlap: 0, sumError: 0, clamped: 0, rules: [], pixels: 0 };
    if (!part.box) return none;
    const frame = wholeFrame(part.box, needsVoxels(document) ? VOXELS.fine : MEASURED);
    const raster = await part.evaluate(frame, control);
    const { area, amounts } = await part.amounts(frame, control);
    const leaves = await part.leaves(frame, control);
    const rules = (document.rules ?? []).length > 0 ? (await part.violations(frame, control)).rules : [];
    const overlapping = leaves.filter(({ features }) => features.length > 1).reduce((sum, leaf) => sum + leaf.area, 0);
    return { area, amounts, leaves, overlap: area > 0 ? overlapping / area : 0, ...checked(raster), rules };
  }

  /** Whether all pixels are there already, and something else is wanted of them. @param {Wanted} wanted */
  const isAtRest = ({ document, view, size }) =>
    latest?.isFine === true && latest.document === document && (needsVoxels(document) || (fineOf?.view === view && fineOf.size === size));

  /** @param {Known} known */
  function tell(known) {
    latest = known;
    changed(known);
  }

  /** All pixels once nothing moves. */
  function rest() {
    clearTimeout(timer);
    timer = setTimeout(() => {
      if (!newest) return;
      if (store.running) rest();
      else lane.push({ ...newest, isFine: true });
    }, REST);
  }

  return {
    /** @param {Wanted} wanted */
    push(wanted) {
      newest = wanted;
      clearTimeout(timer);
      if (lane.busy && isFineRunning) {
        isSuperseded = true;
        lane.cancel();
      }
      lane.push({ ...wanted, isFine: isAtRest(wanted) });
    },
    /** Gives up for the person, who is told. */
    cancel() {
      clearTimeout(timer);
      lane.cancel();
    },
    /** Nothing is wanted any more. */
    close() {
      newest = null;
      clearTimeout(timer);
      lane.cancel();
      results.set({ slow: false, progress: 0 });
    },
  };
}

/** Whether a raster has these pixels. @param {Pick<Known["raster"], "size" | "box">} raster @param {Frame} frame */
const isSame = ({ size, box }, frame) => String([size, box]) === String([frame.size, frame.box]);

/** A mean that follows what is measured within a few measurements. @param {number | null} mean @param {number} next */
const smoothed = (mean, next) => (mean === null ? next : mean + FOLLOW * (next - mean));

/** The document with every body by the rule `repaired`. @param {WholePart} document @returns {WholePart} */
export const repaired = (document) => ({ ...document, bodies: document.bodies.map((body) => ({ ...body, rule: "repaired" })) });

/**
 * What every fraction has to keep to, over the pixels of bodies.
 * @param {{body: Uint8Array, fractions: Float32Array[]}} raster
 * @returns {{pixels: number, sumError: number, clamped: number}}
 */
export function checked({ body, fractions }) {
  let [pixels, sumError, clamped] = [0, 0, 0];
  for (let n = 0; n < body.length; n += 1) {
    if (body[n] === 0) continue;
    pixels += 1;
    let sum = 0;
    let isOutside = false;
    for (const list of fractions) {
      sum += list[n];
      if (list[n] < 0 || list[n] > 1) isOutside = true;
    }
    sumError = Math.max(sumError, Math.abs(sum - 1));
    if (isOutside) clamped += 1;
  }
  return { pixels, sumError, clamped };
}
