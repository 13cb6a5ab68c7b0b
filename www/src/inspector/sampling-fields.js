/**
 * The fields of the sampling: the scheme, and the number of samples on each curve or how fine they are.
 *
 * @import { App } from "../state/app.js"
 * @import { CurvesDocument, Sampling } from "../types.js"
 */
import { segment } from "../controls/choices.js";
import { numberField } from "../controls/number-field.js";
import { row } from "../controls/row.js";
import { h, write } from "../dom.js";
import { words as flow } from "../harmonic/words.js";
import { curveName, letterOf } from "../state/app.js";
import { patch } from "../state/edits.js";
import { hasLooks, isHarmonic } from "../state/look.js";
import { editing } from "./edit.js";
import { numbersTaken } from "./sampling.js";
import { words } from "./sampling-words.js";

/** Samples the format allows on one curve. */
const FEWEST = 3;
const MOST = 1000;
/** Tolerances that the field takes, and the size of a document without curves. */
const FINEST = 1e-6;
const COARSEST = 1e12;
const BLANK = 100;

/**
 * @param {App} app
 * @returns {{element: HTMLElement, render: () => void}}
 */
export function createSamplingFields(app) {
  const scheme = segment(
    {
      label: words.scheme,
      name: "scheme",
      choices: [
        { value: "arc-length", text: words.arcLength },
        { value: "parameter", text: words.parameter },
        { value: "adaptive", text: words.adaptive },
      ],
    },
    (value) => {
      const scheme = /** @type {Sampling["scheme"]} */ (value);
      app.store.commit({
        change: (document) =>
          patch(document, "sampling", scheme === "adaptive" ? { scheme, ...fineness(document) } : { scheme }),
      });
    },
  );
  const count = (/** @type {number} */ index) =>
    numberField(
      {
        label: words.count(curveName(app.store.document, index)),
        name: `count-${index}`,
        prefix: letterOf(index),
        min: FEWEST,
        max: MOST,
        step: 1,
        decimals: 0,
        whole: true,
      },
      editing(app, (document, value) => {
        const { counts } = document.sampling;
        return counts[index] === value ? document : patch(document, "sampling", { counts: counts.with(index, value) });
      }),
    );
  const counts = [0, 1].map(count);
  /**
   * @param {"tolerance" | "maxTurn" | "minCount"} name
   * @param {Omit<import("../controls/number-field.js").NumberOptions, "name">} options
   */
  const fine = (name, options) =>
    numberField(
      { name, ...options },
      editing(app, (document, value) =>
        document.sampling[name] === value ? document : patch(document, "sampling", { [name]: value }),
      ),
    );
  const tolerance = fine("tolerance", {
    label: words.toleranceField(app.store.document.unit),
    min: FINEST,
    max: COARSEST,
    step: () => unitOf(fineness(app.store.document).tolerance),
    decimals: 2,
  });
  const maxTurn = fine("maxTurn", { label: words.maxTurnField, min: 1, max: 90, step: 1, decimals: 0 });
  const minCount = fine("minCount", {
    label: words.minCountField,
    min: FEWEST,
    max: MOST,
    step: 1,
    decimals: 0,
    whole: true,
  });
  const taken = h("span", { class: "fact number", "data-taken": "" });
  const even = row(words.counts, ...counts);
  const adaptive = [
    row(words.tolerance, tolerance),
    row(words.maxTurn, maxTurn, { element: h("span", { class: "unit" }, words.degrees) }),
    row(words.minCount, minCount),
    row(words.counts, { element: taken }),
  ];
  const fields = h("div", {}, h("div", { class: "wide-row" }, scheme.element), even, ...adaptive);
  const unused = h("p", { class: "note", "data-unused": "" });
  const element = h("div", {}, unused, fields);

  return {
    element,
    render() {
      const { document } = app.store;
      const { sampling } = document;
      unused.hidden = !isHarmonic(document);
      fields.hidden = !unused.hidden && !hasLooks(document);
      write(unused, fields.hidden ? flow.unusedSampling : `${flow.unusedSampling} ${flow.usedBeside}`);
      scheme.set(sampling.scheme);
      while (counts.length < sampling.counts.length) {
        const field = count(counts.length);
        counts.push(field);
        even.append(field.element);
      }
      even.classList.toggle("many", sampling.counts.length > 2);
      counts.forEach((field, index) => {
        field.element.hidden = index >= sampling.counts.length;
        field.set(sampling.counts[index] ?? FEWEST);
      });
      even.hidden = sampling.scheme === "adaptive";
      for (const each of adaptive) each.hidden = !even.hidden;
      if (!even.hidden) return;
      const fine = fineness(app.store.document);
      tolerance.set(fine.tolerance);
      maxTurn.set(fine.maxTurn);
      minCount.set(fine.minCount);
      write(taken, words.taken(numbersTaken(app)));
    },
  };
}

/**
 * How fine adaptive samples are: as the document says, else as the format does, the tolerance in two figures.
 * @param {CurvesDocument} document
 */
function fineness({ sampling, curves }) {
  const points = curves.flatMap((curve) => curve.points);
  const span = (/** @type {0 | 1} */ axis) => {
    const values = points.map((point) => point[axis]);
    return values.length > 0 ? Math.max(...values) - Math.min(...values) : BLANK;
  };
  const { tolerance, maxTurn = 15, minCount = 12 } = sampling;
  const size = Math.hypot(span(0), span(1));
  const own = Math.min(COARSEST, Math.max(FINEST, Number((1e-3 * (size || BLANK)).toPrecision(2))));
  return { tolerance: tolerance ?? own, maxTurn, minCount };
}

/** A step of the first figure of a number. @param {number} value */
const unitOf = (value) => 10 ** Math.floor(Math.log10(value) + 1e-9);
