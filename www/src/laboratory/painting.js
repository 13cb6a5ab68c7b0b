/**
 * Brings the picture in space up with what is known and shown: the boundary in its colours with its marks, and the face of the section. Nothing is painted
 * twice.
 *
 * @import { Face } from "./face.js"
 * @import { SpaceView } from "./space-view.js"
 * @import { createPreview } from "./preview.js"
 * @import { Bench } from "./state.js"
 */
import { drawnBox } from "./box-edit.js";
import { elementLabs, hatchedOf } from "./element-colors.js";
import { paintedIn } from "./document.js";
import { rimOf } from "./mesh.js";
import { colorsOf, grown, levelLines, LEVELS } from "./pixels.js";
import { planeOf } from "./section-state.js";

/** How often pixels of a face are grown beyond its edge. */
const GROWN = 2;

/**
 * @param {Bench} bench
 * @param {SpaceView | null} view null where nothing is drawn
 * @param {() => Face | null} latest
 * @param {ReturnType<typeof createPreview>} preview
 */
export function createPainting(bench, view, latest, preview) {
  /** What boundary, marks and face were painted with last. @type {{[what: string]: unknown[]}} */
  const before = {};

  /** Whether something is to be painted anew. @param {string} what @param {unknown[]} now */
  function isNew(what, now) {
    const last = before[what];
    before[what] = now;
    return !last || now.some((each, k) => each !== last[k]);
  }

  return {
    boundary() {
      const { document, known, shown } = bench.now();
      if (!known?.mesh.soup || !view) return;
      const { mesh } = known;
      const materials = paintedIn(document, known);
      const dragged = preview.boundary;
      const boundary = dragged ?? known.boundary;
      const solution = shown.color === "solved" ? known.solution : null;
      const box = shown.group === null || shown.picking ? undefined : document.groups[shown.group]?.where.box;
      view.set({ mesh, plane: document.section ? planeOf(document.section) : null, box: box?.[0].length === 3 ? drawnBox(box, mesh.bounds) : null, shown, theme: bench.app.ui.value.theme });
      if (isNew("boundary", [boundary, solution, shown.color, materials])) {
        view.scene.paint(elementLabs(boundary, materials, solution), hatchedOf(boundary, shown.color === "given" || !solution));
      }
      if (!isNew("marks", [boundary, shown.group])) return;
      const isFaulty = !dragged && boundary.diagnostics.some(({ code }) => code === "missing" || code === "conflict");
      view.scene.mark(
        shown.group === null ? [] : rimOf(mesh.joints, (element) => boundary.members[element] === shown.group),
        isFaulty ? rimOf(mesh.joints, (element) => boundary.groups[element] >= boundary.conditions.length) : [],
      );
    },
    face() {
      const { document, shown } = bench.now();
      const face = latest();
      if (!view || (face && !face.of.mesh.soup)) return;
      const materials = face && paintedIn(document, face.of);
      if (!isNew("face", [face?.values, materials, shown.isolines])) return;
      view.scene.face(face && { pixels: grown(colorsOf(face, materials ?? []), face.size, GROWN), size: face.size, frame: face.frame });
      view.scene.isolines(face && shown.isolines !== null ? linesIn(face, shown.isolines) : []);
      view.request();
    },
  };
}

/** Lines of equal fraction on the plane of a section, six numbers a segment. @param {Face} face @param {number} material */
function linesIn({ frame: { origin, sides }, size, values }, material) {
  /** @type {number[]} */
  const found = [];
  // A material that was added is in no solution yet.
  if (!values[material]) return found;
  for (const level of LEVELS) {
    const flat = levelLines(values[material], size, level);
    for (let k = 0; k < flat.length; k += 2) {
      const [i, j] = [(flat[k] + 0.5) / size[0], (flat[k + 1] + 0.5) / size[1]];
      found.push(...[0, 1, 2].map((axis) => origin[axis] + i * sides[0][axis] + j * sides[1][axis]));
    }
  }
  return found;
}
