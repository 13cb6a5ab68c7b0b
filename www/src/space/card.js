/**
 * What the cards beside a place of a body have in common.
 *
 * @import { Point, Size } from "../types.js"
 */
import { h } from "../dom.js";

/** Distance of the card from the place, and of its edge from the picture, in CSS pixels. */
const GAP = 18;
const EDGE = 8;
/** Fractions that are not shown. */
export const NOTHING = 5e-4;

/** Beside a place of the screen, within the picture. @param {HTMLElement} card @param {Point} at @param {Size} size of the picture */
export function placeCard(card, at, size) {
  const [wide, high] = [card.offsetWidth, card.offsetHeight];
  const x = at[0] + GAP + wide < size.width - EDGE ? at[0] + GAP : at[0] - GAP - wide;
  const y = at[1] + GAP + high < size.height - EDGE ? at[1] + GAP : at[1] - GAP - high;
  card.style.transform = `translate(${Math.round(Math.max(EDGE, x))}px, ${Math.round(Math.max(EDGE, y))}px)`;
}

/** @param {string | Node} label @param {string} value */
export const entry = (label, value) => h("div", { class: "probe-row" }, h("span", {}, label), h("span", { class: "number" }, value));

/** Fractions as parts of a bar. @param {readonly number[]} fractions @param {readonly {color: string}[]} materials */
export function fractionBar(fractions, materials) {
  const bar = h("div", { class: "fraction-bar" });
  fractions.forEach((fraction, i) => {
    if (fraction < NOTHING) return;
    const part = h("span", {});
    part.style.flexGrow = String(fraction);
    part.style.backgroundColor = materials[i]?.color ?? "";
    bar.append(part);
  });
  return bar;
}

/** A measure with its name, in a group beside the picture. @param {string} text @param {Node | string} value @param {string} name */
export const fact = (text, value, name) =>
  h("div", { class: "space-fact", "data-fact": name }, h("span", {}, text), h("span", { class: "strong number" }, value));
