/**
 * What is read of a body below its figure: how its certificate is found, how regular it is, where it meets itself, how cells continue each
 * other, and how much there is of each material.
 *
 * @import { State } from "./cell-reading.js"
 */
import { h, svg } from "../dom.js";
import { coordinate, fixed } from "../format.js";
import { sampleAt } from "../hyperpatch/cell.js";
import { subtract } from "../space/vector.js";
import { reflected } from "./body-edits.js";
import { pieces } from "./certificate.js";
import { rowChart } from "./row-chart.js";
import { words } from "./words-body.js";

/** Distances from the corner at which a gap is measured, each half the one before. */
const DISTANCES = [0.4, 0.2, 0.1, 0.05];
/** Side of one of the 729 numbers in their picture, and the space between layers, in units of its view. */
const SQUARE = 5;
const SPACE = 5;

/** Pairs of a name and a value; `failed` marks one that is wrong. @param {{name: string, value: string | null, key: string, failed?: boolean}[]} rows */
const pairs = (rows) =>
  h(
    "dl",
    {},
    ...rows.flatMap(({ name, value, key, failed }) => [
      h("dt", {}, name),
      h("dd", { class: `number${failed ? " failed" : ""}`, "data-lesson": key }, value ?? "…"),
    ]),
  );

/** @param {readonly number[]} place */
const placeText = (place) => `(${place.map(coordinate).join(", ")})`;

/**
 * The numbers of a piece in nine layers along w: negative ones in the colour of errors, the others in four strengths from the least of them to the
 * greatest.
 * @param {Float64Array} numbers
 */
function layers(numbers) {
  const positive = numbers.filter((value) => value > 0);
  const [least, most] = [positive.reduce((a, b) => Math.min(a, b), Infinity), positive.reduce((a, b) => Math.max(a, b), 0)];
  const side = 9 * SQUARE;
  const paths = ["", "", "", "", ""];
  numbers.forEach((value, n) => {
    const [p, q, r] = [Math.floor(n / 81), Math.floor(n / 9) % 9, n % 9];
    const level = value <= 0 ? 0 : 1 + Math.min(3, Math.floor((4 * (value - least)) / (most - least || 1)));
    paths[level] += `M${r * (side + SPACE) + p * SQUARE} ${(8 - q) * SQUARE}h${SQUARE - 0.6}v${SQUARE - 0.6}h${0.6 - SQUARE}z`;
  });
  return svg(
    "svg",
    { class: "cell-numbers", viewBox: `0 0 ${9 * side + 8 * SPACE} ${side}`, role: "img", "aria-label": words.certificate.picture },
    ...paths.map((d, level) => svg("path", { d, class: `level-${level}` })),
  );
}

/** @param {State} state */
function certificate({ cell, halvings }) {
  const all = pieces(cell, halvings);
  const says = words.certificate;
  const least = all[0].least;
  const corner = Math.min(...all.map((each) => each.corner));
  const open = all.filter((each) => each.least <= 0).length;
  return [
    layers(all[0].numbers),
    pairs([
      { name: says.pieces, value: fixed(all.length, 0), key: "pieces" },
      { name: says.open, value: fixed(open, 0), key: "open-pieces" },
      { name: says.least, value: fixed(least, 3), key: "least-number", failed: least <= 0 },
      { name: says.corner, value: fixed(corner, 3), key: "corner-number", failed: corner <= 0 },
      { name: says.verdict, value: least > 0 ? says.proven : corner < 0 ? says.disproven : says.unsettled, key: "settled", failed: corner < 0 },
    ]),
  ];
}

/** @param {State} state */
const cone = ({ verdict }) =>
  pairs([
    { name: words.cone.margin, value: verdict && fixed(verdict.margin, 3), key: "margin" },
    { name: words.cone.least, value: verdict && fixed(verdict.leastJacobianBound, 3), key: "jacobian-least", failed: verdict !== null && verdict.leastJacobianBound <= 0 },
  ]);

