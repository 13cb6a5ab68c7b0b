/**
 * Control points of a figure that can be dragged, or moved by the arrow keys. One of them is a tab stop.
 *
 * @import { CurvesDocument, Point, View } from "../types.js"
 */
import { ARROWS, stride } from "../controls/arrows.js";
import { attribute, h } from "../dom.js";
import { coordinate } from "../format.js";
import { pointName } from "../state/app.js";
import { handleCount } from "../state/edits.js";
import { aimed, arrowStep, toPlane, toScreen } from "../view.js";
import { words } from "./words.js";

/**
 * @param {ReturnType<typeof import("./surface.js").createSurface>} surface
 * @param {{change: (document: CurvesDocument) => void, done: () => void, say: (text: string) => void}} acts
 */
export function createHandles(surface, { change, done, say }) {
  const element = h("div", { class: "lesson-handles", role: "application", "aria-label": words.handles, "aria-describedby": "lesson-handles-help" });
  const help = h("p", { class: "spoken", id: "lesson-handles-help" }, words.handlesHelp);
  element.append(help);
  /** @type {HTMLButtonElement[]} */
  let buttons = [];
  /** @type {{document: CurvesDocument, view: View} | null} */
  let now = null;
  let stop = 0;

  /** Curve and point of a button. @param {number} index */
  function pointOf(index) {
    let [curve, point] = [0, index];
    for (const each of now?.document.curves ?? []) {
      const count = handleCount(each);
      if (point < count) break;
      point -= count;
      curve += 1;
    }
    return { curve, point };
  }

  /** @param {number} index @param {Point} to */
  function place(index, to) {
    if (!now) return;
    const { curve, point } = pointOf(index);
    const curves = now.document.curves.map((each, k) => {
      if (k !== curve) return each;
      const points = each.points.map((own, i) => (i === point ? to : own));
      // The last control point of a clamped curve repeats the first.
      if (each.form === "clamped" && point === 0) points[points.length - 1] = to;
      return { ...each, points };
    });
    change({ ...now.document, curves });
  }

  /** @param {number} index */
  function handle(index) {
    const { curve } = pointOf(index);
    const button = h("button", { type: "button", class: `handle ${curve === 0 ? "round" : "square"}` });
    button.addEventListener("focus", () => (stop = index));
    button.addEventListener("pointerdown", (event) => {
      if (event.button !== 0) return;
      event.preventDefault();
      button.focus({ preventScroll: true });
      button.setPointerCapture(event.pointerId);
      button.classList.add("held");
    });
    button.addEventListener("pointermove", (event) => {
      if (!button.classList.contains("held") || !now) return;
      const [x, y] = toPlane(now.view, surface.size(), surface.placeOf(event));
      place(index, [aimed(x, now.view), aimed(y, now.view)]);
    });
    const end = () => {
      if (!button.classList.contains("held")) return;
      button.classList.remove("held");
      done();
    };
    button.addEventListener("pointerup", end);
    button.addEventListener("pointercancel", end);
    button.addEventListener("keydown", (event) => key(event, index));
    button.addEventListener("keyup", (event) => {
      if (ARROWS[event.key]) done();
    });
    return button;
  }

  /** @param {KeyboardEvent} event @param {number} index */
  function key(event, index) {
    if (!now || event.ctrlKey || event.metaKey) return;
    const arrow = ARROWS[event.key];
    const other = { Home: 0, End: buttons.length - 1, PageDown: index + 1, PageUp: index - 1 }[event.key];
    if (arrow) {
      const { curve, point } = pointOf(index);
      const [x, y] = /** @type {Point} */ (now.document.curves[curve]?.points[point]);
      const by = arrowStep(now.document) * stride(event);
      const to = /** @type {Point} */ ([aimed(x + by * arrow[0], now.view), aimed(y + by * arrow[1], now.view)]);
      place(index, to);
      say(words.handle(pointName(curve, point), coordinate(to[0]), coordinate(to[1])));
    } else if (other !== undefined) buttons[(other + buttons.length) % buttons.length]?.focus();
    else return;
    event.preventDefault();
    event.stopPropagation();
  }

  return {
    element,
    /** @param {CurvesDocument} document @param {View} view */
    render(document, view) {
      now = { document, view };
      const count = document.curves.reduce((sum, curve) => sum + handleCount(curve), 0);
      if (buttons.length !== count) {
        buttons = Array.from({ length: count }, (_, index) => handle(index));
        element.replaceChildren(help, ...buttons);
      }
      const size = surface.size();
      buttons.forEach((button, index) => {
        const { curve, point } = pointOf(index);
        const at = /** @type {Point} */ (document.curves[curve]?.points[point]);
        const [x, y] = toScreen(view, size, at).map((each) => each * surface.zoom);
        button.style.transform = `translate(${x}px, ${y}px)`;
        attribute(button, "tabindex", index === stop ? "0" : "-1");
        attribute(button, "aria-label", words.handle(pointName(curve, point), coordinate(at[0]), coordinate(at[1])));
      });
    },
  };
}
