/**
 * The workbench Laplace: boundary value problems of compositions, solved by boundary elements, and the laboratory in which solvers are compared.
 *
 * @import { App } from "../state/app.js"
 * @import { Bench, Known, Shown } from "./state.js"
 */
import "../../styles/modes.css";
import "../../styles/push.css";
import "../../styles/space.css";
import "../../styles/composition.css";
import "../../styles/part.css";
import "../../styles/laboratory.css";
import { commandOf, runCommand } from "../commands.js";
import { segment } from "../controls/choices.js";
import { attribute, find, h, write } from "../dom.js";
import { isStl } from "../files/open.js";
import { createGroups } from "../inspector/inspector.js";
import { createKeeping } from "../kinds/keeping.js";
import { createRedraw } from "../kinds/redraw.js";
import { createWorkbench } from "../kinds/workbench.js";
import { later } from "../later.js";
import { STANDARD } from "../space/camera.js";
import { problem } from "../painter.js";
import { moveOf } from "../space/keys.js";
import { createStand, followSize, isElsewhere, whereDrawn } from "../space/stand.js";
import { isOf } from "../state/kind.js";
import { strings } from "../strings.js";
import { createBoxMoves } from "./box-moves.js";
import { boundaryGroup } from "./boundary-group.js";
import { isSameSolution, laboratoryOf } from "./document.js";
import { createFace } from "./face.js";
import { displayGroup, modelGroup, sectionGroup, solverGroup } from "./groups.js";
import { createLegend } from "./legend.js";
import { materialsGroup } from "./materials-group.js";
import { createPainting } from "./painting.js";
import { createPicker } from "./picker.js";
import { offer } from "./picture.js";
import { createPlaneStage } from "./plane-stage.js";
import { createPreview } from "./preview.js";
import { createReader } from "./reader.js";
import { createRunner } from "./runner.js";
import { acrossOf, extentOf, planeOf, placed, placeOf } from "./section-state.js";
import { leave, leftOf } from "./seen.js";
import { createSpaceView } from "./space-view.js";
import { FIRST_SHOWN, withoutGone } from "./state.js";
import { renderStatus, summaryOf } from "./status.js";
import { fixed } from "../format.js";
import { words } from "./words.js";

/** Of documents that are shown here. */
const KIND = "laplace";
/** CSS pixels at the upper edge that stay free. */
const TOP = 56;
/** A step of the plane by keys, as a share of its way. */
const STEP = 0.01;

/** Groups that are open, and the one on a phone, for as long as the page is open. */
let memory = { open: ["model", "boundary", "section", "display"], tab: "model" };

/** @param {App} app */
export const createLaboratory = (app) => createWorkbench(app, KIND, "lab", openWorkbench);

