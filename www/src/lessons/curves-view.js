/**
 * A figure of two curves: painted by the kernel like the page's own, with an in-between curve to be moved, and control points where the
 * lesson wants them to be dragged.
 *
 * @import { App } from "../state/app.js"
 * @import { CurvesDocument, Match, Picture, Point } from "../types.js"
 * @import { Figure } from "../../../scripts/lib/lesson.mjs"
 * @import { FigureView, Host } from "./figure.js"
 */
import { slider } from "../controls/slider.js";
import { attribute, h, write } from "../dom.js";
import { fixed } from "../format.js";
import { icon, symbol } from "../icons.js";
import { imageData } from "../kernel.js";
import { devicePixels } from "../painter.js";
import { outline } from "../spline.js";
import { Lane } from "../state/lane.js";
import { shownTotals } from "../state/lines.js";
import { toScreen } from "../view.js";
import { createHandles } from "./handles.js";
import { partsOf } from "./parts.js";
import { words } from "./words.js";

/** Milliseconds from one curve to the other. */
const SWEEP = 4000;
/** Longest side of a picture that the kernel paints. */
const LARGEST = 4096;
/** Length of a normal that is lit, CSS pixels. */
const NORMAL = 14;
/** Steps of the in-between curve that is lit; the slider has as many. */
const FINE = 100;

/**
 * @param {App} app
 * @param {Host} host
 * @param {Figure} figure
 * @returns {FigureView}
 */
