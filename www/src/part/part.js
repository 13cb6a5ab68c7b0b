/**
 * The workbench Part: bodies in the plane whose composition is a function of the distances to features.
 *
 * @import { App } from "../state/app.js"
 * @import { Point } from "../types.js"
 * @import { Bench, Known, Shown } from "./state.js"
 */
import "../../styles/modes.css";
import "../../styles/push.css";
import "../../styles/space.css";
import "../../styles/part.css";
import { segment } from "../controls/choices.js";
import { attribute, find, h, write } from "../dom.js";
import { openGallery } from "../frame/gallery.js";
import { createGroups } from "../inspector/inspector.js";
import { createKeeping } from "../kinds/keeping.js";
import { createRedraw } from "../kinds/redraw.js";
import { createWorkbench } from "../kinds/workbench.js";
import { listenToGestures } from "../stage/gestures.js";
import { createZoom } from "../stage/zoom.js";
import { isOf } from "../state/kind.js";
import { strings } from "../strings.js";
import { createCanvas } from "./canvas.js";
import { createCompare } from "./compare.js";
import { partOf } from "./document.js";
import { checksGroup, displayGroup, leavesGroup } from "./groups.js";
import { createLegend } from "./legend.js";
import { createLines } from "./lines.js";
import { createProbe } from "./probe.js";
import { createProfileGroups } from "./profile/groups.js";
import { createRuleGroups } from "./rules/groups.js";
import { createRunner } from "./runner.js";
import { leave, leftOf } from "./seen.js";
import { createShapeGroups } from "./shapes/groups.js";
import { createShapes } from "./shapes/shapes.js";
import { createSheets } from "./sheets.js";
import { extentOf, FIRST_SHOWN, firstChoice, stepIn, withoutGone } from "./state.js";
import { renderStatus, summaryOf } from "./status.js";
import { createTree } from "./tree/tree.js";
import { words } from "./words.js";

/** Of documents that are shown here. */
const KIND = "part";
/** CSS pixels round a part that is fitted into the picture: at the upper edge and at the sides. */
const ROOM = { top: 56, side: 40 };

/** What is seen of a part without shapes, in its unit. @type {[Point, Point]} */
const EMPTY = [[-50, -50], [50, 50]];

/** Groups that are open, and the one on a phone, for as long as the page is open. */
let memory = { open: ["tree", "feature", "profile", "overlap", "blend", "display"], tab: "tree" };
/** Width from which the list of features has a place of its own. */
const WIDE = "(width >= 1200px)";

/** @param {App} app */
export const createPart = (app) => createWorkbench(app, KIND, "part", openWorkbench);

