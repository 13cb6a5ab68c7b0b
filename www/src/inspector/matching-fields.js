/**
 * The fields of the matching: the method with its settings, rules, weights, what happens where there is no matching, and the plot and
 * the pins below.
 *
 * @import { App } from "../state/app.js"
 * @import { Matching, PrintedRule } from "../types.js"
 * @import { Choice } from "../state/methods.js"
 */
import "../../styles/correspondence.css";
import "../../styles/matching.css";
import { checkBox, segment } from "../controls/choices.js";
import { numberField } from "../controls/number-field.js";
import { row } from "../controls/row.js";
import { select } from "../controls/select.js";
import { h, write } from "../dom.js";
import { symbol } from "../icons.js";
import { words as flow } from "../harmonic/words.js";
import { later } from "../later.js";
import { isOpen } from "../spline.js";
import { currentMatch } from "../state/app.js";
import { patch } from "../state/edits.js";
import { hasLooks, isHarmonic } from "../state/look.js";
import { choiceOf, CHOICES, choose, printAll, printRule, rulesOf, setLines } from "../state/methods.js";
import { editing } from "./edit.js";
import { words } from "./matching-words.js";
import { weight } from "./weight.js";

/** End of a weight's slider, and the largest weight a field takes. */
const REACH = 4;
const LARGEST = 100;
const STEP = 0.1;
/** Limits of the format: a price, a shift, one-to-one lines. */
const DEAREST = 1e12;
const FARTHEST = 999;
const LINES = { min: 3, max: 1000 };

/**
 * @param {App} app
 * @returns {{element: HTMLElement, render: () => void}}
 */
