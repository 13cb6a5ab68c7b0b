/**
 * A plot of curves over one list of places, on linear or logarithmic axes, drawn by uPlot in the colours of the page. It is read by pointer and by keys,
 * and its curves are switched by the buttons of its legend.
 *
 * @typedef {object} Curve
 * @property {string} name
 * @property {string} color CSS, or a token of the page such as `--text`
 * @property {boolean} dashed
 * @property {boolean} [wide] whether it shows below one that it coincides with
 * @property {boolean} points whether the places are marked
 * @property {(number | null)[]} values one for each place
 *
 * @typedef {{places: number[], curves: Curve[]}} Plot
 *
 * @typedef {object} ChartOptions
 * @property {string} name for the data attributes
 * @property {string} label what is read of it
 * @property {string} across what runs along x, and `up` along y
 * @property {string} up
 * @property {boolean} isLogAcross
 * @property {boolean} [isLinearUp] else y is logarithmic
 * @property {[number, number]} [span] the ends of x, where they are known
 * @property {(value: number) => string} place in words
 * @property {(value: number) => string} value in words
 * @property {(text: string) => void} say
 */
import uPlot from "uplot";
import "uplot/dist/uPlot.min.css";
import { attribute, h, write } from "../../dom.js";

/** CSS pixels of the plot's height, and of lines. */
const HIGH = 236;
const WIDTH = 1.75;
const WIDE = 4;
const DASH = [6, 4];
/** Powers of ten that a logarithmic axis has at least. */
const DECADE = 10;
/** Powers of ten between which an axis leaves some out. */
const MOST_TICKS = 8;

