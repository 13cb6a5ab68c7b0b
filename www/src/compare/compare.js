/**
 * Every method on the same two curves, side by side: small pictures in which one pointer lights a line each, and bars that
 * measure them on common scales. A press on a picture goes on working with its method.
 *
 * @import { App } from "../state/app.js"
 * @import { Place, View as ModeView } from "../modes/modes.js"
 * @import { CurvesDocument, PaintOptions, Point, Size, View } from "../types.js"
 * @import { Result } from "./runner.js"
 */
import "../../styles/compare.css";
import { h } from "../dom.js";
import { advice, explain } from "../explain.js";
import { fixed, significantText } from "../format.js";
import { symbol } from "../icons.js";
import { devicePixels } from "../painter.js";
import { keptGaps, shownLines } from "../state/lines.js";
import { outline } from "../spline.js";
import { strings } from "../strings.js";
import { toPlane } from "../view.js";
import { createBars } from "./bars.js";
import { bestOf, faultsOf, METHODS, methodOf, withMethod } from "./methods.js";
import { nearestLine } from "./nearest.js";
import { createPicture } from "./picture.js";
import { createRunner } from "./runner.js";
import { renderStatus } from "./status.js";
import { words } from "./words.js";

/** Free pixels round the curves of a small picture. */
const MARGIN = 14;
/** Device pixels for one of the screen at most: six pictures are painted for every edit. */
const SHARPEST = 2;
/** Of a picture that is not there yet. @type {Size} */
const NO_ROOM = { width: 0, height: 0 };
/** What the small pictures show. */
const LAYERS = /** @type {const} */ (["material", "rulingLines", "unconnected"]);

/**
 * @param {App} app
 * @param {Place} place
 * @returns {ModeView}
 */
