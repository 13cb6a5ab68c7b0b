/** What a status line is made of. */
import { h } from "../dom.js";

/** A measure with its words. @param {string} name @param {...Node} parts */
export const item = (name, ...parts) => h("span", { class: "item", "data-total": name }, ...parts);

/** @param {string} text */
export const label = (text) => h("span", {}, text);

/** @param {string | Node} text */
export const strong = (text) => h("span", { class: "strong number" }, text);

/** @param {string} name @param {string} text @param {() => void} act */
export const command = (name, text, act) => h("button", { type: "button", class: "command", "data-command": name, onclick: act }, text);
