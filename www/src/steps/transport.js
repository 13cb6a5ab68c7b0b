/**
 * The controls below the picture: first, back, play, forward, last, the scrubber with f of every step above it, speed and the game.
 *
 * @import { Steps } from "../../../js/directrix.js"
 *
 * @typedef {object} Acts
 * @property {(at: number) => void} goTo
 * @property {(by: number) => void} goBy
 * @property {() => void} toggle play or pause
 * @property {(speed: number) => void} setSpeed
 * @property {() => void} togglePrediction
 */
import "../../styles/step-controls.css";
import { slider } from "../controls/slider.js";
import { attribute, h, svg, write } from "../dom.js";
import { icon } from "../icons.js";
import { phaseAt, values } from "./film.js";
import { words } from "./words.js";

/** Lines a second at each speed are twice these. */
const SPEEDS = [0.5, 1, 2, 4, 8];
/** Height of the highest bar and least height of one, CSS pixels. */
const HIGHEST = 20;
const LOWEST = 2;
/** Room that the name of a phase takes below the scrubber, CSS pixels. */
const MARK = 56;

/** Paths of the icons of first, back, forward and last. */
const ICONS = {
  first: "M4 3.5v9M12 3.5 7 8l5 4.5",
  back: "m9.75 3.5-5 4.5 5 4.5",
  forward: "m6.25 3.5 5 4.5-5 4.5",
  last: "M12 3.5v9M4 3.5 9 8l-5 4.5",
};

/** @param {Acts} acts */
export function createTransport(acts) {
  const button = (/** @type {keyof typeof ICONS} */ name, /** @type {() => void} */ act) =>
    h(
      "button",
      { type: "button", class: "bare icon-only", "aria-label": words[name], title: words[name], "data-steps": name, onclick: act },
      /** @type {any} */ (svg("svg", { viewBox: "0 0 16 16", width: 16, height: 16, "aria-hidden": "true", class: "icon" }, svg("path", { d: ICONS[name], class: "icon-line" }))),
    );
  const first = button("first", () => acts.goTo(0));
  const back = button("back", () => acts.goBy(-1));
  const forward = button("forward", () => acts.goBy(1));
  const last = button("last", () => acts.goTo(Infinity));
  const play = h("button", { type: "button", class: "play", "data-steps": "play", onclick: acts.toggle });
  const step = h("span", { class: "strong number" });
  const total = h("span", { class: "number" });
  const reading = h("span", { class: "steps-reading" }, h("span", { class: "long" }, words.stepOf[0]), step, words.stepOf[1], total);
  const control = slider({ label: words.scrubber, name: "step", min: 0, max: 1, step: 1 }, { change: acts.goTo });
  control.element.classList.add("large");
  const bars = ["done", "current", "rest"].map((name) => svg("path", { class: `bar-${name}` }));
  const plot = svg("svg", { class: "steps-bars", "aria-hidden": "true" }, ...bars);
  const marks = h("span", { class: "steps-marks", "aria-hidden": "true" });
  const scrubber = h("div", { class: "steps-scrubber" }, /** @type {any} */ (plot), control.element, marks);
  const speed = h(
    "select",
    { "aria-label": words.speed, "data-steps": "speed", onchange: () => acts.setSpeed(Number(speed.value)) },
    ...SPEEDS.map((value) => h("option", { value: String(value) }, `${value}×`)),
  );
  speed.value = "1";
  const predict = h(
    "button",
    { type: "button", class: "steps-predict", "data-furniture": "", "data-steps": "predict", onclick: acts.togglePrediction, "aria-label": words.predict },
    words.predictShort,
    h("span", { class: "long" }, words.predictRest),
  );
  const element = h(
    "div",
    { class: "steps-transport", role: "group", "aria-label": words.transport, "data-furniture": "" },
    h("span", { class: "steps-buttons" }, first, back, play, forward, last),
    reading,
    scrubber,
    h("label", { class: "steps-speed" }, h("span", {}, words.speedLabel), h("span", { class: "field" }, speed)),
  );

  let face = "";
  let drawn = "";
  /** @type {Steps | null} */
  let marked = null;
  let markedAt = "";

  return {
    element,
    predict,
    /**
     * @param {object} state
     * @param {Steps} state.steps
     * @param {number} state.at
     * @param {number} state.total
     * @param {string} state.text of the step, to be spoken
     * @param {boolean} state.playing
     * @param {boolean} state.still motion is not wanted: play takes one step
     * @param {boolean} state.predicting
     */
    render({ steps, at, total: end, text, playing, still, predicting }) {
      write(step, String(at));
      write(total, String(end));
      control.setMax(end);
      control.set(at);
      attribute(control.input, "aria-valuetext", text);
      first.disabled = back.disabled = at === 0;
      forward.disabled = last.disabled = at === end;
      const wanted = still || predicting ? "step" : playing ? "pause" : "play";
      if (wanted !== face) {
        face = wanted;
        play.replaceChildren(icon(wanted));
        attribute(play, "aria-label", words[wanted]);
        attribute(play, "title", words[wanted]);
      }
      attribute(predict, "aria-pressed", String(predicting));
      drawBars(steps, at, end);
      drawMarks(steps, end);
    },
  };

  /** @param {Steps} steps @param {number} at @param {number} end */
  function drawBars(steps, at, end) {
    const width = scrubber.clientWidth;
    const key = `${width} ${at} ${end}`;
    if (width === 0 || (key === drawn && marked === steps)) return;
    drawn = key;
    const all = values(steps);
    const most = Math.max(...all, 0);
    const paths = ["", "", ""];
    all.forEach((value, k) => {
      const height = most > 0 ? Math.max(LOWEST, (HIGHEST * Math.max(0, value)) / most) : LOWEST;
      const place = k + 1 < at ? 0 : k + 1 === at ? 1 : 2;
      paths[place] += `M${((width * (k + 1)) / end).toFixed(1)} ${HIGHEST + 2}v${(-height).toFixed(1)}`;
    });
    plot.style.strokeWidth = `${Math.min(2, Math.max(0.6, (0.45 * width) / end))}px`;
    bars.forEach((bar, k) => attribute(bar, "d", paths[k] ?? ""));
  }

  /** Names where the phases begin. @param {Steps} steps @param {number} end */
  function drawMarks(steps, end) {
    const width = scrubber.clientWidth;
    const key = `${width} ${end} ${steps.growth.length}`;
    if (width === 0 || (marked === steps && key === markedAt)) return;
    marked = steps;
    markedAt = key;
    /** @type {Map<string, number>} */
    const starts = new Map();
    for (let at = 1; at < end; at++) {
      const { phase } = phaseAt(steps, at);
      const name = phase === "second" ? "first" : phase;
      if (!starts.has(name)) starts.set(name, at);
    }
    let free = width;
    marks.replaceChildren(
      ...[...starts].reverse().map(([name, at]) => {
        const place = (width * at) / end;
        const fits = free - place > MARK;
        if (fits) free = place;
        const mark = h("span", {}, fits ? words.marks[/** @type {keyof typeof words.marks} */ (name)] : "");
        mark.style.left = `${(100 * at) / end}%`;
        return mark;
      }),
    );
  }
}
