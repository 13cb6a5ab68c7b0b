/**
 * Reading one ruling line: the card beside the pointer, the ring on the line, and the same by keyboard.
 *
 * @import { App } from "../state/app.js"
 * @import { CurvesDocument, Point, Reading } from "../types.js"
 */
import { attribute, find, h, svg } from "../dom.js";
import { fixed, length, percent, significantText } from "../format.js";
import { symbol } from "../icons.js";
import { isOpen, nearestFraction, placeOn } from "../spline.js";
import { mixAt } from "../state/composition.js";
import { numberNode } from "../number-node.js";
import { curveName, currentMatch } from "../state/app.js";
import { Lane } from "../state/lane.js";
import { shownLines } from "../state/lines.js";
import { strings } from "../strings.js";
import { toPlane, toScreen } from "../view.js";

/** Distance of the card from the pointer, and of its edge from the canvas. */
const GAP = 18;
const EDGE = 8;
/** Part of a line that one arrow key goes along it. */
const ALONG = 0.05;
/** Materials named in the card. */
const NAMED = 3;
/** Pixels from a curve at which the curve itself is read, and how far into the band its nearest line is looked for. */
const ON_CURVE = 6;
const INTO = [1, 3];
/** Milliseconds that the pointer rests before its reading is spoken. */
const REST = 600;

