/**
 * The composition keys on the curves themselves: drops that point at their place, filled with the colour of their mix. They are there while
 * compositions are edited, in place of the control points.
 *
 * @import { App } from "../state/app.js"
 * @import { Curve, Point } from "../types.js"
 * @import { Key } from "./key-edits.js"
 */
import { attribute, find, h, svg } from "../dom.js";
import { mixed } from "../oklab.js";
import { ending, isOpen, nearestFraction, outline, placeOn, signedArea } from "../spline.js";
import { sideOf } from "../state/open.js";
import { curveName, pointName } from "../state/app.js";
import { strings } from "../strings.js";
import { toPlane, toScreen } from "../view.js";
import { choose, dragKey, insert, pressed, spokenKey } from "./key-edits.js";

/** Distance of a drop's middle from the curve, CSS pixels; its tip touches the curve. */
const OFFSET = 13;
/** Angle at which the tip of the shape lies by itself. */
const TIP = Math.PI * 0.75;

/** @param {App} app */
export function createKeys(app) {
  const layer = h(
    "div",
    { class: "overlay keys", "data-keys": "" },
    h("p", { id: "key-help", class: "spoken" }, strings.composition.help),
  );
  /** @type {ReturnType<typeof createGroup>[]} */
  const groups = [];
  find("#overlay").after(layer);

  /** @param {Key} key */
  function focus(key) {
    choose(app, key);
    render();
    groups[key.curve].focus(key.index);
  }

  function render() {
    const { composing, view } = app.ui.value;
    layer.hidden = !composing || !view;
    if (layer.hidden) return;
    while (groups.length < app.store.document.curves.length) {
      const group = createGroup(app, groups.length, (key) => focus(key));
      groups.push(group);
      layer.append(group.element);
    }
    for (const group of groups) group.render();
  }
  return { render };
}

/**
 * @param {App} app
 * @param {number} curve
 * @param {(key: Key) => void} focus
 */
function createGroup(app, curve, focus) {
  const hit = svg("path", { class: "outline-hit key-hit", "data-key-outline": curve });
  const glow = svg("path", { class: "outline-glow", "aria-hidden": "true" });
  const element = h(
    "div",
    { class: "handles", role: "application", "aria-describedby": "key-help" },
    /** @type {any} */ (svg("svg", { class: "outlines", "aria-hidden": "true" }, glow, hit)),
  );
  /** @type {HTMLButtonElement[]} */
  const buttons = [];
  const shape = () => app.store.document.curves[curve];

  /** @param {MouseEvent} event */
  function fractionAt(event) {
    const { view, size } = app.ui.value;
    const box = find("#stage").getBoundingClientRect();
    if (!view) return 0;
    return nearestFraction(shape(), toPlane(view, size, [event.clientX - box.left, event.clientY - box.top]));
  }

  // The canvas would take the pointer, and with it the second click.
  hit.addEventListener("pointerdown", (event) => event.stopPropagation());
  hit.addEventListener("dblclick", (event) => focus(insert(app, curve, fractionAt(event))));

  element.addEventListener("focusin", (event) => {
    const index = indexOf(event.target);
    if (index >= 0) choose(app, { curve, index });
  });
  element.addEventListener("keydown", (event) => {
    const index = indexOf(event.target);
    if (index < 0) return;
    const next = pressed(app, event, { curve, index });
    if (!next && event.key !== "Escape") return;
    event.preventDefault();
    event.stopPropagation();
    if (next) focus(next);
    else leave(app);
  });
  element.addEventListener("pointerdown", (event) => {
    const index = indexOf(event.target);
    if (index < 0 || event.button !== 0) return;
    event.preventDefault();
    focus({ curve, index });
    dragKey(app, event, { curve, index }, fractionAt);
  });

  /** @param {EventTarget | null} target */
  function indexOf(target) {
    return buttons.findIndex((button) => target instanceof Node && button.contains(target));
  }

  /** @param {number} count */
  function grow(count) {
    while (buttons.length < count) {
      const name = `${pointName(curve, buttons.length)} key`;
      const button = h("button", { type: "button", class: "key", "data-key": name, "data-furniture": "" }, h("i", {}));
      buttons.push(button);
      element.append(button);
    }
    while (buttons.length > count) buttons.pop()?.remove();
  }

  return {
    element,
    /** @param {number} index */
    focus: (index) => buttons[index]?.focus({ preventScroll: true }),

    render() {
      const { document } = app.store;
      const { view, size, key } = app.ui.value;
      const drawn = shape();
      element.hidden = !drawn;
      if (!drawn || !view) return;
      attribute(element, "aria-label", strings.composition.group(curveName(document, curve)));
      const chain = outline(drawn).map(({ at }) => toScreen(view, size, at));
      const d = `M${chain.map(([x, y]) => `${x.toFixed(1)} ${y.toFixed(1)}`).join("L")}${ending(drawn)}`;
      attribute(hit, "d", d);
      attribute(glow, "d", d);
      grow(drawn.composition.length);
      const away = isInside(document.curves, curve) ? -1 : 1;
      const chosen = key?.curve === curve ? key.index : null;
      const colors = document.materials.map(({ color }) => color);
      drawn.composition.forEach(({ at, mix }, index) => {
        const button = buttons[index];
        const place = placeOn(drawn, at);
        const [x, y] = toScreen(view, size, place.at);
        const [nx, ny] = [away * place.normal[0], -away * place.normal[1]];
        button.style.transform = `translate(${(x + nx * OFFSET).toFixed(1)}px, ${(y + ny * OFFSET).toFixed(1)}px)`;
        const face = /** @type {HTMLElement} */ (button.firstElementChild);
        face.style.rotate = `${(Math.atan2(-ny, -nx) - TIP).toFixed(4)}rad`;
        face.style.backgroundColor = mixed(colors, mix);
        attribute(button, "aria-label", spokenKey(document, { curve, index }));
        attribute(button, "tabindex", index === (chosen ?? 0) ? "0" : "-1");
        button.classList.toggle("chosen", index === chosen);
      });
    },
  };
}

/** Gives the curves back to the control points. @param {App} app */
function leave(app) {
  app.ui.set({ composing: false });
  app.say(strings.composition.left);
  /** @type {HTMLElement | null} */ (document.querySelector("[data-action=compose]"))?.focus();
}

/**
 * Whether the outward normals of a curve point into the material: it is the smaller of two, or an open one with the other to its right. Its drops
 * point away from there.
 * @param {Curve[]} curves
 * @param {number} index
 */
function isInside(curves, index) {
  if (isOpen(curves[index])) return sideOf(curves, index) > 0;
  const [area, other] = [index, 1 - index].map((i) => {
    const polygon = curves[i] ? outline(curves[i]).map(({ at }) => /** @type {Point} */ (at)) : [];
    return Math.abs(signedArea(polygon));
  });
  return area < other;
}
