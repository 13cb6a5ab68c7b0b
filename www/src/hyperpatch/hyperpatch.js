/**
 * The workbench Hyperpatch: a body of tricubic cells in three dimensions, with the verdict on each cell and on the whole.
 *
 * @import { App } from "../state/app.js"
 * @import { BodyDocument } from "./document.js"
 * @import { Known } from "./runner.js"
 * @import { Shown } from "./state.js"
 */
import "../../styles/space.css";
import "../../styles/push.css";
import "../../styles/hyperpatch.css";
import { attribute, find, h, write } from "../dom.js";
import { createGroups } from "../inspector/inspector.js";
import { createKeeping } from "../kinds/keeping.js";
import { createWorkbench } from "../kinds/workbench.js";
import { STANDARD } from "../space/camera.js";
import { placeOf, planeMoves } from "../space/section.js";
import { sectionText } from "../space/section-group.js";
import { createStand, followSize, whereDrawn } from "../space/stand.js";
import { isOf } from "../state/kind.js";
import { strings } from "../strings.js";
import { shiftsOf } from "./apart.js";
import { placeOf as coefficientAt, sampleAt } from "./cell.js";
import { coloringOf, labsFor, rangeOf } from "./colors.js";
import { createCorner } from "./corner.js";
import { createCut } from "./cut.js";
import { bodyOf } from "./document.js";
import { createEditing } from "./editing/editing.js";
import { placeOfCorner } from "./edits.js";
import { createBodyGroups, nudgeOf } from "./groups.js";
import { listenToKeys } from "./keys.js";
import { jointsOf } from "./joints.js";
import { createBodyLegend } from "./legend.js";
import { neighboursOf } from "./neighbours.js";
import { offer } from "./picture.js";
import { createRunner } from "./runner.js";
import { leave, leftOf } from "./seen.js";
import { boundsOf, FIRST_SHOWN, hasInner, sharedCorner, withoutGone } from "./state.js";
import { renderStatus, summaryOf } from "./status.js";
import { createBodyView } from "./view.js";
import { words } from "./words.js";

/** Of documents that are shown here. */
const KIND = "hyperpatch";
/** CSS pixels at the upper edge that stay free. */
const TOP = 16;
/** Cells with a badge in the picture at most, and the middle of a cell. */
const MOST_BADGES = 200;
const MIDDLE = [0.5, 0.5, 0.5];

/** Groups that are open, and the one on a phone, for as long as the page is open. */
let memory = { open: ["cells", "section", "materials", "show"], tab: "cells" };

/** @param {App} app */
export const createHyperpatch = (app) => createWorkbench(app, KIND, "body", openWorkbench);

