/**
 * The card beside a place of the solid, and the ring at it.
 *
 * @import { App } from "../state/app.js"
 * @import { Point, Size } from "../types.js"
 * @import { SolidColor } from "./state.js"
 * @import { SolidReading } from "./reading.js"
 */
import { attribute, h, svg } from "../dom.js";
import { coordinate, fixed, percent } from "../format.js";
import { symbol } from "../icons.js";
import { entry, fractionBar, NOTHING, placeCard } from "../space/card.js";
import { curveName } from "../state/app.js";
import { words } from "./words.js";

/** Materials named in the card, the longest line of whole names, and letters of a short one. */
const NAMED = 3;
const LINE = 16;
const SHORT = 3;

/** @param {App} app */
export function createCard(app) {
  const ring = svg("circle", { r: 3.5, class: "probe-ring" });
  const cross = svg("path", { class: "read-cross", d: "M-9 0H9M0 -9V9" });
  const marks = svg("svg", { class: "marks read-marks", "aria-hidden": "true" }, ring, cross);
  const card = h("div", { class: "probe", "aria-hidden": "true", hidden: true, "data-solid-reading": "" });

  return {
    marks,
    card,
    /**
     * @param {SolidReading | "inside" | null} reading
     * @param {Point | null} at where it is on the screen; null where nothing is read
     * @param {{size: Size, color: SolidColor, isCross: boolean}} shown `isCross`: it is read by keyboard
     */
    render(reading, at, { size, color, isCross }) {
      const isRead = at !== null && reading !== null;
      card.hidden = !isRead;
      ring.style.display = isRead && reading !== "inside" && !isCross ? "" : "none";
      cross.style.display = at && isCross ? "" : "none";
      if (!at) return;
      for (const mark of [ring, cross]) attribute(mark, "transform", `translate(${at[0].toFixed(1)} ${at[1].toFixed(1)})`);
      if (!reading) return;
      card.replaceChildren(...(reading === "inside" ? [h("div", { class: "probe-row" }, words.read.inside)] : content(app, reading, color)));
      placeCard(card, at, size);
    },
  };
}

/** @param {App} app @param {SolidReading} reading @param {SolidColor} color */
function content(app, { point, fractions, s, scalar, cap }, color) {
  const { document } = app.store;
  const largest = fractions
    .map((fraction, i) => ({ fraction, name: document.materials[i]?.name ?? "", i }))
    .sort((a, b) => b.fraction - a.fraction)
    .slice(0, NAMED)
    .sort((a, b) => a.i - b.i);
  const isLong = largest.map(({ name }) => name).join("").length > LINE;
  const head = cap !== null ? words.read.cap(curveName(document, cap)) : point.map(coordinate).join(", ");
  return [
    h("div", { class: "probe-head" }, h("strong", { class: "number" }, head), h("span", { class: "number" }, document.unit)),
    ...(cap !== null ? [entry("", point.map(coordinate).join(", "))] : []),
    ...(s === null ? [] : [entry(symbol("s"), fixed(s, 3))]),
    ...(scalar === null || (color !== "twist" && color !== "flank") ? [] : [entry(words.read[color], `${fixed(scalar, 1)}°`)]),
    fractionBar(fractions, document.materials),
    h(
      "div",
      { class: "fraction-names number" },
      ...largest.map(({ name, fraction }) => h("span", {}, `${isLong ? name.slice(0, SHORT) : name} ${percent(fraction)}`)),
    ),
  ];
}

/** A reading in words. @param {App} app @param {SolidReading | "inside" | null} reading @param {SolidColor} color */
export function spokenReading({ store: { document } }, reading, color) {
  if (!reading) return words.read.nothing;
  if (reading === "inside") return words.read.inside;
  const { point, fractions, s, scalar, cap } = reading;
  return words.spoken.summary([
    ...(cap !== null ? [words.read.cap(curveName(document, cap))] : []),
    `x ${coordinate(point[0])}, y ${coordinate(point[1])}, z ${coordinate(point[2])}`,
    ...(s === null ? [] : [`s ${fixed(s, 2)}`]),
    ...(scalar === null || (color !== "twist" && color !== "flank") ? [] : [`${words.read[color]} ${fixed(scalar, 1)}°`]),
    ...fractions.flatMap((fraction, i) => (fraction < NOTHING ? [] : [`${document.materials[i]?.name ?? ""} ${percent(fraction)}`])),
  ]);
}
