/**
 * The card beside the pointer that says what is read there, and the ring on the line.
 *
 * @import { App } from "../state/app.js"
 * @import { Point, Reading } from "../types.js"
 */
import { attribute, find, h, svg } from "../dom.js";
import { fixed, length, percent } from "../format.js";
import { symbol } from "../icons.js";
import { numberNode } from "../number-node.js";
import { curveName } from "../state/app.js";
import { strings } from "../strings.js";
import { toScreen } from "../view.js";

/** Distance of the card from the pointer, and of its edge from the canvas. */
const GAP = 18;
const EDGE = 8;
/** Materials named in the card. */
const NAMED = 3;

/** @param {App} app */
export function createProbeCard(app) {
  const card = find("#probe");
  const marks = svg("svg", { class: "marks", "aria-hidden": "true" });
  const ring = svg("circle", { r: 3.5, class: "probe-ring" });
  marks.append(ring);
  find("#overlay").before(marks);
  /** @type {Reading | null} */
  let shown = null;

  return {
    render() {
      const { probe, view, size } = app.ui.value;
      card.hidden = !probe || !view;
      marks.style.display = card.hidden ? "none" : "";
      if (!probe || !view) return;
      const line = [toScreen(view, size, probe.from), toScreen(view, size, probe.to)];
      const at = probe.gradient ? toScreen(view, size, probe.at) : along(line, probe.s);
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
    ...(probe.gradient
      ? [entry([strings.probe.gradient], numberNode(probe.value))]
      : [entry([`${strings.probe.value} `, symbol("f")], numberNode(probe.value)), entry([strings.probe.cosine], fixed(probe.cosine, 3))]),
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
function beside(at, line, card, canvas) {
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
