/**
 * The plot of a profile: the fraction of one material over the distance, filled with the colours of the mixes; of more than two materials the others are
 * stacked over it. Handles move the limits, the mixes at the ends, the middle of a curve with one number, and the keys of a piecewise one.
 *
 * @import { PartFeature } from "../../../../js/directrix.js"
 * @import { Profile } from "./course.js"
 *
 * @typedef {"from" | "to" | "start" | "end" | "middle" | `key ${number}`} HandleId
 *
 * @typedef {object} Handle
 * @property {HandleId} id
 * @property {number} distance
 * @property {number} fraction
 * @property {boolean} isLimit a line through the whole plot, moved sideways alone
 * @property {string} name
 *
 * @typedef {object} Plotted
 * @property {PartFeature} feature
 * @property {Profile} profile
 * @property {readonly number[]} standard the default of its body
 * @property {boolean} isPrinted whether it goes by the rule as printed, which leads nothing to the default
 * @property {readonly {name: string, color: string}[]} materials
 * @property {readonly number[]} involved indices of those that it has some of, the one that the handles move first
 * @property {string} unit
 * @property {HandleId | null} chosen
 *
 * @typedef {object} Moves
 * @property {(id: HandleId) => void} choose
 * @property {(id: HandleId, to: {distance: number, fraction: number}, run: string) => void} move
 * @property {() => void} end
 * @property {(run: string) => void} cancel
 * @property {(distance: number) => void} insert
 * @property {(id: HandleId) => void} remove
 */
import { ARROWS, KeyRun, stride } from "../../controls/arrows.js";
import { whileHeld } from "../../controls/held.js";
import { newRun } from "../../controls/run.js";
import { attribute, h, svg } from "../../dom.js";
import { fixed, percent } from "../../format.js";
import { mixed } from "../../oklab.js";
import { numberText } from "../../space/measure.js";
import { keysOf } from "../edits/features.js";
import { hasMiddle } from "./course.js";
import { HEIGHT, nice, reachOf, rounded, scalesOf } from "./axes.js";
import { words } from "./words.js";

/** Distances at the end of the axis, and steps between its numbers, from which on they are powers of ten. */
const LONG = { most: 1e5, least: 1e-4 };
/** Places at which the curve is drawn, and stops of the colours under it. */
const PLACES = 240;
const STOPS = 60;
/** How near a press must be to a handle, CSS pixels. */
const REACH = { mouse: 14, touch: 24 };
/** What a press on a limit counts as farther away, so that handles on it come first. */
const BEHIND = 5;
/** Step of a fraction by drag and by key. */
const SHARE = 0.01;

let plots = 0;