export function createMatchingFields(app) {
  /** @param {Partial<Matching>} fields */
  const put = (fields) => app.store.commit({ change: (document) => patch(document, "matching", fields) });
  const method = select(
    { label: words.method, name: "method", choices: CHOICES.map((value) => ({ value, text: words.methods[value] })) },
    (choice) => {
      const pins = app.store.document.matching.pins?.length ?? 0;
      app.store.commit({ change: (document) => choose(document, choice) });
      const lost = pins - (app.store.document.matching.pins?.length ?? 0);
      if (lost === 0) return;
      const text = words.pinsDropped(lost);
      app.ui.set({ note: { tone: "plain", text } });
      app.say(text);
    },
  );
  const about = h("p", { class: "matching-about" });
  const price = numberField(
    { label: words.price, name: "line-price", min: 0, max: DEAREST, step: 0.0001, decimals: 0 },
    editing(app, (document, value) =>
      document.matching.linePrice === value ? document : patch(document, "matching", { linePrice: value }),
    ),
  );
  const shiftKind = segment(
    {
      label: words.shift,
      name: "shift",
      choices: /** @type {const} */ (["best", "number"]).map((value) => ({ value, text: words.shiftBy[value] })),
    },
    (kind) => put({ shift: kind === "best" ? "best" : 0 }),
  );
  const shift = numberField(
    { label: words.shiftField, name: "shift", min: 0, max: FARTHEST, step: 1, decimals: 0, whole: true },
    editing(app, (document, value) =>
      document.matching.shift === value ? document : patch(document, "matching", { shift: value }),
    ),
  );
  const rules = segment(
    {
      label: words.rules,
      name: "rules",
      choices: [
        { value: "repaired", text: words.repaired },
        { value: "printed", text: words.asPrinted },
      ],
    },
    (value) => {
      more.open = value === "printed";
      app.store.commit({ change: (document) => printAll(document, value === "printed") });
    },
  );
  const boxes = /** @type {[PrintedRule, string][]} */ (Object.entries(words.printed)).map(([rule, text]) => ({
    rule,
    ...checkBox({ name: `printed-${rule}`, text: [text] }, (on) =>
      app.store.commit({ change: (document) => printRule(document, rule, on) }),
    ),
  }));
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
    (value) => put({ negative: /** @type {Matching["negative"]} */ (value) }),
  );
  const more = h(
    "details",
    { class: "plot", "data-more": "" },
    h("summary", {}, words.more),
    h("div", { class: "matching-rules", role: "group", "aria-label": words.single }, ...boxes.map(({ element }) => element)),
    row(words.alignmentWeight, ...alignment.controls),
    row(words.negative, negative),
  );
  const policy = segment(
    {
      label: words.infeasible,
      name: "policy",
      choices: [
        { value: "strict", text: words.strict },
        { value: "repair", text: words.repair },
      ],
    },
    (value) => put({ policy: /** @type {Matching["policy"]} */ (value) }),
  );
  const ends = segment(
    {
      label: words.ends,
      name: "ends",
      choices: [
        { value: "tied", text: words.tied },
        { value: "free", text: words.free },
      ],
    },
    (value) => put({ ends: /** @type {Matching["ends"]} */ (value) }),
  );
  const oneToOne = checkBox({ name: "one-to-one", text: [words.oneToOne] }, (on) => put({ oneToOne: on }));
  const count = numberField(
    { label: words.count, name: "lines", ...LINES, step: 1, decimals: 0, whole: true },
    editing(app, (document, value) => setLines(document, value, samples())),
  );
  count.element.classList.add("short");
  const plot = h(
    "details",
    { class: "plot", "data-plot": "" },
    h("summary", {}, symbol("v"), ` ${words.correspondence.over} `, symbol("u")),
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

  const rows = {
    price: row(words.price, price),
    shift: row(words.shift, shiftKind, shift),
    policy: row(words.infeasible, policy),
    ends: row(words.ends, ends),
  };
  const fields = h(
    "div",
    {},
    row(words.method, method),
    about,
    rows.price,
    rows.shift,
    row(words.rules, rules),
    row(words.normalWeight, ...normal.controls),
    row(words.distanceWeight, ...distance.controls),
    rows.policy,
    rows.ends,
    row(words.lines, oneToOne, count),
    more,
    plot,
  );
  const unused = h("p", { class: "note", "data-unused": "" });
  const element = h("div", {}, unused, fields);
  const pins = later(
    app,
    () => (app.store.document.matching.pins?.length ?? 0) > 0,
    async () => {
      const { createPinList } = await import("../lines/pin-list.js");
      return () => {
        const part = createPinList(app);
        plot.before(part.element);
        return part;
      };
    },
  );

  /** The larger number of samples, which is the number of lines where none is named. */
  function samples() {
    const taken = currentMatch(app)?.samples.map(({ points }) => points.length) ?? [];
    // Without a curve there are no samples yet, only their numbers to come.
    return Math.max(LINES.min, ...(taken.length > 0 ? taken : app.store.document.sampling.counts));
  }

  return {
    element,
    render() {
      const { document } = app.store;
      const { matching } = document;
      unused.hidden = !isHarmonic(document);
      // Two curves have the other blend beside, which is what the fields say.
      fields.hidden = !unused.hidden && !hasLooks(document);
      write(unused, fields.hidden ? flow.unusedMatching : `${flow.unusedMatching} ${flow.usedBeside}`);
      /** @type {Choice} */
      const choice = choiceOf(matching);
      method.set(choice);
      write(about, words.about[choice]);
      about.hidden = words.about[choice] === "";
      rows.price.hidden = choice !== "sum-less-price";
      price.set(matching.linePrice ?? 0);
      const open = isOpen(app.store.document.curves[0]);
      rows.ends.hidden = !open;
      ends.set(matching.ends ?? "tied");
      // Open curves have no seam to shift.
      rows.shift.hidden = choice !== "shift" || open;
      const by = matching.shift ?? "best";
      shiftKind.set(by === "best" ? "best" : "number");
      shift.element.hidden = by === "best";
      if (by !== "best") shift.set(by);
      const printed = matching.printed ?? [];
      const known = rulesOf(matching);
      rules.set(printed.some((rule) => known.includes(rule)) ? "printed" : "repaired");
      for (const { rule, element: box, set } of boxes) {
        box.hidden = !known.includes(rule);
        set(printed.includes(rule));
      }
      normal.set(matching.normalWeight);
      distance.set(matching.distanceWeight);
      alignment.set(matching.alignmentWeight);
      negative.set(matching.negative);
      rows.policy.hidden = matching.method !== "exact" && matching.method !== "greedy";
      policy.set(matching.policy ?? "strict");
      oneToOne.set(matching.oneToOne);
      count.element.hidden = matching.method !== "exact" || !matching.oneToOne;
      count.set(matching.lines ?? samples());
      plot.hidden = currentMatch(app)?.reparameterisation.length === 0;
      correspondence.render();
      pins.render();
    },
  };
}
