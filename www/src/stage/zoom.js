/**
 * Fit, zoom, grid and snapping buttons, and the scale bar.
 *
 * @import { App } from "../state/app.js"
 * @import { Point } from "../types.js"
 */
import { commandNamed, commandText, commandTitle, runCommand } from "../commands.js";
import { attribute, find, h, write } from "../dom.js";
import { fixed, percent } from "../format.js";
import { icon } from "../icons.js";
import { devicePixels } from "../painter.js";
import { isCurves } from "../state/kind.js";
import { niceBelow, zoomed } from "../view.js";

/** Zoom of one press of a button or key, and how far from the fitted scale one can go. */
const STEP = 1.25;
const OUT = 1 / 20;
const IN = 400;
/** Longest scale bar in pixels, and on a canvas narrower than `NARROW`. */
const BAR = 160;
const SHORT_BAR = 110;
const NARROW = 1060;
/** Height that the switch of modes takes at the upper edge: of a narrow canvas nearly all, of a wide one only the corner. */
const SWITCH = { narrow: 44, wide: 16 };
const PHONE = 600;

/** @param {App} app */
export function zoomLimits(app) {
  const { fitScale } = app.ui.value;
  return { min: fitScale * OUT, max: fitScale * IN };
}

/**
 * Shows everything, clear of what stands at the upper and the lower edge of the canvas. Other workbenches fit what they show when there is no view.
 * @param {App} app
 */
export async function fit(app) {
  const { size } = app.ui.value;
  if (size.width < 1 || size.height < 1) return;
  if (!isCurves(app.store.document)) return app.ui.set({ view: null, fitted: true });
  const covered = find("#morph").offsetHeight;
  const above = size.width < PHONE ? SWITCH.narrow : SWITCH.wide;
  const free = { width: size.width, height: Math.max(1, size.height - covered - above) };
  const { document } = app.store;
  const view = await app.kernel.fit(document, devicePixels(free, 1));
  if (app.store.document !== document) return;
  const center = /** @type {Point} */ ([view.center[0], view.center[1] + (above - covered) / 2 / view.scale]);
  app.ui.set({ view: { center, scale: view.scale }, fitted: true, fitScale: view.scale });
}

/**
 * @param {App} app
 * @param {number} steps positive zooms in
 */
export function zoomBy(app, steps) {
  const { view, size } = app.ui.value;
  if (!view) return;
  const middle = /** @type {Point} */ ([size.width / 2, size.height / 2]);
  app.ui.set({ view: zoomed(view, size, middle, STEP ** steps, zoomLimits(app)), fitted: false });
}

/**
 * @param {App} app
 * @param {{zoom: HTMLElement, scale: HTMLElement}} [places] of the buttons and of the scale bar
 */
export function createZoom(app, { zoom, scale } = { zoom: find("#zoom"), scale: find("#scale") }) {
  const percentage = h("span", { class: "zoom-value number" });
  const button = (/** @type {string} */ face, /** @type {string} */ command) => {
    const element = h(
      "button",
      { type: "button", class: "bare icon-only", "data-zoom": face, onclick: () => void runCommand(app, command) },
      icon(face),
    );
    const label = commandText(app, command);
    attribute(element, "aria-label", label);
    attribute(element, "title", commandTitle(app, command));
    return { element, command };
  };
  const switches = [button("grid", "grid"), button("snap", "snap")];
  zoom.append(
    ...switches.map(({ element }) => element),
    h("span", { class: "zoom-line", "aria-hidden": "true" }),
    button("minus", "zoom-out").element,
    percentage,
    button("plus", "zoom-in").element,
    button("fit", "fit").element,
  );
  const text = h("span", { class: "number" });
  const bar = h("span", { class: "scale-line" });
  scale.append(text, bar);

  return {
    render() {
      const { view, fitScale, size } = app.ui.value;
      for (const { element, command } of switches) {
        attribute(element, "aria-pressed", String(commandNamed(command).on?.(app) ?? false));
      }
      if (!view) return;
      write(percentage, percent(view.scale / fitScale));
      const length = niceBelow((size.width < NARROW ? SHORT_BAR : BAR) / view.scale);
      bar.style.width = `${length * view.scale}px`;
      write(text, scaleText(length, app.store.document.unit));
    },
  };
}

/** @param {number} length @param {string} unit */
function scaleText(length, unit) {
  const decimals = Math.max(0, -Math.floor(Math.log10(length) + 1e-9));
  return `${fixed(length, decimals)}\u00a0${unit}`;
}
