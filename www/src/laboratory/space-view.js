/**
 * The picture of a problem in space: its boundary, cut by the plane of the section, and what is read of it.
 *
 * @import { App } from "../state/app.js"
 * @import { PictureWanted } from "../files/picture-rows.js"
 * @import { BoxMoves, Side } from "../space/box-mark.js"
 * @import { PlaneMoves } from "../space/plane-mark.js"
 * @import { Plane } from "../space/plane.js"
 * @import { Bounds, Vector } from "../space/vector.js"
 * @import { Point } from "../types.js"
 * @import { Place } from "./reader.js"
 * @import { Mesh, Shown } from "./state.js"
 *
 * @typedef {object} Picture What is drawn.
 * @property {Mesh} mesh
 * @property {Plane | null} plane with what it keeps on the side of its normal
 * @property {Bounds | null} box by which the chosen group picks elements, as it is drawn
 * @property {Readonly<Shown>} shown
 * @property {"light" | "dark"} theme
 */
import { svg } from "../dom.js";
import { put } from "../stage/mark.js";
import { BoxMark } from "../space/box-mark.js";
import { rayAt, seenAt } from "../space/camera.js";
import { firstHit } from "../space/pick.js";
import { add, cornersOf, dot, scaled } from "../space/vector.js";
import { ACCENT, createViewer } from "../space/viewer.js";
import { LaboratoryScene } from "./scene.js";
import { words } from "./words.js";

/** Ground of the page by theme. */
const CANVAS = { light: "#ffffff", dark: "#0e0f12" };

/** @typedef {ReturnType<typeof createSpaceView>} SpaceView */

/**
 * @param {App} app
 * @param {object} options
 * @param {PlaneMoves} options.plane what moving the plane of the section does
 * @param {BoxMoves} options.box what moving the sides of a box does
 * @param {(place: Place | null, at: Point | null, isCross: boolean) => void} options.read a place is pointed at; null for none
 * @param {() => void} options.speak says what is read in the middle
 * @param {(place: Place | null) => void} options.tap
 * @param {(point: Vector) => boolean} options.isInside whether a place of the plane of the section is inside the body
 * @param {() => void} options.rested the camera has been moved, and rests for now
 * @param {(isLost: boolean) => void} options.oncontext
 * @throws {import("../space/space.js").NoWebGl}
 */
export function createSpaceView(app, { plane, box: moves, read, speak, tap, isInside, rested, oncontext }) {
  const { spoken, show } = words;
  const said = { handle: words.section.handle, ...spoken, view: (/** @type {keyof typeof show.viewsLong} */ view) => show.viewsLong[view] };
  /** @type {Picture | null} */
  let picture = null;
  /** @type {import("../space/viewer.js").Viewer} */
  const viewer = createViewer(app, said, {
    draw() {
      if (!picture) return null;
      scene.look(picture.shown, picture.theme, space);
      scene.stand(viewer.isAbove, picture.plane !== null);
      box.look(ACCENT[picture.theme], space.pixelDepth);
      box.place(space.camera, space.frame);
      put(fault, witness && seenAt(space.camera, space.frame, /** @type {Vector} */ (witness)).at);
      return picture.theme;
    },
    read: (at) => read(at && placeAt(at), at, viewer.isCross),
    speak() {
      const at = viewer.readAt;
      read(at && placeAt(at), at, viewer.isCross);
      speak();
    },
    tap: (at) => tap(placeAt(at)),
    // With the frame of the section, which would lie over the words above the body.
    hull: () => (picture ? [...cornersOf(picture.mesh.bounds), ...mark.corners] : []),
    box: () => picture?.mesh.bounds ?? null,
    reach: () => box.corners,
    rested,
    plane,
    oncontext,
  });
  const { space, mark } = viewer;
  const fault = svg("g", { class: "part-witness", "data-lab-witness": "" }, svg("path", { class: "under", d: "M-6 -6 6 6M6 -6-6 6" }), svg("path", { d: "M-6 -6 6 6M6 -6-6 6" }));
  const marks = svg("svg", { class: "marks lab-marks", "aria-hidden": "true" }, fault);
  /** A place that is wrong. @type {readonly number[] | null} */
  let witness = null;
  const scene = new LaboratoryScene(space);
  const box = new BoxMark(words.box.label, moves);
  space.add(...box.objects);

  /** What is seen first: of the boundary or of the face of the section. @param {Point} at @returns {Place | null} */
  function placeAt(at) {
    const soup = picture?.mesh.soup;
    if (!picture || !soup) return null;
    const ray = rayAt(space.camera, space.frame, at);
    const hit = firstHit(soup, ray, picture.plane ? [picture.plane] : []);
    const face = picture.plane && faceAt(picture.plane, ray);
    if (face && (!hit || face.distance < hit.distance) && isInside(face.point)) return { point: face.point, element: null };
    return hit && { point: hit.point, element: hit.triangle };
  }

  return {
    canvas: viewer.canvas,
    overlays: [marks, mark.overlay, mark.handle, box.overlay, box.handles],
    triad: viewer.triad,
    mark,
    /** Says of each side of the box where it stands. @param {(side: Side) => {text: string, now: number, extent: readonly number[]}} of */
    describeBox: (of) => box.describe(of),
    scene,
    resize: viewer.resize,
    fit: viewer.fit,
    restore: viewer.restore,
    look: viewer.look,
    move: viewer.move,
    readMiddle: viewer.readMiddle,
    request: viewer.request,
    get camera() {
      return viewer.camera;
    },
    get back() {
      return viewer.back;
    },
    get size() {
      return space.frame.size;
    },
    /** What is seen in the middle of the picture. */
    get middle() {
      const { size, top, bottom } = space.frame;
      return placeAt([size.width / 2, (top + size.height - bottom) / 2]);
    },
    /** Marks a place that is wrong. @param {readonly number[] | null} place */
    witness(place) {
      if (witness === place) return;
      witness = place;
      viewer.request();
    },

    /** @param {Picture} next */
    set(next) {
      const [isNew, isMoved] = [next.mesh !== picture?.mesh, JSON.stringify(next.plane) !== JSON.stringify(picture?.plane)];
      const isBoxMoved = JSON.stringify(next.box) !== JSON.stringify(picture?.box);
      const isElsewhere = picture !== null && JSON.stringify(next.mesh.bounds) !== JSON.stringify(picture.mesh.bounds);
      picture = next;
      if (isNew) scene.set(next.mesh);
      if (isNew || isMoved) {
        scene.cut(next.plane);
        mark.set(next.plane, next.mesh.soup?.positions ?? []);
      }
      if (isBoxMoved) box.set(next.box);
      if (isNew || isMoved || isBoxMoved) viewer.bound();
      // A body of another size is seen as a whole, from where the last one was seen.
      if (isElsewhere) viewer.fit();
      viewer.request();
    },
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
    close() {
      scene.dispose();
      box.dispose();
      viewer.close();
    },
  };
}

/** Where a ray meets a plane. @param {Plane} plane @param {{from: Vector, along: Vector}} ray */
function faceAt({ normal, offset }, { from, along }) {
  const slope = dot(normal, along);
  const distance = slope === 0 ? -1 : (offset - dot(normal, from)) / slope;
  return distance > 0 ? { point: add(from, scaled(along, distance)), distance } : null;
}
