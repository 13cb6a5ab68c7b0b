/**
 * The picture of the solid: the body in its space, moved by pointer, touch and keys, with the plane of the section and the reading.
 *
 * @import { App } from "../state/app.js"
 * @import { Camera, Frame, StandardView } from "../space/camera.js"
 * @import { Move } from "../space/keys.js"
 * @import { PlaneMoves } from "../space/plane-mark.js"
 * @import { Plane } from "../space/plane.js"
 * @import { Point } from "../types.js"
 * @import { SolidUi, Whole } from "./state.js"
 *
 * @typedef {object} Shown
 * @property {Readonly<SolidUi>} ui
 * @property {number} upTo
 * @property {"light" | "dark"} theme
 */
import { h } from "../dom.js";
import { fixed } from "../format.js";
import { axesOf, dragged, eyeOf, fitted, middleOf, panned, rayAt, seenAt, STANDARD, turned, zoomed } from "../space/camera.js";
import { listenToGestures } from "../space/gestures.js";
import { PlaneMark } from "../space/plane-mark.js";
import { Space } from "../space/space.js";
import { createTriad } from "../space/triad.js";
import { triples } from "../space/vector.js";
import { Body } from "./body.js";
import { createCard, spokenReading } from "./card.js";
import { readingAt } from "./reading.js";
import { levelsOf, sectionPlane, stagesAmong, upToPlane } from "./state.js";
import { words } from "./words.js";

const ACCENT = { light: "#4a45c8", dark: "#a8a4ff" };
/** How far below the ground line the eye has to be for the shadow to go, as a share of the distance. */
const GROUND = -0.02;

/**
 * @param {App} app
 * @param {object} options
 * @param {PlaneMoves} options.plane what moving the plane of the section does
 * @param {() => void} options.moved the camera has been moved, and rests for now
 * @param {(isLost: boolean) => void} options.oncontext
 * @throws {import("../space/space.js").NoWebGl}
 */
