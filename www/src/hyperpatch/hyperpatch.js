/**
 * The workbench Hyperpatch: a body of tricubic cells in three dimensions, with the verdict on each cell and on the whole.
 *
 * @import { App } from "../state/app.js"
 * @import { BodySection } from "../../../js/directrix.js"
 * @import { Plane } from "../space/plane.js"
 * @import { Vector } from "../space/vector.js"
 * @import { BodyDocument } from "./document.js"
 * @import { Known } from "./runner.js"
 * @import { Shown } from "./state.js"
 */
import "../../styles/space.css";
import "../../styles/push.css";
import "../../styles/hyperpatch.css";
import { shownKey } from "../commands.js";
import { newRun } from "../controls/run.js";
import { attribute, find, h, write } from "../dom.js";
import { coordinate, fixed } from "../format.js";
import { icon } from "../icons.js";
import { createGroups } from "../inspector/inspector.js";
import { problem } from "../painter.js";
import { placeOf as placeAlong, sectionText, shareOf } from "../solid/groups.js";
import { sectionPlane } from "../solid/state.js";
import { measure } from "../space/measure.js";
import { STANDARD } from "../space/camera.js";
import { moveOf } from "../space/keys.js";
import { NoWebGl } from "../space/space.js";
import { Lane } from "../state/lane.js";
import { strings } from "../strings.js";
import { edgeSegments, placeOf } from "./cell.js";
import { labsFor, relativeJacobian } from "./colors.js";
import { bodyOf, cellsOf } from "./document.js";
import { moveCorner } from "./edits.js";
import { createBodyGroups, nudgeOf } from "./groups.js";
import { isBody } from "./kind.js";
import { createBodyLegend } from "./legend.js";
import { createRunner } from "./runner.js";
import { boundsOf, FIRST_SHOWN, neighbour, sharedCorner } from "./state.js";
import { judged, leastOf, renderStatus } from "./status.js";
import { createBodyView } from "./view.js";
import { words } from "./words.js";

/** A step of the section plane by keys, as a share of its way. */
const STEP = 0.01;
/** How far inside what is kept the face of a cut is found, as a share of its way: a plane that lies in faces of cells has no face of its own. */
const INSIDE = 1e-6;
/** CSS pixels at the upper edge that stay free. */
const TOP = 16;

/** Groups that are open, and the one on a phone, for as long as the page is open. */
let memory = { open: ["cells", "section", "materials", "show"], tab: "cells" };

/** @param {App} app */
export function createHyperpatch(app) {
  /** @type {ReturnType<typeof openWorkbench> | null} */
  let open = null;
  const root = document.documentElement;
  return {
    render() {
      const isOn = isBody(app.store.document) && app.ui.value.workbench !== "lessons";
      if (isOn && !open) {
        root.dataset.workbench = "hyperpatch";
        open = openWorkbench(app);
      }
      if (isOn) open?.render();
      else if (open) {
        open.close();
        open = null;
        if (root.dataset.workbench === "hyperpatch") delete root.dataset.workbench;
      }
    },
  };
}

