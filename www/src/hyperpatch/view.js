/**
 * The picture of a body: cut by a plane, read under the pointer, its corners and cells chosen by a tap.
 *
 * @import { BodySection, BodySurface } from "../../../js/directrix.js"
 * @import { App } from "../state/app.js"
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
import { rayAt, seenAt } from "../space/camera.js";
import { firstHit } from "../space/pick.js";
import { cornersOf } from "../space/vector.js";
import { createViewer } from "../space/viewer.js";
import { BodyScene } from "./body.js";
import { createMarks, spokenReading } from "./card.js";
import { sampleAt } from "./cell.js";
import { bodyOf, cellsOf } from "./document.js";
import { words } from "./words.js";

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
 * @param {() => void} options.turned the camera stands elsewhere
 * @param {(isLost: boolean) => void} options.oncontext
 * @throws {import("../space/space.js").NoWebGl}
 */
export function createBodyView(app, { plane, chooseCorner, chooseCell, turned, oncontext }) {
  const over = createMarks(app);
  const coarse = matchMedia("(pointer: coarse)");
  const { spoken, show } = words;
  const said = { handle: words.section.field, ...spoken, view: (/** @type {keyof typeof show.viewsLong} */ view) => show.viewsLong[view] };
  /** @type {import("../space/viewer.js").Viewer} */
  const viewer = createViewer(app, said, {
    draw,
    read: (at) => over.reading(at && readingAt(at), at, space.frame.size, viewer.isCross),
    speak: () => app.say(spokenReading(app, viewer.readAt && readingAt(viewer.readAt))),
    hull: () => (picture ? cornersOf(bounds) : []),
    box: () => bounds,
    tap(at) {
      const corner = cornerAt(at, coarse.matches ? TOUCH : NEAR);
      if (corner !== null) chooseCorner(corner);
      else chooseCell(readingAt(at)?.cell ?? null);
    },
    turned,
    plane,
    oncontext,
  });
  const { space, mark } = viewer;
  const scene = new BodyScene(space);

  /** @type {Picture | null} */
  let picture = null;
  /** @type {Bounds} */
  let bounds = { min: [0, 0, 0], max: [1, 1, 1] };
  /** The plane that the picture is cut by, with its face. @type {{plane: Plane, section: BodySection} | null} */
  let cut = null;

  /** Objects and marks for the camera as it stands. */
  function draw() {
    if (!picture) return null;
    const { shown, theme, corner, witnesses } = picture;
    scene.look(shown, theme, space);
    scene.stand(viewer.isAbove, cut !== null);
    const seen = (/** @type {Vector} */ point) => seenAt(space.camera, space.frame, point).at;
    over.corner(corner && seen(corner));
    over.witnesses(witnesses.map(seen));
    return theme;
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

  return {
    canvas: viewer.canvas,
    overlays: [over.marks, mark.overlay, mark.handle, over.card],
    triad: viewer.triad,
    mark,
    resize: viewer.resize,
    fit: viewer.fit,
    look: viewer.look,
    move: viewer.move,
    readMiddle: viewer.readMiddle,
    request: viewer.request,
    get back() {
      return viewer.back;
    },

    /** @param {Picture} next @param {boolean} isNew whether the surface is another one @param {Bounds} box */
    set(next, isNew, box) {
      picture = next;
      if (isNew) {
        bounds = box;
        scene.set(next.surface, bounds);
        viewer.bound();
      }
      scene.choose(next.chosenCell);
      viewer.request();
    },
    /** @param {Float32Array} labs of the surface */
    paint(labs) {
      scene.paintSurface(labs);
      viewer.request();
    },
    /** @param {{plane: Plane, section: BodySection, labs: Float32Array} | null} next */
    cut(next) {
      cut = next;
      scene.cut(next?.plane ?? null, next?.section ?? null);
      if (next) scene.paintFace(next.labs);
      viewer.request();
    },
    /** The frame of the plane with its handle. @param {Plane | null} plane */
    frame(plane) {
      mark.set(plane, picture?.surface.positions ?? []);
      viewer.bound();
      viewer.request();
    },
    close() {
      scene.dispose();
      viewer.close();
    },
  };
}
