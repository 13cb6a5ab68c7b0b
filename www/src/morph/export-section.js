/**
 * The export of the morph, a part of the export panel: an animated SVG, its frames, a film, and the two paths.
 *
 * @import { App } from "../state/app.js"
 * @import { MorphPaths } from "../../../js/directrix.js"
 * @import { PathText } from "./path-texts.js"
 *
 * @typedef {"svg" | "png" | "webm" | "paths"} Kind
 *
 * @typedef {object} Section
 * @property {HTMLElement} element
 * @property {() => void} render
 * @property {() => void} close
 */
import "../../styles/morph.css";
import { segment } from "../controls/choices.js";
import { numberField } from "../controls/number-field.js";
import { row } from "../controls/row.js";
import { select } from "../controls/select.js";
import { h, write } from "../dom.js";
import { copyText } from "../files/clipboard.js";
import { download } from "../files/download.js";
import { fileName } from "../files/names.js";
import { pictureRows } from "../files/picture-rows.js";
import { scaledSize, svgOf } from "../files/pictures.js";
import { significantText } from "../format.js";
import { blendOf } from "../harmonic/blend.js";
import { words as flow } from "../harmonic/words.js";
import { problem } from "../painter.js";
import { isHarmonic, lookedAt } from "../state/look.js";
import { words as stackWords } from "../stack/words.js";
import { animatedStack } from "./animated-stack.js";
import { animatedFigure, animatedShape } from "./animated-svg.js";
import { LARGEST_FILM, RATES, encoderFor, film } from "./film.js";
import { FEWEST_FRAMES, MOST_FRAMES, MOST_PIXELS, pngSequence } from "./frames.js";
import { motionRows } from "./motion-rows.js";
import { pathText } from "./path-texts.js";
import { words } from "./words.js";

const TYPES = { svg: "image/svg+xml", json: "application/json", css: "text/css", smil: "image/svg+xml" };
const ENDINGS = { svg: "svg", json: "json", css: "css", smil: "svg" };
/** Tolerance until another is chosen, and the range offered, as shares of the diagonal of the box of both curves. */
const TOLERANCE = 1e-4;
const FINEST = 1e-8;
const COARSEST = 0.1;
/** Stages from curve to curve of a cubic that plays. */
const SMOOTH = 8;
/** Milliseconds after the last edit before paths are asked for. */
const PAUSE = 150;

/** What was chosen last, for as long as the page is open. */
const last = {
  /** @type {Kind} */ kind: "svg",
  /** @type {"figure" | "shape"} */ shows: "figure",
  frames: 60,
  /** @type {(typeof RATES)[number]} */ rate: "30",
  /** @type {PathText} */ text: "svg",
  transparent: false,
};

/**
 * @param {App} app
 * @returns {Section}
 */