export function createCompare(app, { stage, aside, status }) {
  const { store, ui } = app;
  const coarse = matchMedia("(pointer: coarse)").matches;
  const pictures = METHODS.map(({ name }) => createPicture(name));
  const help = h("p", { id: "compare-help", class: "spoken" }, words.help);
  const grid = h(
    "div",
    { class: "methods", role: "group", "aria-label": words.group, "aria-describedby": help.id },
    ...pictures.map(({ element }) => element),
  );
  const empty = h("p", { class: "methods-empty", hidden: true }, words.needsTwo);
  stage.append(h("p", { class: "methods-hint" }, coarse ? words.hintTouch : words.hint), help, grid, empty);
  const bars = createBars(aside);

  /** @type {(Result | null)[]} */
  let results = METHODS.map(() => null);
  /** @type {Point | null} */
  let at = null;
  /** The picture that the keyboard is on. */
  let here = Math.max(0, methodOf(store.document.matching));
  let asked = "";
  /** @type {CurvesDocument | null} */
  let askedFor = null;
  /** Whether the outcome for the newest document has been told. */
  let told = false;

  const runner = createRunner(app, {
    changed(now) {
      results = now;
      document.documentElement.dataset.ready = "true";
      draw();
      const whole = results.every((result) => result?.document === store.document);
      if (!whole || told) return;
      told = true;
      app.say(spokenOutcome());
    },
    interrupted({ name, code, message }) {
      const text =
        name === "AbortError" ? strings.status.cancelled : code === "trap" ? strings.errors.trap : message;
      ui.set({ note: { tone: name === "AbortError" ? "plain" : "error", text } });
    },
  });

  const observer = new ResizeObserver(() => ask());
  observer.observe(grid);

  /** The room that every small picture has. @returns {Size} */
  const room = () => ({
    width: Math.min(...pictures.map(({ plot }) => plot.clientWidth)),
    height: Math.min(...pictures.map(({ plot }) => plot.clientHeight)),
  });

  /** Asks for everything that has changed. @param {boolean} [force] */
  function ask(force = false) {
    const { document } = store;
    const two = document.curves.length === 2;
    empty.hidden = two;
    grid.hidden = !two;
    aside.hidden = !two;
    if (!two) {
      askedFor = null;
      runner.close();
      return;
    }
    const size = room();
    if (size.width < 1 || size.height < 1) return;
    const ratio = Math.min(SHARPEST, window.devicePixelRatio || 1);
    /** @type {PaintOptions} */
    const options = {
      ...devicePixels(size, ratio),
      view: viewOf(document, size),
      layers: [...LAYERS],
      theme: ui.value.theme,
      s: null,
      line: null,
      patterns: ui.value.patterns,
    };
    const key = JSON.stringify(options);
    if (!force && key === asked && askedFor && hasSamePicture(askedFor, document)) return;
    if (!askedFor || !hasSamePicture(askedFor, document)) {
      told = false;
      at = null;
    }
    [asked, askedFor] = [key, document];
    runner.push({ document, options, size });
  }

  function draw() {
    const { document } = store;
    const chosen = methodOf(document.matching);
    pictures.forEach((picture, i) => {
      const result = results[i];
      picture.describe(textsOf(document, METHODS[i].name, result, i === chosen), i === chosen);
      picture.paint(result?.picture ?? null, result?.size ?? NO_ROOM);
      picture.element.tabIndex = i === here ? 0 : -1;
    });
    light();
    bars.render(results, chosen, document);
    renderStatus(app, status, { results, cancel: runner.cancel, retry: () => ask(true) });
  }

  function light() {
    pictures.forEach((picture, i) => {
      const { match = null, picture: painted = null, size = NO_ROOM } = results[i] ?? {};
      const lines = shownLines(match);
      const line = at ? nearestLine(lines, at) : -1;
      if (painted) picture.light(lines[line] ?? null, painted.view, size);
    });
  }

  /** The place of the plane under the pointer, in whichever picture it is. @param {PointerEvent} event */
  function under(event) {
    const element = event.target instanceof Element ? event.target.closest("[data-method]") : null;
    const i = pictures.findIndex((picture) => picture.element === element);
    const result = results[i];
    if (!result?.picture) return null;
    const box = pictures[i].frame.getBoundingClientRect();
    return toPlane(result.picture.view, result.size, [event.clientX - box.left, event.clientY - box.top]);
  }

  grid.addEventListener("pointermove", (event) => {
    at = under(event);
    light();
  });
  grid.addEventListener("pointerleave", () => {
    at = null;
    light();
  });
  grid.addEventListener("click", (event) => {
    const element = event.target instanceof Element ? event.target.closest("[data-method]") : null;
    const i = pictures.findIndex((picture) => picture.element === element);
    if (i >= 0) choose(i);
  });
  grid.addEventListener("focusin", (event) => {
    const i = pictures.findIndex(({ element }) => element === event.target);
    if (i < 0 || i === here) return;
    here = i;
    pictures.forEach(({ element }, k) => (element.tabIndex = k === here ? 0 : -1));
  });
  grid.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const columns = getComputedStyle(grid).gridTemplateColumns.split(" ").length;
    const by = { ArrowRight: 1, ArrowLeft: -1, ArrowDown: columns, ArrowUp: -columns }[event.key];
    const to = { Home: 0, End: METHODS.length - 1 }[event.key] ?? (by === undefined ? null : here + by);
    if (to !== null) pictures[to]?.element.focus();
    else if (event.key === "PageDown" || event.key === "PageUp") step(event.key === "PageDown" ? 1 : -1);
    else if (event.key === "Escape" && at) {
      at = null;
      light();
    } else return;
    event.preventDefault();
  });

  /** Lights the next line of the picture that has the focus. @param {number} by */
  function step(by) {
    const lines = shownLines(results[here]?.match ?? null);
    if (lines.length === 0) return;
    const now = at ? nearestLine(lines, at) : by > 0 ? -1 : 0;
    const next = (now + by + lines.length) % lines.length;
    const { from, to, value } = lines[next];
    at = [(from[0] + to[0]) / 2, (from[1] + to[1]) / 2];
    light();
    const { name } = words.methods[METHODS[here].name];
    app.say(words.spokenLine(name, next + 1, lines.length, significantText(value)));
  }

  /** @param {number} i */
  function choose(i) {
    store.commit({
      change: (document) => (methodOf(document.matching) === i && isAsCompared(document, i) ? document : withMethod(document, METHODS[i])),
    });
    ui.set({ mode: "figure" });
    app.say(words.chosen(words.methods[METHODS[i].name].name));
  }

  function spokenOutcome() {
    const rated = results.map((result) =>
      result?.match ? { feasible: faultsOf(result.match).feasible, eta: result.quality.eta } : null,
    );
    const best = bestOf(rated);
    const failing = rated.filter((each) => !each?.feasible).length;
    const name = best < 0 ? null : words.methods[METHODS[best].name].name;
    return words.result(name, fixed(rated[best]?.eta ?? 0, 3), failing, METHODS.length);
  }

  return {
    render() {
      ask();
      draw();
    },
    close() {
      observer.disconnect();
      runner.close();
    },
  };
}

