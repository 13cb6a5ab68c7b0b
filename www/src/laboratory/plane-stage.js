/**
 * What stands on the canvas of a problem in the plane: its picture, which is moved and zoomed as other pictures of the plane are, and how it is read.
 *
 * @import { Point } from "../types.js"
 * @import { Face } from "./face.js"
 * @import { BoxMoves } from "../space/box-mark.js"
 * @import { createPreview } from "./preview.js"
 * @import { Place } from "./reader.js"
 * @import { Bench } from "./state.js"
 */
import { attribute, h, svg } from "../dom.js";
import { strings } from "../strings.js";
import { listenToGestures } from "../stage/gestures.js";
import { put } from "../stage/mark.js";
import { createZoom } from "../stage/zoom.js";
import { toPlane, toScreen } from "../view.js";
import { paintedIn } from "./document.js";
import { elementColors } from "./element-colors.js";
import { drawnBox } from "./box-edit.js";
import { createPlaneBox } from "./plane-box.js";
import { createPlaneView } from "./plane-view.js";
import { colorsOf, levelLines, LEVELS } from "./pixels.js";
import { summaryOf } from "./status.js";
import { words } from "./words.js";

/** CSS pixels round a body that is fitted into the picture: at the upper edge and at the sides. */
const ROOM = { top: 84, side: 44 };
/** CSS pixels of one arrow key; Shift and Alt make it ten times as much and a tenth. */
const STEP = 10;
/** @type {{[key: string]: Point}} */
const ARROWS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };

/**
 * @param {Bench} bench
 * @param {object} acts
 * @param {(place: Place | null, at: Point | null, size: import("../types.js").Size, isCross: boolean) => void} acts.read
 * @param {() => void} acts.speak
 * @param {(place: Place | null) => void} acts.tap
 * @param {() => Face | null} acts.face
 * @param {BoxMoves} acts.box what moving the sides of a box does
 * @param {ReturnType<typeof createPreview>} acts.preview of the group that is dragged
 * @param {AbortSignal} acts.signal
 */
