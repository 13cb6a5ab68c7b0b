/** Whether a figure stands on a light or a dark page. */

/**
 * Light or dark, as the place of an element asks for: by the first colour behind it, else by the colour scheme of its page.
 *
 * @param {Element} element
 * @param {Element} paper an element in it that has the background `Canvas`
 * @returns {"light" | "dark"}
 */
export function themeAround(element, paper) {
  for (let each = parentOf(element); each; each = parentOf(each)) {
    const color = channels(getComputedStyle(each).backgroundColor);
    if (color[3] > 127) return isDark(color) ? "dark" : "light";
  }
  return isDark(channels(getComputedStyle(paper).backgroundColor)) ? "dark" : "light";
}

/** Luma, as of ITU-R BT.601, below half of its range. @param {Uint8ClampedArray} color */
const isDark = ([red, green, blue]) => 0.299 * red + 0.587 * green + 0.114 * blue < 128;

/**
 * Calls `change` when something happens that may change the theme of a page: the system's scheme, or a class or an attribute of its root.
 *
 * @param {() => void} change
 * @returns {() => void} ends it
 */
export function watchTheme(change) {
  const system = matchMedia("(prefers-color-scheme: dark)");
  const observer = new MutationObserver(change);
  system.addEventListener("change", change);
  for (const each of [document.documentElement, document.body]) observer.observe(each, { attributes: true });
  // Of a colour that takes its time.
  document.documentElement.addEventListener("transitionend", change);
  return () => {
    system.removeEventListener("change", change);
    observer.disconnect();
    document.documentElement.removeEventListener("transitionend", change);
  };
}

/** @param {Element} element */
function parentOf(element) {
  const { parentNode } = element;
  return parentNode instanceof ShadowRoot ? parentNode.host : element.parentElement;
}

/** @type {CanvasRenderingContext2D | null | undefined} */
let context;
/** @type {Map<string, Uint8ClampedArray>} */
const known = new Map();

/** Red, green, blue and alpha of a colour in any notation. @param {string} color */
function channels(color) {
  const found = known.get(color);
  if (found) return found;
  if (context === undefined) {
    const canvas = document.createElement("canvas");
    canvas.width = canvas.height = 1;
    context = canvas.getContext("2d", { willReadFrequently: true });
  }
  if (!context) return new Uint8ClampedArray(4);
  context.clearRect(0, 0, 1, 1);
  context.fillStyle = color;
  context.fillRect(0, 0, 1, 1);
  const { data } = context.getImageData(0, 0, 1, 1);
  known.set(color, data);
  return data;
}
