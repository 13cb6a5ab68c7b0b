/**
 * Control points and curve outlines as elements over the picture: they take focus, keys and names, and the pointer
 * code finds them here.
 *
 * @import { App } from "../state/app.js"
 * @import { Curve, Point, Size, View } from "../types.js"
 */
import { attribute, find, h, svg, write } from "../dom.js";
import { coordinate } from "../format.js";
import { ending, outline } from "../spline.js";
import { curveName, pointName } from "../state/app.js";
import { handleCount } from "../state/edits.js";
import { seen } from "../state/in-space.js";
import { includes, isWhole, middleOf, singlePoint, whole } from "../state/selection.js";
import { strings } from "../strings.js";
import { toScreen } from "../view.js";

/** @typedef {{curve: number, point: number | null}} Held */

/** @param {App} app */
export function createHandles(app) {
  const overlay = find("#overlay");
  const name = h("span", { class: "handle-name", "aria-hidden": "true" });
  const groups = [0, 1].map(createGroup);
  overlay.append(
    h("p", { id: "handle-help", class: "spoken" }, strings.handles.help),
    ...groups.map((group) => group.element),
    name,
  );

  /** A group for every curve; those of curves that are gone hide. */
  function grow() {
    while (groups.length < app.store.document.curves.length) {
      const group = createGroup(groups.length);
      groups.push(group);
      name.before(group.element);
    }
  }

  return {
    element: overlay,

    render() {
      const { view, size, selection, layers, drawing, composing } = app.ui.value;
      if (!view) return;
      overlay.hidden = drawing || composing || !layers.includes("controlPoints");
      grow();
      for (const group of groups) group.render(app, view, size);
      const point = singlePoint(selection);
      const chosen = selection && point !== null ? app.store.document.curves[selection.curve] : null;
      name.hidden = !chosen;
      if (!chosen || !selection || point === null) return;
      write(name, pointName(selection.curve, point));
      const [x, y] = toScreen(view, size, /** @type {Point} */ (seen(chosen).points[point]));
      const left = x > size.width - 56;
      name.style.transform = `translate(${x + (left ? -38 : 16)}px, ${y < 32 ? y + 8 : y - 26}px)`;
    },

    /**
     * The control point nearest to a place on the screen, not farther than `reach` pixels.
     * @param {Point} at
     * @param {number} reach
     * @returns {Held | null}
     */
    nearest(at, reach) {
      const { view, size } = app.ui.value;
      if (!view || overlay.hidden) return null;
      /** @type {Held | null} */
      let best = null;
      let least = reach;
      app.store.document.curves.map(seen).forEach((curve, c) => {
        for (let i = 0; i < handleCount(curve); i += 1) {
          const [x, y] = toScreen(view, size, /** @type {Point} */ (curve.points[i]));
          const distance = Math.max(Math.abs(x - at[0]), Math.abs(y - at[1]));
          if (distance > least) continue;
          least = distance;
          best = { curve: c, point: i };
        }
      });
      return best;
    },

    /** @param {Held} held */
    focus({ curve, point }) {
      groups[curve]?.focus(point);
    },

    /** Marks what is held, for the look of it. @param {Held | null} held @param {boolean} touch */
    hold(held, touch) {
      for (const element of overlay.querySelectorAll(".held")) element.classList.remove("held", "touched");
      if (!held) return;
      groups[held.curve]?.part(held.point)?.classList.add("held", ...(touch ? ["touched"] : []));
    },
  };
}

/** @param {number} curve */
function createGroup(curve) {
  const hit = svg("path", { class: "outline-hit", role: "button", tabindex: "-1", "data-outline": curve });
  const glow = svg("path", { class: "outline-glow", "aria-hidden": "true" });
  const drawing = svg("svg", { class: "outlines" }, glow, hit);
  const element = h(
    "div",
    { class: "handles", role: "application", "aria-describedby": "handle-help", "data-curve": curve },
    /** @type {any} */ (drawing),
  );
  /** @type {HTMLButtonElement[]} */
  const buttons = [];
  let traced = "";
  /** @type {Curve | null} */
  let tracedCurve = null;

  /** @param {number} count */
  function grow(count) {
    while (buttons.length < count) {
      const name = pointName(curve, buttons.length);
      const button = h("button", { type: "button", class: `handle ${curve % 2 === 0 ? "round" : "square"}` });
      button.dataset.handle = name;
      buttons.push(button);
      element.append(button);
    }
    while (buttons.length > count) buttons.pop()?.remove();
  }

  return {
    element,

    /** @param {number | null} point */
    part: (point) => (point === null ? hit : buttons[point]),

    /** @param {number | null} point */
    focus(point) {
      const target = point === null ? hit : buttons[point];
      target?.focus({ preventScroll: true });
    },

    /** @param {App} app @param {View} view @param {Size} size */
    render(app, view, size) {
      const { document } = app.store;
      const { selection } = app.ui.value;
      element.hidden = !document.curves[curve];
      if (element.hidden) return;
      const shape = seen(document.curves[curve]);
      const label = curveName(document, curve);
      attribute(element, "aria-label", strings.handles.group(label));
      grow(handleCount(shape));
      const mine = selection?.curve === curve ? selection : null;
      const stop = mine ? (mine.points[0] ?? null) : 0;

      const key = `${view.center} ${view.scale} ${size.width} ${size.height}`;
      if (shape !== tracedCurve || key !== traced) {
        [tracedCurve, traced] = [shape, key];
        const chain = outline(shape).map(({ at }) => toScreen(view, size, at));
        const d = `M${chain.map(([x, y]) => `${x.toFixed(1)} ${y.toFixed(1)}`).join("L")}${ending(shape)}`;
        hit.setAttribute("d", d);
        glow.setAttribute("d", d);
      }
      const [cx, cy] = middleOf(document, whole(curve));
      attribute(hit, "aria-label", strings.handles.curve(label, coordinate(cx), coordinate(cy)));
      attribute(hit, "tabindex", stop === null ? "0" : "-1");
      glow.classList.toggle("chosen", isWhole(mine));

      buttons.forEach((button, i) => {
        const at = /** @type {Point} */ (shape.points[i]);
        const [x, y] = toScreen(view, size, at);
        button.style.transform = `translate(${x.toFixed(2)}px, ${y.toFixed(2)}px)`;
        attribute(button, "tabindex", stop === i ? "0" : "-1");
        attribute(
          button,
          "aria-label",
          strings.handles.point(pointName(curve, i), coordinate(at[0]), coordinate(at[1])),
        );
        button.classList.toggle("chosen", includes(mine, curve, i));
      });
    },
  };
}
