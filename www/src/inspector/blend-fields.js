/**
 * The fields of the blend: how a stack is blended, how many stages lie from curve to curve, whether they have names, and how the morph moves.
 *
 * @import { App } from "../state/app.js"
 */
import { checkBox, segment } from "../controls/choices.js";
import { row } from "../controls/row.js";
import { h } from "../dom.js";
import { later } from "../later.js";
import { patch } from "../state/edits.js";
import { isStack } from "./blend.js";
import { words } from "./blend-words.js";
import { editing } from "./edit.js";
import { weight } from "./weight.js";

/** End of the slider, and the most stages the format allows. */
const REACH = 20;
const MOST = 200;

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
      ],
    },
    (value) => app.store.commit({ change: (document) => patch(document, "blend", { kind: value === "cubic" ? "cubic" : "ruled" }) }),
  );
  const kindRow = row(words.kind, kind);
  const element = h("div", {}, kindRow, row(words.stages, ...stages.controls), row("", names));
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
      kindRow.hidden = !isStack(app);
      kind.set(app.store.document.blend.kind);
      stages.set(app.store.document.blend.stages);
      names.set(app.ui.value.stageLabels);
      motion.render();
    },
  };
}
