/**
 * The mode of the solid: what the curves with their heights bound, in three dimensions, with its measures.
 *
 * @import { App } from "../state/app.js"
 * @import { Place, View as ModeView } from "../modes/modes.js"
 * @import { CurvesDocument } from "../types.js"
 * @import { Known } from "./status.js"
 * @import { Whole } from "./state.js"
 */
import "../../styles/space.css";
import "../../styles/push.css";
import "../../styles/solid.css";
import { attribute, h, write } from "../dom.js";
import { explain } from "../explain.js";
import { editable, fixed } from "../format.js";
import { createGroups } from "../inspector/inspector.js";
import { STANDARD } from "../space/camera.js";
import { moveOf } from "../space/keys.js";
import { measure } from "../space/measure.js";
import { placeOf, planeMoves } from "../space/section.js";
import { sectionText } from "../space/section-group.js";
import { createStand, followSize, isElsewhere, whereDrawn } from "../space/stand.js";
import { curveName } from "../state/app.js";
import { seenAlong } from "../state/in-space.js";
import { strings } from "../strings.js";
import { createBuildUp } from "./build-up.js";
import { createSolidGroups } from "./groups.js";
import { createSolidLegend } from "./legend.js";
import { lackOf, proposal, raised, reasonOf } from "./raise.js";
import { createRunner } from "./runner.js";
import { changeSolid, colorOf, levelsOf, solidUi } from "./state.js";
import { renderStatus, sidesOf } from "./status.js";
import { createSolidView } from "./view.js";
import { words } from "./words.js";

/** Milliseconds after the last move of the camera before it is kept. */
const REST = 250;
/** CSS pixels at the upper edge that the switch of modes takes. */
const TOP = 44;

/** Groups that are open, and the one on a phone, for as long as the page is open. */
let memory = { open: ["show", "section", "heights", "body"], tab: "show" };

/**
 * @param {App} app
 * @param {Place} place
 * @returns {ModeView}
 */