/** @param {App} app */
export function createProbe(app) {
  const card = find("#probe");
  const marks = svg("svg", { class: "marks", "aria-hidden": "true" });
  const ring = svg("circle", { r: 3.5, class: "probe-ring" });
  marks.append(ring);
  const keyboard = h("div", {
    id: "probe-keys",
    tabIndex: 0,
    role: "slider",
    "aria-label": strings.canvas.probe,
    "aria-valuemin": 1,
    "aria-describedby": "probe-help",
  });
  find("#overlay").before(marks);
  find("#picture").after(keyboard, h("p", { id: "probe-help", class: "spoken" }, strings.canvas.probeHelp));

  /** @type {Reading | null} */
  let shown = null;
  let wanted = 0;
  /** The line tapped last. @type {number | null} */
  let tapped = null;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let rest;

  /** @type {Lane<Point, {probe: Reading | null, turn: number}>} */
  const lane = new Lane({
    work: async (at, signal) => {
      const turn = wanted;
      const document = app.store.document;
      const probe = (await app.kernel.probe(document, at, { signal })) ?? (await readCurve(document, at, signal));
      return { probe: app.store.document === document ? probe : null, turn };
    },
    done: ({ probe, turn }) => {
      if (turn !== wanted) return;
      app.ui.set({ probe });
      if (probe) rest = setTimeout(() => app.say(spokenFractions(app, probe)), REST);
    },
    failed: () => app.ui.set({ probe: null }),
  });

  /** @param {Point | null} at CSS pixels */
  function hover(at) {
    const { view, size, probe } = app.ui.value;
    wanted += 1;
    clearTimeout(rest);
    if (at && view && shownLines(currentMatch(app)).length > 0) lane.push(toPlane(view, size, at));
    else if (probe) app.ui.set({ probe: null });
  }

  /**
   * The composition on a curve itself, which runs a hair beside the sampled band, and the ruling line nearest to it.
   * @param {CurvesDocument} document
   * @param {Point} at
   * @param {AbortSignal} signal
   * @returns {Promise<Reading | null>}
   */
  async function readCurve(document, at, signal) {
    const scale = app.ui.value.view?.scale ?? 0;
    for (const curve of /** @type {const} */ ([0, 1])) {
      const shape = document.curves[curve];
      if (!shape) continue;
      const fraction = nearestFraction(shape, at);
      const place = placeOn(shape, fraction);
      const [dx, dy] = [place.at[0] - at[0], place.at[1] - at[1]];
      if (Math.hypot(dx, dy) * scale > ON_CURVE) continue;
      for (const by of INTO.flatMap((pixels) => [pixels / scale, -pixels / scale])) {
        const inside = /** @type {Point} */ ([0, 1].map((axis) => place.at[axis] + by * place.normal[axis]));
        const found = await app.kernel.probe(document, inside, { signal });
        if (!found) continue;
        const fractions = mixAt(shape.composition, fraction, isOpen(shape));
        return { ...found, s: curve, at: place.at, fractions, boundary: { curve, at: fraction } };
      }
    }
    return null;
  }

  /**
   * Reads a line at a place along it.
   * @param {number} line
   * @param {number} s
   */
  async function read(line, s) {
    const chosen = shownLines(currentMatch(app))[line];
    if (!chosen) return;
    const { from, to } = chosen;
    wanted += 1;
    const turn = wanted;
    const at = /** @type {Point} */ ([from[0] + (to[0] - from[0]) * s, from[1] + (to[1] - from[1]) * s]);
    const found = await app.kernel.probe(app.store.document, at).catch(() => null);
    if (turn !== wanted || !found) return;
    const probe = { ...found, line, s, at, from, to };
    app.ui.set({ probe });
    app.say(spokenFractions(app, probe));
  }

  keyboard.addEventListener("keydown", (event) => {
    const lines = shownLines(currentMatch(app)).length;
    if (lines === 0 || event.ctrlKey || event.metaKey) return;
    const { probe } = app.ui.value;
    const line = probe?.line ?? 0;
    const s = probe?.s ?? 0.5;
    if (event.key === "Escape" && probe) hover(null);
    else if (event.key === "Enter" && probe) app.ui.set({ line: probe.line });
    else if (event.key === "ArrowRight") void read(probe ? (line + 1) % lines : 0, s);
    else if (event.key === "ArrowLeft") void read(probe ? (line + lines - 1) % lines : 0, s);
    else if (event.key === "ArrowUp") void read(line, Math.min(1, s + ALONG));
    else if (event.key === "ArrowDown") void read(line, Math.max(0, s - ALONG));
    else return;
    event.preventDefault();
  });
  keyboard.addEventListener("blur", () => hover(null));

  /** The ruling line at a place. @param {Point} at CSS pixels */
  const lineAt = async (at) => (await import("../lines/line-at.js")).lineAt(app, at);

  /** Explains the line at a place. @param {Point} at CSS pixels */
  async function pick(at) {
    const line = await lineAt(at);
    app.ui.set({ line, ...(line === null ? { pin: null } : {}) });
  }

  return {
    hover,
    pick,
    /** A tap reads a line, a second one explains it. @param {Point} at CSS pixels */
    async tap(at) {
      const before = tapped;
      hover(at);
      tapped = await lineAt(at);
      if (tapped !== null && tapped === before) app.ui.set({ line: tapped, probe: null });
    },

    render() {
      const { probe, view, size } = app.ui.value;
      const lines = shownLines(currentMatch(app)).length;
      attribute(keyboard, "aria-valuemax", String(Math.max(1, lines)));
      attribute(keyboard, "aria-valuenow", String((probe?.line ?? 0) + 1));
      attribute(keyboard, "aria-valuetext", probe ? spoken(app, probe) : strings.probe.line(1));
      card.hidden = !probe || !view;
      marks.style.display = card.hidden ? "none" : "";
      if (!probe || !view) return;
      const line = [toScreen(view, size, probe.from), toScreen(view, size, probe.to)];
      const at = along(line, probe.s);
      attribute(ring, "cx", at[0].toFixed(1));
      attribute(ring, "cy", at[1].toFixed(1));
      if (probe !== shown) fill(card, app, probe);
      shown = probe;
      const [x, y] = beside(at, line, { width: card.offsetWidth, height: card.offsetHeight }, size);
      card.style.transform = `translate(${Math.round(x)}px, ${Math.round(y)}px)`;
    },
  };
}

/** @param {Point[]} line @param {number} s @returns {Point} */
function along([a = [0, 0], b = a], s) {
  return [a[0] + (b[0] - a[0]) * s, a[1] + (b[1] - a[1]) * s];
}

/** The composition in words. @param {App} app @param {Reading} probe */
function spokenFractions(app, { fractions, s, boundary }) {
  const { document } = app.store;
  const place = boundary
    ? `${strings.probe.onCurve(curveName(document, boundary.curve))} ${strings.probe.at} ${fixed(boundary.at, 3)}`
    : `s ${fixed(s, 2)}`;
  const parts = fractions.map((f, i) => ({ f, name: document.materials[i]?.name ?? "" })).filter(({ f }) => f >= 5e-4);
  return strings.probe.spoken([place, ...parts.map(({ f, name }) => strings.mixing.share(name, percent(f)))]);
}

