/**
 * The groups of the workbench Part that belong to the picture: what was checked, the leaves of the subdivision, and what is shown.
 *
 * @import { Group } from "../inspector/group.js"
 * @import { Bench } from "./state.js"
 */
import { checkBox } from "../controls/choices.js";
import { row } from "../controls/row.js";
import { select } from "../controls/select.js";
import { attribute, h, write } from "../dom.js";
import { fixed, percent, significantText } from "../format.js";
import { fact } from "../space/card.js";
import { measure } from "../space/measure.js";
import { leafColor } from "./pixels.js";
import { choiceOf, faultsOf, isOne } from "./problems.js";
import { needsVoxels } from "./raster.js";
import { words } from "./words.js";

/** Leaves listed at most. */
const LISTED = 40;

/** @param {Bench} bench @returns {Group} */
export function checksGroup(bench) {
  const problems = h("div", { class: "part-problems", role: "group", "aria-label": words.checks.problems });
  const facts = h("div", { class: "part-facts" });
  const element = h("div", {}, problems, facts);
  let drawn = "";
  return {
    name: "checks",
    heading: words.checks.heading,
    body: element,
    phrase() {
      const { known, isCurrent } = bench.now();
      if (!known || !isCurrent) return "";
      const { skipped, remarks, broken } = faultsOf(known);
      const count = skipped.length + remarks.length + broken.length;
      return count > 0 ? words.checks.count(count) : words.checks.none;
    },
    render() {
      const { document, known, isCurrent, shown } = bench.now();
      element.classList.toggle("stale", !isCurrent || !known?.measured);
      if (!known || !isCurrent || !known.measured) return;
      const { unit = "mm" } = document;
      const { measured, part } = known;
      const key = JSON.stringify([part.diagnostics, measured, unit, shown.rule, known.document.rules]);
      if (key === drawn) return;
      drawn = key;
      const { skipped, remarks, broken } = faultsOf(known);
      problems.replaceChildren(
        ...[...skipped, ...remarks].map((diagnostic, n) =>
          h(
            "button",
            { type: "button", class: `part-problem ${diagnostic.skipped ? "failed" : ""}`, "data-diagnostic": diagnostic.code, "data-nth": String(n), onclick: () => bench.change(choiceOf(bench.now().document, diagnostic)) },
            h("span", { class: "part-problem-kind" }, diagnostic.skipped ? words.checks.leftOut : words.checks.remark),
            h("span", {}, diagnostic.message),
          ),
        ),
        ...broken.map(({ rule, name, count, area }) =>
          h(
            "button",
            {
              type: "button",
              class: "part-problem failed",
              "data-broken": String(rule),
              "aria-pressed": String(shown.rule === rule),
              onclick: () => bench.change({ rule: bench.now().shown.rule === rule ? null : rule, violations: true, leaves: false }),
            },
            h("span", { class: "part-problem-kind" }, name),
            h("span", { class: "number" }, words.checks.broken(fixed(count, 0), measure(area, unit, 2))),
          ),
        ),
      );
      facts.replaceChildren(
        fact(words.checks.area, measure(measured.area, unit, 2), "area"),
        fact(words.checks.sum, isOne(measured.sumError) ? "1" : `1 ± ${significantText(measured.sumError)}`, "sum"),
        fact(words.checks.clamped, fixed(measured.clamped, 0), "clamped"),
        fact(words.checks.overlap, percent(measured.overlap), "overlap"),
        fact(words.checks.pixels, fixed(measured.pixels, 0), "pixels"),
      );
    },
  };
}