/** @param {App} app @param {import("../kinds/workbench.js").Place} place */
function openWorkbench(app, { stage, aside }) {
  const { store, ui } = app;
  /** @type {Shown} */
  let shown = FIRST_SHOWN;
  /** @type {Known | null} */
  let known = null;
  /** @type {import("./document.js").LaboratoryDocument | null} */
  let asked = null;
  /** Why the document cannot be read. @type {string | null} */
  let reason = null;
  let isLost = false;
  /** A body has taken the place of another, and is not seen yet. */
  let isAnew = false;
  /** The opening of a document that is shown as it was left. */
  let framed = "";
  /** The one that the camera was fitted to. */
  let fittedTo = "";
  let spoken = "";
  /** What was said of the last edit, and the document that it led to. @type {{text: string, of: import("./document.js").LaboratoryDocument} | null} */
  let lead = null;
  const status = find("#status");
  const over = new AbortController();

  const keeping = createKeeping(() => {
    if (framed && framed === store.origin.name && (fittedTo === framed || known?.mesh.soup === null)) leave(app, framed, view?.camera ?? null, shown);
  });
  const redraw = createRedraw(() => render());
  const { request } = redraw;

  status.replaceChildren();
  if (ui.value.layers.length === 0) ui.set({ layers: ["grid"] });

  /** @type {Bench} */
  const bench = {
    app,
    now() {
      const document = laboratoryOf(app);
      return { document, known, isCurrent: known !== null && isSameSolution(known.document, document), shown, view: ui.value.view, size: ui.value.size };
    },
    change(patch) {
      if (patch.picking) shown = { ...shown, look: "solution" };
      shown = { ...shown, ...patch };
      keeping.later();
      request();
    },
    commit: (change, run) => store.commit({ change: /** @type {any} */ (change), ...(run === undefined ? {} : { run }) }),
    endRun() {
      store.endRun();
      request();
    },
    takeBack: (run) => void store.cancel(run),
    seeAnew() {
      isAnew = true;
      bench.change({ look: "solution", group: null, picking: null });
    },
    request,
  };

  const reader = createReader(bench);
  const face = createFace(bench, () => {
    painting.face();
    request();
  });
  const picker = createPicker(bench);
  const preview = createPreview(bench);
  const box = createBoxMoves(bench, preview, {
    begun: () => view?.readMiddle(false),
    told(text) {
      lead = { text, of: laboratoryOf(app) };
      app.say(text);
    },
  });
  const view = whereDrawn(() =>
    createSpaceView(app, {
      plane: {
        move: (offset, run) => moveSection(({ section: plane }) => (plane ? offset - planeOf(plane).offset : 0), run),
        end: bench.endRun,
        undo: bench.takeBack,
        step(steps) {
          const { section } = laboratoryOf(app);
          const way = extent();
          if (!section || !way) return;
          moveSection(() => 0, undefined, placeOf(section) + steps * STEP * (way[1] - way[0]));
          app.say(sectionText());
        },
      },
      box: box.moves,
      read: (place, at, isCross) => reader.read(shown.picking ? null : place, at, ui.value.size, isCross),
      speak: () => reader.speak(),
      tap: (place) => picker.tap(place),
      isInside,
      rested: () => keeping.later(),
      oncontext(lost) {
        isLost = lost;
        request();
      },
    }),
  );
  const painting = createPainting(bench, view, () => face.latest, preview);
  const plane = createPlaneStage(bench, { read: reader.read, speak: reader.speak, tap: picker.tap, face: () => face.latest, box: box.moves, preview, signal: over.signal });
  offer({
    get size() {
      return ui.value.size;
    },
    picture: (wanted) => (known?.mesh.soup ? (view?.picture(wanted) ?? null) : plane.picture(wanted)),
    known: () => (bench.now().isCurrent ? known : null),
    face: () => face.latest,
  });
  const legend = createLegend(bench);
  const look = segment(
    { label: words.look.label, name: "lab-look", choices: /** @type {const} */ (["solution", "solvers"]).map((value) => ({ value, text: words.look[value] })) },
    (value) => bench.change({ look: value, picking: null }),
  );
  const kindLabel = h("div", { class: "lab-kind", "data-lab-kind": "" }, h("strong", {}), h("span", {}));
  const message = h("div", { class: "space-message", hidden: true, "data-lab-message": "" }, h("p", {}));
  const hint = h("p", { class: "lab-hint", hidden: true, "data-lab-hint": "" }, words.boundary.picking);
  const { picture, keyboard, help, zoom } = createStand({ name: "lab", words, view });
  const foot = h("div", { class: "morph lab-foot" }, /** @type {any} */ (view?.triad) ?? h("span", {}), legend.element, zoom);
  const { resize, close: stopFollowing } = followSize(picture, view, () => ({ top: Math.max(TOP, kindLabel.offsetTop + kindLabel.offsetHeight), bottom: foot.offsetHeight }));
  const solversAt = h("div", { class: "lab-solvers", hidden: true, "data-furniture": "" });
  stage.append(picture, plane.element, ...reader.nodes, h("div", { class: "modes", "data-furniture": "" }, look.element), kindLabel, hint, help, message, foot, plane.foot, solversAt);

  /** @type {{close: () => void} | null} */
  let comparing = null;
  /** The comparison of solvers. */
  const solvers = later(
    app,
    () => shown.look === "solvers",
    async () => {
      const { createSolvers } = await import("./compare/solvers.js");
      return () => (comparing = createSolvers(bench, solversAt));
    },
    (error) => {
      shown = { ...shown, look: "solution" };
      ui.set({ note: { tone: "error", text: problem(error).message } });
    },
  );

  const groupsAt = h("div", { class: "bench-groups lab-panels groups" });
  aside.append(groupsAt);
  const acts = { look: (/** @type {any} */ direction) => view?.look(direction), back: () => view?.back ?? /** @type {import("../space/vector.js").Vector} */ ([0, -1, 0]), face: () => face.latest };
  const [model, section] = [modelGroup(bench), sectionGroup(bench, acts)];
  const groups = createGroups(groupsAt, words.region, [model, boundaryGroup(bench, preview), section, solverGroup(bench), materialsGroup(bench), displayGroup(bench, acts)], {
    read: () => memory,
    write(patch) {
      memory = { ...memory, ...patch };
      request();
    },
  });

  const runner = createRunner(app, {
    changed(next) {
      const isOther = next.solution !== known?.solution;
      known = next;
      reason = null;
      if (isOther) reader.again();
      document.documentElement.dataset.ready = "true";
      painting.boundary();
      tell();
      request();
    },
    refused({ message: text }) {
      reason = text;
      document.documentElement.dataset.ready = "true";
      request();
    },
    interrupted({ name, code, message: text }) {
      const said = name === "AbortError" ? words.cancelled : code === "trap" ? strings.errors.trap : text;
      ui.set({ note: { tone: name === "AbortError" ? "plain" : "error", text: said } });
    },
  });

  /** @returns {[number, number] | null} */
  function extent() {
    const { section: plane } = laboratoryOf(app);
    return plane && known?.mesh.soup ? extentOf(plane, known.mesh.soup.positions) : null;
  }

  /**
   * Moves the plane along its normal, or to a place of its way.
   * @param {(document: import("./document.js").LaboratoryDocument) => number} by
   * @param {string} [run]
   * @param {number} [to]
   */
  function moveSection(by, run, to) {
    const way = extent();
    if (!way) return;
    bench.commit((document) => {
      const { section: plane } = document;
      if (!plane) return document;
      // Its way may run against its normal.
      const isAlong = placeOf({ ...plane, origin: plane.normal }) > 0;
      const place = to ?? placeOf(plane) + (isAlong ? by(document) : -by(document));
      return { ...document, section: placed(plane, place, way) };
    }, run);
  }

  const sectionText = () => {
    const { section: plane } = laboratoryOf(app);
    return plane ? words.section.value(acrossOf(plane), fixed(placeOf(plane), 2)) : words.section.off;
  };

  /** What the face shows: while the same body is solved anew, the solution before it stays in sight. */
  function solvedOf() {
    const isWorking = known !== null && !known.solution && known.boundary.ready && !known.unsolved;
    return isWorking && face.latest?.of.mesh === known?.mesh ? (face.latest?.of ?? null) : known;
  }

  /** Whether a place of the plane is inside, as the pixels of its face have it. @param {import("../space/vector.js").Vector} point */
  function isInside(point) {
    const found = face.latest;
    // Before the face is known its plane is taken for what is seen.
    if (!found || !found.of.mesh.soup) return known?.solution != null;
    const { origin, sides } = found.frame;
    const share = sides.map((side) => {
      const by = point.map((value, k) => value - origin[k]);
      return by.reduce((sum, value, k) => sum + value * side[k], 0) / side.reduce((sum, value) => sum + value * value, 0);
    });
    const [i, j] = share.map((each, k) => Math.floor(each * found.size[k]));
    return i >= 0 && j >= 0 && i < found.size[0] && j < found.size[1] && !Number.isNaN(found.values[0][j * found.size[0] + i]);
  }

  /** Speaks of a problem once an edit is over and it is solved. */
  function tell() {
    const text = summaryOf(bench);
    if (store.running || !bench.now().isCurrent || (!known?.solution && known?.boundary.ready && !known.unsolved) || text === spoken) return;
    spoken = text;
    // What was said of the edit itself is not cut off by what came of it.
    app.say(lead && lead.of === known?.document ? words.spoken.both(lead.text, text) : text);
    lead = null;
  }

  /** Shows a place that is wrong. @param {readonly number[]} place */
  function show(place) {
    shown = { ...shown, look: "solution" };
    view?.witness(place);
    plane.witness(place);
    request();
  }

  function retry() {
    ui.set({ note: null });
    asked = null;
    request();
  }

  /** Goes on where an opening of a document was left. */
  function open() {
    const { name } = store.origin;
    if (framed === name) return;
    framed = name;
    const seen = leftOf(app, name);
    shown = seen?.shown ?? { ...FIRST_SHOWN, look: shown.look };
    ui.set(seen?.view ? { view: seen.view, fitted: seen.fitted, fitScale: seen.fitScale } : { view: null, fitted: true });
  }

  /** Fits the camera to a body that was not seen before. */
  function fit() {
    const { name } = store.origin;
    if (!view || !known?.mesh.soup || !bench.now().isCurrent) return;
    if (isAnew) {
      isAnew = false;
      fittedTo = name;
      view.fit(STANDARD.iso);
    }
    if (fittedTo === name) return;
    fittedTo = name;
    const seen = leftOf(app, name);
    if (seen?.camera) view.restore(seen.camera);
    else view.fit(STANDARD.iso);
  }

  function render() {
    const document = laboratoryOf(app);
    if (!isOf(document, KIND)) return;
    open();
    shown = withoutGone(shown, document);
    if (document !== asked) {
      const isSame = asked !== null && known !== null && reason === null && isSameSolution(asked, document);
      asked = document;
      if (isSame && known?.document) known = { ...known, document };
      else {
        reason = null;
        view?.witness(null);
        plane.witness(null);
        runner.push(document);
      }
    }
    const isSpace = known ? known.mesh.soup !== null : document.model.kind !== "square" && document.model.kind !== "annulus";
    const text = !isSpace || reason !== null ? "" : view === null ? words.noWebGl : isLost ? words.lost : "";
    picture.hidden = !isSpace || text !== "";
    foot.hidden = !isSpace || view === null;
    plane.element.hidden = plane.foot.hidden = isSpace;
    const legendAt = isSpace ? foot : plane.foot;
    if (legend.element.parentElement !== legendAt) legendAt.insertBefore(legend.element, legendAt.lastChild);
    message.hidden = text === "";
    write(/** @type {Node} */ (message.firstChild), text);
    const [heading, line] = words.kinds[isSpace ? (document.section ? "section" : "space") : "plane"];
    write(/** @type {Node} */ (kindLabel.firstChild), heading);
    write(/** @type {Node} */ (kindLabel.lastChild), line);
    kindLabel.dataset.labKind = isSpace ? "space" : "plane";
    hint.hidden = shown.picking === null;
    look.set(shown.look);
    stage.dataset.look = shown.look;
    stage.dataset.picking = shown.picking ?? "";
    painting.boundary();
    fit();
    if (isSpace) resize();
    face.request(solvedOf(), document.section ?? null);
    painting.face();
    if (view) {
      attribute(view.canvas, "aria-label", words.picture(document.title, summaryOf(bench)));
      const way = extent();
      if (document.section && way) view.mark.describe(sectionText(), placeOf(document.section), way);
    }
    if (!isSpace) plane.render();
    const describe = box.describe();
    if (describe) (isSpace ? view : plane)?.describeBox(describe);
    legend.render();
    groups.render();
    solversAt.hidden = shown.look !== "solvers";
    solvers.render();
    const { isCurrent } = bench.now();
    const isSettled = known !== null && isCurrent && (known.solution !== null || known.unsolved !== null || !known.boundary.ready);
    const isWhole = isSpace && !document.section ? known?.solution !== null : face.latest?.isFine && face.latest.of === known;
    stage.dataset.lab = !isSettled ? "" : !known?.solution ? "faulty" : isWhole ? "fine" : "solved";
    renderStatus(bench, status, { reason, face: face.latest, cancel: runner.cancel, retry, show });
  }

  addEventListener("keydown", key, { signal: over.signal });

  /** @param {KeyboardEvent} event */
  function key(event) {
    if (isElsewhere(event)) return;
    const letter = event.altKey ? "" : event.key.toLowerCase();
    const isOnPicture = event.target === keyboard;
    if (letter === "c") {
      bench.change({ look: shown.look === "solvers" ? "solution" : "solvers", picking: null });
      app.say(words.look[shown.look]);
    } else if (shown.look === "solvers") return;
    else if (letter === "p" && shown.group !== null) bench.change({ picking: shown.picking ? null : "direction" });
    else if (event.key === "Escape" && shown.picking) bench.change({ picking: null });
    else if (event.key === "Escape" && shown.group !== null && known?.mesh.soup === null) leaveGroup(event, plane.focus);
    else if (known?.mesh.soup === null) {
      const command = commandOf(event);
      if (command?.topic !== "view") return;
      runCommand(app, command.name);
    } else if (view) {
      if (!keyInSpace(event, isOnPicture, view)) return;
    } else return;
    event.preventDefault();
  }

  /** No group is chosen any more, and with it go the handles of its box. @param {KeyboardEvent} event @param {() => void} focus of the picture */
  function leaveGroup(event, focus) {
    if (event.target instanceof Element && event.target.closest(".box-handles")) focus();
    bench.change({ group: null });
  }

  /**
   * @param {KeyboardEvent} event
   * @param {boolean} isOnPicture
   * @param {import("./space-view.js").SpaceView} seen
   * @returns {boolean} whether the key meant something
   */
  function keyInSpace(event, isOnPicture, seen) {
    if (isOnPicture) keyboard.classList.add("keyed");
    const move = moveOf(event, isOnPicture);
    if (move) seen.move(move);
    else if (event.key === "Enter" && isOnPicture) {
      seen.readMiddle(true);
      if (shown.picking) picker.tap(seen.middle);
    } else if (event.key === "Escape" && (seen.readMiddle(false) || shown.group !== null)) leaveGroup(event, () => keyboard.focus({ preventScroll: true }));
    else return false;
    return true;
  }

  // An STL is taken here, before the page would read it as a document.
  addEventListener(
    "drop",
    (event) => {
      const dropped = event.dataTransfer?.files[0];
      if (!dropped || !isStl(dropped)) return;
      event.preventDefault();
      event.stopImmediatePropagation();
      find("#drop").hidden = true;
      // The group Body may be closed.
      void model.open(dropped).then(({ isOpen, text }) => ui.set({ note: isOpen ? null : { tone: "error", text } }));
    },
    { signal: over.signal, capture: true },
  );

  return {
    render,
    close() {
      over.abort();
      redraw.close();
      stopFollowing();
      keeping.close();
      runner.close();
      face.close();
      reader.close();
      comparing?.close();
      offer(null);
      view?.close();
      status.replaceChildren();
      delete status.dataset.verdict;
    },
  };
}