/** @param {App} app @param {Reading} probe */
function spoken(app, probe) {
  const { materials, unit } = app.store.document;
  return strings.probe.spoken([
    strings.probe.line(probe.line + 1),
    `s ${fixed(probe.s, 2)}`,
    `${strings.probe.value} ${significantText(probe.value)}`,
    `${strings.probe.length} ${length(probe.length, unit)}`,
    ...probe.fractions.flatMap((f, i) => (f > 0 ? [`${materials[i]?.name ?? ""} ${percent(f)}`] : [])),
  ]);
}

/** @param {HTMLElement} card @param {App} app @param {Reading} probe */
function fill(card, app, probe) {
  const { materials, unit } = app.store.document;
  const entry = (/** @type {(Node | string)[]} */ label, /** @type {Node | string} */ value) =>
    h("div", { class: "probe-row" }, h("span", {}, ...label), h("span", { class: "number" }, value));
  const bar = h("div", { class: "fraction-bar" });
  probe.fractions.forEach((fraction, i) => {
    if (fraction < 5e-4) return;
    const part = h("span", {});
    part.style.flexGrow = String(fraction);
    part.style.backgroundColor = materials[i]?.color ?? "";
    bar.append(part);
  });
  const largest = probe.fractions
    .map((fraction, i) => ({ fraction, name: materials[i]?.name ?? "", i }))
    .sort((a, b) => b.fraction - a.fraction)
    .slice(0, NAMED)
    .sort((a, b) => a.i - b.i);
  const short = largest.map(({ name }) => name).join("").length > 16;
  const { boundary } = probe;
  const name = boundary
    ? strings.probe.onCurve(curveName(app.store.document, boundary.curve))
    : strings.probe.line(probe.line + 1);
  const place = boundary ? [`${strings.probe.at} ${fixed(boundary.at, 3)}`] : [symbol("s"), ` ${fixed(probe.s, 2)}`];
  const head = h(
    "div",
    { class: "probe-head" },
    h("strong", {}, name),
    h("span", { class: "number" }, ...place),
  );
  card.replaceChildren(
    head,
    entry([`${strings.probe.value} `, symbol("f")], numberNode(probe.value)),
    entry([strings.probe.cosine], fixed(probe.cosine, 3)),
    entry([strings.probe.length], length(probe.length, unit)),
    bar,
    h(
      "div",
      { class: "fraction-names number" },
      ...largest.map(({ name, fraction }) => h("span", {}, `${short ? name.slice(0, 3) : name} ${percent(fraction)}`)),
    ),
  );
}

/**
 * A place for the card beside the pointer, inside the canvas, and not over the line.
 * @param {Point} at
 * @param {Point[]} line
 * @param {{width: number, height: number}} card
 * @param {{width: number, height: number}} canvas
 * @returns {Point}
 */
export function beside(at, line, card, canvas) {
  const right = at[0] + GAP;
  const left = at[0] - GAP - card.width;
  const below = at[1] + GAP;
  const above = at[1] - GAP - card.height;
  const middle = at[1] - card.height / 2;
  /** @type {Point[]} */
  const places = [
    [right, below],
    [right, above],
    [left, below],
    [left, above],
    [right, middle],
    [left, middle],
  ];
  let best = /** @type {Point} */ (places[0]);
  let least = Infinity;
  for (const [x, y] of places) {
    const inside = [
      Math.min(Math.max(x, EDGE), canvas.width - card.width - EDGE),
      Math.min(Math.max(y, EDGE), canvas.height - card.height - EDGE),
    ];
    const [px = 0, py = 0] = inside;
    const cost = covered(line, px, py, card) * 1000 + Math.hypot(px - x, py - y);
    if (cost < least) [least, best] = [cost, [px, py]];
  }
  return best;
}

/**
 * Part of the line under a box, from 0 to 1, by sampling.
 * @param {Point[]} line
 * @param {number} x
 * @param {number} y
 * @param {{width: number, height: number}} box
 */
function covered(line, x, y, box) {
  const [a, b] = line;
  if (!a || !b) return 0;
  let count = 0;
  for (let i = 0; i <= 20; i += 1) {
    const px = a[0] + ((b[0] - a[0]) * i) / 20;
    const py = a[1] + ((b[1] - a[1]) * i) / 20;
    if (px > x - EDGE && px < x + box.width + EDGE && py > y - EDGE && py < y + box.height + EDGE) count += 1;
  }
  return count / 21;
}
