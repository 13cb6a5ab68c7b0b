/**
 * The one live region: what is said last within a moment is what is spoken.
 */
import { find } from "../dom.js";

/** Milliseconds gathered into one sentence, so that a held key does not flood a screen reader. */
const MOMENT = 150;

/** @returns {(text: string) => void} */
export function createSpeech() {
  const region = find("#speech");
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let timer;
  return (text) => {
    clearTimeout(timer);
    timer = setTimeout(() => {
      // The same sentence twice is spoken twice only if the text differs.
      region.textContent = region.textContent === text ? `${text}\u00a0` : text;
    }, MOMENT);
  };
}
