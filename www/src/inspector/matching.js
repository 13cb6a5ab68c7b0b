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
import { symbol } from "../icons.js";
import { later } from "../later.js";
import { currentMatch } from "../state/app.js";
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
  const plot = h(
    "details",
    { class: "plot", "data-plot": "" },
    h("summary", {}, symbol("v"), ` ${strings.correspondence.over} `, symbol("u")),
  );
  const correspondence = later(
    app,
    () => plot.open,
    async () => {
      const { createCorrespondence } = await import("./correspondence.js");
      return () => {
        const part = createCorrespondence(app);
        plot.append(part.element);
        return part;
      };
    },
  );
  plot.addEventListener("toggle", () => correspondence.render());
  const body = h(
    "div",
    {},
    row(words.method, { element: h("span", { class: "fact" }, words.greedy) }),
    row(words.normalWeight, ...normal.controls),
    row(words.distanceWeight, ...distance.controls),
    row(words.alignmentWeight, ...alignment.controls),
    row(words.negative, negative),
    row(words.lines, oneToOne),
    plot,
  );

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
      plot.hidden = currentMatch(app)?.reparameterisation.length === 0;
      correspondence.render();
    },
  };
}
