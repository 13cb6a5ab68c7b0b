/**
 * The coordinates under the pointer, and the axes through the origin while the grid is shown.
 *
 * @import { App } from "../state/app.js"
 * @import { Curve, Point, Size, View } from "../types.js"
 */
import { attribute, find, h, svg, write } from "../dom.js";
import { fixed } from "../format.js";
import { isOpen, outline } from "../spline.js";
import { isHarmonic } from "../state/look.js";
import { joined } from "../state/open.js";
import { strings } from "../strings.js";
import { toPlane, toScreen } from "../view.js";

/** @param {App} app */
export function createReading(app) {
  const text = h("span", { class: "pointer-place number" });
  find("#scale").prepend(text);
  const clip = svg("path", { "clip-rule": "evenodd" });
  const lines = svg("path", { class: "axes", "clip-path": "url(#outside-band)" });
  const layer = svg(
    "svg",
    { class: "marks", "aria-hidden": "true" },
    svg("clipPath", { id: "outside-band" }, clip),
    lines,
  );
  find("#picture").after(layer);
  let drawn = "";
  /** @type {Curve[] | null} */
  let curves = null;

  return {
    /** @param {Point | null} at CSS pixels */
    show(at) {
      const { view, size } = app.ui.value;
      if (!at || !view) {
        write(text, "");
        return;
      }
      const decimals = Math.min(6, Math.max(0, Math.ceil(Math.log10(view.scale))));
      const [x, y] = toPlane(view, size, at).map((value) => fixed(value, decimals));
      write(text, strings.canvas.pointer(x, y));
    },

    render() {
      const { view, size, layers } = app.ui.value;
      const { document } = app.store;
      const shown = layers.includes("grid") && view !== null;
      layer.style.display = shown ? "" : "none";
      if (!shown || !view) return;
      const key = `${document.blend.kind} ${view.center} ${view.scale} ${size.width} ${size.height}`;
      if (key === drawn && document.curves === curves) return;
      [drawn, curves] = [key, document.curves];
      const [x, y] = toScreen(view, size, [0, 0]).map((value) => Math.round(value) + 0.5);
      attribute(lines, "d", `M${x} 0V${size.height}M0 ${y}H${size.width}`);
      attribute(clip, "d", outsideBand(document.curves, view, size, isHarmonic(document)));
    },
  };
}

/**
 * Everything but what lies between the two curves, where the axes would be drawn over the material.
 * @param {Curve[]} curves
 * @param {View} view
 * @param {Size} size
 * @param {boolean} isFlow whether all curves lie in one
 */
function outsideBand(curves, view, size, isFlow) {
  const all = `M-9-9H${size.width + 9}V${size.height + 9}H-9Z`;
  if (curves.length < 2) return all;
  const chains = curves.map((curve) => outline(curve).map(({ at }) => at));
  // A stack lies between its first and its last curve.
  const [first, last] = [chains[0], chains[chains.length - 1]];
  const loops = isFlow ? chains : isOpen(curves[0]) ? [joined(first, last)] : [first, last];
  const rings = loops.map((loop) =>
    loop.map((at) => toScreen(view, size, at).map((value) => value.toFixed(1)).join(" ")).join("L"),
  );
  return all + rings.map((ring) => `M${ring}Z`).join("");
}
