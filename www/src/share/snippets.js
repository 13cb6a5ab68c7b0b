/**
 * HTML that puts a figure into somebody's page.
 *
 * @import { Link } from "../../../js/directrix.js"
 *
 * @typedef {"column" | "medium" | "small"} Size `column`: as wide as the text round it
 */

/** Where the element's module lies, beside the page. */
const MODULE = "element.js";

/** @type {{[size in Size]: {style: string, width: string, height: string}}} */
const SIZES = {
  column: { style: "width: 100%; height: 400px", width: "100%", height: "400" },
  medium: { style: "width: 640px; height: 400px", width: "640", height: "400" },
  small: { style: "width: 400px; height: 300px", width: "400", height: "300" },
};

/**
 * The custom element with the script that defines it.
 * @param {Omit<Link, "document" | "url"> & {src?: string}} attributes
 * @param {Size} size
 * @param {string} alt
 */
export function elementCode(attributes, size, alt) {
  const module = new URL(MODULE, `${location.origin}${location.pathname}`).href;
  const all = { ...attributes, alt, style: SIZES[size].style };
  const pairs = Object.entries(all).map(([name, value]) => `${name}="${escaped(String(value))}"`);
  return `<script type="module" src="${escaped(module)}"></script>\n<directrix-figure\n  ${pairs.join("\n  ")}\n></directrix-figure>`;
}

/**
 * @param {string} link to the page of a figure alone
 * @param {Size} size
 * @param {string} title
 */
export function frameCode(link, size, title) {
  const { width, height } = SIZES[size];
  const pairs = [
    ["src", link],
    ["title", title],
    ["width", width],
    ["height", height],
    ["loading", "lazy"],
    ["style", "border: 0"],
  ].map(([name = "", value = ""]) => `${name}="${escaped(value)}"`);
  return `<iframe\n  ${pairs.join("\n  ")}\n></iframe>`;
}

/** Text inside an attribute in double quotes. @param {string} text */
const escaped = (text) => text.replaceAll("&", "&amp;").replaceAll('"', "&quot;").replaceAll("<", "&lt;").replaceAll(">", "&gt;");