/** @param {App} app @param {import("../kinds/workbench.js").Place} place */
function openWorkbench(app, { stage, aside }) {
  const { store, ui } = app;
  /** @type {Shown} */
  let shown = FIRST_SHOWN;
  /** @type {Known | null} */
  let known = null;
  /** @type {BodyDocument | null} */
  let asked = null;
  /** @type {string | null} */
  let reason = null;
  let isLost = false;
  let isDirty = true;
  /** The opening of a document that the camera was fitted to. */
  let framed = "";
  let spoken = "";
  let area = /** @type {number | null} */ (null);
  let painted = "";
  /** @type {import("./apart.js").Shifts} */
  let shifts = new Map();
  const status = find("#status");

  const keeping = createKeeping(() => {
    if (framed && framed === store.origin.name) leave(app, framed, view?.camera ?? null, shown);
  });

  status.replaceChildren();

  const nowShown = () => ({ known, shown });
  const coloring = () => coloringOf(shown, known, bodyOf(app).materials.length);
  const cut = createCut(app, {
    now: nowShown,
    view: () => view,
    coloring,
    found(next) {
      area = next;
      groups.render();
      stage.dataset.cut = next === null ? "" : "shown";
    },
  });
  const corner = createCorner(app, {
    now: () => ({ known: framed === store.origin.name ? known : null, shown }),
    chosen(side) {
      if (!memory.open.includes("corner")) memory = { ...memory, open: [...memory.open, "corner"] };
      memory = { ...memory, tab: "corner" };
      change({ corner: side, others: [], at: null });
    },
  });
  const plane = planeMoves({
    read: () => shown.section,
    extent: () => cut.plane()?.extent ?? null,
    write: (section) => change({ section }),
    told: (axis, place) => app.say(sectionText(words.section, axis, place, bodyOf(app).unit)),
  });
  const view = whereDrawn(() =>
    createBodyView(app, {
      plane,
      chooseCorner: (side, isMore) => editing.tapCorner(side, isMore),
      chooseCell: (place, isMore) => editing.tap(place, isMore),
      gizmo: {
        move: corner.dragTo,
        end() {
          moved();
          // Keys go on with what was dragged.
          keyboard.focus({ preventScroll: true });
        },
        undo: (run) => void store.cancel(run),
      },
      step: () => (ui.value.snap ? nudgeOf(known) : null),
      rested: () => keeping.later(),
      turned() {
        if (shown.section.axis === "view") cut.request();
      },
      oncontext(lost) {
        isLost = lost;
        render();
      },
    }),
  );
  offer(view);
  const legend = createBodyLegend(app);
  const message = h("div", { class: "space-message", hidden: true, "data-body-message": "" }, h("p", {}));
  const { picture, keyboard, help, zoom } = createStand({ name: "body", words, view });
  const foot = h("div", { class: "morph body-foot" }, /** @type {any} */ (view?.triad) ?? h("span", {}), h("span", {}), zoom);
  const { resize, close: stopFollowing } = followSize(picture, view, () => ({ top: TOP, bottom: foot.offsetHeight }));
  const editing = createEditing(app, { now: () => ({ known, isCurrent: known?.document === bodyOf(app), shown }), change, corner, step: () => nudgeOf(known), render });
  stage.append(picture, legend.element, help, message, editing.refusal, foot);
  const groupsAt = h("div", { class: "bench-groups body-groups" });
  aside.append(groupsAt);
  const now = () => ({ known, isCurrent: known?.document === bodyOf(app), shown, corner: corner.current(), extent: cut.plane()?.extent ?? null, joints: known && jointsNow(known), area });
  const groups = createGroups(
    groupsAt,
    words.region,
    createBodyGroups(app, now, {
      change,
      chooseCell: editing.chooseCell,
      look: (direction) => view?.look(direction),
      moveTo: corner.moveTo,
      moved,
      takeBack: (run) => void store.cancel(run),
      nextCorner: () => corner.chooseNext(1),
    }, editing.parts, editing.groups),
    {
      read: () => memory,
      write: (patch) => {
        memory = { ...memory, ...patch };
        render();
      },
    },
  );

  const runner = createRunner(app, () => ({ inner: hasInner(shown), continuity: shown.continuity !== "off" }), {
    changed(next) {
      const isNew = next.surface !== known?.surface;
      known = next;
      reason = null;
      shown = withoutGone(shown, next);
      editing.know(next);
      if (isNew) show(true);
      isDirty = true;
      if (next.summary) tell();
      document.documentElement.dataset.ready = "true";
      render();
    },
    refused(error) {
      reason = error.message;
      document.documentElement.dataset.ready = "true";
      render();
    },
    interrupted({ name, code, message: text }) {
      const told = name === "AbortError" ? words.cancelled : code === "trap" ? strings.errors.trap : text;
      ui.set({ note: { tone: name === "AbortError" ? "plain" : "error", text: told } });
    },
  });

  /** A run of moves is over. */
  function moved() {
    store.endRun();
    render();
  }

  /** @param {Partial<Shown>} patch */
  function change(patch) {
    const cells = patch.cell !== undefined && !patch.cells ? { cells: patch.cell === null ? [] : [patch.cell] } : {};
    shown = { ...shown, ...(patch.corner === null ? { others: [], at: null } : {}), ...cells, ...patch };
    isDirty = true;
    keeping.later();
    render();
  }

  /** @type {{of: unknown[], joints: import("./joints.js").Joints | null}} */
  let joined = { of: [], joints: null };

  /** How the cells of the body that is known continue each other. @param {Known} body */
  function jointsNow(body) {
    const { continuity } = shown;
    const of = [body.continuity, body.surface, continuity];
    if (of.some((each, n) => each !== joined.of[n])) {
      joined = { of, joints: continuity === "off" || !body.continuity ? null : jointsOf(body.continuity, body.sharing, body.cellOf, continuity) };
    }
    return joined.joints;
  }

  /** What stands in the picture besides the body. The picture shows the body that is known, and the marks stand on it. @param {Known} body */
  function pictureOf(body) {
    const { document, sharing, verdicts, summary, cellOf } = body;
    const chosen = sharedCorner(sharing, shown.corner);
    const place = chosen && shown.corner && (shown.at ?? placeOfCorner(shown.corner));
    const coefficient = place && cellOf(place.cell)?.coefficients[coefficientAt(place.at[0], place.at[1], place.at[2])];
    // A witness says it at its own place.
    const irregular = verdicts.filter(({ verdict, witness }) => verdict !== "regular" && !witness).slice(0, MOST_BADGES);
    return {
      ...editing.picture(body),
      cellOf,
      joints: jointsNow(body),
      empty: document.materials.flatMap((material, i) => (material.void ? [i] : [])),
      corner: place && coefficient ? { cell: place.cell, position: coefficient.position } : null,
      neighbours: chosen && neighboursOf(chosen.sides, cellOf, shown.apart > 0),
      witnesses: [
        ...verdicts.flatMap(({ cell, witness }) => (witness ? [{ cell, point: witness.point }] : [])),
        ...(summary?.pairs.flatMap(({ cells: [cell], point }) => (point ? [{ cell, point }] : [])) ?? []),
      ],
      badges: irregular.flatMap(({ cell, verdict }) => {
        const shape = cellOf(cell);
        return shape ? [{ cell, verdict, point: sampleAt(shape, MIDDLE, 0).position }] : [];
      }),
    };
  }

  /** Brings the picture up with what is known and shown. @param {boolean} isNew whether the surface is another one */
  function show(isNew) {
    if (!known) return;
    const { name } = store.origin;
    const isOther = isNew && framed !== name;
    const seen = isOther ? leftOf(app, name) : null;
    if (isOther) shown = { ...FIRST_SHOWN, color: shown.color, invalid: shown.invalid, ...seen?.display };
    framed = isNew ? name : framed;
    const bounds = boundsOf(known.surface.positions);
    const { theme } = ui.value;
    if (view) {
      if (isNew) shifts = shiftsOf(known.cells, bounds);
      view.set({ ...pictureOf(known), surface: known.surface, sharing: known.sharing, shifts, shown, theme }, isNew, bounds);
      const coloured = coloring();
      const key = JSON.stringify(coloured.color === "jacobian" ? [...coloured.values] : coloured);
      if (isNew || key !== painted) {
        painted = key;
        view.paint(labsFor(known.surface, coloured));
        if (!isNew) cut.paint();
      }
      if (isOther && seen?.camera) view.restore(seen.camera);
      else if (isOther) view.fit(STANDARD.iso);
    }
    cut.request(isNew);
    runner.look(known);
  }

  const over = new AbortController();
  const stopKeys = listenToKeys({ keyboard, view, corner, change, now: nowShown });

  /** The body in words. */
  const summary = () => (known ? summaryOf(app, known) : (reason ?? words.loading));

  /** Speaks of a body once an edit is over and every check has run. */
  function tell() {
    const text = summary();
    if (store.running || text === spoken) return;
    spoken = text;
    app.say(text);
  }

  function retry() {
    ui.set({ note: null });
    if (known && known.document === bodyOf(app)) runner.check(known);
    else asked = null;
    render();
  }

  let theme = ui.value.theme;
  /** @type {readonly number[] | null} */
  let held = null;

  /** The gizmo stands on the corner where the document has it, which may be ahead of the picture. */
  function hold() {
    const now = corner.current();
    if (held === (now?.position ?? null)) return;
    held = now?.position ?? null;
    view?.hold(now && { cell: now.place.cell, position: now.position });
  }

  function render() {
    const document = bodyOf(app);
    if (!isOf(document, KIND)) return;
    if (document !== asked) {
      const isSame = asked !== null && asked.operations === document.operations && asked.materials.length === document.materials.length && known?.document === asked;
      asked = document;
      // A title changes nothing that was judged.
      if (isSame && known && known.summary && JSON.stringify(known.document.materials) === JSON.stringify(document.materials)) known = { ...known, document };
      else {
        reason = null;
        runner.push(document);
      }
    }
    editing.render();
    if (isDirty || theme !== ui.value.theme) {
      isDirty = false;
      theme = ui.value.theme;
      show(false);
    }
    const text = reason !== null ? "" : view === null ? words.noWebGl : isLost ? words.lost : known?.cells.length === 0 ? words.empty : "";
    picture.hidden = text !== "";
    foot.hidden = view === null;
    legend.element.hidden = !known;
    message.hidden = text === "";
    write(/** @type {Node} */ (message.firstChild), text);
    hold();
    resize();
    legend.render(shown, rangeOf(known), known && jointsNow(known), known?.amounts ?? []);
    if (view) {
      attribute(view.canvas, "aria-label", words.picture(document.title, summary()));
      const found = cut.plane();
      if (found && shown.section.axis !== "off") {
        const place = placeOf(shown.section.at, found.extent, shown.section.axis);
        view.mark.describe(sectionText(words.section, shown.section.axis, place, document.unit), place, found.extent);
      }
    }
    const isCurrent = known?.document === document;
    stage.dataset.body = isCurrent ? (known?.summary ? "checked" : "shown") : "";
    groups.render();
    renderStatus(app, status, { known, isCurrent, reason, cancel: runner.cancel, retry, show: (cell) => change({ cell }) });
  }

  return {
    render,
    close() {
      stopFollowing();
      stopKeys();
      over.abort();
      keeping.close();
      runner.close();
      cut.close();
      editing.close();
      offer(null);
      view?.close();
      status.replaceChildren();
      delete status.dataset.verdict;
    },
  };
}