export function createSolid(app, { stage, aside, status }) {
  const { store, ui } = app;
  /** @type {Known} */
  let known = { solid: null, worst: { twist: null, flank: null }, ms: null, reason: null, lack: null };
  /** @type {CurvesDocument | null} */
  let asked = null;
  /** The document that the solid belongs to. @type {CurvesDocument | null} */
  let answered = null;
  let askedColor = "";
  let upTo = solidUi(app).upTo;
  let isLost = false;
  /** The opening of a document that the camera was fitted to. */
  let framed = "";
  let spoken = "";
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let timer;

  const plane = planeMoves({
    read: () => solidUi(app).section,
    extent: () => view?.extent ?? null,
    write: (section) => changeSolid(app, { section }),
    told: (axis, place) => app.say(sectionText(words.section, axis, place, store.document.unit)),
  });
  const view = whereDrawn(() =>
    createSolidView(app, {
      plane,
      moved: keepLater,
      oncontext(lost) {
        isLost = lost;
        render();
      },
    }),
  );
  const legend = createSolidLegend(app);
  const caption = h("p", { class: "solid-caption" });
  const message = h("div", { class: "space-message", hidden: true });
  const { picture, keyboard, help, zoom } = createStand({ name: "solid", words, view });
  const buildUp = createBuildUp(app, {
    read: () => upTo,
    set(value) {
      upTo = value;
      show();
    },
    rest: keepLater,
  });
  const foot = h("div", { class: "morph solid-foot" }, /** @type {any} */ (view?.triad) ?? h("span", {}), buildUp.element, zoom);
  const { resize, close: stopFollowing } = followSize(picture, view, () => ({ top: TOP, bottom: foot.offsetHeight }));
  stage.append(picture, caption, legend.element, help, message, foot);
  const groupsAt = h("div", { class: "steps-groups solid-groups" });
  aside.append(groupsAt);
  const groups = createGroups(
    groupsAt,
    words.groups.region,
    createSolidGroups(app, () => ({ known, extent: view?.extent ?? null, hasFace: view?.hasFace ?? false }), {
      look: (direction) => view?.look(direction),
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
    changed({ document, solid, match, problem, ms }) {
      answered = document;
      const reason = problem ? explain(document, problem) : solid?.ok ? null : reasonOf(match);
      const { bounds = null } = solid ?? {};
      seenAlong(solid?.projection);
      const whole = solid?.ok && bounds ? { ...solid, bounds } : null;
      known = { ...known, solid: whole, ms, reason, lack: null };
      if (whole) frameOf(whole);
      if (document === store.document) tell();
      globalThis.document.documentElement.dataset.ready = "true";
      render();
    },
    measured(worst) {
      known = { ...known, worst };
      groups.render();
      line();
    },
    interrupted({ name, code, message: text }) {
      const told = name === "AbortError" ? words.cancelled : code === "trap" ? strings.errors.trap : text;
      ui.set({ note: { tone: name === "AbortError" ? "plain" : "error", text: told } });
    },
  });

  /** Shows a new solid from where it was seen before, or as a whole. @param {Whole} solid */
  function frameOf(solid) {
    if (!view) return;
    view.setSolid(solid, isClosed());
    const { name } = store.origin;
    const { seen } = solidUi(app);
    if (framed === name) return;
    const isFirst = framed === "";
    framed = name;
    if (isFirst && seen?.of === name) view.restore(seen.camera);
    else view.fit(STANDARD.iso);
  }

  const isClosed = () => store.document.curves.every(({ form }) => form !== "open");

  /** Keeps what a reload and the way back bring, once it rests. */
  function keepLater() {
    clearTimeout(timer);
    timer = setTimeout(keepNow, REST);
  }

  function keepNow() {
    clearTimeout(timer);
    if (view && framed) changeSolid(app, { seen: { camera: view.camera, of: framed }, upTo });
    else changeSolid(app, { upTo });
  }

  const over = new AbortController();
  addEventListener("keydown", key, { signal: over.signal });
  // Before the page writes down what a reload brings back.
  for (const type of ["beforeunload", "pagehide"]) addEventListener(type, keepNow, { signal: over.signal, capture: true });

  /** @param {KeyboardEvent} event */
  function key(event) {
    if (isElsewhere(event) || !known.solid) return;
    const target = event.target instanceof Element ? event.target : null;
    const isOnPicture = target === keyboard;
    keyboard.classList.add("keyed");
    const move = moveOf(event, isOnPicture);
    if (move && view) view.move(move);
    else if (event.key === " " && !target?.closest("button, a, input")) buildUp.toggle();
    else if (event.key === "Enter" && isOnPicture) view?.readMiddle(true);
    else if (!(event.key === "Escape" && view?.readMiddle(false))) return;
    event.preventDefault();
  }

  /** Why there is no solid, before the kernel is asked. */
  function missing() {
    const { document } = store;
    const text = lackOf(document);
    if (text === null) return null;
    if (document.curves.length < 2) return { text, act: null };
    const raise = proposal(document);
    const name = curveName(document, raise.curve);
    const by = `${editable(raise.by, 0)}\u00a0${document.unit}`.trim();
    const act = () => {
      store.commit({ change: (now) => raised(now, raise) });
      app.say(words.raised(name, by));
      keyboard.focus({ preventScroll: true });
    };
    return { text, act: { text: words.raise(name, by), act } };
  }

  function ask() {
    const { document } = store;
    const lack = missing();
    if (lack) {
      asked = null;
      runner.close();
      known = { solid: null, worst: { twist: null, flank: null }, ms: null, reason: null, lack: lack.text };
      globalThis.document.documentElement.dataset.ready = "true";
      return;
    }
    const color = colorOf(solidUi(app), document.materials.length);
    const key = JSON.stringify(color);
    if (asked && hasSameSolid(asked, document) && key === askedColor) return;
    [asked, askedColor] = [document, key];
    if (known.solid === null) known = { ...known, reason: null, lack: null };
    runner.push({ document, color });
  }

  /** The solid in words. */
  function summary() {
    const { solid, worst, reason, lack } = known;
    const { unit } = store.document;
    if (!solid) return lack ?? reason ?? words.loading;
    return words.spoken.summary([
      solid.watertight ? words.status.watertight : isClosed() ? words.status.leaks : words.status.open,
      words.spoken.size(sidesOf(solid), unit),
      ...(solid.volume === null ? [] : [words.spoken.volume(measure(solid.volume, unit, 3))]),
      words.spoken.area(measure(solid.area, unit, 2)),
      ...(worst.twist === null ? [] : [words.spoken.twist(fixed(worst.twist, 1))]),
      ...(worst.flank === null ? [] : [words.spoken.flank(fixed(worst.flank, 1))]),
    ]);
  }

  /** Speaks of a solid once an edit is over. */
  function tell() {
    if (store.running) return;
    const text = summary();
    if (text === spoken) return;
    spoken = text;
    app.say(text);
  }

  function show() {
    const { theme } = ui.value;
    view?.show({ ui: solidUi(app), upTo, theme });
    buildUp.render(view !== null && known.solid !== null && levelsOf(known.solid) !== null);
  }

  function line() {
    const { cancel } = runner;
    const retry = () => {
      asked = null;
      ui.set({ note: null });
      render();
    };
    renderStatus(app, status, { ...known, cancel, retry, isClosed: isClosed() });
  }

  /** What stands in place of the picture. */
  function tellMissing() {
    const lack = missing();
    const text = lack?.text ?? (known.solid || !known.reason ? (view === null ? words.noWebGl : isLost ? words.lost : "") : known.reason);
    const isDrawn = text === "" && known.solid !== null;
    picture.hidden = text !== "";
    foot.hidden = lack !== null || view === null || known.solid === null;
    legend.element.hidden = !isDrawn;
    message.hidden = text === "";
    if (message.dataset.text === text + (lack?.act?.text ?? "")) return;
    message.dataset.text = text + (lack?.act?.text ?? "");
    message.replaceChildren(
      h("p", {}, text),
      ...(lack?.act ? [h("button", { type: "button", class: "push", "data-solid-raise": "", onclick: lack.act.act }, lack.act.text)] : []),
    );
    if (lack) app.say(text);
  }

  function render() {
    ask();
    const shown = solidUi(app);
    tellMissing();
    resize();
    show();
    legend.render(shown, known.solid);
    write(caption, captionOf());
    if (view) {
      attribute(view.canvas, "aria-label", words.picture(store.document.title, summary()));
      const { extent } = view;
      const { section } = shown;
      if (extent && section.axis !== "off") {
        const now = placeOf(section.at, extent, section.axis);
        view.mark.describe(sectionText(words.section, section.axis, now, store.document.unit), now, extent);
      }
    }
    stage.dataset.solid = answered === store.document && known.solid ? "shown" : "";
    groups.render();
    line();
  }

  /** What the colours mean, where it is not the material. */
  function captionOf() {
    const { color, material } = solidUi(app);
    const { materials } = store.document;
    if (color === "material" || !known.solid) return "";
    if (color === "fraction") return words.legend.fraction(materials[Math.min(material, materials.length - 1)]?.name ?? "");
    const { range } = known.solid;
    return range ? words.angles(words.legend[color], ...range.map((degrees) => fixed(degrees, 1))) : words.legend[color];
  }

  return {
    render,
    close() {
      stopFollowing();
      over.abort();
      buildUp.close();
      runner.close();
      if (timer) keepNow();
      view?.close();
      delete stage.dataset.solid;
    },
  };
}

/**
 * Whether two documents differ in nothing that a solid depends on.
 * @param {CurvesDocument} a
 * @param {CurvesDocument} b
 */
function hasSameSolid(a, b) {
  return /** @type {const} */ (["curves", "sampling", "matching", "materials", "blend"]).every((part) => a[part] === b[part]);
}
