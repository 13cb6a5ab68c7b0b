/**
 * A picture in space that a person moves, by pointer, touch and keys; with a plane that cuts, and a place that is read.
 *
 * @import { App } from "../state/app.js"
 * @import { Camera, Frame, StandardView } from "./camera.js"
 * @import { Move } from "./keys.js"
 * @import { PlaneMoves } from "./plane-mark.js"
 * @import { Bounds, Vector } from "./vector.js"
 * @import { Point } from "../types.js"
 *
 * @typedef {object} ViewerWords
 * @property {string} handle the plane of the section
 * @property {(view: StandardView) => string} view said when the body is seen from there
 * @property {string} fitted
 * @property {(percent: string) => string} zoomed
 * @property {(azimuth: string, elevation: string) => string} turned
 *
 * @typedef {object} ViewerActs
 * @property {() => "light" | "dark" | null} draw brings the objects up with the camera; the theme, or null where there is nothing yet
 * @property {(at: Point | null) => void} read what is seen at a place of the screen; null where nothing is pointed at
 * @property {() => void} speak says what is read in the middle
 * @property {() => Vector[]} hull the points that have to be seen
 * @property {() => Bounds | null} box of the body
 * @property {() => Vector[]} [reach] points that are drawn besides, which need not be seen at once
 * @property {(at: Point, isMore: boolean) => void} [tap] besides reading the place; without it a second tap ends the reading
 * @property {() => void} [turned] the camera stands elsewhere
 * @property {() => void} [rested] the camera has been moved, and rests for now
 * @property {PlaneMoves} plane what moving the plane of the section does
 * @property {(isLost: boolean) => void} oncontext
 */
import { h } from "../dom.js";
import { fixed } from "../format.js";
import { axesOf, dragged, eyeOf, fitted, middleOf, panned, STANDARD, turned, zoomed } from "./camera.js";
import { listenToGestures } from "./gestures.js";
import { PlaneMark } from "./plane-mark.js";
import { Space } from "./space.js";
import { createTriad } from "./triad.js";

/** The accent of lines by theme. */
export const ACCENT = { light: "#4a45c8", dark: "#a8a4ff" };
/** How far below the ground line the eye has to be for the shadow to go, as a share of the distance. */
const GROUND = -0.02;
/** Room round the body for its shadow, as a share of its longer side, and of that what is needed above and below. */
const ROOM = 0.4;
const FLAT = 0.1;

/** @typedef {ReturnType<typeof createViewer>} Viewer */

/**
 * @param {App} app
 * @param {ViewerWords} words
 * @param {ViewerActs} acts
 * @throws {import("./space.js").NoWebGl}
 */