/** @param {App} app @param {import("../kinds/workbench.js").Place} place */
function openWorkbench(app, { stage, aside }) {
  const { store, ui } = app;
  /** @type {Shown} */
  let shown = FIRST_SHOWN;
  /** @type {Known | null} */
  let known = null;
  /** What was asked for last. */
  let asked = "";
  /** @type {ReturnType<typeof partOf> | null} */
  let askedFor = null;
  /** Why the part cannot be evaluated. @type {string | null} */
  let reason = null;
  /** The opening of a document that the view belongs to. */
  let framed = "";
  const status = find("#status");
  const over = new AbortController();
  if (ui.value.layers.length === 0) ui.set({ layers: ["grid"] });

  const list = h("aside", { class: "part-list", "data-furniture": "", "aria-label": words.tree });
  find("#stage").before(list);
  const keeping = createKeeping(() => {
    if (framed && isFramed()) leave(app, framed, shown);
  });
  const redraw = createRedraw(() => render());
  const { request } = redraw;

  status.replaceChildren();

  /** @type {Bench} */
  const bench = {
    app,
    now: () => ({ document: partOf(app), known, isCurrent: known?.document === partOf(app), shown, view: isFramed() ? ui.value.view : null, size: ui.value.size }),
    change(patch) {
      reveal(patch);
      shown = { ...shown, ...patch };
      keeping.later();
      request();
    },
    commit: (change, run) => store.commit({ change: /** @type {any} */ (change), ...(run === undefined ? {} : { run }) }),
    endRun: () => store.endRun(),
    step: () => stepIn(bench.now().view, ui.value.snap),
    request,
  };

  /** Whether the view is one of the open document. */
  const isFramed = () => framed === store.origin.name;

  const { canvas, draw } = createCanvas();
  const sheets = createSheets();
  const lines = createLines(bench);
  const probe = createProbe(bench);
  const legend = createLegend(bench);
  const compare = createCompare(bench);
  const scale = h("div", { class: "scale", "aria-hidden": "true" });
  const zoomAt = h("div", { class: "zoom", role: "group", "aria-label": strings.canvas.zoom, "data-furniture": "" });
  const foot = h("div", { class: "morph part-foot" }, scale, legend.element, zoomAt);
  const zoom = createZoom(app, { zoom: zoomAt, scale });
  const look = segment(
    { label: words.look.label, name: "part-look", choices: /** @type {const} */ (["colors", "leaves", "compare"]).map((value) => ({ value, text: words.look[value] })) },
    (value) => bench.change({ leaves: value === "leaves", compare: value === "compare", leaf: null }),
  );
  const told = h("p", { class: "part-told" });
  const gallery = h("button", { type: "button", class: "outlined", "data-empty": "gallery", onclick: () => void openGallery(app) }, words.empty.gallery);
  const empty = h("div", { class: "empty", hidden: true, "data-part-empty": "" }, h("p", {}, words.empty.line), h("div", { class: "empty-commands", "data-furniture": "" }, gallery));
  stage.append(
    h("div", { class: "modes", "data-furniture": "" }, look.element),
    canvas,
    /** @type {any} */ (lines.element),
    ...probe.nodes,
    told,
    empty,
    foot,
    compare.element,
  );
  const groupsAt = h("div", { class: "bench-groups part-groups groups" });
  aside.append(groupsAt);
  const tree = createTree(bench);
  const treeAt = h("div", {});
  const treeGroup = { name: "tree", heading: words.tree, body: treeAt, phrase: () => "", render() {} };
  const wide = matchMedia(WIDE);
  const placeTree = () => (wide.matches ? list : treeAt).append(tree.element);
  wide.addEventListener("change", placeTree, { signal: over.signal });
  placeTree();
  const all = [treeGroup, ...createShapeGroups(bench), ...createProfileGroups(bench), ...createRuleGroups(bench), leavesGroup(bench), checksGroup(bench), displayGroup(bench)];
  const groups = createGroups(groupsAt, words.region, all, {
    read: () => memory,
    write(patch) {
      memory = { ...memory, ...patch };
      request();
    },
  });
  const shapes = createShapes(bench, stage);
  const gestures = listenToGestures(app, stage, {
    press(at) {
      probe.hover(null);
      const stroke = shapes.stroke(at);
      return stroke ? { ...stroke, kind: "stroke", from: at, moved: false } : gestures.pan(at);
    },
    hover(at, isPressed) {
      if (!isPressed) probe.hover(shapes.hover(at) ? null : at);
    },
    released({ kind, moved }, at, event) {
      if (moved || shapes.tap(at, event)) return;
      if (kind === "pan" && event.pointerType === "touch") probe.hover(at);
    },
    signal: over.signal,
  });

  const runner = createRunner(app, {
    changed(next) {
      const isOther = next.document !== known?.document || next.raster !== known?.raster;
      known = next;
      reason = null;
      if (isOther) probe.again();
      document.documentElement.dataset.ready = "true";
      // Without waiting for another frame: it is the picture of a drag.
      render();
    },
    refused({ message }) {
      reason = message;
      document.documentElement.dataset.ready = "true";
      request();
    },
    interrupted({ name, code, message }) {
      const text = name === "AbortError" ? words.cancelled : code === "trap" ? strings.errors.trap : message;
      ui.set({ note: { tone: name === "AbortError" ? "plain" : "error", text } });
    },
  });

  /** Opens the groups of what is chosen anew. @param {Partial<Shown>} patch */
  function reveal(patch) {
    const isNew = (/** @type {"shape" | "feature" | "rule" | "body"} */ key) => patch[key] !== undefined && patch[key] !== null && patch[key] !== shown[key];
    const names = [
      ...(isNew("shape") ? ["shape"] : []),
      ...(isNew("feature") || (isNew("body") && patch.feature != null) ? ["feature", "profile"] : []),
      ...(isNew("rule") ? ["rules"] : []),
      ...(patch.body != null && patch.feature == null && partOf(app).bodies[patch.body]?.blend ? ["blend"] : []),
    ];
    if (names.length > 0) memory = { ...memory, open: [...new Set([...memory.open, ...names])] };
  }

  /** The view as it was drawn last. */
  let seenView = /** @type {import("../types.js").View | null} */ (null);

  /** Goes on where an opening of a document was left, or shows the whole of a new one. */
  function frameDocument() {
    const { name } = store.origin;
    const { size, view } = ui.value;
    if (size.width < 1 || size.height < 1) return;
    const isOther = framed !== name;
    if (isOther) {
      const seen = leftOf(app, name);
      shown = seen?.shown ?? { ...FIRST_SHOWN, ...firstChoice(partOf(app)) };
      framed = name;
      if (seen?.view) return ui.set({ view: seen.view, fitted: seen.fitted, fitScale: seen.fitScale });
    }
    if (isOther || view === null) fit();
  }

  /** Shows all shapes, clear of what stands at the edges. */
  function fit() {
    const { width, height } = ui.value.size;
    const [[left, low], [right, high]] = extentOf(partOf(app)) ?? EMPTY;
    const [wide, tall] = [width - 2 * ROOM.side, height - ROOM.top - foot.offsetHeight];
    const [across, up] = [right - left, high - low];
    const found = Math.min(Math.max(1, wide) / across, Math.max(1, tall) / up);
    const toFit = Number.isFinite(found) ? found : 1;
    ui.set({
      view: { center: [(left + right) / 2, (low + high) / 2 + (ROOM.top - foot.offsetHeight) / 2 / toFit], scale: toFit },
      fitted: true,
      fitScale: toFit,
    });
  }

  /** Asks for what the picture lacks. */
  function ask() {
    const { view, size } = bench.now();
    if (!view || size.width < 1 || size.height < 1) return;
    const ratio = window.devicePixelRatio || 1;
    const wanted = { of: store.origin.name, document: partOf(app), view, size, ratio, shown };
    const key = JSON.stringify([view, size, ratio, shown.isolines, shown.violations, shown.difference]);
    if (key === asked && wanted.document === askedFor) return;
    if (wanted.document !== askedFor) reason = null;
    [asked, askedFor] = [key, wanted.document];
    runner.push(wanted);
  }

  function retry() {
    ui.set({ note: null });
    askedFor = null;
    request();
  }

  /** What is shown besides the colours, at the upper right. */
  function toldNow() {
    if (shown.compare || shown.leaves) return "";
    if (shown.difference && known?.reference) return words.difference;
    return shown.isolines === null ? "" : words.lines(partOf(app).materials?.[shown.isolines]?.name ?? "", known?.isFine ? "0.1" : "0.2");
  }

  function render() {
    const document = partOf(app);
    if (!isOf(document, KIND)) return;
    frameDocument();
    shown = withoutGone(shown, document);
    ask();
    const { view, size } = bench.now();
    const { theme, layers } = ui.value;
    if (view !== seenView) {
      seenView = view;
      keeping.later();
    }
    if (view && known) draw({ view, size, theme, hasGrid: layers.includes("grid"), ...sheets.of(known, shown) });
    attribute(canvas, "aria-label", words.picture(document.title ?? "", summaryOf(bench)));
    look.set(shown.compare ? "compare" : shown.leaves ? "leaves" : "colors");
    write(told, toldNow());
    empty.hidden = (document.shapes ?? []).length > 0 || ui.value.drawing || app.tool !== null;
    zoom.render();
    lines.render();
    shapes.render();
    probe.render();
    legend.render();
    compare.render();
    groups.render();
    tree.render();
    stage.dataset.look = shown.compare ? "compare" : shown.leaves ? "leaves" : "colors";
    stage.dataset.part = known?.document !== document ? "" : known.measured ? "measured" : "shown";
    renderStatus(bench, status, { reason, cancel: runner.cancel, retry });
  }

  return {
    render,
    close() {
      over.abort();
      redraw.close();
      keeping.close();
      runner.close();
      probe.close();
      compare.close();
      shapes.close();
      list.remove();
      status.replaceChildren();
      delete status.dataset.verdict;
    },
  };
}