/** @param {App} app */
function openWorkbench(app) {
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
  let cutKey = "";
  /** @type {{of: string, at: number} | null} */
  let drag = null;
  let pressed = newRun("corner");
  const status = find("#status");

  const stage = h("div", { class: "body-stage", "data-furniture": "" });
  const aside = h("div", { class: "body-aside" });
  find("#stage").prepend(stage);
  find("#inspector").append(aside);
  status.replaceChildren();

  const view = tryView();
  const legend = createBodyLegend(app);
  const message = h("div", { class: "space-message", hidden: true, "data-body-message": "" }, h("p", {}));
  const help = h("p", { id: "body-help", class: "spoken" }, words.keyboardHelp);
  const keyboard = h("div", {
    class: "space-keys",
    tabIndex: 0,
    role: "application",
    "aria-label": words.keyboard,
    "aria-describedby": "body-help",
    "data-body-keys": "",
  });
  const zoom = h(
    "div",
    { class: "zoom", role: "group", "aria-label": words.zoom.region },
    zoomButton("minus", words.zoom.out, "-", () => view?.move({ zoom: 1 / 1.25 })),
    zoomButton("plus", words.zoom.in, "+", () => view?.move({ zoom: 1.25 })),
    zoomButton("fit", words.zoom.fit, "F", () => view?.move({ fit: true })),
  );
  const foot = h("div", { class: "morph body-foot" }, /** @type {any} */ (view?.triad) ?? h("span", {}), h("span", {}), zoom);
  const picture = h("div", { class: "space-picture" }, ...(view ? [view.canvas] : []), keyboard, .../** @type {any[]} */ (view?.overlays ?? []));
  stage.append(picture, legend.element, help, message, foot);
  const groupsAt = h("div", { class: "body-groups" });
  aside.append(groupsAt);
  const now = () => ({ known, isCurrent: known?.document === bodyOf(app), shown, corner: chosenCorner(), extent: planeNow()?.extent ?? null, area });
  const groups = createGroups(
    groupsAt,
    words.region,
    createBodyGroups(app, now, {
      change,
      look: (direction) => view?.look(direction),
      moveTo(axis, value, run) {
        const corner = chosenCorner();
        if (!corner) return;
        /** @type {Vector} */
        const by = [0, 0, 0];
        by[axis] = value - corner.position[axis];
        moveBy(by, run);
      },
      moved: () => store.endRun(),
      takeBack: (run) => void store.cancel(run),
      nextCorner: () => chooseNext(1),
    }),
    {
      read: () => memory,
      write: (patch) => {
        memory = { ...memory, ...patch };
        render();
      },
    },
  );

  const runner = createRunner(app, {
    changed(next) {
      const isNew = next.surface !== known?.surface;
      known = next;
      reason = null;
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

  /** One section at a time, the newest wanted next. @type {Lane<{plane: Plane, of: Known, by: number}, BodySection>} */
  const sections = new Lane({
    work: ({ plane, of, by }, signal) => of.body.section({ normal: plane.normal, offset: plane.offset + by }, {}, { signal }),
    done(section, { plane, of }) {
      if (of.surface !== known?.surface || shown.section.axis === "off") return;
      area = section.area;
      view?.cut({ plane, section, labs: labsFor(section, how()) });
      faceOf = { plane, section };
      groups.render();
      stage.dataset.cut = "shown";
    },
    failed(error) {
      const { name, message: text } = problem(error);
      if (name !== "AbortError") ui.set({ note: { tone: "error", text } });
    },
  });
  /** @type {{plane: Plane, section: BodySection} | null} */
  let faceOf = null;

  function tryView() {
    try {
      return createBodyView(app, {
        plane: { move: movePlane, end: () => (drag = null), undo: undoPlane, step: stepPlane },
        chooseCorner(index) {
          const found = known?.surface.corners[index];
          if (found) choose({ cell: found.cell, corner: found.corner });
        },
        chooseCell: (cell) => change({ cell: cell === shown.cell ? null : cell, corner: null }),
        turned() {
          if (shown.section.axis === "view") requestCut();
        },
        oncontext(lost) {
          isLost = lost;
          render();
        },
      });
    } catch (error) {
      if (error instanceof NoWebGl) return null;
      throw error;
    }
  }

  /** @param {string} face @param {string} label @param {string} key @param {() => void} act */
  function zoomButton(face, label, key, act) {
    return h(
      "button",
      { type: "button", class: "bare icon-only", "data-body-zoom": face, "aria-label": label, title: `${label} (${shownKey(key)})`, onclick: act },
      icon(face),
    );
  }

  /** @param {Partial<Shown>} patch */
  function change(patch) {
    shown = { ...shown, ...patch };
    isDirty = true;
    render();
  }

  /** What the colours are, for surfaces and faces alike. @returns {Parameters<typeof labsFor>[1]} */
  function how() {
    const { color, material } = shown;
    if (color === "fraction") return { color, material: Math.min(material, bodyOf(app).materials.length - 1) };
    if (color === "material" || !known) return { color: "material" };
    const [low, high] = range() ?? [0, 1];
    const volumes = new Map(known.cells.map(({ id, volume }) => [id, volume]));
    const values = new Map(known.verdicts.map((verdict) => [verdict.cell, (relativeJacobian(verdict, volumes.get(verdict.cell) ?? 0) - low) / (high - low)]));
    return { color, values };
  }

  /** The ends of the scale of Jacobians: from the least of all cells, but 0 at most, to 1. @returns {[number, number] | null} */
  function range() {
    const least = known && leastOf(known);
    return least === null ? null : [Math.min(0, least), 1];
  }

  /** The chosen corner where the document has it now, with all its cells. */
  function chosenCorner() {
    const found = known && framed === store.origin.name ? sharedCorner(known.sharing, shown.corner) : null;
    if (!found) return null;
    const [{ cell, corner }] = found.sides;
    const [i, j, k] = corner.map((end) => 3 * end);
    const position = cellsOf(bodyOf(app))[cell]?.coefficients[placeOf(i, j, k)].position;
    return position ? { position, sides: found.sides } : null;
  }

  /** The plane of the section with its way, as the camera stands. */
  function planeNow() {
    return known ? sectionPlane(shown.section, known.surface.positions, view?.back ?? [0, -1, 0]) : null;
  }

  function requestCut() {
    const found = planeNow();
    const key = found && known ? JSON.stringify(found.plane) : "";
    if (key === cutKey) return;
    cutKey = key;
    if (found && known) {
      view?.frame(shown.section.axis === "view" ? null : found.plane);
      sections.push({ plane: found.plane, of: known, by: INSIDE * (found.extent[1] - found.extent[0]) });
      return;
    }
    faceOf = null;
    area = null;
    view?.frame(null);
    view?.cut(null);
    delete stage.dataset.cut;
  }

  /** Brings the picture up with what is known and shown. @param {boolean} isNew whether the surface is another one */
  function show(isNew) {
    if (!known) return;
    const bounds = boundsOf(known.surface.positions);
    const cell = cellsOf(known.document)[shown.cell ?? -1];
    const witnesses = known.verdicts.flatMap(({ witness }) => (witness ? [witness.point] : []));
    const overlaps = known.summary?.pairs.flatMap(({ point }) => (point ? [point] : [])) ?? [];
    const { theme } = ui.value;
    // The picture shows the body that is known, and the mark stands on it.
    const corner = sharedCorner(known.sharing, shown.corner)?.position ?? null;
    if (view) {
      view.set({ surface: known.surface, shown, theme, chosenCell: cell ? edgeSegments(cell) : [], corner, witnesses: [...witnesses, ...overlaps] }, isNew, bounds);
      const coloured = how();
      const key = JSON.stringify(coloured.color === "jacobian" ? [...coloured.values] : coloured);
      if (isNew || key !== painted) {
        painted = key;
        view.paint(labsFor(known.surface, coloured));
        if (faceOf && !isNew) view.cut({ ...faceOf, labs: labsFor(faceOf.section, coloured) });
      }
      if (isNew && framed !== store.origin.name) view.fit(STANDARD.iso);
    }
    if (isNew) {
      if (framed !== store.origin.name) shown = { ...FIRST_SHOWN, color: shown.color };
      framed = store.origin.name;
      cutKey = " ";
    }
    requestCut();
  }

  /** @param {import("./edits.js").Side} side */
  function choose(side) {
    // What moves another corner is another entry of the log.
    pressed = newRun("corner");
    if (!memory.open.includes("corner")) memory = { ...memory, open: [...memory.open, "corner"] };
    memory = { ...memory, tab: "corner" };
    change({ corner: side, cell: null });
    const corner = chosenCorner();
    if (!corner || !known) return;
    const { sharing, surface } = known;
    const shared = sharedCorner(sharing, side);
    const index = surface.corners.findIndex((each) => sharedCorner(sharing, each) === shared);
    const cells = new Set(corner.sides.map(({ cell }) => cell)).size;
    app.say(words.corner.chosen(index + 1, surface.corners.length, placeText(corner.position), words.corner.shared(cells)));
  }

  /** @param {1 | -1} by */
  function chooseNext(by) {
    const next = known && neighbour(known.surface, known.sharing, shown.corner, by);
    if (next) choose(next);
  }

  /** @param {readonly number[]} place */
  const placeText = (place) => `x ${coordinate(place[0])}, y ${coordinate(place[1])}, z ${coordinate(place[2])}`;

  /** @param {Vector} by @param {string} [run] */
  function moveBy(by, run) {
    const corner = chosenCorner();
    if (!corner) return;
    const move = (/** @type {unknown} */ document) => /** @type {any} */ (moveCorner(/** @type {BodyDocument} */ (document), corner.sides, by, shown.reach));
    store.commit({ change: move, ...(run === undefined ? {} : { run }) });
  }

  /** @param {number} offset along the normal @param {string} run */
  function movePlane(offset, run) {
    const found = planeNow();
    const { section } = shown;
    if (!found) return;
    if (drag?.of !== run) drag = { of: run, at: section.at };
    const isReversed = (section.axis !== "y") !== section.flipped;
    change({ section: { ...section, at: shareOf(isReversed ? -offset : offset, found.extent, section.axis) } });
  }

  /** @param {string} run */
  function undoPlane(run) {
    if (drag?.of === run) change({ section: { ...shown.section, at: drag.at } });
    drag = null;
  }

  /** @param {number} steps */
  function stepPlane(steps) {
    const { section } = shown;
    const at = Math.min(1, Math.max(0, section.at + steps * STEP));
    change({ section: { ...section, at } });
    const extent = planeNow()?.extent;
    if (extent) app.say(sectionText(section.axis, placeAlong(at, extent, section.axis), bodyOf(app).unit));
  }

  const over = new AbortController();
  addEventListener("keydown", key, { signal: over.signal });

  /** @param {KeyboardEvent} event */
  function key(event) {
    if (event.defaultPrevented || event.ctrlKey || event.metaKey || !known) return;
    const target = event.target instanceof Element ? event.target : null;
    if (target?.closest("input[type=text], select, textarea, [data-panel], [role=menu], [role=tab]")) return;
    const isOnPicture = target === keyboard;
    if (isOnPicture) keyboard.classList.add("keyed");
    const arrow = isOnPicture && shown.corner ? cornerStep(event) : null;
    const move = arrow ? null : moveOf(event, isOnPicture);
    if (arrow) {
      moveBy(arrow, pressed);
      const corner = chosenCorner();
      if (corner) app.say(words.corner.moved(placeText(corner.position)));
    } else if (move && view) view.move(move);
    else if (isOnPicture && (event.key === "PageDown" || event.key === "PageUp")) chooseNext(event.key === "PageDown" ? 1 : -1);
    else if (event.key === "Enter" && isOnPicture) view?.readMiddle(true);
    else if (event.key === "Escape" && (view?.readMiddle(false) || shown.corner || shown.cell !== null)) change({ corner: null, cell: null });
    else return;
    event.preventDefault();
  }

  /** What an arrow moves the chosen corner by, along x and z. @param {KeyboardEvent} event @returns {Vector | null} */
  function cornerStep({ key, shiftKey, altKey }) {
    const step = nudgeOf(known) * (shiftKey ? 10 : altKey ? 0.1 : 1);
    const along = { ArrowRight: [1, 0, 0], ArrowLeft: [-1, 0, 0], ArrowUp: [0, 0, 1], ArrowDown: [0, 0, -1] }[key];
    return along ? /** @type {Vector} */ (along.map((one) => one * step)) : null;
  }

  keyboard.addEventListener("blur", () => {
    pressed = newRun("corner");
    store.endRun();
  });
  view?.canvas.addEventListener("click", () => {
    keyboard.focus({ preventScroll: true });
    keyboard.classList.remove("keyed");
  });

  const observer = new ResizeObserver(() => {
    resize();
    view?.request();
  });
  observer.observe(picture);

  function resize() {
    const { clientWidth: width, clientHeight: height } = picture;
    if (width < 1 || height < 1) return;
    view?.resize({ size: { width, height }, top: TOP, bottom: foot.offsetHeight });
  }

  /** The body in words. */
  function summary() {
    if (!known) return reason ?? words.loading;
    const { outcome, problems, remarks } = judged(known);
    const verdict = { checking: words.status.checking, verified: words.status.verified, certified: words.status.valid, problems: problems.map(({ text }) => text).join(", ") }[outcome];
    const least = leastOf(known);
    return words.spoken.summary([
      verdict,
      words.cells.phrase(known.cells.length),
      ...(least === null ? [] : [`${words.cells.jacobian} ${fixed(least, 2)} ${words.cells.ofMean}`]),
      `${words.status.volume} ${measure(known.volume, bodyOf(app).unit, 3)}`,
      ...remarks,
    ]);
  }

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

  function render() {
    const document = bodyOf(app);
    if (!isBody(document)) return;
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
    if (isDirty || theme !== ui.value.theme) {
      isDirty = false;
      theme = ui.value.theme;
      show(false);
    }
    const text = reason !== null ? "" : view === null ? words.noWebGl : isLost ? words.lost : "";
    picture.hidden = text !== "";
    foot.hidden = view === null;
    legend.element.hidden = !known;
    message.hidden = text === "";
    write(/** @type {Node} */ (message.firstChild), text);
    resize();
    legend.render(shown, range());
    if (view) {
      attribute(view.canvas, "aria-label", words.picture(document.title, summary()));
      const found = planeNow();
      if (found && shown.section.axis !== "off") {
        const place = placeAlong(shown.section.at, found.extent, shown.section.axis);
        view.mark.describe(sectionText(shown.section.axis, place, document.unit), place, found.extent);
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
      observer.disconnect();
      over.abort();
      runner.close();
      sections.cancel();
      view?.close();
      stage.remove();
      aside.remove();
      status.replaceChildren();
      delete status.dataset.verdict;
    },
  };
}
