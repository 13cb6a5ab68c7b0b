/**
 * The switch between the two blends of two closed curves and their difference, in the group Blend.
 *
 * @import { App } from "../state/app.js"
 */
import { segment } from "../controls/choices.js";
import { h, write } from "../dom.js";
import { hasLooks } from "../state/look.js";
import { differenceText } from "./legend.js";
import { lookOf, setLook } from "./look.js";
import { words } from "./words.js";

const LOOKS = /** @type {const} */ (["ruled", "harmonic", "difference"]);

/**
 * @param {App} app
 * @param {HTMLElement} place
 * @returns {{render: () => void}}
 */
export function createLooks(app, place) {
  const choice = segment(
    { label: words.look, name: "look", choices: LOOKS.map((value) => ({ value, text: words.looks[value] })) },
    (value) => setLook(app, value),
  );
  const note = h("p", { class: "note", "data-look-note": "" });
  place.append(h("div", { class: "wide-row" }, h("span", { class: "row-label" }, words.look), choice.element), note);
  return {
    render() {
      place.hidden = !hasLooks(app.store.document);
      choice.set(lookOf(app));
      const difference = differenceText(app);
      write(note, difference === "" ? words.lookHelp : `${difference}. ${words.lookHelp}`);
    },
  };
}
