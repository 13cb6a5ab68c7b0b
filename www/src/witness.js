/**
 * Showing where a certificate fails: the view goes to the next place each time.
 *
 * @import { App } from "./state/app.js"
 * @import { Match, Point } from "./types.js"
 */
import { coordinate } from "./format.js";
import { currentMatch } from "./state/app.js";
import { strings } from "./strings.js";
import { toScreen } from "./view.js";

/** Part of the canvas, from each edge, in which a witness is brought to the middle. */
const MARGIN = 0.12;
/** Diagnostics that carry the places of each certificate. */
export const CODES = {
  crossings: ["crossing"],
  blocked: ["blocked"],
  uncovered: ["orphan", "stuck", "disjoint"],
  gaps: ["unverified-gap"],
  occluded: ["occluded"],
};

/** @type {{[name: string]: number}} */
const turn = {};

/**
 * @param {App} app
 * @param {keyof typeof CODES} name
 */
export function nextWitness(app, name) {
  const match = currentMatch(app);
  const places = match ? witnesses(match, name) : [];
  if (places.length === 0) return;
  const index = (turn[name] ?? 0) % places.length;
  turn[name] = index + 1;
  const at = /** @type {Point} */ (places[index]);
  app.ui.set({ witness: at });
  bring(app, at);
  app.say(`${strings.status[name]} ${index + 1}: x ${coordinate(at[0])}, y ${coordinate(at[1])}`);
}

/** Brings a place to the middle of the canvas, unless it is well inside already. @param {App} app @param {Point} at */
export function bring(app, at) {
  const { view, size } = app.ui.value;
  if (!view) return;
  const [x, y] = toScreen(view, size, at);
  const inside =
    x > size.width * MARGIN &&
    x < size.width * (1 - MARGIN) &&
    y > size.height * MARGIN &&
    y < size.height * (1 - MARGIN);
  if (!inside) app.ui.set({ view: { ...view, center: at }, fitted: false });
}

/**
 * @param {Match} match
 * @param {keyof typeof CODES} name
 * @returns {Point[]}
 */
function witnesses(match, name) {
  if (name === "uncovered") {
    return (match.totals.lines?.uncovered ?? []).flatMap((vertices, curve) =>
      vertices.map((vertex) => /** @type {Point} */ (match.samples[curve]?.points[vertex])),
    );
  }
  const named = match.diagnostics.filter(({ code }) => CODES[name].includes(code));
  const places = named.flatMap(({ at, lines = [] }) => (at ? [at] : lines.map((line) => middleOf(match, line))));
  const hidden =
    name === "blocked" ? match.lines.flatMap(({ visible }, i) => (visible ? [] : [middleOf(match, i)])) : [];
  return places.length > 0 ? places : hidden;
}

/** @param {Match} match @param {number} index @returns {Point} */
function middleOf(match, index) {
  const line = match.lines[index];
  const a = line && match.samples[0]?.points[line.from];
  const b = line && match.samples[1]?.points[line.to];
  return a && b ? [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2] : [0, 0];
}
