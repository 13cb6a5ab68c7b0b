/**
 * The groups of a body and of the document: how features share where they overlap, the default of the body and its blend, the design rules, and the materials.
 *
 * @import { Group } from "../../inspector/group.js"
 * @import { Bench } from "../state.js"
 */
import "../../../styles/part-rules.css";
import { segment } from "../../controls/choices.js";
import { mixingControl } from "../../controls/mixing.js";
import { row } from "../../controls/row.js";
import { h, write } from "../../dom.js";
import { percent } from "../../format.js";
import { blendGroup } from "../blend/group.js";
import { setDefault, setRule } from "../edits/bodies.js";
import { defaultOf, queueOf } from "../edits/features.js";
import { isUsed, materialsOf } from "../edits/materials.js";
import { designGroup } from "./design.js";
import { materialsGroup } from "./materials.js";
import { words } from "./words.js";

const RULES = /** @type {const} */ (["repaired", "depth", "printed"]);

/** @param {Bench} bench @returns {Group[]} */
export const createRuleGroups = (bench) => [overlapGroup(bench), defaultGroup(bench), blendGroup(bench), designGroup(bench), materialsGroup(bench)];

/** The body that the groups are about: the chosen one, else the first. @param {Bench} bench */
function bodyOf(bench) {
  const { document, shown } = bench.now();
  const index = shown.body !== null && document.bodies[shown.body] ? shown.body : 0;
  return { index, body: document.bodies[index], several: document.bodies.length > 1 };
}

/** @param {Bench} bench @returns {Group} */
function overlapGroup(bench) {
  const choice = segment({ label: words.rule, name: "part-rule", choices: RULES.map((value) => ({ value, text: words.rules[value] })) }, (rule) =>
    bench.commit((document) => setRule(document, bodyOf(bench).index, rule)),
  );
  choice.element.classList.add("wide");
  const of = h("p", { class: "part-label" });
  const means = h("p", { class: "part-note" });
  const order = h("span", { class: "fact", "data-part-order": "" });
  const none = h("p", { class: "part-note" }, words.noBody);
  const rows = h("div", {}, of, choice.element, means, row(words.order, { element: order }));
  return {
    name: "overlap",
    heading: words.groups.overlap,
    body: h("div", {}, none, rows),
    phrase() {
      const { body } = bodyOf(bench);
      return body ? words.rules[body.rule ?? "repaired"].toLowerCase() : words.noneShort;
    },
    render() {
      const { body, several } = bodyOf(bench);
      [none.hidden, rows.hidden] = [body !== undefined, body === undefined];
      if (!body) return;
      const { rule = "repaired" } = body;
      choice.set(rule);
      write(means, words.means[rule]);
      of.hidden = !several;
      write(of, words.of(body.name));
      const acting = queueOf(body).filter(({ hidden }) => !hidden);
      const queue = acting.map(({ name = "" }) => name).join(" \u2192 ");
      write(order, acting.length < 2 && rule === "printed" ? words.oneOnly : rule === "printed" ? queue : words.noOrder);
    },
  };
}

/** @param {Bench} bench @returns {Group} */
function defaultGroup(bench) {
  const about = h("p", { class: "part-note" });
  const mixing = mixingControl({
    change: (mix, run) => bench.commit((document) => setDefault(document, bodyOf(bench).index, mix), run),
    end: bench.endRun,
    cancel: (run) => void bench.app.store.cancel(run),
  });
  return {
    name: "default",
    heading: words.groups.standard,
    body: h("div", {}, about, mixing.element),
    phrase() {
      const { document } = bench.now();
      if (document.bodies.length === 0) return words.noneShort;
      const materials = materialsOf(document);
      return defaultOf(document, bodyOf(bench).index)
        .flatMap((fraction, k) => (fraction > 0 && materials[k] ? [fraction === 1 ? materials[k].name : `${materials[k].name} ${percent(fraction)}`] : []))
        .join(", ");
    },
    render() {
      const { document } = bench.now();
      const { index, body } = bodyOf(bench);
      mixing.element.hidden = !body;
      if (!body) return write(about, words.noBody);
      write(about, words.standard.about(body.name));
      const materials = materialsOf(document);
      const used = materials.map((_, k) => k).filter((k) => isUsed(document, k));
      mixing.render({ materials: /** @type {any} */ (materials), mix: defaultOf(document, index), used, three: null });
    },
  };
}
