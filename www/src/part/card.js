/**
 * The card beside a place of a part: where it is, in which body, how far from every feature, and of which materials.
 *
 * @import { Point, Size } from "../types.js"
 * @import { PartReading } from "./reading.js"
 * @import { WholePart } from "./document.js"
 */
import { h, svg } from "../dom.js";
import { coordinate, fixed, length, percent } from "../format.js";
import { entry, fractionBar, NOTHING, placeCard } from "../space/card.js";
import { put } from "../stage/mark.js";
import { words } from "./words.js";

/** Features and materials named in the card. */
const NAMED = 5;

export function createCard() {
  const ring = svg("circle", { r: 3.5, class: "probe-ring" });
  const cross = svg("path", { class: "read-cross", d: "M-9 0H9M0 -9V9" });
  const witness = svg("g", { class: "part-witness", "data-part-witness": "" }, svg("path", { class: "under", d: "M-6 -6 6 6M6 -6-6 6" }), svg("path", { d: "M-6 -6 6 6M6 -6-6 6" }));
  const marks = svg("svg", { class: "marks part-marks", "aria-hidden": "true" }, witness, ring, cross);
  const card = h("div", { class: "probe part-card", "aria-hidden": "true", hidden: true, "data-part-reading": "" });
  /** @type {PartReading | null} */
  let filled = null;

  return {
    marks,
    card,
    /** @param {Point | null} at on the screen */
    witness: (at) => put(witness, at),
    /**
     * @param {WholePart} document
     * @param {PartReading | null} reading
     * @param {Point | null} at of the reader on the screen, also where there is nothing to be read
     * @param {Size} size of the picture
     * @param {boolean} isKeyed it is read by keyboard
     */
    render(document, reading, at, size, isKeyed) {
      card.hidden = at === null || reading === null;
      put(ring, card.hidden || isKeyed ? null : at);
      put(cross, isKeyed ? at : null);
      if (!at || !reading) return;
      if (filled !== reading) card.replaceChildren(...content(document, reading));
      filled = reading;
      placeCard(card, at, size);
    },
  };
}

/** A reading as rows of the card. @param {WholePart} document @param {PartReading} reading */
function content({ bodies, materials = [], unit = "mm" }, { at, body, fractions, distances, nearest, isVoxel }) {
  const present = (fractions ?? []).flatMap((fraction, i) => (fraction < NOTHING ? [] : [{ fraction, material: materials[i] }]));
  const near = [...distances].sort((a, b) => a.distance - b.distance);
  return [
    h("div", { class: "probe-head" }, h("strong", { class: "number" }, at.map(coordinate).join(", ")), h("span", { class: "number" }, unit)),
    entry(words.card.body, bodies[body]?.name ?? ""),
    ...near.slice(0, NAMED).map(({ feature, name, distance, holds }) => {
      const row = entry(words.card.to(name), length(distance, unit));
      row.classList.toggle("part-near", feature === nearest);
      row.classList.toggle("part-away", !holds);
      return row;
    }),
    ...(near.length > NAMED ? [h("div", { class: "probe-row" }, h("span", {}, words.card.more(near.length - NAMED)))] : []),
    ...(fractions ? [fractionBar(fractions, materials)] : []),
    ...present.slice(0, NAMED).map(({ fraction, material }) => entry(material?.name ?? "", percent(fraction))),
    ...(isVoxel ? [h("div", { class: "probe-row part-voxel" }, h("span", {}, words.card.voxel))] : []),
  ];
}

/** A reading in words. @param {WholePart} document @param {PartReading | null} reading @param {Point} at */
export function spokenReading({ bodies, materials = [], unit = "mm" }, reading, at) {
  const place = words.card.place(coordinate(at[0]), coordinate(at[1]));
  if (!reading) return words.card.spoken([place, words.card.nothing]);
  const { body, fractions, distances, nearest } = reading;
  const near = distances.find(({ feature }) => feature === nearest);
  return words.card.spoken([
    place,
    bodies[body]?.name ?? "",
    ...(fractions ?? []).flatMap((fraction, i) => (fraction < NOTHING ? [] : [`${materials[i]?.name ?? ""} ${percent(fraction)}`])),
    ...(near ? [words.card.nearest(near.name, `${fixed(near.distance, 1)} ${unit}`)] : []),
  ]);
}