export function createViewer(app, words, { draw, read, speak, hull, box, reach = () => [], tap, turned: hasTurned = () => {}, rested = () => {}, plane, oncontext }) {
  const canvas = h("canvas", { class: "space-canvas", role: "img", "data-space": "" });
  const triad = createTriad();
  const mark = new PlaneMark(words.handle, plane);
  const space = new Space({ canvas, oncontext, ondraw: overlay });
  space.add(...mark.objects);

  /** The distance of the fitted camera, which counts as 100 %. */
  let whole = 1;
  /** Whether the camera still stands where it was fitted, so that it follows the size of the picture. */
  let follows = true;
  /** @type {Point | null} */
  let pointed = null;
  /** The place in the middle is read, by keyboard. */
  let isCross = false;
  let frame = 0;

  /** Objects, marks and reading for the camera as it stands. */
  function overlay() {
    const theme = draw();
    if (!theme) return;
    mark.raise(space.pixelDepth);
    mark.paint(ACCENT[theme]);
    mark.place(space.camera, space.frame);
    triad.render(space.camera);
    showReading();
  }

  /** Reads what is pointed at, which changes nothing of the picture itself. */
  function showReading() {
    cancelAnimationFrame(frame);
    frame = 0;
    read(readAt());
  }

  const readAt = () => (isCross ? middleOf(space.frame) : pointed);

  function readSoon() {
    if (frame === 0) frame = requestAnimationFrame(showReading);
  }

  /** Keeps all that is drawn between the planes that bound it. */
  function bound() {
    const bounds = box();
    if (!bounds) return;
    const { min, max } = bounds;
    const room = Math.max(max[0] - min[0], max[1] - min[1]) * ROOM;
    const corners = [...mark.corners, ...reach()];
    const far = (/** @type {0 | 1 | 2} */ axis) => (axis === 2 ? room * FLAT : room);
    const least = (/** @type {0 | 1 | 2} */ axis) => Math.min(min[axis] - far(axis), ...corners.map((corner) => corner[axis]));
    const most = (/** @type {0 | 1 | 2} */ axis) => Math.max(max[axis] + far(axis), ...corners.map((corner) => corner[axis]));
    space.holds({ min: [least(0), least(1), least(2)], max: [most(0), most(1), most(2)] });
  }

  /** @param {Camera} camera */
  function put(camera) {
    space.camera = camera;
    follows = false;
    space.request();
    hasTurned();
  }

  const stopListening = listenToGestures(canvas, {
    turn(x, y) {
      put(dragged(space.camera, x, y));
      space.drag();
    },
    pan(x, y) {
      put(panned(space.camera, space.frame, x, y));
      space.drag();
    },
    zoom: (at, factor) => put(zoomed(space.camera, space.frame, at, factor, whole)),
    hover(at) {
      if (at && isCross) isCross = false;
      if (pointed === at) return;
      pointed = at;
      readSoon();
    },
    tap(at, isMore) {
      const isAgain = !tap && pointed !== null && Math.hypot(pointed[0] - at[0], pointed[1] - at[1]) < 1;
      pointed = isAgain ? null : at;
      isCross = false;
      tap?.(at, isMore);
      readSoon();
    },
    rest() {
      space.rest();
      rested();
    },
  });

  /** @param {Pick<Camera, "azimuth" | "elevation">} [direction] */
  function fit(direction = space.camera) {
    const points = hull();
    if (points.length === 0) return;
    space.camera = fitted(direction, space.frame, points);
    whole = space.camera.distance;
    follows = true;
    space.request();
    hasTurned();
  }

  /** @param {StandardView} view */
  function look(view) {
    fit(STANDARD[view]);
    rested();
    app.say(words.view(view));
  }

  /** Sees all of the body again, unless the camera has been moved. */
  const refit = () => void (follows && fit());

  return {
    canvas,
    triad: triad.element,
    mark,
    space,
    bound,
    fit,
    refit,
    look,
    /** Whether the reading is that in the middle. */
    get isCross() {
      return isCross;
    },
    get readAt() {
      return readAt();
    },
    get camera() {
      return space.camera;
    },
    /** From the body to the eye. */
    get back() {
      return axesOf(space.camera).back;
    },
    /** Whether the eye is above the ground that the body stands on. */
    get isAbove() {
      const bounds = box();
      return bounds !== null && eyeOf(space.camera)[2] > bounds.min[2] + GROUND * space.camera.distance;
    },
    /** @param {Frame} next */
    resize(next) {
      const { size, top, bottom } = space.frame;
      if (size.width === next.size.width && size.height === next.size.height && top === next.top && bottom === next.bottom) return;
      space.frame = next;
      if (follows) fit();
      space.resize(next);
    },
    /**
     * What is seen now as a picture of a size of its own, without marks; lines are as wide against the body as on the screen.
     * @param {import("../types.js").Size} size in pixels
     * @param {string | null} ground CSS; null for none
     * @returns {OffscreenCanvas | null} null where the graphics card draws no picture of that size
     */
    picture({ width, height }, ground) {
      const { camera, frame, fullRatio } = space;
      const ratio = Math.max(width, height) / Math.max(frame.size.width, frame.size.height);
      const wanted = { size: { width: width / ratio, height: height / ratio }, top: 0, bottom: 0 };
      const flat = new OffscreenCanvas(width, height);
      const context = flat.getContext("2d");
      try {
        if (follows) space.camera = fitted(camera, wanted, hull());
        // The renderer rounds down what it is given.
        space.resize(wanted, ratio * (1 + 1e-9));
        if (!context || space.drawn.width !== width || space.drawn.height !== height) return null;
        if (ground) {
          context.fillStyle = ground;
          context.fillRect(0, 0, width, height);
        }
        context.drawImage(canvas, 0, 0);
        return flat;
      } finally {
        space.camera = camera;
        space.resize(frame, fullRatio);
      }
    },
    /** A camera that was kept. @param {Camera} camera */
    restore(camera) {
      const points = hull();
      whole = points.length > 0 ? fitted(camera, space.frame, points).distance : camera.distance;
      put(camera);
    },
    /** @param {Move} move what it does, and what is said of it */
    move(move) {
      if ("view" in move) look(move.view);
      else if ("fit" in move) {
        fit();
        app.say(words.fitted);
      } else if ("zoom" in move) {
        put(zoomed(space.camera, space.frame, middleOf(space.frame), move.zoom, whole));
        app.say(words.zoomed(`${Math.round((100 * whole) / space.camera.distance)}\u00a0%`));
      } else if ("pan" in move) put(panned(space.camera, space.frame, ...move.pan));
      else {
        put(turned(space.camera, ...move.turn));
        const { azimuth, elevation } = space.camera;
        if (!isCross) app.say(words.turned(fixed(azimuth, 0), fixed(elevation, 0)));
      }
      if (isCross) speak();
      rested();
    },
    /** Begins or ends the reading in the middle of the picture. @param {boolean} on @returns {boolean} whether anything changed */
    readMiddle(on) {
      if (isCross === on && pointed === null) return false;
      isCross = on;
      pointed = null;
      readSoon();
      if (on) speak();
      return true;
    },
    request: () => space.request(),
    /** After the objects of the picture were disposed of. */
    close() {
      cancelAnimationFrame(frame);
      stopListening();
      mark.dispose();
      space.close();
    },
  };
}
