/**
 * Results in words, for those who do not see the picture: screen readers, captions, the description inside an SVG. Imports nothing, so
 * that page, element and package say the same.
 */

/**
 * What a matching is worth, in one sentence without a full stop, such as `44 lines, none crossing, none blocked, eta 0.981`.
 *
 * It speaks of one-to-one lines where there are such. What fails is counted; what holds is said once.
 *
 * @param {import("./directrix.js").Match} match
 * @returns {string}
 */
export function describe({ ok, diagnostics, totals, samples, gap, gapKind, spans, harmonic }) {
  if (harmonic) return describeHarmonic(samples.length, harmonic);
  if (spans) return describeStack({ ok, diagnostics, spans });
  const shown = totals.pairs ?? totals.lines;
  if (samples.length < 2) return samples.length === 0 ? "No curve yet" : "One curve, not matched yet";
  if (!shown) return `The two curves are not matched${diagnostics[0] ? `: ${diagnostics[0].message}` : ""}`;
  const { count, crossings, blocked, uncovered, eta } = shown;
  const bare = uncovered[0].length + uncovered[1].length;
  const through = diagnostics.find(({ code }) => code === "occluded")?.lines?.length ?? 0;
  const gaps = diagnostics.filter(({ code }) => code === "unverified-gap").length;
  return [
    counted(count, "line", "lines"),
    `${crossings || "none"} crossing`,
    `${blocked || "none"} blocked`,
    bare > 0 && `${counted(bare, "sample", "samples")} without a line`,
    through > 0 && `${counted(through, "more line passes", "more lines pass")} through a curve`,
    gaps > 0 && `${counted(gaps, "gap keeps", "gaps keep")} lines that share ends`,
    eta !== null && `eta ${eta.toFixed(3)}`,
    gapKind === "lattice" && gap !== null && gap >= 5e-4 && `${(gap * 100).toFixed(1)} % below the optimum`,
  ]
    .filter(Boolean)
    .join(", ");
}

/**
 * A harmonic blend.
 *
 * @param {number} curves
 * @param {NonNullable<import("./directrix.js").Match["harmonic"]>} numbers
 */
function describeHarmonic(curves, { lines, crossings, lost, fluxBalance }) {
  return [
    `Harmonic blend of ${curves} curves`,
    counted(lines, "line along the gradient", "lines along the gradient"),
    `${crossings || "none"} crossing`,
    lost > 0 && `${lost} left out`,
    `heat flow balanced to ${(100 * fluxBalance).toPrecision(1)} %`,
  ]
    .filter(Boolean)
    .join(", ");
}

/**
 * A stack: what all spans count together, and the least eta of them with its span.
 *
 * @param {{ ok: boolean, diagnostics: import("./directrix.js").Diagnostic[], spans: import("./directrix.js").Match[] }} match
 */
function describeStack({ ok, diagnostics, spans }) {
  const shown = spans.map(({ totals }) => totals.pairs ?? totals.lines);
  const missing = shown.indexOf(null);
  const why = diagnostics.find(({ span, code }) => span === missing || code === "order")?.message;
  if (missing >= 0) return `Curves ${missing + 1} and ${missing + 2} are not matched${why ? `: ${why}` : ""}`;
  const sum = (/** @type {(totals: import("./directrix.js").LineTotals) => number} */ of) =>
    shown.reduce((all, totals) => all + (totals ? of(totals) : 0), 0);
  const bare = sum(({ uncovered }) => uncovered[0].length + uncovered[1].length);
  const etas = shown.map((totals) => totals?.eta ?? Infinity);
  const least = Math.min(...etas);
  const blend = ok ? undefined : diagnostics.find(({ code }) => ["order", "overlap", "no-thread"].includes(code));
  return [
    `${spans.length + 1} curves`,
    counted(sum(({ count }) => count), "line", "lines"),
    `${sum(({ crossings }) => crossings) || "none"} crossing`,
    `${sum(({ blocked }) => blocked) || "none"} blocked`,
    bare > 0 && `${counted(bare, "sample", "samples")} without a line`,
    least < Infinity && `least eta ${least.toFixed(3)} between curves ${etas.indexOf(least) + 1} and ${etas.indexOf(least) + 2}`,
    blend && `not blended: ${blend.message}`,
  ]
    .filter(Boolean)
    .join(", ");
}

