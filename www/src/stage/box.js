/**
 * Selecting the points in a box that is dragged over the canvas.
 *
 * @import { App } from "../state/app.js"
 * @import { Point } from "../types.js"
 * @import { Drag } from "./gestures.js"
 */
import { find, h } from "../dom.js";
import { handleCount } from "../state/edits.js";
import { seen } from "../state/in-space.js";
import { isWhole, several } from "../state/selection.js";
import { strings } from "../strings.js";
import { toScreen } from "../view.js";

/**
 * @param {App} app
 * @param {ReturnType<typeof import("./handles.js").createHandles>} handles
 */
export function createBox(app, handles) {
  const element = h("div", { class: "select-box", hidden: true, "aria-hidden": "true" });
  find("#overlay").before(element);

  /**
   * Control points inside the box, on the curve that has the most of them.
   * @param {Point} a CSS pixels
   * @param {Point} b
   */
  function inside(a, b) {
    const { view, size } = app.ui.value;
    const found = app.store.document.curves.map(seen).map((curve) =>
      [...Array(handleCount(curve)).keys()].filter((i) => {
        if (!view) return false;
        const [x, y] = toScreen(view, size, curve.points[i]);
        return (x - a[0]) * (x - b[0]) <= 0 && (y - a[1]) * (y - b[1]) <= 0;
      }),
    );
    const most = Math.max(0, ...found.map(({ length }) => length));
    const curve = Math.max(0, found.findIndex(({ length }) => length === most));
    return { curve, points: found[curve] ?? [] };
  }

  return {
    /** @param {Point} from @returns {Drag} */
    drag(from) {
      const { selection: before } = app.ui.value;
      return {
        kind: "box",
        from,
        moved: false,
        to(at) {
          element.hidden = false;
          element.style.transform = `translate(${Math.min(from[0], at[0])}px, ${Math.min(from[1], at[1])}px)`;
          element.style.width = `${Math.abs(at[0] - from[0])}px`;
          element.style.height = `${Math.abs(at[1] - from[1])}px`;
          const { curve, points } = inside(from, at);
          // Points chosen before stay, as Shift promises, when they are on the same curve.
          const kept = before?.curve === curve && !isWhole(before) ? before.points : [];
          app.ui.set({ selection: points.length > 0 ? several(curve, [...kept, ...points]) : before });
        },
        end() {
          element.hidden = true;
          const { selection } = app.ui.value;
          const count = selection === before ? 0 : (selection?.points.length ?? 0);
          app.say(count > 0 ? strings.curves.selected(count) : strings.curves.noneInBox);
          if (!selection || count === 0) return;
          handles.render();
          handles.focus({ curve: selection.curve, point: selection.points[0] });
        },
        undo() {
          element.hidden = true;
          app.ui.set({ selection: before });
        },
      };
    },
  };
}