export function createSolidView(app, { plane, moved, oncontext }) {
  const canvas = h("canvas", { class: "space-canvas", role: "img", "data-space": "" });
  const triad = createTriad();
  const mark = new PlaneMark(words.section.handle, plane);
  const { card, marks, render: renderCard } = createCard(app);
  const space = new Space({ canvas, oncontext, ondraw: overlay });
  const body = new Body(space);
  space.add(...mark.objects);

  /** @type {Whole | null} */
  let solid = null;
  /** @type {Shown | null} */
  let shown = null;
  /** The distance of the fitted camera, which counts as 100 %. */
  let whole = 1;
  /** Whether the camera still stands where it was fitted, so that it follows the size of the picture. */
  let follows = true;
  /** @type {Point | null} */
  let pointed = null;
  /** The place in the middle is read, by keyboard. */
  let isCross = false;
  /** @type {Plane | null} */
  let upTo = null;
  let reading = /** @type {ReturnType<typeof readingAt>} */ (null);
  let cutKey = "";
  let frame = 0;

  /** The points that have to be seen. */
  const hull = () => (solid ? solid.curves.flatMap((points) => triples(points)) : []);

  /** The plane of the section with its way, as the camera stands. */
  const sectionNow = () => (solid && shown ? sectionPlane(shown.ui.section, solid.positions, axesOf(space.camera).back) : null);

  /** Cuts, marks and reading for the camera as it stands. */
  function overlay() {
    if (!solid || !shown) return;
    const { section, layers } = shown.ui;
    const { back } = axesOf(space.camera);
    const found = sectionNow();
    upTo = upToPlane(levelsOf(solid), shown.upTo);
    const key = JSON.stringify([section, section.axis === "view" ? back : null, shown.upTo, layers]);
    if (key !== cutKey) {
      cutKey = key;
      body.cut({ upTo, section: found?.plane ?? null }, layers);
      mark.set(section.axis === "view" ? null : (found?.plane ?? null), solid.positions);
      bound();
    }
    body.look(shown.ui, shown.theme, space);
    mark.raise(space.pixelDepth);
    body.stand(eyeOf(space.camera)[2] > solid.bounds.min[2] + GROUND * space.camera.distance, upTo !== null || found !== null);
    mark.paint(ACCENT[shown.theme]);
    mark.place(space.camera, space.frame);
    triad.render(space.camera);
    showReading();
  }

  /** Reads what is pointed at, which changes nothing of the picture itself. */
  function showReading() {
    cancelAnimationFrame(frame);
    frame = 0;
    if (!shown) return;
    read();
    const at = isCross ? middleOf(space.frame) : reading && reading !== "inside" ? seenAt(space.camera, space.frame, reading.point).at : pointed;
    renderCard(reading, isCross || pointed ? at : null, { size: space.frame.size, color: shown.ui.color, isCross });
  }

  function readSoon() {
    if (frame === 0) frame = requestAnimationFrame(showReading);
  }

  function bound() {
    if (!solid) return;
    const { min, max } = solid.bounds;
    const room = Math.max(max[0] - min[0], max[1] - min[1]) * 0.4;
    const corners = mark.corners;
    const least = (/** @type {0 | 1 | 2} */ axis, /** @type {number} */ by) => Math.min(min[axis] - by, ...corners.map((corner) => corner[axis]));
    const most = (/** @type {0 | 1 | 2} */ axis, /** @type {number} */ by) => Math.max(max[axis] + by, ...corners.map((corner) => corner[axis]));
    space.holds({ min: [least(0, room), least(1, room), least(2, room * 0.1)], max: [most(0, room), most(1, room), most(2, room * 0.1)] });
  }

  function read() {
    const at = isCross ? middleOf(space.frame) : pointed;
    if (!at || !solid || !shown) {
      reading = null;
      return;
    }
    const { layers } = shown.ui;
    const planes = [upTo, sectionNow()?.plane ?? null].filter((each) => each !== null);
    reading = readingAt(solid, rayAt(space.camera, space.frame, at), { planes, hasCaps: layers.includes("caps"), hasFace: body.hasFace(layers) });
  }

  /** @param {Camera} camera */
  function put(camera) {
    space.camera = camera;
    follows = false;
    space.request();
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
    tap(at) {
      pointed = pointed && Math.hypot(pointed[0] - at[0], pointed[1] - at[1]) < 1 ? null : at;
      isCross = false;
      readSoon();
    },
    rest() {
      space.rest();
      moved();
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
  }

  return {
    canvas,
    overlays: [marks, mark.overlay, mark.handle, card],
    triad: triad.element,
    mark,

    /**
     * @param {Whole} next
     * @param {boolean} isClosed
     */
    setSolid(next, isClosed) {
      solid = next;
      cutKey = "";
      body.set(next, isClosed, stagesAmong(app.store.document, next.stages));
      bound();
      space.request();
    },
    /** @param {Shown} next */
    show(next) {
      const isSame = shown !== null && shown.ui === next.ui && shown.upTo === next.upTo && shown.theme === next.theme;
      shown = next;
      if (!isSame) space.request();
    },
    /** @param {Frame} frame */
    resize(frame) {
      const { size, top, bottom } = space.frame;
      if (size.width === frame.size.width && size.height === frame.size.height && top === frame.top && bottom === frame.bottom) return;
      space.frame = frame;
      if (follows) fit();
      space.resize(frame);
    },
    get camera() {
      return space.camera;
    },
    /** A camera that was kept. @param {Camera} camera */
    restore(camera) {
      const points = hull();
      whole = points.length > 0 ? fitted(camera, space.frame, points).distance : camera.distance;
      put(camera);
    },
    fit,
    /** @param {StandardView} view */
    look(view) {
      fit(STANDARD[view]);
      moved();
      app.say(words.spoken.view(words.show.viewsLong[view]));
    },
    /** @param {Move} move what it does, and what is said of it */
    move(move) {
      if ("view" in move) return this.look(move.view);
      if ("fit" in move) {
        fit();
        app.say(words.spoken.fitted);
      } else if ("zoom" in move) {
        put(zoomed(space.camera, space.frame, middleOf(space.frame), move.zoom, whole));
        app.say(words.spoken.zoomed(`${Math.round((100 * whole) / space.camera.distance)}\u00a0%`));
      } else if ("pan" in move) put(panned(space.camera, space.frame, ...move.pan));
      else {
        put(turned(space.camera, ...move.turn));
        const { azimuth, elevation } = space.camera;
        if (!isCross) app.say(words.spoken.turned(fixed(azimuth, 0), fixed(elevation, 0)));
      }
      if (isCross) this.speakReading();
      moved();
    },
    /** Begins or ends the reading in the middle of the picture. @param {boolean} on @returns {boolean} whether anything changed */
    readMiddle(on) {
      if (isCross === on && pointed === null) return false;
      isCross = on;
      pointed = null;
      readSoon();
      if (on) this.speakReading();
      return true;
    },
    speakReading() {
      read();
      app.say(spokenReading(app, reading, shown?.ui.color ?? "material"));
    },
    get extent() {
      return sectionNow()?.extent ?? null;
    },
    get hasFace() {
      return shown !== null && body.hasFace(shown.ui.layers);
    },
    request: () => space.request(),
    close() {
      cancelAnimationFrame(frame);
      stopListening();
      mark.dispose();
      body.dispose();
      space.close();
    },
  };
}
