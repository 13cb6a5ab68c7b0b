/** Marks over the picture. */
import { attribute } from "../dom.js";

/** Puts a mark at a place on the screen, or away. @param {SVGElement} mark @param {import("../types.js").Point | null} at */
export function put(mark, at) {
  mark.style.display = at ? "" : "none";
  if (at) attribute(mark, "transform", `translate(${at[0].toFixed(1)} ${at[1].toFixed(1)})`);
}
