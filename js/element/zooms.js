/**
 * The buttons that come nearer, go farther and show everything, for pictures that have a camera or a view.
 *
 * @typedef {"farther" | "nearer" | "fit"} Zoom
 */
import { h } from "./dom.js";

const SHAPES = {
  farther: "M3.5 8h9",
  nearer: "M3.5 8h9M8 3.5v9",
  fit: "M6 2.5H2.5V6M10 2.5h3.5V6M6 13.5H2.5V10M10 13.5h3.5V10",
};
const SVG = "http://www.w3.org/2000/svg";

/**
 * @param {string} label of all
 * @param {{ [name in Zoom]: string }} names
 * @param {(zoom: Zoom) => void} act
 */
export function createZooms(label, names, act) {
  const buttons = /** @type {Zoom[]} */ (Object.keys(SHAPES)).map((name) => {
    const face = document.createElementNS(SVG, "svg");
    const size = { viewBox: "0 0 16 16", width: "16", height: "16", "aria-hidden": "true" };
    for (const [key, value] of Object.entries(size)) face.setAttribute(key, value);
    const path = document.createElementNS(SVG, "path");
    path.setAttribute("d", SHAPES[name]);
    face.append(path);
    const button = h("button", { type: "button", "aria-label": names[name], title: names[name], "data-zoom": name }, face);
    button.addEventListener("click", () => act(name));
    return button;
  });
  return h("div", { class: "zooms", role: "group", "aria-label": label }, ...buttons);
}

/** For the sheets of those that have them. */
export const ZOOMS_CSS = `
.zooms { display: flex; flex: none; gap: 2px; }
.zooms button { width: var(--height); height: var(--height); }
.zooms button:hover { background: var(--hover); }
.zooms svg { display: block; fill: none; stroke: currentColor; stroke-width: 1.5; stroke-linecap: round; stroke-linejoin: round; }
.frame:not([data-controls="full"]) .zooms { display: none; }
@container (width < 440px) { .zooms { display: none; } }
@media (forced-colors: active) { .zooms button { border: 1px solid ButtonText; } }
`;
