/**
 * How cells continue each other at the chosen corner, and switches for it: for each face there, shape and material apart.
 *
 * @import { MarkName } from "../../../../js/directrix.js"
 * @import { Operation } from "../edits.js"
 * @import { Around } from "./around.js"
 */
import { segment } from "../../controls/choices.js";
import { row } from "../../controls/row.js";
import { select } from "../../controls/select.js";
import { h, write } from "../../dom.js";
import { words } from "./words.js";

const said = words.continuity;

/** @param {(operation: Operation, told: string) => void} append */
export function continuityRows(append) {
  let at = 0;
  let drawn = "";
  /** @type {"corner" | "face"} */
  let where = "corner";
  /** @type {Around["neighbourhood"]["joints"]} */
  let joints = [];
  /** What was switched and is not answered yet. @type {{known: unknown, what: "shape" | "material", kind: MarkName} | null} */
  let pending = null;
  /** The body that is looked at. */
  let known = /** @type {unknown} */ (null);
  const kinds = /** @type {const} */ (["C1", "C0", "none"]).map((value) => ({ value, text: said.kinds[value === "none" ? "none" : value] }));
  const switches = /** @type {const} */ (["shape", "material"]).map((what) => ({ what, control: segment({ label: said[what], name: `joint-${what}`, choices: kinds }, (value) => set(what, value)) }));
  const reach = segment(
    { label: said.where, name: "joint-where", choices: /** @type {const} */ (["corner", "face"]).map((value) => ({ value, text: said.wheres[value] })) },
    (value) => (where = value),
  );
  reach.set(where);
  const choice = h("div", {});
  /** @type {ReturnType<typeof select> | null} */
  let joint = null;
  const note = h("p", { class: "body-note" });
  const rows = h("div", {}, choice, row(said.where, reach), ...switches.map(({ what, control }) => row(said[what], control)));
  const element = h("div", { class: "body-part" }, h("h3", { class: "body-label" }, said.heading), rows, note);

  /** @param {"shape" | "material"} what @param {MarkName} kind */
  function set(what, kind) {
    const [side] = joints[at]?.sides ?? [];
    if (!side) return;
    pending = { known, what, kind };
    const corner = where === "corner" ? { corner: /** @type {[number, number, number]} */ ([...side.corner]) } : {};
    append({ op: "continuity", cell: side.cell, face: side.face, ...corner, [what]: kind }, said.set(said[what], said.kinds[kind]));
  }

  return {
    element,
    /** The face that is looked at. */
    get joint() {
      return joints[at] ?? null;
    },
    /** @param {Around | null} around */
    render(around) {
      joints = around?.neighbourhood.joints ?? [];
      known = around?.known ?? null;
      if (pending?.known !== known) pending = null;
      element.hidden = !around;
      at = Math.min(at, Math.max(0, joints.length - 1));
      rows.hidden = joints.length === 0;
      const key = JSON.stringify(joints.map(({ sides }) => sides));
      if (key !== drawn) {
        drawn = key;
        joint = select({ label: said.joint, name: "joint", choices: joints.map(({ sides: [a, b] }, n) => ({ value: String(n), text: said.name(a, b) })) }, (value) => {
          at = Number(value);
          show();
        });
        choice.replaceChildren(row(said.joint, joint));
      }
      joint?.set(String(at));
      show();
    },
  };

  function show() {
    const found = joints[at];
    if (!found) {
      write(note, said.none);
      return;
    }
    for (const { what, control } of switches) control.set(pending?.what === what ? pending.kind : found[what]);
    const how = (/** @type {boolean} */ isMarked) => (isMarked ? said.marked : said.found);
    write(note, said.says(how(found.shapeMarked), how(found.materialMarked)));
  }
}
