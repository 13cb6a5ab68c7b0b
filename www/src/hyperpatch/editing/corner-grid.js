/**
 * The coefficients at a corner as a small grid: layers along w, in each of them u to the right and v upwards. A corner of eight cells has 27, one
 * of a single cell 8. One stop of the keyboard; the arrow keys go through it.
 *
 * @import { Material } from "../../types.js"
 * @import { Place } from "../edits.js"
 * @import { Around, Point } from "./around.js"
 * @import { Node } from "./grid.js"
 */
import { attribute, h, write } from "../../dom.js";
import { coordinate, percent } from "../../format.js";
import { NOTHING } from "../../space/card.js";
import { mixed } from "../../oklab.js";
import { isPlace, pointOf } from "./around.js";
import { nodesOf } from "./grid.js";
import { words } from "./words.js";

/** What a node is called. @param {Node} node @param {boolean} isRegular */
const nameOf = ({ at, isCorner }, isRegular) => (isCorner ? words.grid.corner : isRegular ? words.grid.point(at) : words.grid.inner(at));

/** @param {(place: Place, point: Point, spoken: string) => void} choose */
export function cornerGrid(choose) {
  const element = h("div", { class: "corner-grid", role: "group", "aria-label": words.grid.region, "aria-describedby": "corner-grid-help", "data-corner-grid": "" });
  const about = h("p", { class: "body-note" });
  const whole = h("div", {}, h("p", { id: "corner-grid-help", hidden: true }, words.grid.help), element, about);
  /** @type {{node: Node, button: HTMLButtonElement}[]} */
  let buttons = [];
  let drawn = "";

  element.addEventListener("keydown", (event) => {
    const by = { ArrowRight: [1, 0, 0], ArrowLeft: [-1, 0, 0], ArrowUp: [0, 1, 0], ArrowDown: [0, -1, 0], PageUp: [0, 0, 1], PageDown: [0, 0, -1] }[event.key];
    const here = buttons.find(({ button }) => button === document.activeElement);
    if (!by || !here || event.altKey || event.ctrlKey || event.metaKey) return;
    event.preventDefault();
    const to = here.node.at.map((along, k) => along + by[k]);
    const next = buttons.find(({ node }) => node.at.every((along, k) => along === to[k]));
    if (!next) return;
    next.button.focus();
    next.button.click();
  });

  return {
    element: whole,
    /** @param {Around | null} around @param {Place | null} chosen @param {Material[]} materials */
    render(around, chosen, materials) {
      whole.hidden = !around;
      if (!around) return;
      const nodes = nodesOf(around);
      const key = JSON.stringify([nodes.map(({ at }) => at), around.neighbourhood.regular]);
      if (key !== drawn) {
        drawn = key;
        const isFocused = element.contains(document.activeElement);
        rebuild(nodes, around.neighbourhood.regular);
        if (isFocused) buttons.find(({ button }) => button.tabIndex === 0)?.button.focus();
      }
      const current = chosen && pointOf(around, chosen);
      const byPlace = new Map(nodes.map((node) => [String(node.at), node]));
      for (const each of buttons) {
        const node = byPlace.get(String(each.node.at));
        if (!node) continue;
        each.node = node;
        const { point } = node;
        const name = nameOf(node, around.neighbourhood.regular);
        const isChosen = point === current;
        const { button } = each;
        attribute(button, "aria-pressed", String(isChosen));
        button.tabIndex = isChosen ? 0 : -1;
        const mix = point.mix.flatMap((fraction, i) => (fraction < NOTHING || !materials[i] ? [] : [`${materials[i].name} ${percent(fraction)}`])).join(", ");
        attribute(button, "aria-label", words.grid.spoken(name, point.position.map(coordinate).join(", "), mix));
        attribute(button, "title", name);
        button.style.setProperty("--mix", mixed(materials.map(({ color }) => color), point.mix));
      }
      if (!buttons.some(({ button }) => button.tabIndex === 0) && buttons[0]) buttons[0].button.tabIndex = 0;
      const { regular, cells, points } = around.neighbourhood;
      const moving = new Set(around.moves.map((move) => around.neighbourhood.points.findIndex(({ users }) => users.some((user) => isPlace(user, move)))));
      write(about, `${regular ? words.grid.regular(cells.length, points.length - 1) : words.grid.crease(cells.length)}. ${words.grid.moves(moving.size)}.`.replaceAll("..", "."));
    },
  };

  /** @param {Node[]} nodes @param {boolean} isRegular */
  function rebuild(nodes, isRegular) {
    const along = [0, 1, 2].map((k) => [...new Set(nodes.map(({ at }) => at[k]))].sort((a, b) => a - b));
    buttons = [];
    const layers = along[2].map((w) => {
      const rows = [...along[1]].reverse().flatMap((v) =>
        along[0].map((u) => {
          const node = nodes.find(({ at }) => at[0] === u && at[1] === v && at[2] === w);
          if (!node) return h("span", {});
          const button = h("button", { type: "button", class: node.isCorner ? "corner-node corner" : "corner-node", "data-node": node.at.join(" "), tabIndex: -1 });
          const each = { node, button };
          button.addEventListener("click", () => {
            const [user] = each.node.point.users;
            choose(user, each.node.point, button.getAttribute("aria-label") ?? "");
          });
          buttons.push(each);
          return button;
        }),
      );
      const layer = h("div", { class: "corner-layer" }, ...rows);
      layer.style.setProperty("--columns", String(along[0].length));
      return h("div", {}, layer, h("span", { class: "corner-layer-name", "aria-hidden": "true" }, isRegular ? words.grid.layer(w) : `w ${w}`));
    });
    element.replaceChildren(...layers);
  }
}
