/**
 * The picture of a body: cut by a plane, read under the pointer, its corners and cells chosen by a tap.
 *
 * @import { BodySection, BodySharing, BodySurface } from "../../../js/directrix.js"
 * @import { App } from "../state/app.js"
 * @import { PictureWanted } from "../files/picture-rows.js"
 * @import { PlaneMoves } from "../space/plane-mark.js"
 * @import { Plane } from "../space/plane.js"
 * @import { Bounds, Vector } from "../space/vector.js"
 * @import { Point } from "../types.js"
 * @import { Shifts } from "./apart.js"
 * @import { BodyReading } from "./card.js"
 * @import { Side } from "./edits.js"
 * @import { Joints } from "./joints.js"
 * @import { Shown } from "./state.js"
 *
 * @typedef {object} Picture What is drawn.
 * @property {BodySurface} surface
 * @property {BodySharing} sharing
 * @property {Shifts} shifts
 * @property {number[]} empty indices of materials that are void
 * @property {Joints | null} joints
 * @property {Shown} shown
 * @property {"light" | "dark"} theme
 * @property {number[]} chosenCell segments of the boundary curves of the chosen cell
 * @property {{cell: number, position: Vector} | null} corner the chosen one
 * @property {import("./neighbours.js").Neighbours | null} neighbours of the chosen corner
 * @property {{cell: number, point: Vector}[]} witnesses
 * @property {{cell: number, point: Vector, verdict: import("../../../js/directrix.js").VerdictName}[]} badges
 */
import { rayAt, seenAt } from "../space/camera.js";
import { Gizmo } from "../space/gizmo.js";
import { firstHit } from "../space/pick.js";
import { isKept } from "../space/plane.js";
import { add, cornersOf, scaled, subtract } from "../space/vector.js";
import { createViewer } from "../space/viewer.js";
import { drawnBounds, drawnPositions, shiftOf } from "./apart.js";
import { BodyScene, cornersOf as drawnCorners } from "./body.js";
import { createMarks, spokenReading } from "./card.js";
import { sampleAt } from "./cell.js";
import { bodyOf, cellsOf } from "./document.js";
import { words } from "./words.js";

/** Ground of the page by theme. */
const CANVAS = { light: "#ffffff", dark: "#0e0f12" };
/** CSS pixels within which a tap means a corner, and by touch. */
const NEAR = 12;
const TOUCH = 22;
/** How much farther than the surface a corner may lie and still be seen, as a share of the distance. */
const BEHIND = 5e-3;

/**
 * @param {App} app
 * @param {object} options
 * @param {PlaneMoves} options.plane what moving the plane of the section does
 * @param {(corner: Side) => void} options.chooseCorner
 * @param {(cell: number | null) => void} options.chooseCell
 * @param {import("../space/gizmo.js").GizmoMoves} options.gizmo what dragging the chosen corner does
 * @param {() => number | null} options.step that a dragged corner rests on; null for none
 * @param {() => void} options.rested the camera has been moved, and rests for now
 * @param {() => void} options.turned the camera stands elsewhere
 * @param {(isLost: boolean) => void} options.oncontext
 * @throws {import("../space/space.js").NoWebGl}
 */
