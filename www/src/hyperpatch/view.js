/**
 * The picture of a body: moved by pointer, touch and keys, cut by a plane, read under the pointer, its corners and cells chosen by a tap.
 *
 * @import { BodySection, BodySurface } from "../../../js/directrix.js"
 * @import { App } from "../state/app.js"
 * @import { Frame, StandardView } from "../space/camera.js"
 * @import { Move } from "../space/keys.js"
 * @import { PlaneMoves } from "../space/plane-mark.js"
 * @import { Plane } from "../space/plane.js"
 * @import { Bounds, Vector } from "../space/vector.js"
 * @import { Point } from "../types.js"
 * @import { BodyReading } from "./card.js"
 * @import { Shown } from "./state.js"
 *
 * @typedef {object} Picture What is drawn.
 * @property {BodySurface} surface
 * @property {Shown} shown
 * @property {"light" | "dark"} theme
 * @property {number[]} chosenCell segments of the boundary curves of the chosen cell
 * @property {Vector | null} corner the chosen one
 * @property {Vector[]} witnesses
 */
import { h } from "../dom.js";
import { fixed } from "../format.js";
import { axesOf, dragged, eyeOf, fitted, middleOf, panned, rayAt, seenAt, STANDARD, turned, zoomed } from "../space/camera.js";
import { listenToGestures } from "../space/gestures.js";
import { firstHit } from "../space/pick.js";
import { PlaneMark } from "../space/plane-mark.js";
import { Space } from "../space/space.js";
import { createTriad } from "../space/triad.js";
import { cornersOf } from "../space/vector.js";
import { BodyScene } from "./body.js";
import { createMarks, spokenReading } from "./card.js";
import { cellsOf, bodyOf } from "./document.js";
import { sampleAt } from "./cell.js";
import { words } from "./words.js";

const ACCENT = { light: "#4a45c8", dark: "#a8a4ff" };
/** How far below the ground line the eye has to be for the shadow to go, as a share of the distance. */
const GROUND = -0.02;
/** CSS pixels within which a tap means a corner, and by touch. */
const NEAR = 12;
const TOUCH = 22;
/** How much farther than the surface a corner may lie and still be seen, as a share of the distance. */
const BEHIND = 5e-3;

/**
 * @param {App} app
 * @param {object} options
 * @param {PlaneMoves} options.plane what moving the plane of the section does
 * @param {(corner: number) => void} options.chooseCorner by its place among the corners of the surface
 * @param {(cell: number | null) => void} options.chooseCell
 * @param {() => void} options.turned the camera has moved
 * @param {(isLost: boolean) => void} options.oncontext
 * @throws {import("../space/space.js").NoWebGl}
 */
