/**
 * The place between the curves: play, slider and its reading.
 *
 * @import { App } from "../state/app.js"
 * @import { CurvesDocument } from "../types.js"
 */
import { shownKey } from "../commands.js";
import { slider } from "../controls/slider.js";
import { attribute, find, h, write } from "../dom.js";
import { fixed } from "../format.js";
import { icon, symbol } from "../icons.js";
import { curveName } from "../state/app.js";
import { countsBack, segmentsOf } from "../state/stages.js";
import { strings } from "../strings.js";

/** Stages past which ticks would run into each other. */
const TICKS = 40;
const STEP = 0.01;

/** @param {App} app */
export function createMorph(app) {
  const still = matchMedia("(prefers-reduced-motion: reduce)");
  const play = h("button", { type: "button", class: "play", "data-play": "" });
  const first = h("span", { class: "morph-end" });
  const last = h("span", { class: "morph-end" });
  const value = h("span", { class: "number strong" });
  const stage = h("span", { class: "morph-stage number" });
  const control = slider(
    { label: strings.morph.slider, name: "s", min: 0, max: 1, step: STEP },
    { change: (s) => app.ui.set({ s: snapped(s, segmentsOf(app.store.document)), playing: false }) },
  );
  const ticks = h("span", { class: "ticks", "aria-hidden": "true" });
  control.element.prepend(ticks);
  control.element.classList.add("large");
  const reading = h(
    "span",
    { class: "morph-reading" },
    symbol("s"),
    " ",
    value,
    h("span", { class: "morph-stage" }, " · "),
    stage,
  );
  find("#morph-controls").append(play, first, control.element, last, reading);

  let drawnTicks = -1;
  let face = "";

  function toggle() {
    const { playing, s } = app.ui.value;
    if (app.store.document.curves.length < 2) {
      app.say(strings.morph.needsTwo);
      return;
    }
    if (still.matches) {
      const segments = segmentsOf(app.store.document);
      const j = Math.floor(s * segments + 1e-9) + 1;
      const next = j > segments ? 0 : j / segments;
      app.ui.set({ s: next, playing: false });
      app.say(strings.morph.spoken(fixed(next, 2), stageText(next, app.store.document)));
      return;
    }
    app.ui.set({ playing: !playing });
    if (!playing) void import("../morph/player.js").then(({ play }) => play(app));
  }
  play.addEventListener("click", toggle);

  return {
    toggle,
    render() {
      const { s, playing } = app.ui.value;
      const { document } = app.store;
      write(first, document.curves[0] ? curveName(document, 0) : "");
      write(last, document.curves[1] ? curveName(document, 1) : "");
      write(value, fixed(s, 2));
      write(stage, stageText(s, document));
      control.set(s);
      attribute(control.input, "aria-valuetext", strings.morph.spoken(fixed(s, 2), stageText(s, document)));
      const whole = document.curves.length === 2;
      play.disabled = !whole;
      control.input.disabled = !whole;
      control.element.classList.toggle("disabled", !whole);
      attribute(control.input, "title", whole ? null : strings.morph.needsTwo);
      const wanted = !whole ? "none" : still.matches ? "step" : playing ? "pause" : "play";
      if (wanted !== face) {
        face = wanted;
        play.replaceChildren(icon(wanted === "none" ? "play" : wanted));
        const label = wanted === "none" ? strings.morph.play : strings.morph[wanted];
        attribute(play, "aria-label", label);
        attribute(play, "title", wanted === "none" ? strings.morph.needsTwo : `${label} (${shownKey("Space")})`);
      }
      const segments = segmentsOf(document);
      const count = segments <= TICKS ? segments : 1;
      if (count === drawnTicks) return;
      drawnTicks = count;
      ticks.replaceChildren(
        ...Array.from({ length: count + 1 }, (_, j) => {
          const tick = h("span", {});
          tick.style.left = `${(100 * j) / count}%`;
          return tick;
        }),
      );
    },
  };
}

/**
 * The stage itself when the slider stands within half a step of it.
 * @param {number} s
 * @param {number} stages
 */
function snapped(s, stages) {
  const stage = Math.round(s * stages) / stages;
  return Math.abs(stage - s) <= STEP / 2 ? stage : s;
}

/** @param {number} s @param {CurvesDocument} document */
function stageText(s, document) {
  const segments = segmentsOf(document);
  const j = (countsBack(document) ? 1 - s : s) * segments;
  const whole = Math.round(j);
  return Math.abs(j - whole) < 1e-6 ? strings.morph.stage(whole, segments) : strings.morph.between(Math.floor(j), segments);
}
