/**
 * Matching: the method, the weights of its value, and what it joins to what.
 *
 * @import { App } from "../state/app.js"
 * @import { Matching } from "../types.js"
 * @import { Group } from "./group.js"
 */
import { checkBox, segment } from "../controls/choices.js";
import { row } from "../controls/row.js";
import { h } from "../dom.js";
import { editable } from "../format.js";
import { patch } from "../state/edits.js";
import { strings } from "../strings.js";
import { editing } from "./edit.js";
import { weight } from "./weight.js";

/** End of a weight's slider, and the largest weight a field takes. */
const REACH = 4;
const LARGEST = 100;
const STEP = 0.1;

/**
 * @param {App} app
 * @returns {Group}
 */
export function matchingGroup(app) {
  const words = strings.matching;
  /**
   * @param {"normalWeight" | "distanceWeight" | "alignmentWeight"} name
   * @param {string} label
   */
  const slide = (name, label) =>
    weight(
      { label, name, min: 0, reach: REACH, max: LARGEST, step: STEP },
      editing(app, (document, value) =>
        document.matching[name] === value ? document : patch(document, "matching", { [name]: value }),
      ),
    );
  const normal = slide("normalWeight", words.normalWeight);
  const distance = slide("distanceWeight", words.distanceWeight);
  const alignment = slide("alignmentWeight", words.alignmentField);
  const negative = segment(
    {
      label: words.negativeField,
      name: "negative",
      choices: [
        { value: "signed", text: words.signed },
        { value: "clamp", text: words.clamp },
        { value: "half", text: words.half },
      ],
    },
    (value) =>
      app.store.commit({
        change: (document) => patch(document, "matching", { negative: /** @type {Matching["negative"]} */ (value) }),
      }),
  );
  const oneToOne = checkBox({ name: "one-to-one", text: [words.oneToOne] }, (on) =>
    app.store.commit({ change: (document) => patch(document, "matching", { oneToOne: on }) }),
  );
  const body = h(
    "div",
    {},
    row(words.method, { element: h("span", { class: "fact" }, words.greedy) }),
    row(words.normalWeight, ...normal.controls),
    row(words.distanceWeight, ...distance.controls),
    row(words.alignmentWeight, ...alignment.controls),
    row(words.negative, negative),
    row(words.lines, oneToOne),
  );
  /** @type {{element: HTMLElement, render: () => void} | null} */
  let plot = null;
  let asked = false;
  /** The plot comes when the group is first seen. */
  function renderPlot() {
    plot?.render();
    if (asked) return;
    asked = true;
    void import("./correspondence.js").then(({ createCorrespondence }) => {
      plot = createCorrespondence(app);
      body.append(plot.element);
      plot.render();
    });
  }

  return {
    name: "matching",
    heading: words.heading,
    body,
    phrase() {
      const { normalWeight, distanceWeight } = app.store.document.matching;
      return words.phrase(editable(normalWeight, 1), editable(distanceWeight, 1));
    },
    render() {
      const { matching } = app.store.document;
      normal.set(matching.normalWeight);
      distance.set(matching.distanceWeight);
      alignment.set(matching.alignmentWeight);
      negative.set(matching.negative);
      oneToOne.set(matching.oneToOne);
      renderPlot();
    },
  };
}
