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
import { isHarmonic, lookedAt } from "../state/look.js";
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
    { change: (s) => app.ui.set({ s: snapped(s, places()), playing: false }) },
  );
  /** Places of the stages. Those of a stack follow the ways between its curves, which the result knows. */
  function places() {
    const { document } = app.store;
    // The potential goes from all inner curves to the outer one at once.
    const [segments, spans] = [segmentsOf(document), isHarmonic(lookedAt(app)) ? 1 : Math.max(1, document.curves.length - 1)];
    const known = app.results.value.match?.knots;
    const knots = known?.length === spans + 1 ? known : Array.from({ length: spans + 1 }, (_, k) => k / spans);
    const between = knots.slice(1).flatMap((to, k) => Array.from({ length: segments }, (_, j) => knots[k] + ((to - knots[k]) * j) / segments));
    return [...between, 1];
  }
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

  let drawnTicks = "";
  let face = "";

  function toggle() {
    const { playing, s } = app.ui.value;
    if (app.store.document.curves.length < 2) {
      app.say(strings.morph.needsTwo);
      return;
    }
    if (still.matches) {
      const next = places().find((place) => place > s + 1e-9) ?? 0;
      app.ui.set({ s: next, playing: false });
      app.say(strings.morph.spoken(fixed(next, 2), stageText(next, places(), app.store.document)));
      return;
    }
    app.ui.set({ playing: !playing });
    if (!playing) void import("../morph/player.js").then(({ play }) => play(app));
  }
  play.addEventListener("click", toggle);

  /**
   * The curves at the ends of the slider; -1: all the inner ones.
   * @param {CurvesDocument} document
   * @param {number} end
   */
  function endsOf(document, end) {
    if (!isHarmonic(lookedAt(app)) || end < 1) return [0, end];
    const outer = app.results.value.match?.harmonic?.outer ?? end;
    return [end > 1 ? -1 : 1 - outer, outer];
  }

  return {
    toggle,
    render() {
      const { s, playing } = app.ui.value;
      const { document } = app.store;
      const end = document.curves.length - 1;
      const [from, to] = endsOf(document, end);
      write(first, end < 0 ? "" : from < 0 ? strings.curves.inner : curveName(document, from));
      write(last, end > 0 ? curveName(document, to) : "");
      write(value, fixed(s, 2));
      const all = places();
      write(stage, stageText(s, all, document));
      control.set(s);
      attribute(control.input, "aria-valuetext", strings.morph.spoken(fixed(s, 2), stageText(s, all, document)));
      const whole = document.curves.length > 1;
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
      // Too many would run into each other: the curves stay.
      const ticked = all.length - 1 <= TICKS ? all : all.filter((_, j) => j % segments === 0);
      const key = ticked.join(" ");
      if (key === drawnTicks) return;
      drawnTicks = key;
      ticks.replaceChildren(
        ...ticked.map((place) => {
          const tick = h("span", {});
          tick.style.left = `${100 * place}%`;
          return tick;
        }),
      );
    },
  };
}

/**
 * The stage itself when the slider stands within half a step of it.
 * @param {number} s
 * @param {number[]} places of the stages
 */
const snapped = (s, places) => places.find((stage) => Math.abs(stage - s) <= STEP / 2) ?? s;

/** @param {number} s @param {number[]} places of the stages @param {CurvesDocument} document */
function stageText(s, places, document) {
  const last = places.length - 1;
  const at = places.findIndex((place) => Math.abs(place - s) < 1e-6);
  const before = places.findLastIndex((place) => place <= s);
  if (at >= 0) return strings.morph.stage(countsBack(document) ? last - at : at, last);
  return strings.morph.between(countsBack(document) ? last - before - 1 : before, last);
}