/** @param {Moves} moves */
export function createPlot(moves) {
  plots += 1;
  const id = `part-plot-${plots}`;
  const gradient = svg("linearGradient", { id: `${id}-fill`, gradientUnits: "userSpaceOnUse", y1: 0, y2: 0 });
  const [grid, bands, area, plain, curve, limits] = [svg("g", { class: "plot-grid" }), svg("g", {}), svg("path", { fill: `url(#${id}-fill)` }), svg("path", { class: "plot-plain" }), svg("path", { class: "plot-curve" }), svg("g", { class: "plot-limits" })];
  const picture = svg("svg", { class: "plot-picture", height: HEIGHT, "aria-hidden": "true" }, svg("defs", {}, gradient), grid, area, bands, plain, curve, limits);
  const labels = h("div", { class: "plot-labels number", "aria-hidden": "true" });
  const group = h("div", { class: "plot-handles", role: "group", "aria-describedby": `${id}-help` });
  const element = h("div", { class: "plot", "data-plot": "" }, /** @type {any} */ (picture), labels, group, h("p", { class: "tree-help", id: `${id}-help` }, words.plot.help));
  element.style.height = `${HEIGHT}px`;
  /** @type {Map<HandleId, HTMLElement>} */
  const made = new Map();
  /** @type {Handle[]} */
  let handles = [];
  /** @type {Plotted | null} */
  let plotted = null;
  let scales = scalesOf(272, reachOf(1));
  /** The axis while a limit is dragged: it would run away under the pointer. @type {{tick: number, most: number} | null} */
  let held = null;
  const runs = new KeyRun("profile");
  let drawn = "";

  new ResizeObserver(() => plotted && render(plotted)).observe(element);

  /** @param {PointerEvent | MouseEvent} event */
  const placeOf = (event) => {
    const box = element.getBoundingClientRect();
    return { x: event.clientX - box.left, y: event.clientY - box.top };
  };

  /** The handle under a press. @param {PointerEvent} event */
  function under(event) {
    const { x, y } = placeOf(event);
    const reach = event.pointerType === "touch" ? REACH.touch : REACH.mouse;
    const ways = handles.map((handle) => {
      const across = Math.abs(scales.x(handle.distance) - x);
      return { handle, way: handle.isLimit ? across + BEHIND : Math.hypot(across, scales.y(handle.fraction) - y) };
    });
    const near = ways.filter(({ way }) => way <= reach).sort((a, b) => a.way - b.way);
    return near[0]?.handle ?? null;
  }

  /** @param {HandleId} which @param {number} x @param {number} y @param {string} name */
  function moveTo(which, x, y, name) {
    moves.move(which, { distance: rounded(scales.distance(x), scales.step), fraction: rounded(scales.fraction(y), SHARE) }, name);
  }

  element.addEventListener("pointerdown", (down) => {
    if (down.button !== 0) return;
    const handle = under(down);
    if (!handle) return;
    down.preventDefault();
    const { id: which } = handle;
    moves.choose(which);
    made.get(which)?.focus({ preventScroll: true });
    const own = newRun("profile");
    const start = placeOf(down);
    // A press beside the middle of a handle does not move it.
    const off = { x: scales.x(handle.distance) - start.x, y: handle.isLimit ? 0 : scales.y(handle.fraction) - start.y };
    held = { tick: scales.tick, most: scales.most };
    let isMoving = false;
    element.classList.add("held");
    whileHeld({
      move(event) {
        if (event.pointerId !== down.pointerId) return;
        // By how far the pointer went: rows that come and go may move the plot meanwhile.
        const [x, y] = [start.x + event.clientX - down.clientX, start.y + event.clientY - down.clientY];
        if (!isMoving && Math.hypot(x - start.x, y - start.y) < 2) return;
        isMoving = true;
        moveTo(which, x + off.x, y + off.y, own);
      },
      finish(undo) {
        held = null;
        element.classList.remove("held");
        if (isMoving && undo) moves.cancel(own);
        moves.end();
        if (plotted) render(plotted);
      },
    });
  });
  element.addEventListener("dblclick", (event) => moves.insert(rounded(scales.distance(placeOf(event).x), scales.step)));

  /** @param {KeyboardEvent} event @param {HandleId} which */
  function pressed(event, which) {
    const handle = handles.find((each) => each.id === which);
    const arrow = ARROWS[event.key];
    if (!handle || event.ctrlKey || event.metaKey) return false;
    if (arrow) {
      const run = runs.press();
      const factor = stride(event);
      const [across, up] = handle.isLimit ? [arrow[0] || arrow[1], 0] : arrow;
      const distance = Number((handle.distance + across * factor * nice(scales.most / 200)).toPrecision(9));
      moves.move(which, { distance, fraction: Number((handle.fraction + up * factor * SHARE).toFixed(6)) }, run);
      return true;
    }
    const keys = handles.filter((each) => each.id.startsWith("key"));
    const here = keys.indexOf(handle);
    const to = { PageDown: here + 1, PageUp: here - 1 }[event.key];
    if (to !== undefined && here >= 0) {
      const next = keys[(to + keys.length) % keys.length];
      moves.choose(next.id);
      made.get(next.id)?.focus({ preventScroll: true });
      return true;
    }
    if (event.key === "Insert" && here >= 0) {
      const next = keys[here + 1] ?? keys[here - 1];
      moves.insert(next ? (handle.distance + next.distance) / 2 : scales.most / 2);
      return true;
    }
    if ((event.key === "Delete" || event.key === "Backspace") && here >= 0) {
      moves.remove(which);
      return true;
    }
    if (event.key === "Escape") {
      moves.cancel(runs.name);
      runs.renew();
      return true;
    }
    return false;
  }

  /** @param {HandleId} which */
  function createHandle(which) {
    const isLimit = which === "from" || which === "to";
    const node = h("div", { class: isLimit ? "plot-handle limit" : which === "middle" ? "plot-handle middle" : "plot-handle", role: "slider", "data-plot-handle": which });
    attribute(node, "aria-valuemin", "0");
    attribute(node, "aria-orientation", isLimit ? "horizontal" : "vertical");
    node.addEventListener("focus", () => moves.choose(which));
    node.addEventListener("keydown", (event) => {
      if (!pressed(event, which)) return;
      event.preventDefault();
      event.stopPropagation();
    });
    node.addEventListener("blur", () => {
      runs.renew();
      moves.end();
    });
    return node;
  }

  /** @param {Plotted} next */
  function render(next) {
    plotted = next;
    const { feature, standard, isPrinted, materials, involved, unit, chosen } = next;
    const [material] = involved;
    scales = scalesOf(element.clientWidth || 272, held ?? reachOf(Math.max(feature.from ?? 0, feature.to)));
    handles = handlesOf(next);
    const key = JSON.stringify([feature, standard, isPrinted, involved, materials, scales.most, scales.frame, unit]);
    if (key !== drawn) {
      drawn = key;
      draw(next);
    }
    attribute(group, "aria-label", words.plot.label(materials[material].name, unit));
    const ids = new Set(handles.map((each) => each.id));
    for (const [which, node] of made) {
      if (ids.has(which)) continue;
      node.remove();
      made.delete(which);
    }
    const keys = handles.filter((each) => each.id.startsWith("key"));
    const stop = keys.find((each) => each.id === chosen) ?? keys[0];
    for (const handle of handles) {
      let node = made.get(handle.id);
      if (!node) {
        node = createHandle(handle.id);
        made.set(handle.id, node);
        group.append(node);
      }
      node.style.left = `${scales.x(handle.distance)}px`;
      node.style.top = `${handle.isLimit ? scales.frame.top - 18 : scales.y(handle.fraction)}px`;
      node.classList.toggle("chosen", handle.id === chosen);
      const at = `${fixed(handle.distance, decimalsOf(scales.step))}\u00a0${unit}`.trim();
      const share = words.plot.share(materials[material].name, percent(handle.fraction));
      attribute(node, "aria-label", handle.name);
      attribute(node, "aria-valuenow", String(handle.isLimit ? handle.distance : handle.fraction));
      attribute(node, "aria-valuemax", String(handle.isLimit ? scales.most : 1));
      attribute(node, "aria-valuetext", handle.isLimit ? at : `${share}, ${words.plot.at(at)}`);
      // One tab stop for all keys of a piecewise profile.
      attribute(node, "tabindex", handle.id.startsWith("key") && handle !== stop ? "-1" : "0");
    }
  }

  /** @param {Plotted} state */
  function draw({ feature, profile, standard, isPrinted, materials, involved }) {
    const { frame, x, y, most, tick } = scales;
    const colors = materials.map(({ color }) => color);
    const { from, to } = profile;
    const width = to - from;
    const inside = (/** @type {number} */ d) => profile.plain(Math.min(1, Math.max(0, (d - from) / width)));
    const alone = (/** @type {number} */ d) => (isPrinted && to > from && d >= from && d <= to ? inside(d) : profile.alone(d));
    picture.setAttribute("width", String(frame.right + 10));
    // Limits are drawn from both sides, so that a jump is upright.
    const even = Array.from({ length: PLACES + 1 }, (_, n) => (most * n) / PLACES);
    const tiny = most * 1e-9;
    const keyed = keysOf(feature).map(({ at }) => from + at * width);
    const led = profile.taper > 0 ? [from + profile.taper, to - profile.taper] : [];
    const places = [...even, from - tiny, from, to, to + tiny, ...keyed, ...led].filter((d) => d >= 0 && d <= most).sort((a, b) => a - b);
    const mixes = places.map(alone);
    const point = (/** @type {number} */ d, /** @type {number} */ fraction) => `${x(d).toFixed(2)} ${y(fraction).toFixed(2)}`;
    const line = (/** @type {readonly number[]} */ heights) => heights.map((fraction, n) => point(places[n], fraction)).join("L");
    const [material] = involved;
    const own = mixes.map((mix) => mix[material]);
    curve.setAttribute("d", `M${line(own)}`);
    const isStacked = involved.length > 2;
    if (isStacked) {
      let below = mixes.map(() => 0);
      const filled = involved.map((k) => {
        const above = below.map((height, n) => height + mixes[n][k]);
        const back = below.map((height, n) => point(places[n], height)).reverse();
        below = above;
        return svg("path", { d: `M${line(above)}L${back.join("L")}Z`, fill: colors[k] });
      });
      bands.replaceChildren(...filled);
      area.setAttribute("d", "");
    } else {
      bands.replaceChildren();
      area.setAttribute("d", `M${x(0)} ${y(0)}L${line(own)}L${x(most)} ${y(0)}Z`);
      gradient.setAttribute("x1", String(frame.left));
      gradient.setAttribute("x2", String(frame.right));
      gradient.replaceChildren(
        ...Array.from({ length: STOPS + 1 }, (_, n) => {
          const stop = svg("stop", { offset: n / STOPS });
          stop.style.stopColor = mixed(colors, alone((most * n) / STOPS));
          return stop;
        }),
      );
    }
    // What it would be without being led to the default.
    const offends = to > from && profile.meets.some((isMet) => !isMet) && !isPrinted;
    const within = places.filter((d) => d >= from && d <= to);
    plain.setAttribute("d", offends ? `M${within.map((d) => point(d, inside(d)[material])).join("L")}` : "");
    const ticks = Array.from({ length: Math.round(most / tick) + 1 }, (_, n) => rounded(n * tick, tick));
    grid.replaceChildren(
      ...[1, 0.5].map((fraction) => svg("path", { d: `M${frame.left} ${y(fraction)}H${frame.right}`, class: "plot-dashed" })),
      svg("path", { d: `M${frame.left} ${y(0)}H${frame.right}` }),
      svg("path", { d: `M${frame.left} ${y(0)}V${y(1)}` }),
      ...ticks.map((d) => svg("path", { d: `M${x(d)} ${y(0)}v3` })),
    );
    limits.replaceChildren(...[...(from > 0 ? [from] : []), to].map((d) => svg("path", { d: `M${x(d)} ${frame.top - 14}V${frame.bottom}` })));
    const label = (/** @type {string} */ text, /** @type {string} */ kind, /** @type {number} */ left, /** @type {number} */ top) => {
      const node = h("span", { class: `plot-${kind}` }, text);
      node.style.left = `${left}px`;
      node.style.top = `${top}px`;
      return node;
    };
    // Powers of ten take more room, so that every other number has to do.
    const isLong = most >= LONG.most || tick < LONG.least;
    labels.replaceChildren(
      ...[0, 0.5, 1].map((fraction) => label(String(fraction), "share", frame.left, y(fraction))),
      ...ticks.filter((_, n) => !isLong || n % 2 === 0).map((d) => label(isLong ? numberText(d).replace(/\.?0+(?= )/, "") : fixed(d, decimalsOf(tick)), "tick", x(d), frame.bottom)),
      label(words.plot.short.to, x(to) > frame.right - 40 ? "name before" : "name", x(to), frame.top - 18),
      ...(from > 0 && x(to) - x(from) > 60 ? [label(words.plot.short.from, "name", x(from), frame.top - 18)] : []),
    );
  }

  return {
    element,
    render,
    /** @param {HandleId} which */
    focus: (which) => made.get(which)?.focus({ preventScroll: true }),
  };
}