/** @param {ChartOptions} options */
export function createChart({ name, label, across, up, isLogAcross, isLinearUp = false, span, place, value, say }) {
  const surface = h("div", { class: "lab-chart-plot", tabIndex: 0, role: "img", "data-lab-chart": name });
  const legend = h("div", { class: "lab-chart-legend", role: "group", "aria-label": label });
  const readout = h("p", { class: "lab-chart-readout number", "aria-hidden": "true" });
  const element = h("figure", { class: "lab-chart" }, h("figcaption", {}, label), surface, legend, readout);
  /** @type {uPlot | null} */
  let plot = null;
  /** @type {Plot} */
  let shown = { places: [], curves: [] };
  let key = "";
  /** Curves that were switched off, by their names. @type {Set<string>} */
  const off = new Set();

  const token = (/** @type {string} */ css) => (css.startsWith("--") ? getComputedStyle(surface).getPropertyValue(css).trim() : css);

  /** What stands at a place, in words. @param {number} index */
  const told = (index) =>
    [place(shown.places[index]), ...shown.curves.flatMap((curve) => (off.has(curve.name) || curve.values[index] == null ? [] : [`${curve.name} ${value(Number(curve.values[index]))}`]))].join(" · ");

  function draw() {
    plot?.destroy();
    const { places, curves } = shown;
    const [text, line, strong] = ["--text-2", "--line", "--line-strong"].map(token);
    const font = `11px ${getComputedStyle(surface).fontFamily}`;
    /** @type {uPlot.Axis} */
    const axis = { stroke: text, font, labelFont: font, grid: { stroke: line, width: 1 }, ticks: { stroke: strong, width: 1, size: 4 }, border: { show: true, stroke: strong, width: 1 } };
    /** @param {boolean} isDense whether twos and fives stand between the powers of ten @returns {Pick<uPlot.Axis, "splits" | "filter">} */
    const logarithmic = (isDense) => ({ splits: (_, __, low, high) => ticksOf(low, high, isDense), filter: (_, splits) => splits });
    plot = new uPlot(
      {
        width: Math.max(120, surface.clientWidth),
        height: HIGH,
        legend: { show: false },
        cursor: { drag: { setScale: false, x: false, y: false }, points: { size: 7 }, y: false },
        scales: {
          x: isLogAcross ? { time: false, distr: 3, range: (_, low, high) => [low / 1.15, high * 1.15] } : { time: false, range: (_, low, high) => span ?? [low, Math.max(high, low + 1)] },
          y: isLinearUp ? { range: (_, __, high) => [0, Math.max(1, 1.1 * high)] } : { distr: 3, range: (_, low, high) => widened(low, high) },
        },
        axes: [
          { ...axis, label: across, labelSize: 18, size: 30, ...(isLogAcross ? { ...logarithmic(true), values: (_, splits) => splits.map(place) } : {}) },
          { ...axis, label: up, labelSize: 18, size: 46, ...(isLinearUp ? {} : { ...logarithmic(false), values: (_, splits) => splits.map(power) }) },
        ],
        series: [
          {},
          ...curves.map((curve) => ({
            label: curve.name,
            stroke: token(curve.color),
            width: curve.wide ? WIDE : WIDTH,
            spanGaps: true,
            show: !off.has(curve.name),
            ...(curve.dashed ? { dash: DASH } : {}),
            points: { show: curve.points, size: 6, fill: token("--canvas"), width: WIDTH },
          })),
        ],
        hooks: {
          setCursor: [
            ({ cursor: { idx } }) => {
              write(readout, idx == null ? "" : told(idx));
            },
          ],
        },
      },
      /** @type {uPlot.AlignedData} */ ([places, ...curves.map(({ values }) => values)]),
      surface,
    );
    legend.replaceChildren(
      ...curves.map((curve, k) => {
        const sample = h("span", { class: curve.dashed ? "lab-chart-line dashed" : "lab-chart-line", "aria-hidden": "true" });
        sample.style.color = token(curve.color);
        return h("button", { type: "button", class: "lab-chart-key", "aria-pressed": String(!off.has(curve.name)), "data-curve": curve.name, onclick: () => toggle(curve.name, k) }, sample, h("span", {}, curve.name));
      }),
    );
  }

  /** @param {string} which @param {number} k */
  function toggle(which, k) {
    if (!off.delete(which)) off.add(which);
    plot?.setSeries(k + 1, { show: !off.has(which) });
    attribute(/** @type {Element} */ (legend.children[k]), "aria-pressed", String(!off.has(which)));
  }

  surface.addEventListener("keydown", (event) => {
    const count = shown.places.length;
    const now = plot?.cursor.idx ?? null;
    const by = { ArrowRight: 1, ArrowLeft: -1, PageDown: 10, PageUp: -10, Home: -Infinity, End: Infinity }[event.key];
    if (!plot || by === undefined || count === 0 || event.ctrlKey || event.metaKey) return;
    event.preventDefault();
    event.stopPropagation();
    // The first key begins at the end that it leads away from.
    const next = Math.min(count - 1, Math.max(0, (now ?? (by < 0 ? count : -1)) + by));
    plot.setCursor({ left: plot.valToPos(shown.places[next], "x"), top: 10 });
    say(told(next));
  });
  surface.addEventListener("blur", () => plot?.setCursor({ left: -10, top: -10 }));

  const observer = new ResizeObserver(() => {
    if (plot && surface.clientWidth > 0 && surface.clientWidth !== plot.width) plot.setSize({ width: surface.clientWidth, height: HIGH });
    else if (!plot && surface.clientWidth > 0 && shown.places.length > 0) draw();
  });
  observer.observe(surface);

  return {
    element,
    /** @param {Plot} next @param {string} theme whose colours it has @param {string} summary of what it shows, in words */
    set(next, theme, summary) {
      attribute(surface, "aria-label", summary);
      const nextKey = JSON.stringify([next, theme]);
      if (nextKey === key) return;
      key = nextKey;
      shown = next;
      element.classList.toggle("empty", next.places.length === 0);
      if (surface.clientWidth > 0) draw();
    },
    close() {
      observer.disconnect();
      plot?.destroy();
    },
  };
}

/** Whole powers of ten round the values. @param {number} low @param {number} high @returns {[number, number]} */
function widened(low, high) {
  if (!(low > 0) || !(high > 0)) return [1e-6, 1];
  const [from, to] = [Math.floor(Math.log10(low) + 1e-9), Math.ceil(Math.log10(high) - 1e-9)];
  return [DECADE ** from, DECADE ** Math.max(to, from + 1)];
}

/**
 * Places of ticks on a logarithmic axis: powers of ten, with twos and fives where there are few.
 * @param {number} low
 * @param {number} high
 * @param {boolean} isDense
 */
function ticksOf(low, high, isDense) {
  const [from, to] = [Math.floor(Math.log10(low) + 1e-9), Math.ceil(Math.log10(high) - 1e-9)];
  const step = isDense ? 1 : Math.max(1, Math.ceil((to - from) / MOST_TICKS));
  const found = [];
  for (let exponent = from; exponent <= to; exponent += step) for (const lead of isDense ? [1, 2, 5] : [1]) found.push(lead * DECADE ** exponent);
  return found.filter((tick) => tick >= low * (1 - 1e-9) && tick <= high * (1 + 1e-9));
}

/** A power of ten. @param {number} value */
const power = (value) => `10${[...String(Math.round(Math.log10(value)))].map((sign) => (sign === "-" ? "⁻" : "⁰¹²³⁴⁵⁶⁷⁸⁹"[Number(sign)])).join("")}`;