export function createCurvesView(app, host, figure) {
  const { kernel, ui } = app;
  const { surface } = host;
  const still = matchMedia("(prefers-reduced-motion: reduce)");
  const canvas = h("canvas", { role: "img", width: 1, height: 1 });
  const status = h("p", { class: "lesson-status" });
  surface.element.prepend(canvas);
  /** @type {CurvesDocument | null} */
  let document = null;
  /** @type {Match | null} */
  let match = null;
  /** @type {Picture | null} */
  let picture = null;
  /** @type {number | null} */
  let s = null;
  let playing = false;
  let moving = false;
  let over = false;
  let direction = 1;
  let before = 0;
  /** The in-between curve at s, once it was asked for. @type {{key: string, points: Point[]} | null} */
  let between = null;
  /** @type {{key: string, all: Point[][]} | null} */
  let betweens = null;

  const play = h("button", { type: "button", class: "play", "data-lesson": "play", onclick: toggle });
  const value = h("span", { class: "number strong", "data-lesson": "s" });
  const control = slider({ label: words.slider, name: "lesson-s", min: 0, max: 1, step: 1 / FINE }, { change: (next) => move(next) });
  control.element.classList.add("large");
  const controls = h("div", { class: "lesson-morph" }, play, control.element, h("span", { class: "lesson-reading" }, symbol("s"), " ", value));
  const handles = figure.controls === "full" ? createHandles(surface, { change: edit, done: settle, say: app.say }) : null;
  if (handles) surface.element.append(handles.element);

  /** @typedef {{document: CurvesDocument, coarse: boolean}} Job */
  /** @type {Lane<Job, {match: Match, picture: Picture}>} */
  const lane = new Lane({
    async work(job, signal) {
      const size = surface.size();
      const most = LARGEST / Math.max(size.width, size.height);
      const options = {
        ...devicePixels(size, Math.min(most, surface.zoom * (window.devicePixelRatio || 1))),
        theme: ui.value.theme,
        patterns: ui.value.patterns,
        s,
        background: false,
        coarse: job.coarse,
        ...(picture && handles && moving ? { view: picture.view } : {}),
      };
      const [found, painted] = await Promise.all([
        kernel.match(job.document, { coarse: job.coarse }, { signal }),
        kernel.paint(job.document, options, { signal }),
      ]);
      return { match: found, picture: painted };
    },
    done(result) {
      if (over) return;
      ({ match, picture } = result);
      host.failed(null);
      canvas.width = picture.width;
      canvas.height = picture.height;
      canvas.getContext("2d")?.putImageData(imageData(picture), 0, 0);
      drawn();
    },
    failed: host.failed,
  });

  function paint() {
    if (document && surface.size().width >= 1) lane.push({ document, coarse: moving });
  }

  /** What follows from a picture: names, numbers and handles on it. */
  function drawn() {
    if (!document || !match || !picture) return;
    attribute(canvas, "aria-label", host.alt());
    handles?.render(document, picture.view);
    drawStatus();
    name();
    host.element.dataset.drawn = "true";
  }

  function drawStatus() {
    if (match?.harmonic && figure.controls !== "none") {
      const { lines, crossings } = match.harmonic;
      const count = (/** @type {string} */ text, /** @type {number} */ number) => h("span", {}, h("span", { class: "strong number" }, String(number)), ` ${text}`);
      status.hidden = false;
      status.replaceChildren(...(crossings === 0 ? [icon("check", 14)] : []), count(words.status.gradientLines, lines), count(words.status.crossings, crossings));
      return;
    }
    const totals = match && shownTotals(match);
    status.hidden = figure.controls === "none" || !totals || !match;
    if (!totals || !match) return;
    const w = words.status;
    const [a, b] = totals.uncovered;
    const item = (/** @type {string | Node} */ label, /** @type {string} */ text, failed = false) =>
      h("span", { class: failed ? "failed" : "" }, label, " ", h("span", { class: "strong number" }, text));
    status.replaceChildren(
      ...(match.ok ? [icon("check", 14)] : []),
      h("span", {}, h("span", { class: "strong number" }, String(totals.count)), ` ${w.lines}`),
      ...(totals.eta === null ? [] : [item(symbol("η"), fixed(totals.eta, 3))]),
      item(w.crossings, String(totals.crossings), totals.crossings > 0),
      ...(totals.blocked > 0 ? [item(w.blocked, String(totals.blocked), true)] : []),
      ...(a.length + b.length > 0 ? [item(w.uncovered, `${a.length} + ${b.length}`, true)] : []),
    );
  }

  /** Tells the ground what the terms of the text name. */
  function name() {
    if (!document || !match || !picture) return;
    const { view } = picture;
    const size = surface.size();
    const at = (/** @type {Point} */ point) => toScreen(view, size, point);
    const outlines = document.curves.map((curve) => outline(curve).map((vertex) => at(vertex.at)));
    const { samples } = match;
    const ends = match.pairs.length > 0
      ? match.pairs.map(({ from, to, verified }) => ({ line: [at(from), at(to)], sound: verified }))
      : match.lines.map(({ from, to, visible }) => ({ line: [at(sample(samples, 0, from)), at(sample(samples, 1, to))], sound: visible }));
    const parts = partsOf(host.terms, {
      first: () => ({ lines: outlines.slice(0, 1) }),
      second: () => ({ lines: outlines.slice(1, 2) }),
      lines: () => ({ lines: ends.map(({ line }) => line) }),
      faults: () => ({ lines: ends.filter(({ sound }) => !sound).map(({ line }) => line) }),
      samples: () => ({ dots: samples.flatMap(({ points }) => points.map(at)) }),
      band: () => ({ area: outlines }),
      normals: () => ({ lines: samples.flatMap(({ points, normals }) => points.map((point, k) => normalAt(at(point), normals[k] ?? [0, 0]))) }),
      stage: () => ({ lines: between ? [closed(between.points.map(at))] : [] }),
      stages: () => ({ lines: (betweens?.all ?? []).map((points) => closed(points.map(at))) }),
    });
    for (const term of host.terms) {
      const line = /^line:(\d+)$/.exec(term);
      const one = line && ends[Number(line[1])];
      if (line) parts.set(term, { lines: one ? [one.line] : [] });
    }
    surface.name(parts);
    void fetchBetween();
  }

  /** Asks for the in-between curves that a term names. */
  async function fetchBetween() {
    const here = document;
    if (!here || !match?.ok) return;
    try {
      const own = `${JSON.stringify(here)} ${s}`;
      if (host.terms.has("stage") && s !== null && between?.key !== own && !playing && !moving) {
        const at = Math.round(s * FINE);
        const stages = await kernel.stages({ ...here, blend: { ...here.blend, stages: FINE } }, { refine: 4 });
        if (over || document !== here) return;
        between = { key: own, points: stages[at]?.points ?? [] };
        name();
      }
      const all = JSON.stringify(here);
      if (host.terms.has("stages") && betweens?.key !== all && !moving) {
        const stages = await kernel.stages(here, { refine: 4 });
        if (over || document !== here) return;
        betweens = { key: all, all: stages.slice(1, -1).map(({ points }) => points) };
        name();
      }
    } catch {
      // The figure itself says what is wrong with its document; without in-between curves a term lights nothing.
    }
  }

  /** @param {number} next */
  function move(next) {
    playing = false;
    s = next;
    host.touched();
    paint();
    face();
  }

  function toggle() {
    host.touched();
    if (still.matches) {
      const stages = document?.blend.stages ?? 1;
      const j = Math.floor((s ?? 0) * stages + 1e-9) + 1;
      move(j > stages ? 0 : j / stages);
      app.say(`s ${fixed(s ?? 0, 2)}`);
      return;
    }
    playing = !playing;
    face();
    if (!playing) return;
    before = performance.now();
    requestAnimationFrame(frame);
  }

  /** @param {number} now */
  function frame(now) {
    if (!playing || over) return;
    const elapsed = Math.min(100, now - before);
    before = now;
    let next = (s ?? 0) + (direction * elapsed) / SWEEP;
    if (next >= 1) [next, direction] = [1, -1];
    if (next <= 0) [next, direction] = [0, 1];
    s = next;
    paint();
    face();
    requestAnimationFrame(frame);
  }

  let shown = "";
  function face() {
    control.set(s ?? 0);
    write(value, fixed(s ?? 0, 2));
    attribute(control.input, "aria-valuetext", fixed(s ?? 0, 2));
    const wanted = still.matches ? "step" : playing ? "pause" : "play";
    if (wanted === shown) return;
    shown = wanted;
    play.replaceChildren(icon(wanted));
    attribute(play, "aria-label", words[wanted]);
    attribute(play, "title", words[wanted]);
  }

  /** @param {CurvesDocument} next */
  function edit(next) {
    moving = true;
    document = next;
    host.touched();
    if (picture) handles?.render(next, picture.view);
    paint();
  }

  function settle() {
    moving = false;
    paint();
  }

  return {
    status,
    controls: figure.s !== null && figure.controls !== "none" ? controls : null,
    show(next) {
      playing = moving = false;
      document = next;
      picture = null;
      s = figure.s ?? null;
      face();
      paint();
    },
    draw: paint,
    state: () => (document ? { document, s, step: null } : null),
    close() {
      over = true;
      playing = false;
      lane.cancel();
    },
  };
}

/** @param {Match["samples"]} samples @param {number} curve @param {number} vertex @returns {Point} */
const sample = (samples, curve, vertex) => samples[curve]?.points[vertex] ?? [0, 0];

/** @param {Point} at @param {Point} normal @returns {Point[]} */
const normalAt = (at, [x, y]) => [at, [at[0] + NORMAL * x, at[1] - NORMAL * y]];

/** @param {Point[]} points */
const closed = (points) => [...points, ...points.slice(0, 1)];