/** @param {Bench} bench @returns {Group} */
export function leavesGroup(bench) {
  const list = h("div", { class: "part-leaves", role: "group", "aria-label": words.leaves.heading });
  const note = h("p", { class: "part-note" });
  const element = h("div", {}, list, note);
  let drawn = "";
  return {
    name: "leaves",
    heading: words.leaves.heading,
    body: element,
    phrase() {
      const { known } = bench.now();
      return known?.measured ? words.leaves.count(known.measured.leaves.length) : "";
    },
    render() {
      const { document, known, isCurrent, shown } = bench.now();
      element.classList.toggle("stale", !isCurrent || !known?.measured);
      if (!known?.measured || !isCurrent) return;
      const { unit = "mm", bodies } = document;
      const leaves = [...known.measured.leaves].sort((a, b) => a.body - b.body || b.area - a.area);
      const key = JSON.stringify([leaves, unit, bodies.map(({ name }) => name)]);
      if (key !== drawn) {
        drawn = key;
        const focused = globalThis.document.activeElement instanceof HTMLElement ? globalThis.document.activeElement.dataset.leaf : undefined;
        list.replaceChildren(
          ...leaves.slice(0, LISTED).map(({ body, leaf, names, area }) => {
            const swatch = h("span", { class: "part-swatch" });
            swatch.style.backgroundColor = `rgb(${leafColor({ body, leaf }).join(" ")})`;
            return h(
              "button",
              { type: "button", class: "part-leaf", "data-leaf": `${body}.${leaf}`, onclick: () => light(body, leaf) },
              swatch,
              h("span", { class: "part-name" }, ...(bodies.length > 1 ? [h("span", { class: "part-of" }, `${bodies[body]?.name}: `)] : []), names.join(" ∩ ") || words.leaves.none),
              h("span", { class: "number" }, measure(area, unit, 2)),
            );
          }),
        );
        if (focused !== undefined) /** @type {HTMLElement | null} */ (list.querySelector(`[data-leaf="${focused}"]`))?.focus();
        write(note, leaves.length > LISTED ? words.leaves.more(leaves.length - LISTED) : words.leaves.note);
      }
      for (const button of list.children) {
        const [body, leaf] = (/** @type {HTMLElement} */ (button).dataset.leaf ?? "").split(".").map(Number);
        attribute(button, "aria-pressed", String(shown.leaves && shown.leaf?.body === body && shown.leaf.leaf === leaf));
      }
    },
  };

  /** Lights a leaf in the picture, or none where it was lit. @param {number} body @param {number} leaf */
  function light(body, leaf) {
    const { shown } = bench.now();
    const isLit = shown.leaves && shown.leaf?.body === body && shown.leaf.leaf === leaf;
    bench.change(isLit ? { leaf: null } : { leaves: true, compare: false, leaf: { body, leaf } });
  }
}

/** @param {Bench} bench @returns {Group} */
export function displayGroup(bench) {
  const place = h("div", {});
  const boxes = /** @type {const} */ (["shapes", "violations", "difference"]).map((name) => ({
    name,
    ...checkBox({ name: `part-${name}`, text: [words.display[name]] }, (on) => bench.change({ [name]: on })),
  }));
  const note = h("p", { class: "part-note" }, words.display.voxels);
  let names = "";
  /** @type {ReturnType<typeof select> | null} */
  let lines = null;
  return {
    name: "display",
    heading: words.display.heading,
    body: h("div", {}, place, h("div", { class: "layers part-layers" }, ...boxes.map(({ element }) => element)), note),
    phrase() {
      const { document, shown } = bench.now();
      return shown.isolines === null ? words.display.noLines : words.display.linesOf(document.materials?.[shown.isolines]?.name ?? "");
    },
    render() {
      const { document, shown } = bench.now();
      const key = JSON.stringify(document.materials?.map(({ name }) => name));
      if (key !== names) {
        names = key;
        const choices = [{ value: "", text: words.display.off }, ...(document.materials ?? []).map(({ name }, i) => ({ value: String(i), text: name }))];
        lines = select({ label: words.display.lines, name: "part-isolines", choices }, (value) => bench.change({ isolines: value === "" ? null : Number(value) }));
        place.replaceChildren(row(words.display.lines, lines));
      }
      lines?.set(shown.isolines === null ? "" : String(shown.isolines));
      const isPrinted = needsVoxels(document);
      for (const { name, element, set } of boxes) {
        set(shown[name]);
        element.hidden = (name === "difference" && !isPrinted) || (name === "violations" && (document.rules ?? []).length === 0);
      }
      note.hidden = !isPrinted;
    },
  };
}