export function createPlaneStage(bench, { read, speak, tap, face, box: moves, preview, signal }) {
  const { app } = bench;
  const { ui } = app;
  const picture = createPlaneView();
  const help = h("p", { id: "lab-plane-help", class: "spoken" }, words.planeHelp);
  const keyboard = h("div", { class: "part-keys", tabIndex: 0, role: "application", "aria-label": words.keyboard, "aria-describedby": help.id, "data-lab-plane-keys": "" });
  const fault = svg("g", { class: "part-witness" }, svg("path", { class: "under", d: "M-6 -6 6 6M6 -6-6 6" }), svg("path", { d: "M-6 -6 6 6M6 -6-6 6" }));
  const marks = svg("svg", { class: "marks lab-marks", "aria-hidden": "true" }, fault);
  const box = createPlaneBox(moves);
  const element = h("div", { class: "lab-plane" }, picture.canvas, picture.over, /** @type {any} */ (marks), keyboard, ...box.nodes, help);
  /** A place that is wrong. @type {readonly number[] | null} */
  let witness = null;
  const scale = h("div", { class: "scale", "aria-hidden": "true" });
  const zoomAt = h("div", { class: "zoom", role: "group", "aria-label": strings.canvas.zoom, "data-furniture": "" });
  const foot = h("div", { class: "morph lab-foot" }, scale, zoomAt);
  const zoom = createZoom(app, { zoom: zoomAt, scale });
  /** What the view was fitted to. */
  let fittedFor = "";
  /** Where something is read by keys, document units. @type {Point | null} */
  let crossed = null;
  /** What was made of the face last. @type {{of: unknown[], pixels: Uint8ClampedArray<ArrayBuffer>, lines: number[]} | null} */
  let made = null;

  /** @param {Point} at CSS pixels @returns {Place | null} */
  function placeAt(at) {
    const { view, size } = ui.value;
    if (!view || !bench.now().known) return null;
    return { point: [...toPlane(view, size, at), 0], element: picture.elementAt(at) };
  }

  const gestures = listenToGestures(app, element, {
    press(at) {
      read(null, null, ui.value.size, false);
      return gestures.pan(at);
    },
    hover(at, isPressed) {
      if (isPressed) return;
      crossed = null;
      read(at && !bench.now().shown.picking ? placeAt(at) : null, at, ui.value.size, false);
    },
    released({ moved }, at, event) {
      if (moved) return;
      const place = placeAt(at);
      tap(place);
      if (event.pointerType === "touch" && !bench.now().shown.picking) read(place, at, ui.value.size, false);
      keyboard.focus({ preventScroll: true });
    },
    signal,
  });

  keyboard.addEventListener("keydown", (event) => {
    const arrow = ARROWS[event.key];
    if (event.ctrlKey || event.metaKey) return;
    if (event.key === "Escape" && crossed) {
      crossed = null;
      read(null, null, ui.value.size, false);
    } else if (event.key === "Enter" && crossed && bench.now().shown.picking) tap(placeAt(screenOf(crossed)));
    else if (arrow) {
      const { view, size } = ui.value;
      if (!view) return;
      const by = STEP * (event.shiftKey ? 10 : event.altKey ? 0.1 : 1);
      const from = crossed ? toScreen(view, size, crossed) : [size.width / 2, size.height / 2];
      const to = /** @type {Point} */ ([from[0] + (crossed ? arrow[0] * by : 0), from[1] + (crossed ? arrow[1] * by : 0)]);
      crossed = toPlane(view, size, to);
      read(placeAt(to), to, size, true);
      speak();
    } else return;
    event.preventDefault();
    event.stopPropagation();
  });

  /** @param {Point} at document units @returns {Point} */
  const screenOf = (at) => toScreen(/** @type {import("../types.js").View} */ (ui.value.view), ui.value.size, at);

  /** Shows all of the boundary, clear of what stands at the edges. */
  function fit() {
    const { known, size } = bench.now();
    if (!known || size.width < 1 || size.height < 1) return;
    const { min, max } = known.mesh.bounds;
    const [wide, tall] = [Math.max(1, size.width - 2 * ROOM.side), Math.max(1, size.height - ROOM.top - foot.offsetHeight)];
    const toFit = Math.min(wide / Math.max(1e-12, max[0] - min[0]), tall / Math.max(1e-12, max[1] - min[1]));
    ui.set({ view: { center: [(min[0] + max[0]) / 2, (min[1] + max[1]) / 2 + (ROOM.top - foot.offsetHeight) / 2 / toFit], scale: toFit }, fitted: true, fitScale: toFit });
  }

  /** The pixels and lines of the face, made once. @param {Face} found */
  function sheetOf(found) {
    const { document, shown } = bench.now();
    const materials = paintedIn(document, found.of);
    const of = [found.values, materials, shown.isolines];
    if (!made || of.some((each, k) => each !== made?.of[k])) {
      const { size, values, frame } = found;
      const lines = shown.isolines === null || !values[shown.isolines] ? [] : LEVELS.flatMap((level) => levelLines(values[/** @type {number} */ (shown.isolines)], size, level));
      const placed = lines.map((at, k) => frame.origin[k % 2] + ((at + 0.5) / size[k % 2]) * frame.sides[k % 2][k % 2]);
      made = { of, pixels: colorsOf(found, materials, true), lines: placed };
    }
    return made;
  }

  return {
    element,
    foot,
    render() {
      const { document, known, shown, view, size } = bench.now();
      if (!known || known.mesh.soup) return;
      const { min, max } = known.mesh.bounds;
      const toFit = [size.width, size.height, ...min, ...max].join(" ");
      if (view === null || (ui.value.fitted && fittedFor !== toFit)) {
        fittedFor = toFit;
        fit();
        return;
      }
      const found = face();
      const own = found && !found.of.mesh.soup ? found : null;
      const sheet = own && sheetOf(own);
      const dragged = preview.boundary;
      const boundary = dragged ?? known.boundary;
      const chosen = shown.group === null || shown.picking ? undefined : document.groups[shown.group]?.where.box;
      box.render(chosen?.[0].length === 2 ? drawnBox(chosen, known.mesh.bounds) : null, view, size);
      picture.draw({
        view,
        size,
        theme: ui.value.theme,
        hasGrid: ui.value.layers.includes("grid"),
        sheet: own && sheet ? { pixels: sheet.pixels, size: own.size, box: [[min[0], min[1]], [max[0], max[1]]] } : null,
        mesh: known.mesh,
        boundary,
        colorOf: elementColors(boundary, paintedIn(document, known), shown.color === "solved" ? known.solution : null),
        isChosen: (each) => shown.group !== null && boundary.members[each] === shown.group,
        isWrong: (each) => !dragged && boundary.groups[each] >= boundary.conditions.length,
        edges: shown.edges,
        isolines: sheet?.lines ?? [],
      });
      attribute(picture.canvas, "aria-label", words.picture(document.title, summaryOf(bench)));
      put(fault, witness && toScreen(view, size, [witness[0], witness[1]]));
      zoom.render();
    },
    picture: picture.picture,
    describeBox: box.describe,
    focus: () => keyboard.focus({ preventScroll: true }),
    /** Marks a place that is wrong. @param {readonly number[] | null} place */
    witness(place) {
      witness = place;
    },
  };
}
