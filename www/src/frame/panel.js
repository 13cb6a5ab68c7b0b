/**
 * A panel over the canvas for a task of its own: gallery, import, export, shortcuts. It is not modal: the figure stays at
 * work beside it. One panel is open at a time; Escape or its cross closes it and gives the focus back.
 *
 * @typedef {object} Panel
 * @property {HTMLElement} element
 * @property {() => void} close
 */
import { find, h } from "../dom.js";
import { icon } from "../icons.js";
import { strings } from "../strings.js";

/** @type {Panel & {name: string} | null} */
let shown = null;

/**
 * Opens a panel in place of any other. Asking again for the one that is open closes it and gives null.
 * @param {object} options
 * @param {string} options.name for the data attribute
 * @param {string} options.heading
 * @param {(Node | string)[]} options.body
 * @param {boolean} [options.wide]
 * @param {boolean} [options.tall] on a phone it takes the whole screen below the bar, not only the canvas
 * @param {() => void} [options.onclose] called once, however it is closed
 * @returns {Panel | null}
 */
export function openPanel({ name, heading, body, wide = false, tall = false, onclose }) {
  const same = shown?.name === name;
  shown?.close();
  if (same) return null;
  const before = document.activeElement;
  const title = h("h2", { id: `panel-${name}`, tabIndex: -1 }, heading);
  const cross = h(
    "button",
    { type: "button", class: "bare icon-only", "aria-label": strings.panel.close, title: strings.panel.close },
    icon("cross", 14),
  );
  cross.dataset.close = name;
  const cover = tall && matchMedia("(width < 600px)").matches;
  const element = h(
    "section",
    { class: ["panel", wide && "wide", cover && "cover"].filter(Boolean).join(" "), "aria-labelledby": title.id, "data-panel": name, "data-furniture": "" },
    h("header", { class: "panel-head" }, title, cross),
    h("div", { class: "panel-body" }, ...body),
  );
  const close = () => {
    if (shown?.element !== element) return;
    shown = null;
    const held = element.contains(document.activeElement);
    element.remove();
    onclose?.();
    if (held && before instanceof HTMLElement) before.focus();
  };
  cross.addEventListener("click", close);
  element.addEventListener("keydown", (event) => {
    // Keys of the figure are none here; those of the whole page, with Ctrl, are.
    if (!event.ctrlKey && !event.metaKey) event.stopPropagation();
    if (event.key === "Escape") close();
  });
  (cover ? document.body : find("#stage")).append(element);
  shown = { name, element, close };
  title.focus();
  return shown;
}
