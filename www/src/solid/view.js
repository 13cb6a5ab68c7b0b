/**
 * The picture of the solid: the body in its space, with the plane of the section, what is built up, and the reading.
 *
 * @import { App } from "../state/app.js"
 * @import { PlaneMoves } from "../space/plane-mark.js"
 * @import { Plane } from "../space/plane.js"
 * @import { SolidUi, Whole } from "./state.js"
 *
 * @typedef {object} Shown
 * @property {Readonly<SolidUi>} ui
 * @property {number} upTo
 * @property {"light" | "dark"} theme
 */
import { rayAt, seenAt } from "../space/camera.js";
import { sectionPlane } from "../space/section.js";
import { triples } from "../space/vector.js";
import { createViewer } from "../space/viewer.js";
import { Body } from "./body.js";
import { createCard, spokenReading } from "./card.js";
import { readingAt } from "./reading.js";
import { levelsOf, stagesAmong, upToPlane } from "./state.js";
import { words } from "./words.js";

/**
 * @param {App} app
 * @param {object} options
 * @param {PlaneMoves} options.plane what moving the plane of the section does
 * @param {() => void} options.moved the camera has been moved, and rests for now
 * @param {(isLost: boolean) => void} options.oncontext
 * @throws {import("../space/space.js").NoWebGl}
 */
export function createSolidView(app, { plane, moved, oncontext }) {
  const { card, marks, render: renderCard } = createCard(app);
  const { spoken, show } = words;
  const said = { handle: words.section.handle, ...spoken, view: (/** @type {keyof typeof show.viewsLong} */ view) => spoken.view(show.viewsLong[view]) };
  /** @type {import("../space/viewer.js").Viewer} */
  const viewer = createViewer(app, said, {
    draw,
    read(at) {
      if (!shown) return;
      read(at);
      const place = !viewer.isCross && reading && reading !== "inside" ? seenAt(space.camera, space.frame, reading.point).at : at;
      renderCard(reading, at && place, { size: space.frame.size, color: shown.ui.color, isCross: viewer.isCross });
    },
    speak: () => speakReading(),
    hull: () => (solid ? solid.curves.flatMap((points) => triples(points)) : []),
    box: () => solid?.bounds ?? null,
    rested: moved,
    plane,
    oncontext,
  });
  const { space, mark } = viewer;
  const body = new Body(space);

  /** @type {Whole | null} */
  let solid = null;
  /** @type {Shown | null} */
  let shown = null;
  /** @type {Plane | null} */
  let upTo = null;
  let reading = /** @type {ReturnType<typeof readingAt>} */ (null);
  let cutKey = "";

  /** The plane of the section with its way, as the camera stands. */
  const sectionNow = () => (solid && shown ? sectionPlane(shown.ui.section, solid.positions, viewer.back) : null);

  /** Cuts and looks for the camera as it stands. */
  function draw() {
    if (!solid || !shown) return null;
    const { section, layers } = shown.ui;
    const found = sectionNow();
    upTo = upToPlane(levelsOf(solid), shown.upTo);
    const key = JSON.stringify([section, section.axis === "view" ? viewer.back : null, shown.upTo, layers]);
    if (key !== cutKey) {
      cutKey = key;
      body.cut({ upTo, section: found?.plane ?? null }, layers);
      mark.set(section.axis === "view" ? null : (found?.plane ?? null), solid.positions);
      viewer.bound();
    }
    body.look(shown.ui, shown.theme, space);
    body.stand(viewer.isAbove, upTo !== null || found !== null);
    return shown.theme;
  }

  /** @param {import("../types.js").Point | null} at */
  function read(at) {
    if (!at || !solid || !shown) {
      reading = null;
      return;
    }
    const { layers } = shown.ui;
    const planes = [upTo, sectionNow()?.plane ?? null].filter((each) => each !== null);
    reading = readingAt(solid, rayAt(space.camera, space.frame, at), { planes, hasCaps: layers.includes("caps"), hasFace: body.hasFace(layers) });
  }

  function speakReading() {
    read(viewer.readAt);
    app.say(spokenReading(app, reading, shown?.ui.color ?? "material"));
  }

  return {
    canvas: viewer.canvas,
    overlays: [marks, mark.overlay, mark.handle, card],
    triad: viewer.triad,
    mark,
    resize: viewer.resize,
    restore: viewer.restore,
    fit: viewer.fit,
    look: viewer.look,
    move: viewer.move,
    readMiddle: viewer.readMiddle,
    request: viewer.request,

    /**
     * @param {Whole} next
     * @param {boolean} isClosed
     */
    setSolid(next, isClosed) {
      solid = next;
      cutKey = "";
      body.set(next, isClosed, stagesAmong(app.store.document, next.stages));
      viewer.bound();
      viewer.request();
    },
    /** @param {Shown} next */
    show(next) {
      const isSame = shown !== null && shown.ui === next.ui && shown.upTo === next.upTo && shown.theme === next.theme;
      shown = next;
      if (!isSame) viewer.request();
    },
    get camera() {
      return viewer.camera;
    },
    get extent() {
      return sectionNow()?.extent ?? null;
    },
    get hasFace() {
      return shown !== null && body.hasFace(shown.ui.layers);
    },
    close() {
      body.dispose();
      viewer.close();
    },
  };
}
