/**
 * The menu of what lies under the pointer or has the focus: a point, a curve, or the canvas.
 *
 * @import { App } from "../state/app.js"
 * @import { Point } from "../types.js"
 * @import { Item } from "../frame/menu.js"
 * @import { Held } from "./handles.js"
 */
import { commandItems } from "../commands.js";
import { openMenu } from "../frame/menu.js";
import { curveName, pointName } from "../state/app.js";
import { includes, isWhole, toggle } from "../state/selection.js";
import { strings } from "../strings.js";
import { toPlane } from "../view.js";
import { words } from "./curve-words.js";
import { chosenBy } from "./handle-keys.js";
import { insertAt } from "./points.js";

const CANVAS = ["draw", "select-all", "line", "fit", "grid", "snap", "line", "new", "shortcuts"];
const CURVE = [
  ...["insert-point", "select-all", "line", "duplicate-curve", "rename-curve", "reverse-curve", "smooth-curve"],
  ...["swap-curves", "draw", "line", "delete-curve"],
];
const POINTS = [
  ...["insert-point", "duplicate-point", "delete-points", "line", "select-all", "select-curve", "line"],
  ...["duplicate-curve", "reverse-curve", "delete-curve"],
];

/** Commands that are not worth a line in a menu while they cannot be done. */
const QUIET = ["smooth-curve", "swap-curves", "select-all", "duplicate-point"];

/**
 * @param {App} app
 * @param {Held | null} held what the menu is about
 * @param {Point} at CSS pixels on the canvas
 * @param {{left: number, top: number, bottom: number}} box on the screen
 */
export function openContextMenu(app, held, at, box) {
  const { selection, view, size } = app.ui.value;
  if (held) {
    const kept = held.point === null ? isWhole(selection) && selection?.curve === held.curve : includes(selection, held.curve, held.point);
    if (!kept) app.ui.set({ selection: chosenBy(held) });
  }
  const { document } = app.store;
  const names = held === null ? CANVAS : held.point === null ? CURVE : POINTS;
  const items = commandItems(app, names).filter((item) => item === "line" || !item.disabled || !QUIET.includes(item.name));
  if (held?.point === null && view) {
    for (const item of items) {
      // On a curve the point comes where the menu was asked for.
      if (item !== "line" && item.name === "insert-point") item.act = () => void insertAt(app, held.curve, toPlane(view, size, at));
    }
  }
  if (held && held.point !== null) items.unshift(...selecting(app, held.curve, held.point, selection));
  const label =
    held === null
      ? words.menu
      : held.point === null
        ? curveName(document, held.curve)
        : pointName(held.curve, held.point);
  openMenu(items, { label, box });
}

/**
 * Adding to the selection without a keyboard: offered where a point of the same curve was chosen already.
 * @param {App} app
 * @param {number} curve
 * @param {number} point
 * @param {import("../types.js").Selection | null} before
 * @returns {(Item | "line")[]}
 */
function selecting(app, curve, point, before) {
  if (!before || before.curve !== curve || isWhole(before)) return [];
  const inside = includes(before, curve, point);
  if (inside && before.points.length === 1) return [];
  return [
    {
      name: "select-add",
      text: inside ? words.dropPoint : words.addPoint,
      act: () => {
        const selection = toggle(before, curve, point);
        app.ui.set({ selection });
        app.say(strings.curves.selected(selection.points.length));
      },
    },
    "line",
  ];
}
