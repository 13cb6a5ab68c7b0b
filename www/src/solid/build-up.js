/**
 * How much of the body stands: play, slider and its reading, at the foot of the picture.
 *
 * @import { App } from "../state/app.js"
 */
import { slider } from "../controls/slider.js";
import { attribute, h, write } from "../dom.js";
import { fixed } from "../format.js";
import { icon, symbol } from "../icons.js";
import { shownKey } from "../commands.js";
import { curveName } from "../state/app.js";
import { segmentsOf } from "../state/stages.js";
import { words } from "./words.js";

const STEP = 0.005;
/** Stages past which ticks would run into each other. */
const TICKS = 40;
/** Milliseconds from the first curve to the last. */
const LASTS = 4000;

/**
 * @param {App} app
 * @param {object} acts
 * @param {() => number} acts.read how much stands, 0 to 1
 * @param {(upTo: number) => void} acts.set
 * @param {() => void} acts.rest the place is not changed for now
 */
export function createBuildUp(app, { read, set, rest }) {
  const still = matchMedia("(prefers-reduced-motion: reduce)");
  const play = h("button", { type: "button", class: "play", "data-solid-play": "", onclick: () => toggle() });
  const first = h("span", { class: "morph-end" });
  const last = h("span", { class: "morph-end" });
  const value = h("span", { class: "number strong" });
  const stage = h("span", { class: "number" });
  const control = slider(
    { label: words.upTo.slider, name: "up-to", min: 0, max: 1, step: STEP },
    {
      change(upTo) {
        stop();
        set(snapped(upTo, segments()));
      },
      end: rest,
    },
  );
  const ticks = h("span", { class: "ticks", "aria-hidden": "true" });
  control.element.prepend(ticks);
  control.element.classList.add("large");
  const reading = h("span", { class: "morph-reading" }, symbol("s"), " ", value, h("span", { class: "morph-stage" }, " · ", stage));
  const element = h(
    "div",
    { class: "morph-controls", role: "group", "aria-label": words.upTo.region, "data-furniture": "" },
    play,
    first,
    control.element,
    last,
    reading,
  );
  let frame = 0;
  let face = "";
  let isPossible = false;

  const segments = () => segmentsOf(app.store.document);

  function stop() {
    cancelAnimationFrame(frame);
    frame = 0;
  }

  function toggle() {
    if (!isPossible) return app.say(words.upTo.notFlat);
    const from = read() >= 1 ? 0 : read();
    if (still.matches) {
      const next = Math.floor(from * segments() + 1e-9) + 1;
      const upTo = Math.min(1, next / segments());
      set(upTo);
      rest();
      app.say(`s ${fixed(upTo, 2)}, ${stageText(upTo)}`);
      return;
    }
    if (frame) {
      stop();
      rest();
      set(read());
      return;
    }
    const started = performance.now() - from * LASTS;
    const go = (/** @type {number} */ time) => {
      const upTo = Math.min(1, Math.max(0, (time - started) / LASTS));
      frame = upTo < 1 ? requestAnimationFrame(go) : 0;
      set(upTo);
      if (upTo === 1) rest();
    };
    frame = requestAnimationFrame(go);
  }

  /** @param {number} s */
  function stageText(s) {
    const j = s * segments();
    const whole = Math.round(j);
    return Math.abs(j - whole) < 1e-6 ? words.upTo.stage(whole, segments()) : words.upTo.between(Math.floor(j), segments());
  }

  return {
    element,
    toggle,
    close: stop,
    /** @param {boolean} possible whether the body can be built up */
    render(possible) {
      isPossible = possible;
      const { curves } = app.store.document;
      const s = possible ? read() : 1;
      write(first, curves.length > 0 ? curveName(app.store.document, 0) : "");
      write(last, curves.length > 1 ? curveName(app.store.document, curves.length - 1) : "");
      write(value, fixed(s, 2));
      write(stage, stageText(s));
      control.set(s);
      control.input.disabled = !possible;
      control.element.classList.toggle("disabled", !possible);
      attribute(control.input, "title", possible ? null : words.upTo.notFlat);
      attribute(control.input, "aria-valuetext", `s ${fixed(s, 2)}, ${stageText(s)}`);
      const count = segments() <= TICKS ? segments() : 1;
      if (ticks.childElementCount !== count + 1) ticks.replaceChildren(...Array.from({ length: count + 1 }, (_, j) => tickAt(j / count)));
      attribute(play, "aria-disabled", possible ? null : "true");
      const wanted = still.matches ? "step" : frame ? "pause" : "play";
      attribute(play, "title", possible ? `${words.upTo[wanted]} (${shownKey("Space")})` : words.upTo.notFlat);
      if (wanted === face) return;
      face = wanted;
      play.replaceChildren(icon(wanted));
      attribute(play, "aria-label", words.upTo[wanted]);
    },
  };
}

/** @param {number} share */
function tickAt(share) {
  const tick = h("span", {});
  tick.style.left = `${100 * share}%`;
  return tick;
}

/** The stage itself when the slider stands within half a step of it. @param {number} s @param {number} stages */
function snapped(s, stages) {
  const stage = Math.round(s * stages) / stages;
  return Math.abs(stage - s) <= STEP / 2 ? stage : s;
}
