/**
 * A mix of materials: one bar for each, and for three a triangle. Whatever is moved, the fractions stay at least 0 and sum to 1.
 *
 * @import { Material } from "../types.js"
 * @import { Editing } from "./run.js"
 */
import { ARROWS, stride } from "./arrows.js";
import { attribute, h, write } from "../dom.js";
import { percent } from "../format.js";
import { fromTriangle, inTriangle, withFraction, written } from "../state/mix.js";
import { strings } from "../strings.js";
import { mixed } from "../oklab.js";
import { words } from "./mixing-words.js";
import { numberField } from "./number-field.js";
import { newRun } from "./run.js";
import { slider } from "./slider.js";
import { TALL, triangle } from "./triangle.js";

/** Side of the triangle, CSS pixels. */
const SIDE = 128;
const STEP = 0.01;

/**
 * @param {Editing<number[]>} editing
 */
export function mixingControl(editing) {
  /** @type {Material[]} */
  let materials = [];
  /** @type {number[]} */
  let mix = [];
  /** @type {number[]} */
  let used = [];
  /** The mix when the open run began: its proportions come back when a bar goes to its end and back. */
  let base = { run: "", mix };

  /** @param {number} index @param {number} fraction @param {string} [run] */
  function change(index, fraction, run) {
    if (run === undefined || run !== base.run) base = { run: run ?? "", mix };
    editing.change(withFraction(base.mix, index, fraction, used), run);
  }

  const bars = h("div", { class: "mix-bars" });
  /** @type {ReturnType<typeof createBar>[]} */
  const rows = [];

  /** @param {number} index */
  function createBar(index) {
    const swatch = h("span", { class: "mix-swatch", "aria-hidden": "true" });
    const name = h("span", { class: "mix-name" });
    const track = slider(
      { label: "", name: `mix-${index}`, min: 0, max: 1, step: STEP },
      { ...editing, change: (value, run) => change(index, value, run) },
    );
    const field = numberField(
      { label: "", name: `percent-${index}`, min: 0, max: 100, step: 1, decimals: 0 },
      { ...editing, change: (value, run) => change(index, value / 100, run) },
    );
    field.element.classList.add("short");
    const input = /** @type {HTMLInputElement} */ (field.element.querySelector("input"));
    return {
      element: h("div", { class: "mix-bar" }, swatch, name, track.element, field.element, field.error),
      render() {
        const material = materials[index];
        swatch.style.backgroundColor = material.color;
        write(name, material.name);
        attribute(track.input, "aria-label", words.bar(material.name));
        attribute(input, "aria-label", words.percent(material.name));
        attribute(track.input, "aria-valuetext", percent(mix[index]));
        track.set(mix[index]);
        field.set(Number((mix[index] * 100).toFixed(2)));
      },
    };
  }

  const pad = createPad(editing, () => mix);
  const element = h("div", { class: "mixing", role: "group", "aria-label": words.group }, pad.element, bars);

  return {
    element,

    /**
     * @param {{materials: Material[], mix: number[], used: number[], three: [number, number, number] | null}} state
     *   `used`: materials that a pure mix shares with first; `three`: those of the triangle, if there is one
     */
    render(state) {
      ({ materials, mix, used } = state);
      while (rows.length < materials.length) {
        const row = createBar(rows.length);
        rows.push(row);
        bars.append(row.element);
      }
      while (rows.length > materials.length) rows.pop()?.element.remove();
      for (const row of rows) row.render();
      const three = state.three?.every((i) => mix[i] !== undefined) ? state.three : null;
      const outside = three && mix.some((fraction, i) => fraction > 0 && !three.includes(i));
      pad.element.hidden = !three || outside === true;
      if (three && !outside) pad.render(materials, mix, three);
    },
  };
}

/**
 * The triangle: drag the point, or move it with the arrows.
 * @param {Editing<number[]>} editing
 * @param {() => number[]} current the mix as it stands
 */
function createPad(editing, current) {
  /** @type {[number, number, number]} */
  let three = [0, 1, 2];
  let run = newRun("triangle");
  const colors = triangle(SIDE);
  const dot = h("span", { class: "triangle-dot" });
  const names = [0, 1, 2].map((i) => h("span", { class: `triangle-name corner-${i}`, "aria-hidden": "true" }));
  const area = h(
    "div",
    { class: "triangle-area", tabIndex: 0, role: "slider", "aria-label": words.triangle, "data-triangle": "" },
    colors.element,
    dot,
  );
  attribute(area, "aria-valuemin", "0");
  attribute(area, "aria-valuemax", "1");
  const element = h("div", { class: "triangle" }, names[2], area, h("div", { class: "triangle-base" }, names[0], names[1]));

  /** @param {[number, number]} place */
  function go(place) {
    const fractions = fromTriangle(place);
    const mix = current().map(() => 0);
    three.forEach((material, i) => (mix[material] = fractions[i]));
    editing.change(written(mix), run);
  }
  const place = () => inTriangle(three.map((material) => current()[material]));
  const end = () => {
    run = newRun("triangle");
    editing.end?.();
  };

  area.addEventListener("pointerdown", (down) => {
    if (down.button !== 0) return;
    down.preventDefault();
    area.focus();
    area.setPointerCapture(down.pointerId);
    const box = colors.element.getBoundingClientRect();
    const over = new AbortController();
    /** @param {PointerEvent} event */
    const move = (event) => go([(event.clientX - box.left) / box.width, (TALL * (box.bottom - event.clientY)) / box.height]);
    /** @param {PointerEvent} event */
    const up = (event) => {
      over.abort();
      if (event.type === "pointercancel") editing.cancel?.(run);
      end();
    };
    move(down);
    area.addEventListener("pointermove", move, { signal: over.signal });
    area.addEventListener("pointerup", up, { signal: over.signal });
    area.addEventListener("pointercancel", up, { signal: over.signal });
  });
  area.addEventListener("keydown", (event) => {
    const arrow = ARROWS[event.key];
    if (event.key === "Escape" && editing.cancel) {
      editing.cancel(run);
      run = newRun("triangle");
      return;
    }
    if (!arrow || event.ctrlKey || event.metaKey) return;
    event.preventDefault();
    const by = STEP * stride(event);
    const [x, y] = place();
    go([x + arrow[0] * by, y + arrow[1] * by * TALL]);
  });
  area.addEventListener("blur", end);

  return {
    element,
    /** @param {Material[]} materials @param {number[]} mix @param {[number, number, number]} chosen */
    render(materials, mix, chosen) {
      three = chosen;
      colors.draw(three.map((i) => materials[i].color));
      names.forEach((name, i) => write(name, materials[three[i]].name));
      const [x, y] = place();
      dot.style.left = `${x * SIDE}px`;
      dot.style.bottom = `${y * SIDE}px`;
      dot.style.backgroundColor = mixed(
        materials.map(({ color }) => color),
        mix,
      );
      attribute(area, "aria-valuenow", String(mix[three[0]]));
      attribute(
        area,
        "aria-valuetext",
        three.map((i) => strings.mixing.share(materials[i].name, percent(mix[i]))).join(", "),
      );
    },
  };
}
