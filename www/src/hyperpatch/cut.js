/**
 * The section of a body: its plane as the camera stands, and the face that the kernel finds in it.
 *
 * @import { BodySection } from "../../../js/directrix.js"
 * @import { App } from "../state/app.js"
 * @import { Plane } from "../space/plane.js"
 * @import { Coloring } from "./colors.js"
 * @import { Known } from "./runner.js"
 * @import { Shown } from "./state.js"
 *
 * @typedef {object} CutView
 * @property {import("../space/vector.js").Vector} back
 * @property {(plane: Plane | null) => void} frame
 * @property {(next: {plane: Plane, section: BodySection, labs: Float32Array} | null) => void} cut
 */
import { problem } from "../painter.js";
import { sectionPlane } from "../space/section.js";
import { Lane } from "../state/lane.js";
import { labsFor } from "./colors.js";

/** How far inside what is kept the face of a cut is found, as a share of its way: a plane that lies in faces of cells has no face of its own. */
const INSIDE = 1e-6;

/**
 * @param {App} app
 * @param {object} of
 * @param {() => {known: Known | null, shown: Shown}} of.now
 * @param {() => CutView | null} of.view
 * @param {() => Coloring} of.coloring
 * @param {(area: number | null) => void} of.found the area of the face; null where nothing is cut
 */
export function createCut(app, { now, view, coloring, found: told }) {
  let key = "";
  /** @type {{plane: Plane, section: BodySection} | null} */
  let face = null;

  /** One section at a time, the newest wanted next. @type {Lane<{plane: Plane, of: Known, by: number}, BodySection>} */
  const sections = new Lane({
    work: ({ plane, of, by }, signal) => of.body.section({ normal: plane.normal, offset: plane.offset + by }, {}, { signal }),
    done(section, { plane, of }) {
      const { known, shown } = now();
      if (of.surface !== known?.surface || shown.section.axis === "off") return;
      face = { plane, section };
      paint();
      told(section.area);
    },
    failed(error) {
      const { name, message } = problem(error);
      if (name !== "AbortError") app.ui.set({ note: { tone: "error", text: message } });
    },
  });

  /** The plane with its way, as the camera stands. */
  function plane() {
    const { known, shown } = now();
    return known ? sectionPlane(shown.section, known.surface.positions, view()?.back ?? [0, -1, 0]) : null;
  }

  /** Colours the face as the surface is coloured now. */
  function paint() {
    if (face) view()?.cut({ ...face, labs: labsFor(face.section, coloring()) });
  }

  return {
    plane,
    paint,
    /** Asks for the face where the plane has moved. @param {boolean} [isNew] whether the body is another one */
    request(isNew = false) {
      const { known, shown } = now();
      const found = plane();
      const next = found && known ? JSON.stringify(found.plane) : "";
      if (next === key && !isNew) return;
      key = next;
      if (found && known) {
        view()?.frame(shown.section.axis === "view" ? null : found.plane);
        sections.push({ plane: found.plane, of: known, by: INSIDE * (found.extent[1] - found.extent[0]) });
        return;
      }
      face = null;
      view()?.frame(null);
      view()?.cut(null);
      told(null);
    },
    close: () => sections.cancel(),
  };
}