/** Decimals that a step shows. @param {number} step */
export const decimalsOf = (step) => Math.min(6, Math.max(0, -Math.floor(Math.log10(step) + 1e-9)));

/** @param {Plotted} state @returns {Handle[]} */
function handlesOf({ feature, profile, involved }) {
  const { from, to } = profile;
  const [material] = involved;
  const { handles: names } = words.plot;
  const course = feature.course ?? { kind: "linear" };
  const keys = keysOf(feature);
  const start = feature.start?.[material] ?? 0;
  const end = feature.end?.[material] ?? 0;
  /** @type {Handle[]} */
  const handles = [
    { id: "from", distance: from, fraction: 1, isLimit: true, name: names.from },
    { id: "to", distance: to, fraction: 1, isLimit: true, name: names.to },
  ];
  if (course.kind === "piecewise") {
    keys.forEach(({ at, mix }, n) =>
      handles.push({ id: `key ${n}`, distance: from + at * (to - from), fraction: mix[material], isLimit: false, name: words.plot.key(n, keys.length) }),
    );
    return handles;
  }
  handles.push({ id: "start", distance: from, fraction: start, isLimit: false, name: names.start });
  if (hasMiddle(course) && Math.abs(end - start) > 1e-6) {
    handles.push({ id: "middle", distance: (from + to) / 2, fraction: profile.plain(0.5)[material], isLimit: false, name: names.middle });
  }
  handles.push({ id: "end", distance: to, fraction: end, isLimit: false, name: names.end });
  return handles;
}
