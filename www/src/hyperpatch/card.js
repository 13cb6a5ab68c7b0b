/**
 * The card beside a place of the body, and the marks over the picture: what is read, the chosen corner, witnesses.
 *
 * @import { App } from "../state/app.js"
 * @import { Point, Size } from "../types.js"
 * @import { Vector } from "../space/vector.js"
 *
 * @typedef {object} BodyReading
 * @property {number} cell
 * @property {Vector} uvw
 * @property {Vector} point
 * @property {number[]} mix
 */
import { attribute, h, svg } from "../dom.js";
import { coordinate, fixed, percent } from "../format.js";
import { entry, fractionBar, NOTHING, placeCard } from "../space/card.js";
import { put } from "../stage/mark.js";
import { bodyOf } from "./document.js";
import { sign } from "./verdict.js";
import { words } from "./words.js";

/** @param {App} app */
export function createMarks(app) {
  const ring = svg("circle", { r: 3.5, class: "probe-ring" });
  const cross = svg("path", { class: "read-cross", d: "M-9 0H9M0 -9V9" });
  const corner = svg("g", { class: "body-corner" }, svg("circle", { r: 12.5, class: "halo" }), svg("circle", { r: 5.5, class: "dot" }));
  const witnesses = svg("g", {});
  const badges = svg("g", { "data-body-badges": "" });
  const grid = svg("path", { class: "body-grid" });
  const points = svg("path", { class: "body-grid-points" });
  const ghosts = svg("path", { class: "body-ghosts", "data-body-ghosts": "" });
  const marks = svg("svg", { class: "marks read-marks", "aria-hidden": "true" }, badges, grid, points, ghosts, witnesses, corner, ring, cross);
  /** Verdicts that badges have now. */
  let badged = "";
  const card = h("div", { class: "probe", "aria-hidden": "true", hidden: true, "data-body-reading": "" });

  return {
    marks,
    card,
    /** @param {Point | null} at */
    corner: (at) => put(corner, at),
    /** The small grid of the neighbours of the chosen corner. @param {[Point, Point][]} lines @param {Point[]} dots */
    neighbours(lines, dots) {
      attribute(grid, "d", lines.map((ends) => `M${ends.map(text).join("L")}`).join(""));
      attribute(points, "d", dots.map((dot) => `M${text(dot)}h0`).join(""));
    },
    /** Cells that are not regular, at their middles. @param {{at: Point, verdict: import("../../../js/directrix.js").VerdictName}[]} shown */
    badges(shown) {
      const key = shown.map(({ verdict }) => verdict).join();
      if (key !== badged) {
        badged = key;
        badges.replaceChildren(...shown.map(({ verdict }) => svg("g", { class: "body-badge", "data-badge": verdict }, svg("circle", { r: 10 }), svg("g", { transform: "translate(-8 -8)" }, sign(verdict)))));
      }
      shown.forEach(({ at }, n) => put(/** @type {SVGElement} */ (badges.children[n]), at));
    },
    /** Coefficients that would move with what is chosen, as small rings. @param {Point[]} places */
    ghosts: (places) => attribute(ghosts, "d", places.map(([x, y]) => `M${(x - 4).toFixed(1)} ${y.toFixed(1)}a4 4 0 1 0 8 0a4 4 0 1 0 -8 0`).join("")),
    /** @param {Point[]} places of witnesses on the screen */
    witnesses(places) {
      while (witnesses.children.length > places.length) witnesses.lastElementChild?.remove();
      while (witnesses.children.length < places.length) {
        witnesses.append(svg("g", { class: "body-witness", "data-body-witness": "" }, svg("path", { class: "under", d: "M-6 -6 6 6M6 -6-6 6" }), svg("path", { d: "M-6 -6 6 6M6 -6-6 6" })));
      }
      places.forEach((at, n) => put(/** @type {SVGElement} */ (witnesses.children[n]), at));
    },
    /**
     * @param {BodyReading | null} reading
     * @param {Point | null} at where it is on the screen; null where nothing is read
     * @param {Size} size of the picture
     * @param {boolean} isCross it is read by keyboard
     */
    reading(reading, at, size, isCross) {
      const isRead = at !== null && reading !== null;
      card.hidden = !isRead;
      put(ring, isRead && !isCross ? at : null);
      put(cross, isCross ? at : null);
      if (!at || !reading) return;
      card.replaceChildren(...content(app, reading));
      placeCard(card, at, size);
    },
  };
}

/** @param {Point} at */
const text = (at) => at.map((value) => value.toFixed(1)).join(" ");

/** @param {App} app @param {BodyReading} reading */
function content(app, { cell, uvw, point, mix }) {
  const { materials, unit } = bodyOf(app);
  const present = mix.map((fraction, i) => ({ fraction, material: materials[i] })).filter(({ fraction }) => fraction >= NOTHING);
  return [
    h("div", { class: "probe-head" }, h("strong", {}, words.cells.nth(cell)), h("span", { class: "number" }, unit)),
    entry("u, v, w", uvw.map((t) => fixed(t, 2)).join(", ")),
    entry("x, y, z", point.map(coordinate).join(", ")),
    fractionBar(mix, materials),
    ...present.map(({ fraction, material }) => entry(material.name, percent(fraction))),
  ];
}

/** A reading in words. @param {App} app @param {BodyReading | null} reading */
export function spokenReading(app, reading) {
  if (!reading) return words.spoken.nothing;
  const { materials } = bodyOf(app);
  const { cell, uvw, point, mix } = reading;
  return words.spoken.summary([
    words.cells.nth(cell),
    ...["u", "v", "w"].map((name, k) => `${name} ${fixed(uvw[k], 2)}`),
    ...["x", "y", "z"].map((name, k) => `${name} ${coordinate(point[k])}`),
    ...mix.flatMap((fraction, i) => (fraction < NOTHING ? [] : [`${materials[i].name} ${percent(fraction)}`])),
  ]);
}
