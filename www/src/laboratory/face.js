/**
 * The pixels of a solution: of the section of one in space, or of the whole of one in the plane. Few of them while something moves, many when it rests.
 *
 * @import { Bounds } from "../space/vector.js"
 * @import { FaceFrame, Section } from "./section-state.js"
 * @import { Bench, Known } from "./state.js"
 *
 * @typedef {object} Face
 * @property {Known} of
 * @property {string} key of its place
 * @property {FaceFrame} frame
 * @property {[number, number]} size
 * @property {Float32Array[]} values of each material, row by row, from `frame.origin` on; NaN outside
 * @property {number} clamped pixels that were taken back to the range
 * @property {number} inside pixels
 * @property {boolean} isFine
 * @property {number} ms
 */
import { problem } from "../painter.js";
import { cornersOf } from "../space/vector.js";
import { Lane } from "../state/lane.js";
import { faceFrame, planeOf, pixelsOf } from "./section-state.js";

/** Pixels along the longer side: while something moves, and at rest at least and at most. */
const COARSE = 72;
const FINE = { least: 160, most: 512 };
/** Products of pixels and elements that a picture at rest may take. */
const WORK = 8e8;
/** Milliseconds of rest before all pixels are evaluated. */
const REST = 140;

/**
 * @param {Bench} bench
 * @param {(face: Face | null) => void} found
 */
export function createFace(bench, found) {
  const { app } = bench;
  /** @type {Face | null} */
  let latest = null;
  let asked = "";
  /** @type {Known | null} */
  let askedOf = null;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let timer;

  /** @type {Lane<{known: Known, frame: FaceFrame, key: string, isFine: boolean}, Face>} */
  const lane = new Lane({
    async work({ known, frame, key, isFine }, signal) {
      const { solution, boundary, mesh } = known;
      if (!solution) throw new Error("there is no solution");
      const started = performance.now();
      const size = pixelsOf(frame.sides, isFine ? finest(mesh.count) : COARSE);
      const cut = (/** @type {readonly number[]} */ vector) => vector.slice(0, boundary.dimension);
      const raster = await solution.section({ origin: cut(frame.origin), sides: [cut(frame.sides[0]), cut(frame.sides[1])], size }, { signal });
      return { of: known, key, frame, size: raster.size, values: raster.values, clamped: raster.clamped, inside: raster.inside, isFine, ms: performance.now() - started };
    },
    done(face, { known, key }) {
      if (known !== askedOf) return;
      latest = face;
      found(face);
      if (!face.isFine && key === asked && !lane.waits) rest({ known, frame: face.frame, key });
    },
    failed(error) {
      const { name, message } = problem(error);
      if (name !== "AbortError") app.ui.set({ note: { tone: "error", text: message } });
    },
  });

  /** @param {{known: Known, frame: FaceFrame, key: string}} job */
  function rest(job) {
    clearTimeout(timer);
    timer = setTimeout(() => {
      if (job.key !== asked || job.known !== askedOf) return;
      if (app.store.running) rest(job);
      else lane.push({ ...job, isFine: true });
    }, REST);
  }

  return {
    get latest() {
      return latest;
    },
    /** Asks for what the picture lacks. @param {Known | null} known @param {Section | null} section of a problem in space */
    request(known, section) {
      const frame = known?.solution ? frameOf(known, section) : null;
      const key = frame ? JSON.stringify(frame) : "";
      if (key === asked && (known === askedOf || !frame)) return;
      clearTimeout(timer);
      const isSameSolution = latest !== null && latest.of.solution === known?.solution;
      [asked, askedOf] = [key, known];
      if (!known || !frame) {
        lane.cancel();
        if (latest) {
          latest = null;
          found(null);
        }
        return;
      }
      if (isSameSolution && latest?.key === key) {
        latest = { ...latest, of: known };
        found(latest);
        return;
      }
      lane.push({ known, frame, key, isFine: false });
    },
    close() {
      clearTimeout(timer);
      lane.cancel();
    },
  };
}

/** The rectangle that is asked for. @param {Known} known @param {Section | null} section @returns {FaceFrame | null} */
function frameOf({ mesh }, section) {
  if (!mesh.soup) return boxFrame(mesh.bounds);
  return section && faceFrame(planeOf(section), Float32Array.from(cornersOf(mesh.bounds).flat()));
}

/** @param {Bounds} bounds of a boundary in the plane @returns {FaceFrame} */
const boxFrame = ({ min, max }) => ({ origin: [min[0], min[1], 0], sides: [[max[0] - min[0], 0, 0], [0, max[1] - min[1], 0]] });

/** Pixels along the longer side at rest, for so many elements. @param {number} count */
const finest = (count) => Math.round(Math.min(FINE.most, Math.max(FINE.least, Math.sqrt(WORK / Math.max(1, count)))));