export function createMorphExport(app) {
  const wanted = { ...last, theme: app.ui.value.theme, ...scaledSize(app.ui.value.size, Math.min(1, LARGEST_FILM / Math.max(app.ui.value.size.width, app.ui.value.size.height))) };
  /** @type {number | null} null: the default of the document */
  let tolerance = null;
  /** @type {MorphPaths | null} */
  let paths = null;
  /** @type {AbortController | null} */
  let work = null;
  let canFilm = true;
  /** Whether the message says why there are no paths. */
  let unmatched = false;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let timer;

  const kind = select(
    {
      label: words.kind,
      name: "morph-kind",
      choices: /** @type {const} */ (["svg", "png", "webm", "paths"]).map((value) => ({ value, text: words.kinds[value] })),
    },
    (value) => change({ kind: value }),
  );
  const shows = segment(
    {
      label: words.shows,
      name: "morph-shows",
      choices: /** @type {const} */ (["figure", "shape"]).map((value) => ({ value, text: words.showns[value] })),
    },
    (value) => change({ shows: value }),
  );
  const frames = numberField(
    { label: words.frames, name: "morph-frames", min: FEWEST_FRAMES, max: MOST_FRAMES, step: 1, decimals: 0, whole: true },
    { change: (value) => change({ frames: value }) },
  );
  const rate = select(
    { label: words.rate, name: "morph-rate", choices: RATES.map((value) => ({ value, text: value })) },
    (value) => change({ rate: value }),
  );
  const picture = pictureRows({ name: "morph", largest: LARGEST_FILM }, change);
  const within = numberField(
    {
      label: words.toleranceLabel(app.store.document.unit),
      name: "morph-tolerance",
      min: rounded(FINEST * diagonal(app)),
      max: rounded(COARSEST * diagonal(app)),
      step: () => (tolerance ?? TOLERANCE * diagonal(app)) / 2,
      decimals: 0,
    },
    {
      change: (value) => {
        tolerance = value;
        change({});
      },
    },
  );
  const text = segment(
    {
      label: words.text,
      name: "morph-text",
      choices: /** @type {const} */ (["svg", "json", "css", "smil"]).map((value) => ({ value, text: words.texts[value] })),
    },
    (value) => change({ text: value }),
  );
  const motion = motionRows(app, "export");

  const rows = {
    shows: row(words.shows, shows),
    size: picture.size,
    frames: row(words.frames, frames),
    rate: row(words.rate, rate),
    theme: picture.theme,
    background: picture.background,
    tolerance: row(words.tolerance, within),
    text: row(words.text, text),
    motion: motion.element,
  };
  /** @type {{[kind in Kind]: (keyof typeof rows)[]}} */
  const shown = {
    svg: ["shows", "theme", "background", "motion"],
    png: ["size", "frames", "theme", "background", "motion"],
    webm: ["size", "rate", "theme", "motion"],
    paths: ["tolerance", "text", "motion"],
  };

  const certificate = h("p", { class: "export-note morph-certificate", "data-certificate": "" });
  const code = h("textarea", { class: "morph-code", readOnly: true, spellcheck: false, "data-code": "" });
  const note = h("p", { class: "export-note", "data-note": "" });
  const bar = h("progress", { class: "morph-progress", max: 1, "aria-label": words.progress, hidden: true });
  const message = h("p", { class: "export-message", "data-message": "morph", hidden: true });
  const button = (/** @type {string} */ name, /** @type {string} */ label, /** @type {() => void} */ act) =>
    h("button", { type: "button", class: "push", "data-morph": name, onclick: act }, label);
  const save = button("download", words.download, () => void run(saved));
  const copy = button("copy", words.copy, () => void run(copied));
  const cancel = button("cancel", words.cancel, () => work?.abort());

  const element = h(
    "div",
    { class: "morph-export" },
    row(words.kind, kind),
    rows.tolerance,
    rows.text,
    rows.shows,
    rows.size,
    rows.frames,
    rows.rate,
    rows.theme,
    rows.background,
    rows.motion,
    certificate,
    code,
    note,
    bar,
    h("div", { class: "export-acts" }, save, copy, cancel),
    message,
  );

  /** @param {Partial<typeof wanted>} patch */
  function change(patch) {
    Object.assign(wanted, patch);
    const { kind, shows, frames, rate, text, transparent } = wanted;
    Object.assign(last, { kind, shows, frames, rate, text, transparent });
    tell(null);
    render();
    if (!("text" in patch)) soon();
  }

  function render() {
    kind.set(wanted.kind);
    shows.set(wanted.shows);
    frames.set(wanted.frames);
    rate.set(wanted.rate);
    picture.set(wanted);
    within.set(rounded(tolerance ?? TOLERANCE * diagonal(app)));
    text.set(wanted.text);
    motion.render();
    for (const [name, element] of Object.entries(rows)) {
      element.hidden = !shown[wanted.kind].some((each) => each === name);
    }
    motion.duration.hidden = wanted.kind === "png";
    if (wanted.kind === "paths") rows.motion.hidden = wanted.text === "svg" || wanted.text === "json";
    const isPaths = wanted.kind === "paths";
    certificate.hidden = code.hidden = !isPaths || paths === null;
    code.setAttribute("aria-label", words.code(words.texts[wanted.text]));
    if (isPaths && paths) {
      const unit = app.store.document.unit;
      write(certificate, words.certificate(paths.commands, `${significantText(paths.error)} ${unit}`.trim()));
      const made = written(paths);
      if (code.value !== made) code.value = made;
    }
    write(note, noteOf());
    copy.hidden = wanted.kind === "png" || wanted.kind === "webm";
    cancel.hidden = work === null;
    const barred = work !== null || (wanted.kind === "webm" && !canFilm);
    for (const each of [save, copy]) each.setAttribute("aria-disabled", String(barred));
  }

  function noteOf() {
    const { kind, shows, text } = wanted;
    if (kind === "svg") return words.notes.svg[shows];
    if (kind === "png") return words.notes.png(words.megapixels(MOST_PIXELS / 1e6));
    if (kind === "webm") return canFilm ? words.notes.webm : words.noVideo;
    return words.notes.paths[text];
  }

  /** Asks for what the shown kind needs to know, once edits rest. */
  function soon() {
    clearTimeout(timer);
    if (wanted.kind === "webm") {
      void encoderFor(wanted, Number(wanted.rate)).then((found) => {
        canFilm = found !== null;
        render();
      });
    }
    if (wanted.kind === "paths") timer = setTimeout(() => void refresh(), PAUSE);
  }

  async function refresh() {
    try {
      paths = await found();
      if (unmatched) tell(null);
      unmatched = false;
    } catch (error) {
      paths = null;
      unmatched = true;
      tell(words.failed(plain(error)), true);
    }
    render();
  }

  const isFlow = () => isHarmonic(lookedAt(app));
  const isStack = () => app.store.document.curves.length > 2;

  /** The stages of a stack, with as many from curve to curve as a cubic needs to look like one. */
  async function stages() {
    const { document } = app.store;
    const finer = Math.max(document.blend.stages, document.blend.kind === "cubic" ? SMOOTH : 1);
    const { printed: _, ...matching } = document.matching;
    const found = await app.kernel.stages({ ...document, matching, blend: { ...document.blend, stages: finer } });
    if (found.length === 0) throw new Error(words.unmatched);
    return found;
  }

  /** Whether there is a harmonic blend to be played. */
  async function levels() {
    if (!(await blendOf(app)).ok) throw new Error(flow.noBlend);
  }

  /** The paths of the document as it stands. */
  async function found() {
    if (isFlow()) throw new Error(flow.noPaths);
    if (isStack()) throw new Error(stackWords.onePath);
    const made = await app.kernel.morphPaths(app.store.document, wanted.kind === "paths" && tolerance !== null ? { tolerance } : {});
    if (!made) throw new Error(words.unmatched);
    return made;
  }

  /** @param {MorphPaths} made */
  function written(made) {
    const { title, materials } = app.store.document;
    return pathText(wanted.text, made, { title, materials, motion: app.ui.value.motion });
  }

  /** The text of what is one. @returns {Promise<string>} */
  async function content() {
    if (wanted.kind === "paths") {
      paths = await found();
      return written(paths);
    }
    const { title, materials } = app.store.document;
    const { size, view, layers, patterns, motion } = app.ui.value;
    if (isFlow()) throw new Error(wanted.shows === "shape" ? flow.noShape : flow.noPlaying);
    if (isStack()) {
      if (wanted.shows === "shape" || !view) throw new Error(stackWords.onePath);
      const closed = app.store.document.curves[0].form !== "open";
      return animatedStack(await svgOf(app, wanted, { s: null }), view, { stages: await stages(), closed, motion, size });
    }
    const made = await found();
    const options = { paths: made, motion, materials, size, theme: wanted.theme };
    if (wanted.shows === "shape" || !view) return animatedShape(title, wanted.transparent, options);
    const figure = await svgOf(app, wanted, { s: null });
    const onBand = patterns || layers.includes("material") || layers.includes("unitCells");
    return animatedFigure(figure, view, onBand, options);
  }

  /** @param {AbortSignal} signal @returns {Promise<string>} */
  async function saved(signal) {
    const title = fileName(app.store.document.title);
    const onframe = (/** @type {number} */ done, /** @type {number} */ of) => {
      bar.value = done / of;
      bar.hidden = false;
      // Frames pass faster than they can be spoken.
      message.hidden = false;
      write(message, words.frame(done, of));
    };
    const { motion } = app.ui.value;
    const { kind, theme, width, height, transparent, text } = wanted;
    const working = { signal, onframe };
    if (kind === "png" || kind === "webm") await (isFlow() ? levels() : isStack() ? stages() : found());
    if (kind === "png") {
      const sequence = { width, height, theme, transparent, motion, count: wanted.frames };
      return handed(await pngSequence(app, sequence, title, working), `${title}-frames.zip`);
    }
    if (kind === "webm") {
      const blob = await film(app, { width, height, theme, motion, rate: Number(wanted.rate) }, working);
      return handed(blob, `${title}.webm`);
    }
    const type = kind === "svg" ? TYPES.svg : TYPES[text];
    const name = kind === "svg" ? `${title}-morph.svg` : `${title}-paths${text === "smil" ? "-smil" : ""}.${ENDINGS[text]}`;
    return handed(new Blob([await content()], { type }), name);
  }

  /** @param {Blob} blob @param {string} name */
  function handed(blob, name) {
    download(blob, name);
    return words.downloaded(name);
  }

  async function copied() {
    await copyText(content());
    return words.copied;
  }

  /** @param {string | null} line @param {boolean} [failed] */
  function tell(line, failed = false) {
    message.hidden = line === null;
    message.classList.toggle("failed", failed);
    write(message, line ?? "");
    if (line !== null) app.say(line);
  }

  /** @param {(signal: AbortSignal) => Promise<string>} act */
  async function run(act) {
    if (work || save.ariaDisabled === "true") return;
    const mine = new AbortController();
    work = mine;
    tell(null);
    render();
    try {
      tell(await act(mine.signal));
    } catch (error) {
      if (mine.signal.aborted) tell(words.cancelled);
      else tell(words.failed(plain(error)), true);
    }
    work = null;
    bar.hidden = true;
    bar.value = 0;
    const held = document.activeElement === cancel;
    render();
    if (held) save.focus();
  }

  const listeners = [
    app.ui.subscribe((ui, before) => {
      if (ui.motion !== before.motion) render();
    }),
    app.store.subscribe(soon),
  ];
  render();
  soon();
  return {
    element,
    render,
    close() {
      clearTimeout(timer);
      work?.abort();
      for (const stop of listeners) stop();
    },
  };
}

/** The diagonal of the box of all control points. @param {App} app */
function diagonal({ store }) {
  const points = store.document.curves.flatMap((curve) => curve.points);
  if (points.length === 0) return 1;
  const reach = [0, 1].map((axis) => {
    const values = points.map((point) => point[axis] ?? 0);
    return Math.max(...values) - Math.min(...values);
  });
  return Math.hypot(...reach);
}

/** @param {number} value */
const rounded = (value) => Number(value.toPrecision(2));

/** @param {unknown} error */
const plain = (error) => problem(error).message.replace(/\.$/, "");
