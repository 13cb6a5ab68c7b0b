/**
 * What stands round a picture in space: the place that keys are heard on, the buttons of the camera, and the picture's own size.
 *
 * @import { StandardView } from "./camera.js"
 * @import { Viewer } from "./viewer.js"
 *
 * @typedef {object} StandWords
 * @property {string} keyboard
 * @property {string} keyboardHelp
 * @property {{region: string, in: string, out: string, fit: string}} zoom
 *
 * @typedef {object} Stand
 * @property {HTMLElement} picture canvas, keys and marks
 * @property {HTMLElement} keyboard
 * @property {HTMLElement} help what a screen reader says of the keys
 * @property {HTMLElement} zoom
 */
import { shownKey } from "../commands.js";
import { h } from "../dom.js";
import { icon } from "../icons.js";
import { keyOf } from "./keys.js";
import { NoWebGl } from "./space.js";

/** Factor of one press of a zoom button. */
const ZOOM = 1.25;

/**
 * A picture, or null where the browser has no WebGL 2.
 * @template T
 * @param {() => T} make
 */
export function whereDrawn(make) {
  try {
    return make();
  } catch (error) {
    if (error instanceof NoWebGl) return null;
    throw error;
  }
}

/**
 * @param {object} options
 * @param {string} options.name before the names of its parts
 * @param {StandWords} options.words
 * @param {(Pick<Viewer, "canvas" | "move"> & {overlays: Node[]}) | null} options.view null where nothing is drawn
 * @returns {Stand}
 */
export function createStand({ name, words, view }) {
  const help = h("p", { id: `${name}-help`, class: "spoken" }, words.keyboardHelp);
  const keyboard = h("div", {
    id: `${name}-keys`,
    class: "space-keys",
    tabIndex: 0,
    role: "application",
    "aria-label": words.keyboard,
    "aria-describedby": help.id,
    [`data-${name}-keys`]: "",
  });
  /** @param {string} face @param {string} label @param {string} key @param {import("./keys.js").Move} move */
  const button = (face, label, key, move) =>
    h(
      "button",
      { type: "button", class: "bare icon-only", [`data-${name}-zoom`]: face, "aria-label": label, title: `${label} (${shownKey(key)})`, onclick: () => view?.move(move) },
      icon(face),
    );
  const zoom = h(
    "div",
    { class: "zoom", role: "group", "aria-label": words.zoom.region, "data-furniture": "" },
    button("minus", words.zoom.out, "-", { zoom: 1 / ZOOM }),
    button("plus", words.zoom.in, "+", { zoom: ZOOM }),
    button("fit", words.zoom.fit, "F", { fit: true }),
  );
  const picture = h("div", { class: "space-picture" }, ...(view ? [view.canvas] : []), keyboard, .../** @type {any[]} */ (view?.overlays ?? []));
  view?.canvas.addEventListener("click", () => {
    keyboard.focus({ preventScroll: true });
    keyboard.classList.remove("keyed");
  });
  return { picture, keyboard, help, zoom };
}

/**
 * Keeps a view as large as its picture.
 * @param {HTMLElement} picture
 * @param {Pick<Viewer, "resize" | "request"> | null} view
 * @param {() => {top: number, bottom: number}} covered CSS pixels that something covers at the edges
 */
export function followSize(picture, view, covered) {
  function resize() {
    const { clientWidth: width, clientHeight: height } = picture;
    if (width > 0 && height > 0) view?.resize({ size: { width, height }, ...covered() });
  }
  const observer = new ResizeObserver(() => {
    resize();
    view?.request();
  });
  observer.observe(picture);
  return { resize, close: () => observer.disconnect() };
}

/**
 * The standard views as buttons.
 * @param {string} name before the names of the buttons
 * @param {{view: string, views: {[view in StandardView]: string}, viewsLong: {[view in StandardView]: string}}} words
 * @param {(view: StandardView) => void} look
 */
export function viewButtons(name, words, look) {
  const buttons = /** @type {const} */ (["iso", "front", "side", "top"]).map((view) =>
    h(
      "button",
      { type: "button", class: "push space-view", [`data-${name}-view`]: view, title: `${words.viewsLong[view]} (${shownKey(keyOf(view))})`, onclick: () => look(view) },
      words.views[view],
    ),
  );
  return h("div", { class: "space-views", role: "group", "aria-label": words.view }, ...buttons);
}

/** Whether a key that is pressed there is meant for something else than a picture. @param {KeyboardEvent} event */
export function isElsewhere(event) {
  if (event.defaultPrevented || event.ctrlKey || event.metaKey) return true;
  const target = event.target instanceof Element ? event.target : null;
  return Boolean(target?.closest("input[type=text], select, textarea, [data-panel], [role=menu], [role=tab]"));
}
