/**
 * Sampling: the scheme and the number of samples on each curve.
 *
 * @import { App } from "../state/app.js"
 * @import { Group } from "./group.js"
 */
import { segment } from "../controls/choices.js";
import { numberField } from "../controls/number-field.js";
import { row } from "../controls/row.js";
import { curveName } from "../state/app.js";
import { patch } from "../state/edits.js";
import { strings } from "../strings.js";
import { editing } from "./edit.js";

/** Samples the format allows on one curve. */
const FEWEST = 3;
const MOST = 1000;

/**
 * @param {App} app
 * @returns {Group}
 */
export function samplingGroup(app) {
  const words = strings.sampling;
  const scheme = segment(
    {
      label: words.scheme,
      name: "scheme",
      choices: [
        { value: "arc-length", text: words.arcLength },
        { value: "parameter", text: words.parameter },
      ],
    },
    (value) =>
      app.store.commit({
        change: (document) =>
          patch(document, "sampling", { scheme: /** @type {"arc-length" | "parameter"} */ (value) }),
      }),
  );
  const counts = /** @type {const} */ ([0, 1]).map((index) =>
    numberField(
      {
        label: words.count(curveName(app.store.document, index)),
        name: `count-${index}`,
        prefix: index === 0 ? "A" : "B",
        min: FEWEST,
        max: MOST,
        step: 1,
        decimals: 0,
        whole: true,
      },
      editing(app, (document, value) => {
        const next = /** @type {[number, number]} */ ([...document.sampling.counts]);
        if (next[index] === value) return document;
        next[index] = value;
        return patch(document, "sampling", { counts: next });
      }),
    ),
  );
  const body = document.createElement("div");
  body.append(row(words.scheme, scheme), row(words.counts, ...counts));

  return {
    name: "sampling",
    heading: words.heading,
    body,
    phrase() {
      const { scheme: value, counts: count } = app.store.document.sampling;
      const text = value === "arc-length" ? words.arcLength : words.parameter;
      return words.phrase(text.toLowerCase(), count[0], count[1]);
    },
    render() {
      const { sampling } = app.store.document;
      scheme.set(sampling.scheme);
      counts.forEach((field, index) => field.set(sampling.counts[index] ?? FEWEST));
    },
  };
}
