/**
 * The mix of chosen cells, of a corner or of one coefficient, and the slope of the material at a corner.
 *
 * @import { App } from "../../state/app.js"
 * @import { Known } from "../runner.js"
 * @import { Shown } from "../state.js"
 * @import { Operation, Place } from "../edits.js"
 * @import { Around } from "./around.js"
 * @import { Mode } from "./mix.js"
 */
import { mixingControl } from "../../controls/mixing.js";
import { row } from "../../controls/row.js";
import { select } from "../../controls/select.js";
import { attribute, h, write } from "../../dom.js";
import { placeOf } from "../cell.js";
import { bodyOf } from "../document.js";
import { placeOfCorner } from "../edits.js";
import { MODES, mixTarget, triple, wholePercents } from "./mix.js";
import { threeOf } from "./operation-numbers.js";
import { profile } from "./profile.js";
import { words } from "./words.js";

const said = words.material;
/**
 * @param {App} app
 * @param {object} of
 * @param {() => {known: Known | null, shown: Shown}} of.now
 * @param {() => Around | null} of.around
 * @param {() => Around["neighbourhood"]["joints"][number] | null} of.joint the face at the corner that is looked at
 * @param {(operation: Operation, run?: string) => void} of.append
 */
export function materialRows(app, { now, around, joint, append }) {
  /** The one that was picked; before that it follows what is chosen. @type {Mode | null} */
  let picked = null;
  /** @type {Mode} */
  let mode = "cells";
  const choice = select({ label: said.mode, name: "mix-mode", choices: MODES.map((value) => ({ value, text: said.modes[value] })) }, (value) => {
    picked = value;
    render();
  });
  const note = h("p", { class: "body-note", "data-mix-note": "" });
  const mixing = mixingControl({
    change(mix, run) {
      const target = mixTarget(mode, now().shown);
      if (target) append(/** @type {Operation} */ ({ op: "mix", ...target, mix }), run);
    },
    end: () => app.store.endRun(),
    cancel: (run) => void app.store.cancel(run),
  });
  const rules = /** @type {const} */ (["flat", "natural"]).map((rule) =>
    h(
      "button",
      {
        type: "button",
        class: "push",
        "data-slope": rule,
        onclick() {
          const { corner } = now().shown;
          if (!corner) return;
          append({ op: "slope", cell: corner.cell, corner: triple(corner.corner), rule });
          app.say(said.sloped(said[rule]));
        },
      },
      said[rule],
    ),
  );
  const drawing = profile();
  const rulesRow = row(said.slope, { element: h("span", { class: "body-rules" }, ...rules) });
  const slope = h("div", {}, rulesRow, drawing.element, h("p", { class: "body-note" }, said.slopeNote));
  const element = h("div", { class: "body-part" }, h("h3", { class: "body-label" }, said.heading), row(said.mode, choice), note, mixing.element, slope);

  /** A coefficient whose mix stands for the target. @returns {Place | null} */
  function sample() {
    const { shown } = now();
    if (mode === "cells") return shown.cells.length > 0 ? { cell: shown.cells[shown.cells.length - 1], at: [0, 0, 0] } : null;
    return shown.corner && (mode === "at" && shown.at ? shown.at : placeOfCorner(shown.corner));
  }

  /** The mix as the target has it, or the mean of a cell. @returns {number[] | null} */
  function current() {
    const { known } = now();
    const place = sample();
    const cell = place && known?.cellOf(place.cell);
    const target = mixTarget(mode, now().shown);
    if (!cell || !place || !target) return null;
    // What the document says last, while the module has not answered yet.
    const last = bodyOf(app).operations.at(-1);
    if (last?.op === "mix" && known && last !== known.document.operations.at(-1)) return last.mix;
    if (mode !== "cells") return /** @type {number[]} */ (cell.coefficients[placeOf(place.at[0], place.at[1], place.at[2])].mix);
    const { length } = cell.coefficients;
    return wholePercents(bodyOf(app).materials.map((_, i) => cell.coefficients.reduce((sum, { mix = [] }) => sum + (mix[i] ?? 0) / length, 0)));
  }

  function render() {
    const { shown } = now();
    const { materials } = bodyOf(app);
    mode = picked ?? (shown.corner ? (shown.at ? "at" : "corner") : "cells");
    choice.set(mode);
    const mix = current();
    mixing.element.hidden = !mix;
    attribute(note, "class", mix ? "body-note" : "body-note needs");
    write(note, !mix ? said.needs[mode] : mode === "cells" ? said.about.cells(shown.cells.length) : said.about[mode]);
    if (mix) mixing.render({ materials, mix: materials.map((_, i) => mix[i] ?? 0), used: materials.map((_, i) => i), three: threeOf(materials) });
    const found = around();
    slope.hidden = !found || mode === "cells";
    const { known } = now();
    if (found && known) drawing.render(known, joint(), materials);
  }

  return { element, render };
}