export function createBodyView(app, { plane, chooseCorner, chooseCell, gizmo: moves, step, rested, turned, oncontext }) {
  const over = createMarks(app);
  const coarse = matchMedia("(pointer: coarse)");
  const { spoken, show } = words;
  const said = { handle: words.section.field, ...spoken, view: (/** @type {keyof typeof show.viewsLong} */ view) => show.viewsLong[view] };
  /** @type {import("../space/viewer.js").Viewer} */
  const viewer = createViewer(app, said, {
    draw,
    read: (at) => over.reading(at && readingAt(at), at, space.frame.size, viewer.isCross),
    speak: () => app.say(spokenReading(app, viewer.readAt && readingAt(viewer.readAt))),
    hull: () => (picture ? cornersOf(box()) : []),
    box: () => box(),
    tap(at) {
      const corner = cornerAt(at, coarse.matches ? TOUCH : NEAR);
      if (corner !== null) chooseCorner(corner);
      else chooseCell(readingAt(at)?.cell ?? null);
    },
    turned,
    rested,
    plane,
    oncontext,
  });
  const { space, mark } = viewer;
  const scene = new BodyScene(space);
  const gizmo = new Gizmo(
    {
      ...moves,
      move(place, run) {
        if (held) moves.move(subtract(place, subtract(drawnAt(held.cell, held.position), held.position)), run);
      },
    },
    step,
  );
  /** The chosen corner where the document has it, which may be ahead of the picture. @type {{cell: number, position: Vector} | null} */
  let held = null;

  /** @type {Picture | null} */
  let picture = null;
  /** @type {Bounds} */
  let bounds = { min: [0, 0, 0], max: [1, 1, 1] };
  /** The plane that the picture is cut by, with its face. @type {{plane: Plane, section: BodySection} | null} */
  let cut = null;

  let apart = 0;
  /** @type {Joints | null} */
  let joints = null;

  /** A box that holds all that is drawn of the body. */
  const box = () => (picture && apart > 0 ? drawnBounds(bounds, picture.shifts, apart) : bounds);

  /** Where a point of a cell is drawn. @param {number} cell @param {Vector} point @returns {Vector} */
  const drawnAt = (cell, point) => (picture && apart > 0 ? add(point, scaled(shiftOf(picture.shifts, cell), apart)) : point);

  /** Objects and marks for the camera as it stands. */
  function draw() {
    if (!picture) return null;
    const { shown, theme, corner, witnesses } = picture;
    scene.look(shown, viewer.back, theme, space);
    scene.stand(viewer.isAbove, cut !== null || shown.transparency > 0);
    const seen = (/** @type {number} */ cell, /** @type {Vector} */ point) => seenAt(space.camera, space.frame, drawnAt(cell, point)).at;
    const { neighbours, badges } = picture;
    over.corner(corner && seen(corner.cell, corner.position));
    over.neighbours(
      neighbours?.lines.map(({ cell, from, to }) => [seen(cell, from), seen(cell, to)]) ?? [],
      neighbours?.points.map(({ cell, position }) => seen(cell, position)) ?? [],
    );
    gizmo.set(held && drawnAt(held.cell, held.position));
    gizmo.place(space.camera, space.frame);
    over.witnesses(witnesses.map(({ cell, point }) => seen(cell, point)));
    over.badges(badges.map(({ cell, point, verdict }) => ({ at: seen(cell, point), verdict })));
    return theme;
  }

  /** What is seen first along a ray: of the boundary or of the face of the cut. @param {Point} at */
  function hitAt(at) {
    if (!picture) return null;
    const ray = rayAt(space.camera, space.frame, at);
    const { surface, shifts } = picture;
    const [drawn, face] = drawnMeshes();
    // What the plane has taken away is known by where the cells are together.
    const isKeptOf = (/** @type {number} */ triangle, /** @type {Vector} */ point) =>
      !cut || isKept([cut.plane], subtract(point, scaled(shiftOf(shifts, surface.cells[surface.indices[3 * triangle]]), apart)));
    const onSurface = firstHit(drawn, ray, [], isKeptOf);
    const onFace = face && firstHit(face, ray);
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

  /** @type {{of: unknown[], meshes: {positions: Float32Array, indices: Uint32Array}[]}} */
  let moved = { of: [], meshes: [] };

  /** Surface and face of the cut as they are drawn. */
  function drawnMeshes() {
    if (!picture) return [];
    const { surface, shifts } = picture;
    const key = [surface, cut?.section, apart];
    if (key.some((each, n) => each !== moved.of[n])) {
      const meshes = [surface, ...(cut ? [cut.section] : [])];
      // Inside the body there is nothing to be met before its boundary.
      const end = apart > 0 ? undefined : scene.end;
      moved = { of: key, meshes: meshes.map((mesh, n) => ({ positions: drawnPositions(mesh, shifts, apart), indices: n === 0 ? mesh.indices.subarray(0, end) : mesh.indices })) };
    }
    return moved.meshes;
  }

  /** The corner of the surface near a place of the screen that nothing hides; null where there is none. @param {Point} at @param {number} within */
  function cornerAt(at, within) {
    if (!picture?.shown.corners) return null;
    let [best, nearest] = [/** @type {Side | null} */ (null), within];
    const isClear = picture.shown.transparency > 0;
    drawnCorners(picture, apart > 0).forEach(({ cell, corner, position }) => {
      const { at: place, depth } = seenAt(space.camera, space.frame, drawnAt(cell, position));
      const off = Math.hypot(place[0] - at[0], place[1] - at[1]);
      if (depth <= 0 || off >= nearest) return;
      const found = isClear ? null : hitAt(place);
      if (found && found.hit.distance < depth * (1 - BEHIND)) return;
      [best, nearest] = [{ cell, corner }, off];
    });
    return best;
  }

  return {
    canvas: viewer.canvas,
    overlays: [over.marks, gizmo.element, gizmo.handles, mark.overlay, mark.handle, over.card],
    triad: viewer.triad,
    mark,
    resize: viewer.resize,
    fit: viewer.fit,
    restore: viewer.restore,
    /** What is seen now as a picture. @param {PictureWanted} wanted @returns {OffscreenCanvas | null} */
    picture({ theme, transparent, ...size }) {
      const kept = picture;
      if (kept) picture = { ...kept, theme };
      try {
        return viewer.picture(size, transparent ? null : CANVAS[theme]);
      } finally {
        picture = kept;
        viewer.request();
      }
    },
    get size() {
      return space.frame.size;
    },
    look: viewer.look,
    move: viewer.move,
    readMiddle: viewer.readMiddle,
    request: viewer.request,
    get back() {
      return viewer.back;
    },
    get camera() {
      return viewer.camera;
    },
    /** What the gizmo moves. @param {typeof held} corner */
    hold(corner) {
      held = corner;
      viewer.request();
    },

    /** @param {Picture} next @param {boolean} isNew whether the surface is another one @param {Bounds} around */
    set(next, isNew, around) {
      picture = next;
      if (isNew) {
        bounds = around;
        scene.set(next, bounds);
      }
      if (isNew || next.joints !== joints) {
        joints = next.joints;
        scene.mark(joints);
      }
      if (isNew || next.shown.apart !== apart) {
        ({ apart } = next.shown);
        viewer.bound();
        viewer.refit();
      }
      scene.choose(next.chosenCell, next.shown.cell);
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
      mark.set(plane, drawnMeshes()[0]?.positions ?? []);
      viewer.bound();
      viewer.request();
    },
    close() {
      scene.dispose();
      viewer.close();
    },
  };
}
