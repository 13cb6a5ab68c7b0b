/**
 * What there is to a chosen corner besides its place: its neighbours, what moves with it, and how cells continue each other there.
 *
 * @import { App } from "../../state/app.js"
 * @import { createCorner } from "../corner.js"
 * @import { Operation } from "../edits.js"
 * @import { Known } from "../runner.js"
 * @import { Shown } from "../state.js"
 * @import { Around } from "./around.js"
 */
import { checkBox, segment } from "../../controls/choices.js";
import { row } from "../../controls/row.js";
import { h, write } from "../../dom.js";
import { bodyOf } from "../document.js";
import { isCorner, placeOfCorner } from "../edits.js";
import { continuityRows } from "./continuity-rows.js";
import { cornerGrid } from "./corner-grid.js";
import { words } from "./words.js";

const said = words.also;

/**
 * @param {App} app
 * @param {object} of
 * @param {() => {known: Known | null, shown: Shown}} of.now
 * @param {() => Around | null} of.around
 * @param {ReturnType<typeof createCorner>} of.corner
 * @param {(patch: Partial<Shown>) => void} of.change
 * @param {(operation: Operation) => void} of.append
 */
export function cornerRows(app, { now, around, corner, change, append }) {
  const grid = cornerGrid((place, point, spoken) => {
    const { shown } = now();
    if (!shown.corner) return;
    // The corner is a coefficient of its own.
    const own = placeOfCorner(shown.corner);
    const isItself = isCorner(place.at) && point.users.some(({ cell, at }) => cell === own.cell && at.every((along, k) => along === own.at[k]));
    const user = point.users.find(({ cell }) => cell === own.cell) ?? place;
    change({ at: isItself ? null : user, others: isItself ? shown.others : [] });
    app.say(spoken);
  });
  const several = checkBox({ name: "corner-several", text: [said.several] }, (on) => change({ picksCorners: on }));
  const count = h("span", { class: "number body-chosen-count" });
  const only = h("button", { type: "button", class: "command-word", "data-corners": "only", onclick: () => change({ others: [] }) }, said.clear);
  const mirror = segment(
    { label: said.mirror, name: "corner-mirror", choices: /** @type {const} */ (["off", "x", "y", "z"]).map((value) => ({ value, text: said.planes[value] })) },
    (value) => change({ mirror: value }),
  );
  const middle = checkBox({ name: "corner-middle", text: [said.middle] }, (on) => change({ isMiddle: on }));
  const opposite = h("p", { class: "body-note" });
  const joints = continuityRows((operation, told) => {
    append(operation);
    app.say(told);
  });
  const element = h(
    "div",
    {},
    h("div", { class: "body-choosing" }, several.element, count, only),
    row(said.mirror, mirror),
    middle.element,
    opposite,
    joints.element,
  );
  return {
    element,
    /** The small grid, which stands by itself below the place. */
    grid: grid.element,
    get joint() {
      return joints.joint;
    },
    render() {
      const { shown } = now();
      element.hidden = grid.element.hidden = !shown.corner;
      if (!shown.corner) return;
      const found = around();
      grid.render(found, shown.at ?? placeOfCorner(shown.corner), bodyOf(app).materials);
      several.set(shown.picksCorners);
      const { length } = shown.others;
      write(count, length > 0 ? said.count(length) : "");
      only.hidden = length === 0;
      mirror.set(shown.mirror);
      middle.element.hidden = shown.mirror === "off";
      middle.set(shown.isMiddle);
      const across = corner.opposite();
      opposite.hidden = across === null;
      write(opposite, across === null ? "" : said[across]);
      joints.render(found);
    },
  };
}
