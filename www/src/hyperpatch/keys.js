/**
 * The keys of the workbench: the camera, the chosen corner, and the reading in the middle.
 *
 * @import { Vector } from "../space/vector.js"
 * @import { createCorner } from "./corner.js"
 * @import { Known } from "./runner.js"
 * @import { Shown } from "./state.js"
 * @import { createBodyView } from "./view.js"
 */
import { groundStep, moveOf } from "../space/keys.js";
import { isElsewhere } from "../space/stand.js";
import { scaled } from "../space/vector.js";
import { nudgeOf } from "./groups.js";

/**
 * @param {object} of
 * @param {HTMLElement} of.keyboard where the picture's own keys are heard
 * @param {ReturnType<typeof createBodyView> | null} of.view
 * @param {ReturnType<typeof createCorner>} of.corner
 * @param {(patch: Partial<Shown>) => void} of.change
 * @param {() => {known: Known | null, shown: Shown}} of.now
 * @returns {() => void} ends the listening
 */
export function listenToKeys({ keyboard, view, corner, change, now }) {
  const over = new AbortController();
  const { signal } = over;
  keyboard.addEventListener("blur", corner.release, { signal });
  addEventListener("keydown", key, { signal });

  /** @param {KeyboardEvent} event */
  function key(event) {
    const { known, shown } = now();
    if (isElsewhere(event) || !known) return;
    const isOnPicture = event.target === keyboard;
    if (isOnPicture) keyboard.classList.add("keyed");
    const step = isOnPicture && shown.corner ? cornerStep(event) : null;
    const move = step ? null : moveOf(event, isOnPicture);
    if (step) corner.press(step);
    else if (move && view) view.move(move);
    else if (isOnPicture && (event.key === "PageDown" || event.key === "PageUp")) corner.chooseNext(event.key === "PageDown" ? 1 : -1);
    else if (event.key === "Enter" && isOnPicture) view?.readMiddle(true);
    else if (event.key === "Escape" && (view?.readMiddle(false) || shown.corner || shown.cell !== null)) change({ corner: null, cell: null });
    else return;
    event.preventDefault();
  }

  /** What a key moves the chosen corner by: arrows over the ground as the camera sees it, Home and End up and down. @param {KeyboardEvent} event @returns {Vector | null} */
  function cornerStep({ key, shiftKey, altKey }) {
    const along = groundStep(key, view?.camera.azimuth ?? -90);
    return along && scaled(along, nudgeOf(now().known) * (shiftKey ? 10 : altKey ? 0.1 : 1));
  }

  return () => over.abort();
}
