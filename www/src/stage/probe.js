/**
 * Reading one ruling line under the pointer, by a tap or by keyboard. Its card is `probe-card.js`.
 *
 * @import { App } from "../state/app.js"
 * @import { CurvesDocument, Point, Reading } from "../types.js"
 */
import { attribute, find, h } from "../dom.js";
import { fixed, length, percent, significantText } from "../format.js";
import { isOpen, nearestFraction, placeOn } from "../spline.js";
import { mixAt } from "../state/composition.js";
import { curveName, currentMatch } from "../state/app.js";
import { Lane } from "../state/lane.js";
import { lookedAt } from "../state/look.js";
import { inSpan, numbered, shownLines } from "../state/lines.js";
import { strings } from "../strings.js";
import { toPlane } from "../view.js";

/** Part of a line that one arrow key goes along it. */
const ALONG = 0.05;
/** Pixels from a curve at which the curve itself is read, and how far into the band its nearest line is looked for. */
const ON_CURVE = 6;
const INTO = [1, 3];
/** Milliseconds that the pointer rests before its reading is spoken. */
const REST = 600;

/** @param {App} app */
export function createProbe(app) {
  const keyboard = h("div", {
    id: "probe-keys",
    tabIndex: 0,
    role: "slider",
    "aria-label": strings.canvas.probe,
    "aria-valuemin": 1,
    "aria-describedby": "probe-help",
  });
  find("#picture").after(keyboard, h("p", { id: "probe-help", class: "spoken" }, strings.canvas.probeHelp));

  let wanted = 0;
  /** The line tapped last. @type {number | null} */
  let tapped = null;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let rest;

  /** @type {Lane<Point, {probe: Reading | null, turn: number}>} */
  const lane = new Lane({
    work: async (at, signal) => {
      const turn = wanted;
      const document = lookedAt(app);
      const probe = (await app.kernel.probe(document, at, { signal })) ?? (await readCurve(document, at, signal));
      return { probe: probe && lookedAt(app) === document ? numbered(currentMatch(app), probe) : null, turn };
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
    if (at && view && countOf(app) > 0) lane.push(toPlane(view, size, at));
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
    const knots = currentMatch(app)?.knots;
    for (const [curve, shape] of document.curves.entries()) {
      const fraction = nearestFraction(shape, at);
      const place = placeOn(shape, fraction);
      const [dx, dy] = [place.at[0] - at[0], place.at[1] - at[1]];
      if (Math.hypot(dx, dy) * scale > ON_CURVE) continue;
      for (const by of INTO.flatMap((pixels) => [pixels / scale, -pixels / scale])) {
        const inside = /** @type {Point} */ ([0, 1].map((axis) => place.at[axis] + by * place.normal[axis]));
        const found = await app.kernel.probe(document, inside, { signal });
        if (!found) continue;
        const fractions = mixAt(shape.composition, fraction, isOpen(shape));
        return { ...found, s: found.gradient ? Math.round(found.s) : (knots?.[curve] ?? curve), at: place.at, fractions, boundary: { curve, at: fraction } };
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
    if (currentMatch(app)?.harmonic) {
      wanted += 1;
      const turn = wanted;
      const probe = await (await import("../harmonic/blend.js")).readLine(app, line, Math.min(1, Math.max(0, s))).catch(() => null);
      if (turn !== wanted || !probe) return;
      app.ui.set({ probe });
      app.say(spokenFractions(app, probe));
      return;
    }
    const chosen = shownLines(currentMatch(app))[line];
    if (!chosen) return;
    const { from, to } = chosen;
    wanted += 1;
    const turn = wanted;
    const match = currentMatch(app);
    const { span } = inSpan(match, line);
    const [low = 0, high = 1] = match?.knots?.slice(span, span + 2) ?? [];
    s = Math.min(high, Math.max(low, s));
    const share = (s - low) / (high - low);
    const at = /** @type {Point} */ ([from[0] + (to[0] - from[0]) * share, from[1] + (to[1] - from[1]) * share]);
    const found = await app.kernel.probe(app.store.document, at).catch(() => null);
    if (turn !== wanted || !found) return;
    const probe = { ...found, line, s, at, from, to };
    app.ui.set({ probe });
    app.say(spokenFractions(app, probe));
  }

  keyboard.addEventListener("keydown", (event) => {
    const lines = countOf(app);
    if (lines === 0 || event.ctrlKey || event.metaKey) return;
    const { probe } = app.ui.value;
    const line = probe?.line ?? 0;
    const s = probe?.s ?? 0.5;
    if (event.key === "Escape" && probe) hover(null);
    else if (event.key === "Enter" && probe?.gradient) void import("../harmonic/words.js").then(({ words }) => app.say(words.noWhy));
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
      const { probe } = app.ui.value;
      const lines = countOf(app);
      attribute(keyboard, "aria-valuemax", String(Math.max(1, lines)));
      attribute(keyboard, "aria-valuenow", String((probe?.line ?? 0) + 1));
      attribute(keyboard, "aria-valuetext", probe ? spoken(app, probe) : strings.probe.line(1));
    },
  };
}

/** Number of the lines that can be read. @param {App} app */
function countOf(app) {
  const match = currentMatch(app);
  return match?.harmonic?.lines ?? shownLines(match).length;
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
    `${probe.gradient ? strings.probe.gradient : strings.probe.value} ${significantText(probe.value)}`,
    `${strings.probe.length} ${length(probe.length, unit)}`,
    ...probe.fractions.flatMap((f, i) => (f > 0 ? [`${materials[i]?.name ?? ""} ${percent(f)}`] : [])),
  ]);
}