/** Whether a document has a method exactly as it is compared. @param {CurvesDocument} document @param {number} i */
function isAsCompared({ matching }, i) {
  return METHODS[i].settings.oneToOne === matching.oneToOne;
}

/**
 * Whether two documents differ in nothing that the pictures show.
 * @param {CurvesDocument} a
 * @param {CurvesDocument} b
 */
function hasSamePicture(a, b) {
  return /** @type {const} */ (["curves", "sampling", "matching", "materials", "blend"]).every((part) => a[part] === b[part]);
}

/**
 * The view that shows both curves as large as there is room.
 * @param {CurvesDocument} document
 * @param {Size} size
 * @returns {View}
 */
function viewOf(document, { width, height }) {
  const points = document.curves.flatMap((curve) => outline(curve).map((each) => each.at));
  const [x, y] = [0, 1].map((axis) => {
    let [low, high] = [Infinity, -Infinity];
    for (const point of points) {
      low = Math.min(low, point[axis]);
      high = Math.max(high, point[axis]);
    }
    return { middle: (low + high) / 2, span: Math.max(high - low, 1e-9 * Math.abs(high), Number.MIN_VALUE) };
  });
  const free = (/** @type {number} */ side) => Math.max(1, side - 2 * MARGIN);
  return { center: [x.middle, y.middle], scale: Math.min(free(width) / x.span, free(height) / y.span) };
}

/**
 * What stands above a picture.
 * @param {CurvesDocument} document
 * @param {string} method
 * @param {Result | null} result
 * @param {boolean} chosen
 * @returns {import("./picture.js").Texts}
 */
function textsOf(document, method, result, chosen) {
  const { name, line } = words.methods[method];
  const mark = chosen ? words.current : "";
  if (!result) return { name, line: [line], failed: false, eta: [], spoken: mark };
  const { match, problem, quality } = result;
  if (!match) {
    const text = problem ? explain(document, problem) : words.none;
    return { name, line: [text], failed: true, eta: [], spoken: mark };
  }
  const { feasible, crossings, blocked, uncovered, occluded } = faultsOf(match);
  const eta = quality.eta === null ? [] : [symbol("η"), ` ${fixed(quality.eta, 3)}`];
  const faults = [
    crossings > 0 ? words.crossings(crossings) : "",
    blocked > 0 ? words.blocked(blocked) : "",
    uncovered[0] + uncovered[1] > 0 ? words.uncovered(...uncovered) : "",
    occluded > 0 ? words.occluded(occluded) : "",
  ].filter(Boolean);
  const wrong = feasible
    ? null
    : faults.length === 0
      ? (advice(match) ?? words.noBlend([words.none]))
      : words.noBlend(faults);
  const nodes = wrong === null ? lineOf(document, method, result) : [wrong];
  const count = words.spokenCount(shownLines(match).length);
  const spoken = words.spokenPicture([feasible ? "" : words.infeasible, count, feasible ? words.sound : "", mark]);
  return { name, line: nodes, failed: !feasible, eta, spoken };
}

/**
 * What a method does, with what it found.
 * @param {CurvesDocument} document
 * @param {string} method
 * @param {Result} result
 * @returns {(Node | string)[]}
 */
function lineOf({ matching }, method, { match }) {
  const { line } = words.methods[method];
  const pins = matching.pins?.length ?? 0;
  const gaps = match ? keptGaps(match).length : 0;
  const isExact = method === "exact" || method === "sum";
  const after =
    (pins === 0 ? "" : `, ${isExact ? words.pinned(pins) : words.pinless}`) + (gaps === 0 ? "" : `, ${words.gaps(gaps)}`);
  const [first] = match?.lines ?? [];
  if (method === "shift" && match && first) {
    const count = match.samples[1].points.length;
    return [words.shifted((first.to - first.from + count) % count) + after];
  }
  return method === "exact" ? [`${line} `, symbol("J"), after] : [line + after];
}
