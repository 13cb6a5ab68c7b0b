/**
 * The design rules: each with how many pixels break it. The chosen one opens, and is lit in the picture.
 *
 * @import { Group } from "../../inspector/group.js"
 * @import { WholePart } from "../document.js"
 * @import { DesignRule } from "../edits/rules.js"
 * @import { Bench } from "../state.js"
 */
import { segment } from "../../controls/choices.js";
import { numberField } from "../../controls/number-field.js";
import { row } from "../../controls/row.js";
import { textField } from "../../controls/text-field.js";
import { attribute, h, write } from "../../dom.js";
import { fixed, percent } from "../../format.js";
import { FAR } from "../edits/features.js";
import { materialsOf } from "../edits/materials.js";
import { addRule, changeRule, removeRule, RULE_LIMIT, rulesOf } from "../edits/rules.js";
import { picker } from "../profile/picker.js";
import { words } from "./words.js";

/** @param {Bench} bench @returns {Group} */
export function designGroup(bench) {
  const { app } = bench;
  const said = words.design;
  const chosen = () => bench.now().shown.rule;
  /** @param {(document: WholePart, rule: number) => WholePart} change @param {string} [run] */
  const commit = (change, run) => {
    const rule = chosen();
    if (rule !== null) bench.commit((document) => change(document, rule), run);
  };
  const end = bench.endRun;
  const cancel = (/** @type {string} */ run) => void app.store.cancel(run);

  const add = h("button", { type: "button", class: "command-word", "data-action": "add-rule" }, words.add);
  add.addEventListener("click", () => {
    const count = rulesOf(bench.now().document).length;
    bench.commit((document) => addRule(document, said.fresh));
    if (rulesOf(bench.now().document).length > count) bench.change({ rule: count });
  });
  const none = h("p", { class: "part-note" }, said.none);
  const list = h("div", { class: "design-rules", role: "group", "aria-label": said.list });

  const name = textField({ label: said.name, name: "rule-name" }, (text) => commit((document, rule) => changeRule(document, rule, { name: text })));
  const swatch = h("span", { class: "part-swatch", "aria-hidden": "true" });
  const material = picker({ label: said.material, name: "rule-material" }, (value) => commit((document, rule) => changeRule(document, rule, { material: Number(value) })));
  material.element.prepend(swatch);
  const quantity = segment(
    { label: said.quantity, name: "rule-of", choices: /** @type {const} */ (["fraction", "gradient"]).map((value) => ({ value, text: said.of[value] })) },
    (of) => commit((document, rule) => changeRule(document, rule, { of })),
  );
  const isGradient = () => rulesOf(bench.now().document)[chosen() ?? -1]?.of === "gradient";
  const bound = (/** @type {"least" | "most"} */ which) =>
    numberField(
      { label: which === "least" ? said.leastLabel : said.mostLabel, name: `rule-${which}`, prefix: said[which], min: 0, max: FAR, step: () => (isGradient() ? 0.001 : 0.01), decimals: 2 },
      { change: (value, run) => commit((document, rule) => changeRule(document, rule, { [which]: value }), run), end, cancel },
    );
  const [least, most] = [bound("least"), bound("most")];
  const range = h("span", {});
  const remove = h("button", { type: "button", class: "command-word", "data-action": "remove-rule" }, said.remove);
  remove.addEventListener("click", () => {
    const rule = chosen();
    if (rule === null) return;
    const gone = rulesOf(bench.now().document)[rule]?.name ?? "";
    bench.commit((document) => removeRule(document, rule));
    bench.change({ rule: null });
    app.say(said.removed(gone));
    add.focus();
  });
  const fault = h("p", { class: "part-fault", hidden: true });
  const area = h("p", { class: "part-note number" });
  const details = h(
    "div",
    { class: "design-details" },
    row(said.name, name),
    row(said.material, material),
    row(said.quantity, quantity),
    h("div", { class: "row" }, h("span", { class: "row-label" }, range), h("span", { class: "row-controls" }, least.element, most.element), least.error, most.error),
    fault,
    area,
    h("div", { class: "part-commands" }, remove),
  );

  /** @typedef {{element: HTMLButtonElement, swatch: HTMLElement, name: HTMLElement, count: HTMLElement}} Line */
  /** @type {Line[]} */
  const lines = [];

  /** @param {number} index @returns {Line} */
  function createLine(index) {
    const [sign, label, count] = [h("span", { class: "part-swatch" }), h("span", { class: "design-name" }), h("span", { class: "design-count number" })];
    const element = h("button", { type: "button", class: "design-rule", "data-part-rule": index }, sign, label, count);
    element.addEventListener("click", () => bench.change({ rule: chosen() === index ? null : index }));
    return { element, swatch: sign, name: label, count };
  }

  /** How many pixels break a rule and on what area, once that is known of the document as it stands. @param {number} index */
  function counted(index) {
    const { known, isCurrent } = bench.now();
    const found = (known?.measured?.rules ?? known?.violations?.rules)?.find(({ rule }) => rule === index);
    return found && isCurrent ? { ...found, whole: known?.measured?.area ?? null } : null;
  }
  /** @param {number} index */
  const faultOf = (index) => {
    const { known, isCurrent } = bench.now();
    return (isCurrent && known?.part.diagnostics.find(({ path }) => path.startsWith(`rules[${index}].`))) || null;
  };

  /** @param {DesignRule} rule @param {number} index */
  function renderLine({ name: label = "", material: of }, index) {
    const line = lines[index];
    const { document } = bench.now();
    const found = counted(index);
    const isOpen = chosen() === index;
    line.swatch.style.backgroundColor = materialsOf(document)[of]?.color ?? "";
    write(line.name, label);
    const count = faultOf(index) ? said.skipped : !found ? said.unknown : found.count === 0 ? said.kept : said.broken(fixed(found.count, 0));
    write(line.count, count);
    line.element.classList.toggle("broken", (found?.count ?? 0) > 0);
    attribute(line.element, "aria-expanded", String(isOpen));
    attribute(line.element, "aria-label", said.row(label, found && found.count > 0 && found.whole ? said.brokenSpoken(fixed(found.count, 0), percent(found.area / found.whole)) : count));
    if (isOpen && details.previousElementSibling !== line.element) line.element.after(details);
  }

  return {
    name: "rules",
    heading: words.groups.rules,
    body: h("div", {}, none, list),
    commands: [add],
    phrase() {
      const rules = rulesOf(bench.now().document);
      return said.phrase(rules.length, rules.filter((_, k) => (counted(k)?.count ?? 0) > 0).length);
    },
    render() {
      const { document } = bench.now();
      const rules = rulesOf(document);
      const rule = chosen();
      none.hidden = rules.length > 0;
      list.hidden = rules.length === 0;
      add.disabled = rules.length >= RULE_LIMIT;
      while (lines.length < rules.length) {
        const line = createLine(lines.length);
        lines.push(line);
        list.append(line.element);
      }
      while (lines.length > rules.length) lines.pop()?.element.remove();
      rules.forEach(renderLine);
      const spec = rule === null ? undefined : rules[rule];
      details.hidden = !spec;
      if (!spec || rule === null) return;
      name.set(spec.name ?? "");
      material.set(String(spec.material), materialsOf(document).map((each, k) => ({ value: String(k), text: each.name })));
      swatch.style.backgroundColor = materialsOf(document)[spec.material]?.color ?? "";
      quantity.set(spec.of ?? "fraction");
      write(range, spec.of === "gradient" ? said.perUnit(document.unit ?? "") : said.range);
      least.set(spec.least ?? 0);
      most.set(spec.most ?? 1);
      const wrong = faultOf(rule);
      write(fault, wrong?.message ?? "");
      fault.hidden = !wrong;
      const found = counted(rule);
      const unit = document.unit ? `\u00a0${document.unit}²` : "";
      write(area, found && found.count > 0 && found.whole ? said.area(`${fixed(found.area, 1)}${unit}`, percent(found.area / found.whole)) : "");
      area.hidden = area.textContent === "";
    },
  };
}