/**
 * The curves of a document, in one sentence each: degree, control points, width and height, and what they are made of at their first key.
 *
 * @param {import("./directrix.js").CurvesDocument} document
 * @returns {string}
 */
export function describeCurves({ curves, materials = [], unit = "mm" }) {
  return curves
    .map(({ name, degree, points, composition = [] }, index) => {
      const [width, height] = [0, 1].map((axis) => extent(points.map((point) => point[axis] ?? 0)));
      const held = new Set(composition.flatMap(({ mix }) => mix.flatMap((share, i) => (share > 0 ? [i] : []))));
      const made = materials.filter((_, i) => held.has(i)).map((material) => material.name);
      return (
        `${name || (curves.length > 2 ? `Curve ${index + 1}` : index === 0 ? "First curve" : "Second curve")}: degree ${degree}, ` +
        `${counted(points.length, "control point", "control points")} within ${width} by ${height} ${unit}` +
        `${made.length > 0 ? `, of ${list(made)}` : ""}.`
      );
    })
    .join(" ");
}

/** What is said of the cells with a verdict, from the worst on; of those that are regular nothing is. */
const FOUND = /** @type {const} */ ([
  ["invalid", "invalid"],
  ["degenerate", "degenerate"],
  ["locally-valid", "sound in every place, not proven to meet itself nowhere"],
  ["valid", "valid but not regular"],
]);

/**
 * What is known of a body, in one sentence without a full stop, such as `8 cells, all regular, none overlapping, materials sum to 1`.
 *
 * @param {import("./directrix.js").BodySummary} summary
 * @returns {string}
 */
export function describeBody({ cells, verdicts, mirrored, worst, pairs, sumError }) {
  if (cells === 0) return "No cell yet";
  const pairsThat = (/** @type {string} */ relation) => pairs.filter((pair) => pair.relation === relation).length;
  const [overlaps, touches, open] = ["overlaps", "touches", "not-proven"].map(pairsThat);
  const all = (/** @type {number} */ count) => (count === cells && cells > 1 ? "all" : `${count}`);
  const states = FOUND.filter(([name]) => verdicts[name] > 0).map(([name, words]) => {
    const count = cells === 1 ? "" : `${all(verdicts[name])} `;
    return `${count}${words}${worst?.verdict === name && name === "invalid" && cells > 1 ? ` (cell ${worst.cell})` : ""}`;
  });
  return [
    counted(cells, "cell", "cells"),
    ...(states.length > 0 ? states : [cells === 1 ? "regular" : "all regular"]),
    mirrored > 0 && (cells === 1 ? "mirrored" : `${all(mirrored)} mirrored`),
    cells > 1 && (overlaps > 0 ? `${counted(overlaps, "pair", "pairs")} overlapping` : open === 0 && "none overlapping"),
    touches > 0 && `${counted(touches, "pair", "pairs")} touching`,
    open > 0 && `${counted(open, "pair", "pairs")} not decided`,
    sumError <= 1e-9 ? "materials sum to 1" : `materials sum to 1 within ${sumError.toPrecision(1)}`,
  ]
    .filter(Boolean)
    .join(", ");
}

/** @param {number} count @param {string} one @param {string} many */
export const counted = (count, one, many) => `${count} ${count === 1 ? one : many}`;

/** @param {string[]} names */
export const list = (names) => [names.slice(0, -1).join(", "), ...names.slice(-1)].filter((part) => part !== "").join(" and ");

/** From the least to the greatest value, to three figures. @param {number[]} values */
function extent(values) {
  let [low, high] = [Infinity, -Infinity];
  for (const value of values) [low, high] = [Math.min(low, value), Math.max(high, value)];
  return Number((high - low).toPrecision(3)).toString();
}