export function createBodyView(app, { plane: planeMoves, chooseCorner, chooseCell, turned: hasTurned, oncontext }) {
  const canvas = h("canvas", { class: "space-canvas", role: "img", "data-space": "" });
  const triad = createTriad();
  const mark = new PlaneMark(words.section.field, planeMoves);
  const over = createMarks(app);
  const space = new Space({ canvas, oncontext, ondraw: overlay });
  const scene = new BodyScene(space);
  space.add(...mark.objects);

  /** @type {Picture | null} */
  let picture = null;
  /** @type {Bounds} */
  let bounds = { min: [0, 0, 0], max: [1, 1, 1] };
  /** The plane that the picture is cut by, with its face. @type {{plane: Plane, section: BodySection} | null} */
  let cut = null;
  /** The distance of the fitted camera, which counts as 100 %. */
  let whole = 1;
  /** Whether the camera still stands where it was fitted, so that it follows the size of the picture. */
  let follows = true;
  /** @type {Point | null} */
  let pointed = null;
  /** The place in the middle is read, by keyboard. */
  let isCross = false;
  let frame = 0;

  /** Marks and reading for the camera as it stands. */
  function overlay() {
    if (!picture) return;
    const { shown, theme, corner, witnesses } = picture;
    scene.look(shown, theme, space);
    mark.raise(space.pixelDepth);
    scene.stand(eyeOf(space.camera)[2] > bounds.min[2] + GROUND * space.camera.distance, cut !== null);
    mark.paint(ACCENT[theme]);
    mark.place(space.camera, space.frame);
    triad.render(space.camera);
    const seen = (/** @type {Vector} */ point) => seenAt(space.camera, space.frame, point).at;
    over.corner(corner && seen(corner));
    over.witnesses(witnesses.map(seen));
    showReading();
  }

  /** Reads what is pointed at, which changes nothing of the picture itself. */
  function showReading() {
    cancelAnimationFrame(frame);
    frame = 0;
    const at = isCross ? middleOf(space.frame) : pointed;
    const reading = at && readingAt(at);
    over.reading(reading, at, space.frame.size, isCross);
  }

  function readSoon() {
    if (frame === 0) frame = requestAnimationFrame(showReading);
  }

  /** What is seen first along a ray: of the boundary or of the face of the cut. @param {Point} at */
  function hitAt(at) {
    if (!picture) return null;
    const ray = rayAt(space.camera, space.frame, at);
    const onSurface = firstHit(picture.surface, ray, cut ? [cut.plane] : []);
    const onFace = cut && firstHit(cut.section, ray);
    const isFace = onFace && (!onSurface || onFace.distance <= onSurface.distance);
    const hit = isFace ? onFace : onSurface;
    return hit && { hit, mesh: isFace && cut ? cut.section : picture.surface };
  }

  /** The composition at the parameters of what is seen. @param {Point} at @returns {BodyReading | null} */
  function readingAt(at) {
    const found = hitAt(at);
    if (!found) return null;
    const { hit, mesh } = found;
    const corners = [0, 1, 2].map((k) => mesh.indices[3 * hit.triangle + k]);
    const cell = mesh.cells[corners[0]];
    const uvw = /** @type {Vector} */ ([0, 1, 2].map((k) => corners.reduce((sum, corner, n) => sum + hit.weights[n] * mesh.parameters[3 * corner + k], 0)));
    const document = bodyOf(app);
    const whole = cellsOf(document)[cell];
    if (!whole) return null;
    const { position, mix } = sampleAt(whole, uvw, document.materials.length);
    return { cell, uvw, point: position, mix };
  }

  function bound() {
    const { min, max } = bounds;
    const room = Math.max(max[0] - min[0], max[1] - min[1]) * 0.4;
    const corners = mark.corners;
    const far = (/** @type {0 | 1 | 2} */ axis) => (axis === 2 ? room * 0.1 : room);
    const least = (/** @type {0 | 1 | 2} */ axis) => Math.min(min[axis] - far(axis), ...corners.map((corner) => corner[axis]));
    const most = (/** @type {0 | 1 | 2} */ axis) => Math.max(max[axis] + far(axis), ...corners.map((corner) => corner[axis]));
    space.holds({ min: [least(0), least(1), least(2)], max: [most(0), most(1), most(2)] });
  }

  /** @param {import("../space/camera.js").Camera} camera */
  function put(camera) {
    space.camera = camera;
    follows = false;
    space.request();
    hasTurned();
  }

  /** The corner of the surface near a place of the screen that nothing hides; null where there is none. @param {Point} at @param {number} within */
  function cornerAt(at, within) {
    if (!picture?.shown.corners) return null;
    let [best, nearest] = [/** @type {number | null} */ (null), within];
    picture.surface.corners.forEach(({ position }, n) => {
      const { at: place, depth } = seenAt(space.camera, space.frame, position);
      const off = Math.hypot(place[0] - at[0], place[1] - at[1]);
      if (depth <= 0 || off >= nearest) return;
      const found = hitAt(place);
      if (found && found.hit.distance < depth * (1 - BEHIND)) return;
      [best, nearest] = [n, off];
    });
    return best;
  }

  const coarse = matchMedia("(pointer: coarse)");
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
      pointed = at;
      readSoon();
    },
    tap(at) {
      isCross = false;
      pointed = at;
      const corner = cornerAt(at, coarse.matches ? TOUCH : NEAR);
      if (corner !== null) chooseCorner(corner);
      else chooseCell(readingAt(at)?.cell ?? null);
      readSoon();
    },
    rest: () => space.rest(),
  });

  /** @param {Pick<import("../space/camera.js").Camera, "azimuth" | "elevation">} [direction] */
  function fit(direction = space.camera) {
    space.camera = fitted(direction, space.frame, cornersOf(bounds));
    whole = space.camera.distance;
    follows = true;
    space.request();
    hasTurned();
  }

  return {
    canvas,
    overlays: [over.marks, mark.overlay, mark.handle, over.card],
    triad: triad.element,
    mark,
    get back() {
      return axesOf(space.camera).back;
    },

    /** @param {Picture} next @param {boolean} isNew whether the surface is another one @param {Bounds} box */
    set(next, isNew, box) {
      picture = next;
      if (isNew) {
        bounds = box;
        scene.set(next.surface, bounds);
        bound();
      }
      scene.choose(next.chosenCell);
      space.request();
    },
    /** @param {Float32Array} labs of the surface */
    paint(labs) {
      scene.paintSurface(labs);
      space.request();
    },
    /** @param {{plane: Plane, section: BodySection, labs: Float32Array} | null} next */
    cut(next) {
      cut = next;
      scene.cut(next?.plane ?? null, next?.section ?? null);
      if (next) scene.paintFace(next.labs);
      space.request();
    },
    /** The frame of the plane with its handle. @param {Plane | null} plane */
    frame(plane) {
      mark.set(plane, picture?.surface.positions ?? []);
      bound();
      space.request();
    },
    /** @param {Frame} next */
    resize(next) {
      const { size, top, bottom } = space.frame;
      if (size.width === next.size.width && size.height === next.size.height && top === next.top && bottom === next.bottom) return;
      space.frame = next;
      if (follows && picture) fit();
      space.resize(next);
    },
    fit,
    /** @param {StandardView} view */
    look(view) {
      fit(STANDARD[view]);
      app.say(words.show.viewsLong[view]);
    },
    /** @param {Move} move what it does, and what is said of it */
    move(move) {
      if ("view" in move) this.look(move.view);
      else if ("fit" in move) {
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
      app.say(spokenReading(app, readingAt(middleOf(space.frame))));
    },
    request: () => space.request(),
    close() {
      cancelAnimationFrame(frame);
      stopListening();
      mark.dispose();
      scene.dispose();
      space.close();
    },
  };
}
