/**
 * The keyboard of the step view: steps from anywhere on the page, vertices of the curves where the picture has the focus.
 *
 * @typedef {object} Acts
 * @property {() => boolean} isReady whether there are steps
 * @property {() => boolean} isHidden whether a line is to be guessed
 * @property {(by: number) => void} moveAlong to the next vertex of the curve
 * @property {() => void} changeCurve
 * @property {(at: number) => void} goTo
 * @property {(by: number) => void} goBy
 * @property {() => void} toggle play or pause
 * @property {() => boolean} settle takes the guess, or goes on after it; false where nothing is to be guessed
 * @property {() => boolean} leave gives up the chosen vertex, or the game; false where there is neither
 */
import { h } from "../dom.js";
import { words } from "./words.js";

/**
 * @param {HTMLElement} aside where Page up, Page down, Home and End scroll
 * @param {Acts} acts
 */
export function createKeyboard(aside, acts) {
  const element = h("div", {
    id: "steps-keys",
    class: "steps-keys",
    tabIndex: 0,
    role: "application",
    "aria-label": words.keyboard,
    "aria-describedby": "steps-help",
  });
  const help = h("p", { id: "steps-help", class: "spoken" }, words.keyboardHelp);
  const over = new AbortController();
  addEventListener("keydown", press, { signal: over.signal });

  /** @param {KeyboardEvent} event */
  function press(event) {
    element.classList.add("keyed");
    if (event.defaultPrevented || event.ctrlKey || event.metaKey || event.altKey || !acts.isReady()) return;
    const target = event.target instanceof Element ? event.target : null;
    if (target?.closest("input, select, textarea, [data-panel], [role=menu], [role=tab]")) return;
    if (act(event.key, target)) event.preventDefault();
  }

  /** @param {string} key @param {Element | null} target @returns {boolean} whether the key means something here */
  function act(key, target) {
    const onButton = target !== null && target.closest("button, a") !== null;
    const onCanvas = target === element;
    const inAside = target !== null && aside.contains(target);
    const along = { ArrowRight: 1, ArrowLeft: -1 }[key];
    if (along !== undefined) {
      if (onCanvas || acts.isHidden()) acts.moveAlong(along);
      else acts.goBy(along);
    } else if ((key === "ArrowUp" || key === "ArrowDown") && onCanvas) acts.changeCurve();
    else if (key === "PageDown" && !inAside) acts.goBy(1);
    else if (key === "PageUp" && !inAside) acts.goBy(-1);
    else if (key === "Home" && !inAside) acts.goTo(0);
    else if (key === "End" && !inAside) acts.goTo(Infinity);
    else if (key === " " && !onButton) acts.toggle();
    else if (key === "Enter") return !onButton && acts.settle();
    else return key === "Escape" && acts.leave();
    return true;
  }

  return {
    elements: [element, help],
    /** Takes the focus for keys alone, without the ring that shows it to who uses them. */
    take() {
      element.focus({ preventScroll: true });
      element.classList.remove("keyed");
    },
    focus: () => element.focus({ preventScroll: true }),
    close: () => over.abort(),
  };
}