/** @param {State} state */
function meeting({ cell, uvw, materials, verdict }) {
  const says = words.meeting;
  const witness = verdict?.witness?.kind === "meeting" ? verdict.witness : null;
  const place = (/** @type {readonly number[]} */ at) => sampleAt(cell, at, materials.length).position;
  const apart = witness && Math.hypot(...subtract(place(witness.at), place(witness.other)));
  return pairs([
    { name: words.table.place, value: placeText(place(uvw)), key: "place" },
    { name: says.local, value: verdict && fixed(verdict.leastJacobianBound, 3), key: "jacobian-least" },
    { name: says.first, value: verdict && (witness ? placeText(witness.at) : says.none), key: "meeting-first", failed: witness !== null },
    { name: says.second, value: verdict && (witness ? placeText(witness.other) : says.none), key: "meeting-second", failed: witness !== null },
    ...(apart === null ? [] : [{ name: says.apart, value: fixed(apart, 3), key: "meeting-apart" }]),
  ]);
}

/** @param {State} state */
function joints({ known }) {
  const all = known?.around?.joints ?? null;
  const smooth = (/** @type {"shape" | "material"} */ kind) => all && all.filter((joint) => joint[kind] === "C1").length;
  const says = words.joints;
  const row = (/** @type {string} */ name, /** @type {number | null} */ count, /** @type {string} */ key, failed = false) => ({ name, value: count === null ? null : fixed(count, 0), key, failed });
  const shape = smooth("shape");
  return pairs([
    row(says.moving, known && new Set(known.moving.map(({ cell, at }) => String(known.cells[cell]?.coefficients[(at[0] * 4 + at[1]) * 4 + at[2]].position))).size, "moving"),
    row(says.faces, all && all.length, "faces"),
    row(says.shape, shape, "smooth-shape", shape !== null && all !== null && shape < all.length),
    row(says.material, smooth("material"), "smooth-material"),
  ]);
}

/** How far the first two cells lie apart on their common face, from its first corner along v. @param {State} state */
function gap({ cells, materials }) {
  const [first, second] = cells;
  const says = words.gap;
  const gaps = DISTANCES.map((t) => Math.hypot(...subtract(sampleAt(first, [1, t, 0], materials.length).position, sampleAt(second, [0, t, 0], materials.length).position)));
  const rows = DISTANCES.map((t, n) =>
    h(
      "tr",
      {},
      h("th", { scope: "row", class: "number" }, fixed(t, 2)),
      h("td", { class: "number", "data-lesson": `gap-${n}` }, fixed(gaps[n], 4)),
      h("td", { class: "number", "data-lesson": `ratio-${n}` }, n > 0 && gaps[n] > 0 ? fixed(gaps[n - 1] / gaps[n], 2) : says.none),
    ),
  );
  const head = [says.t, says.gap, says.ratio].map((text) => h("th", { scope: "col" }, text));
  return h("table", { class: "cell-gaps" }, h("thead", {}, h("tr", {}, ...head)), h("tbody", {}, ...rows));
}

/** @param {State} state */
function row({ cells, materials, shares, rule, known }) {
  const says = words.row;
  const pair = (/** @type {number} */ share) => `(${fixed(1 - share, 2)}, ${fixed(share, 2)})`;
  const beyond = reflected(shares);
  const isOutside = beyond < 0 || beyond > 1;
  const joint = known?.around?.joints[0]?.material;
  return [
    rowChart(cells, materials, rule === "reflect" ? shares : null),
    pairs([
      ...(rule === "reflect"
        ? [
            { name: says.before, value: pair(shares.before), key: "mix-before" },
            { name: says.at, value: pair(shares.at), key: "mix-at" },
            { name: says.beyond, value: `${pair(beyond)}${isOutside ? `, ${says.outside}` : ""}`, key: "mix-beyond", failed: isOutside },
          ]
        : []),
      { name: says.joint, value: joint ? says.kinds[joint] : null, key: "joint" },
    ]),
  ];
}

/** @param {State} state */
function amounts({ cell, uvw, materials, known }) {
  const measures = known?.measures ?? null;
  const of = (/** @type {number} */ m) => measures && `${fixed(measures.amounts[m], 2)} (${fixed((100 * measures.amounts[m]) / measures.volume, 1)}\u00a0%)`;
  return pairs([
    { name: words.amounts.volume, value: measures && fixed(measures.volume, 2), key: "volume" },
    ...materials.map(({ name }, m) => ({ name: words.amounts.of(name), value: of(m), key: `amount-${m}` })),
    ...materials.map(({ name }, m) => ({ name: words.amounts.here(name), value: `${fixed(100 * sampleAt(cell, uvw, materials.length).mix[m], 1)}\u00a0%`, key: `here-${m}` })),
  ]);
}

/** By the names that lessons have for them. */
export const READINGS = { certificate, cone, meeting, joints, gap, row, amounts };
