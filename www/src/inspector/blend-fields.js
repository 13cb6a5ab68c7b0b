/**
 * The fields of the blend: how curves are blended, how many stages lie from curve to curve, whether they have names, how either blend of two
 * curves looks, and how the morph moves.
 *
 * @import { App } from "../state/app.js"
 * @import { Blend } from "../types.js"
 */
import { checkBox, segment } from "../controls/choices.js";
import { numberField } from "../controls/number-field.js";
import { row } from "../controls/row.js";
import { h } from "../dom.js";
import { words as flow } from "../harmonic/words.js";
import { later } from "../later.js";
import { patch } from "../state/edits.js";
import { hasLooks, isHarmonic, withBlend } from "../state/look.js";
import { isStack } from "./blend.js";
import { words } from "./blend-words.js";
import { editing } from "./edit.js";
import { weight } from "./weight.js";

/** End of the slider, and the most stages the format allows. */
const REACH = 20;
const MOST = 200;
/** Lines along the gradient and segments of a curve that the format allows. */
const LINES = { min: 1, max: 400, step: 1 };
const SEGMENTS = { min: 16, max: 1000, step: 10 };

/**
 * @param {App} app
 * @returns {{element: HTMLElement, render: () => void}}
 */
export function createBlendFields(app) {
  const stages = weight(
    { label: words.stages, name: "stages", min: 1, reach: REACH, max: MOST, step: 1, whole: true },
    editing(app, (document, value) =>
      document.blend.stages === value ? document : patch(document, "blend", { stages: value }),
    ),
  );
  const names = checkBox({ name: "stage-labels", text: [words.names] }, (on) => app.ui.set({ stageLabels: on }));
  const kind = segment(
    {
      label: words.kind,
      name: "blend-kind",
      choices: [
        { value: "ruled", text: words.ruled },
        { value: "cubic", text: words.cubic },
        { value: "harmonic", text: flow.kind },
      ],
    },
    (value) => app.store.commit({ change: (document) => withBlend(document, /** @type {Blend["kind"]} */ (value)) }),
  );
  /** @param {string} value */
  const choice = (value) => /** @type {HTMLElement} */ (kind.element.querySelector(`[value=${value}]`)?.parentElement);
  /**
   * @param {"lines" | "segments"} name
   * @param {string} label
   * @param {typeof LINES} range
   */
  const count = (name, label, range) => {
    const field = numberField(
      { label, name: `harmonic-${name}`, ...range, decimals: 0, whole: true },
      editing(app, (document, value) => (document.blend[name] === value ? document : patch(document, "blend", { [name]: value }))),
    );
    field.element.classList.add("short");
    return field;
  };
  const lines = count("lines", flow.linesField, LINES);
  const segments = count("segments", flow.segmentsField, SEGMENTS);
  const kindRow = row(words.kind, kind);
  const linesRow = row(flow.lines, lines);
  const segmentsRow = row(flow.segments, segments);
  const looks = h("div", {});
  const element = h("div", {}, kindRow, linesRow, segmentsRow, row(words.stages, ...stages.controls), row("", names), looks);
  const look = later(app, () => hasLooks(app.store.document), async () => {
    const { createLooks } = await import("../harmonic/looks.js");
    return () => createLooks(app, looks);
  });
  const motion = later(app, () => true, async () => {
    const { motionRows } = await import("../morph/motion-rows.js");
    return () => {
      const rows = motionRows(app, "blend");
      element.append(rows.element);
      return rows;
    };
  });
  return {
    element,
    render() {
      const { document } = app.store;
      const { blend, curves } = document;
      const isFlow = isHarmonic(document);
      const closed = curves.length > 1 && curves.every(({ form }) => form !== "open");
      choice("cubic").hidden = !isStack(app) && blend.kind !== "cubic";
      choice("harmonic").hidden = !closed && !isFlow;
      kindRow.hidden = choice("cubic").hidden && choice("harmonic").hidden;
      kind.set(blend.kind);
      linesRow.hidden = segmentsRow.hidden = !isFlow;
      if (isFlow) {
        lines.set(blend.lines ?? LINES.min);
        segments.set(blend.segments ?? SEGMENTS.min);
      }
      stages.set(blend.stages);
      names.set(app.ui.value.stageLabels);
      look.render();
      motion.render();
    },
  };
}
