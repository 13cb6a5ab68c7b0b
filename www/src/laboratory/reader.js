/**
 * What is read of a problem at a place: fractions inside and on elements, what flows there, and how far they are from the exact ones. The card beside the
 * place is filled when the kernel has answered.
 *
 * @import { Point, Size } from "../types.js"
 * @import { Vector } from "../space/vector.js"
 * @import { Bench, Known, Reading } from "./state.js"
 *
 * @typedef {{point: Vector, element: number | null}} Place `element`: of the boundary; null inside.
 */
import { h, svg } from "../dom.js";
import { fixed, percent } from "../format.js";
import { entry, fractionBar, NOTHING, placeCard } from "../space/card.js";
import { numberText } from "../space/measure.js";
import { put } from "../stage/mark.js";
import { Lane } from "../state/lane.js";
import { decimalsOf } from "./box-edit.js";
import { mixOf } from "./pixels.js";
import { words } from "./words.js";

/** Materials named in the card. */
const NAMED = 6;
/** Milliseconds that the pointer rests before its reading is spoken. */
const REST = 600;

/** @param {Bench} bench */
export function createReader(bench) {
  const { app } = bench;
  const ring = svg("circle", { r: 3.5, class: "probe-ring" });
  const cross = svg("path", { class: "read-cross", d: "M-9 0H9M0 -9V9" });
  const marks = svg("svg", { class: "marks lab-marks", "aria-hidden": "true" }, ring, cross);
  const card = h("div", { class: "probe lab-card", "aria-hidden": "true", hidden: true, "data-lab-reading": "" });
  /** @type {Place | null} */
  let place = null;
  /** @type {Reading | null} */
  let reading = null;
  let speaks = false;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let timer;
  /** @type {{at: Point | null, size: Size, isCross: boolean}} */
  let last = { at: null, size: { width: 0, height: 0 }, isCross: false };

  /** @type {Lane<Place, Reading | null>} */
  const lane = new Lane({
    async work(wanted, signal) {
      const { known } = bench.now();
      return known ? readingOf(bench, known, wanted, signal) : null;
    },
    done(found, wanted) {
      if (wanted !== place) return;
      reading = found;
      fill();
      clearTimeout(timer);
      if (speaks) app.say(spokenReading(bench, found));
      else if (!last.isCross && found) timer = setTimeout(() => app.say(spokenReading(bench, found)), REST);
      speaks = false;
    },
    failed() {
      if (place) reading = null;
    },
  });

  function fill() {
    const { at, size, isCross } = last;
    card.hidden = at === null || reading === null;
    put(ring, at === null || place === null || isCross ? null : at);
    put(cross, isCross ? at : null);
    if (!at || !reading) return;
    card.replaceChildren(...content(bench, reading));
    placeCard(card, at, size);
  }
  fill();

  return {
    nodes: [/** @type {any} */ (marks), card],
    /**
     * @param {Place | null} next
     * @param {Point | null} at CSS pixels
     * @param {Size} size of the picture
     * @param {boolean} isCross it is read by keyboard
     */
    read(next, at, size, isCross) {
      last = { at, size, isCross };
      clearTimeout(timer);
      const isSame = next !== null && place !== null && next.element === place.element && next.point.every((value, k) => value === place?.point[k]);
      if (isSame && reading) return fill();
      place = next;
      if (next) lane.push(next);
      else reading = null;
      fill();
    },
    /** Says what is read, once it is. */
    speak() {
      if (place && reading && !lane.busy) app.say(spokenReading(bench, reading));
      else if (place) speaks = true;
      else app.say(words.spoken.nothing);
    },
    /** What is known is another solution. */
    again() {
      if (place) lane.push(place);
    },
    close() {
      clearTimeout(timer);
      lane.cancel();
    },
  };
}

/**
 * @param {Bench} bench
 * @param {Known} known
 * @param {Place} place
 * @param {AbortSignal} signal
 * @returns {Promise<Reading>}
 */
async function readingOf({ app }, { document, boundary, solution }, { point, element }, signal) {
  const { dimension, exact } = boundary;
  const own = point.slice(0, dimension);
  if (element !== null) {
    const condition = boundary.conditions[boundary.groups[element]];
    return {
      point,
      element,
      fractions: solution ? solution.values.map((values) => values[element]) : mixOf(condition),
      exact: null,
      flux: solution ? solution.fluxes.map((fluxes) => fluxes[element]) : null,
    };
  }
  if (!solution) return { point, element, fractions: null, exact: null, flux: null };
  const { values } = await solution.at(own, { outside: "skip" }, { signal });
  const isInside = !Number.isNaN(values[0]);
  return {
    point,
    element,
    fractions: isInside ? [...values] : null,
    exact: isInside && exact !== null ? [...(await app.kernel.exact(/** @type {any} */ (document), own))] : null,
    flux: null,
  };
}

/** The largest difference of fractions from the exact ones. @param {Reading} reading */
const errorOf = ({ fractions, exact }) => (fractions && exact ? Math.max(...fractions.map((fraction, i) => Math.abs(fraction - exact[i]))) : null);

/** @param {Bench} bench @param {Reading} reading */
function content(bench, reading) {
  const { document, known } = bench.now();
  const { materials } = document;
  const { point, element, fractions, flux } = reading;
  const error = errorOf(reading);
  const dimension = known?.boundary.dimension ?? 3;
  const group = element === null || !known ? null : known.boundary.names[known.boundary.groups[element]];
  const decimals = known ? decimalsOf(known.mesh.bounds, 3, 1) : 3;
  const present = (fractions ?? []).flatMap((fraction, i) => (Math.abs(fraction) < NOTHING ? [] : [{ i, fraction }]));
  return [
    h("div", { class: "probe-head" }, h("strong", { class: "number" }, point.slice(0, dimension).map((value) => fixed(value, decimals)).join(", ")), h("span", {}, element === null ? words.card.inside : words.card.element(element))),
    ...(group ? [entry(words.card.group, group)] : []),
    ...(fractions ? [fractionBar(fractions, materials)] : []),
    ...present.slice(0, NAMED).map(({ i, fraction }) => entry(materials[i]?.name ?? "", `${fixed(fraction, 4)}`)),
    ...(flux ? [entry(words.card.flux(materials[0]?.name ?? ""), numberText(flux[0]))] : []),
    ...(error === null ? [] : [entry(words.card.error, numberText(error))]),
  ];
}

/** A reading in words. @param {Bench} bench @param {Reading | null} reading */
function spokenReading(bench, reading) {
  if (!reading) return words.spoken.nothing;
  const { document, known } = bench.now();
  const { point, element, fractions } = reading;
  const error = errorOf(reading);
  const group = element === null || !known ? null : known.boundary.names[known.boundary.groups[element]];
  return words.spoken.reading([
    point.slice(0, known?.boundary.dimension ?? 3).map((value, k) => `${"xyz"[k]} ${fixed(value, 2)}`).join(", "),
    ...(element === null ? [] : [words.card.element(element)]),
    ...(group ? [group] : []),
    ...(fractions ?? []).flatMap((fraction, i) => (Math.abs(fraction) < NOTHING ? [] : [`${document.materials[i]?.name ?? ""} ${percent(fraction)}`])),
    ...(error === null ? [] : [`${words.card.error} ${numberText(error)}`]),
  ]);
}
