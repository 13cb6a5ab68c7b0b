/**
 * The chosen composition key in numbers: its place and its mix.
 *
 * @import { App } from "../state/app.js"
 */
import { mixingControl } from "../controls/mixing.js";
import { numberField } from "../controls/number-field.js";
import { row } from "../controls/row.js";
import { attribute, h, write } from "../dom.js";
import { curveName } from "../state/app.js";
import { setMix } from "../state/composition.js";
import { holds, threeMaterials, usedMaterials } from "../state/materials.js";
import { insertAfter, remove, slide } from "../stage/key-edits.js";
import { strings } from "../strings.js";
import { newRun } from "../controls/run.js";
import { editing } from "./edit.js";

/** Largest place: the seam itself is 0. */
const LAST = 0.999999;

/** @param {App} app */
export function createKeyPanel(app) {
  const words = strings.composition;
  const chosen = () => app.ui.value.key ?? { curve: /** @type {const} */ (0), index: 0 };
  const current = () => app.store.document.curves[chosen().curve]?.composition[chosen().index];

  const place = numberField(
    { label: words.place, name: "key-at", min: 0, max: LAST, step: 0.01, decimals: 3 },
    {
      ...editing(app, (document) => document),
      change: (value, run) => {
        const key = current();
        if (key) slide(app, chosen(), value - key.at, run ?? newRun("key-at"));
        if (run === undefined) app.store.endRun();
      },
    },
  );
  const add = h("button", { type: "button", class: "command-word", "data-action": "add-key" }, words.add);
  const removing = h("button", { type: "button", class: "command-word", "data-action": "remove-key" }, words.remove);
  add.addEventListener("click", () => insertAfter(app, chosen()));
  removing.addEventListener("click", () => remove(app, chosen()));
  const mixing = mixingControl(
    editing(app, (document, mix) => setMix(document, chosen().curve, chosen().index, mix)),
  );
  const title = h("span", { class: "key-title" });
  const placeRow = row(words.place, place);
  const element = h(
    "div",
    { class: "key-panel", "data-key-panel": "" },
    h("div", { class: "key-head" }, title, add, removing),
    placeRow,
    mixing.element,
  );

  return {
    element,
    render() {
      const { document } = app.store;
      const { curve, index } = chosen();
      const key = current();
      element.hidden = !key;
      if (!key) return;
      const keys = document.curves[curve].composition;
      write(title, words.key(index + 1, keys.length, curveName(document, curve)));
      place.set(key.at);
      removing.disabled = keys.length < 2;
      attribute(removing, "title", removing.disabled ? words.lastStays : null);
      const here = document.materials.map((_, i) => i).filter((i) => holds(document.curves[curve], i));
      mixing.render({
        materials: document.materials,
        mix: key.mix,
        used: here.length > 1 ? here : usedMaterials(document),
        three: threeMaterials(document),
      });
    },
  };
}
