/**
 * The plot of v over u: which place of the second curve each place of the first is joined to, as fractions of their domains.
 *
 * @import { App } from "../state/app.js"
 * @import { Curve, Match, Point, Probe } from "../types.js"
 */
import { attribute, h, svg, write } from "../dom.js";
import { fixed } from "../format.js";
import { isOpen, unrolled } from "../spline.js";
import { currentMatch } from "../state/app.js";
import { keptGaps, shownLines } from "../state/lines.js";
import { Lane } from "../state/lane.js";
import { lookedAt } from "../state/look.js";
import { words as matching } from "./matching-words.js";

const words = matching.correspondence;

/** Side of the plot in its own units. */
const SIDE = 100;

/**
 * @param {App} app
 * @returns {{element: HTMLElement, render: () => void}}
 */
export function createCorrespondence(app) {
  const identity = svg("path", { class: "identity" });
  const path = svg("path", { class: "pairs" });
  const kept = svg("path", { class: "kept" });
  const dot = svg("circle", { r: 3, class: "here" });
  const plot = svg(
    "svg",
    { class: "correspondence", viewBox: `0 0 ${SIDE} ${SIDE}`, role: "img", preserveAspectRatio: "none" },
    svg("path", { class: "quarters", d: [25, 50, 75].map((at) => `M${at} 0V${SIDE}M0 ${at}H${SIDE}`).join("") }),
    identity,
    path,
    kept,
  );
  const marks = svg("svg", { class: "correspondence-marks", "aria-hidden": "true" }, dot);
  const note = h("div", { class: "correspondence-note number" });
  const frame = h("div", { class: "correspondence-frame" }, /** @type {any} */ (plot), /** @type {any} */ (marks));
  const element = h("div", {}, frame, note);
  /** @type {Point[]} */
  let places = [];
  /** @type {Match | null} */
  let drawn = null;
  let wanted = -1;

  /** @type {Lane<number, {line: number, found: Probe | null}>} */
  const lane = new Lane({
    work: async (line, signal) => {
      const { from, to } = shownLines(currentMatch(app))[line];
      const middle = /** @type {Point} */ ([(from[0] + to[0]) / 2, (from[1] + to[1]) / 2]);
      return { line, found: await app.kernel.probe(lookedAt(app), middle, { signal }) };
    },
    done: ({ line, found }) => {
      const ends = shownLines(currentMatch(app))[line];
      if (line === wanted && found && ends) app.ui.set({ probe: { ...found, line, s: 0.5, from: ends.from, to: ends.to } });
    },
    failed: () => app.ui.set({ probe: null }),
  });

  frame.addEventListener("pointermove", (event) => {
    const box = frame.getBoundingClientRect();
    const u = (event.clientX - box.x) / box.width;
    const line = nearest(places, u);
    if (line === wanted || line < 0) return;
    wanted = line;
    lane.push(line);
  });
  frame.addEventListener("pointerleave", () => {
    if (wanted < 0) return;
    wanted = -1;
    app.ui.set({ probe: null });
  });

  return {
    element,
    render() {
      const match = currentMatch(app);
      if (match && match !== drawn) {
        drawn = match;
        draw(match);
      }
      const place = places[app.ui.value.probe?.line ?? -1];
      dot.style.display = place ? "" : "none";
      if (!place) return;
      attribute(dot, "cx", `${(100 * place[0]).toFixed(2)}%`);
      attribute(dot, "cy", `${(100 * (1 - wrapped(place[1]))).toFixed(2)}%`);
    },
  };

  /** @param {Match} match */
  function draw(match) {
    const { curves } = app.store.document;
    places = fractions(match, curves);
    if (places.length === 0) return;
    const open = isOpen(curves[0]);
    const ring = open ? places : [...places, /** @type {Point} */ ([places[0][0] + 1, places[0][1] + 1])];
    attribute(path, "d", stepped(ring));
    const gaps = keptGaps(match).map(({ lines = [] }) => lines.map((line, i) => lapped(places, line, lines[0], i)));
    attribute(kept, "d", gaps.map(stepped).join(""));
    attribute(identity, "d", stepped([[-0.5, -0.5], [1.5, 1.5]]));
    const off = Math.max(...places.map(([u, v]) => Math.abs(v - u - Math.round(v - u))));
    write(note, words.off(fixed(100 * off, 0)));
    const kind = match.pairs.length > 0 ? words.pairs(match.pairs.length) : words.lines(match.lines.length);
    const name = words.name(kind, fixed(100 * off, 0), gaps.length);
    attribute(plot, "aria-label", name);
  }
}

/**
 * The ends of every line as fractions of the two domains, ascending, the second within half a lap of the first on average.
 * @param {Match} match
 * @param {Curve[]} curves
 * @returns {Point[]}
 */
function fractions({ reparameterisation }, curves) {
  const domains = curves.map((curve) => {
    const { knots, points } = unrolled(curve);
    return [knots[curve.degree], knots[points.length]];
  });
  if (domains.length < 2) return [];
  const share = (/** @type {number} */ u, /** @type {number} */ axis) =>
    (u - domains[axis][0]) / (domains[axis][1] - domains[axis][0]);
  return reparameterisation.map(([u, v]) => [share(u, 0), share(v, 1)]);
}

/**
 * A place of a list that goes round, counted on from another one.
 * @param {Point[]} places
 * @param {number} index
 * @param {number} first
 * @param {number} step
 * @returns {Point}
 */
function lapped(places, index, first, step) {
  const lap = step > 0 && index < first ? 1 : 0;
  return [places[index][0] + lap, places[index][1] + lap];
}

/**
 * The outline of a rising chain, once for every lap in which a part of it lies in the plot.
 * @param {Point[]} chain
 */
function stepped(chain) {
  const [low, high] = [Math.floor(chain[0][1]), Math.ceil(chain[chain.length - 1][1])];
  let d = "";
  for (const right of [-1, 0]) {
    for (let up = low; up <= high; up += 1) {
      const point = (/** @type {Point} */ [u, v]) =>
        `${((u + right) * SIDE).toFixed(2)} ${((1 - (v - up)) * SIDE).toFixed(2)}`;
      d += `M${chain.map(point).join("L")}`;
    }
  }
  return d;
}

/** @param {number} v */
const wrapped = (v) => v - Math.floor(v);

/**
 * Index of the line whose end on the first curve is nearest to a fraction of its domain.
 * @param {Point[]} places
 * @param {number} u
 */
function nearest(places, u) {
  const off = (/** @type {number} */ i) => Math.abs(wrapped(places[i][0] - u + 0.5) - 0.5);
  return places.reduce((best, _, i) => (best < 0 || off(i) < off(best) ? i : best), -1);
}
