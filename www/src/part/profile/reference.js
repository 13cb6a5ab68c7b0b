/**
 * What a feature is measured to: a shape, the boundary of a body without what lies on some shapes, or several of them with an expression.
 *
 * @import { PartFeature, PartReference } from "../../../../js/directrix.js"
 * @import { WholePart } from "../document.js"
 * @import { At } from "../edits/features.js"
 * @import { Bench } from "../state.js"
 */
import { checkBox } from "../../controls/choices.js";
import { row } from "../../controls/row.js";
import { attribute, h } from "../../dom.js";
import { setReference, setReferences } from "../edits/features.js";
import { shapesOf } from "../edits/shapes.js";
import { expression } from "./expression.js";
import { expressionField, faultIn, faultOf } from "./expression-field.js";
import { picker } from "./picker.js";
import { words } from "./words.js";

const SEVERAL = "several";
/** Most references of a feature, as in docs/format.md. */
const MOST = 8;
/** Names of references as they are added. */
const NAMES = [..."abcdefgh"];

/** A reference as the value of a choice, and back. @param {PartReference | undefined} reference */
const valueOf = (reference) => (reference === undefined ? SEVERAL : typeof reference === "string" ? `shape ${reference}` : `boundary ${reference.boundary}`);
/** @param {string} value @returns {PartReference} */
const referenceOf = (value) => {
  const [kind] = value.split(" ", 1);
  const name = value.slice(kind.length + 1);
  return kind === "shape" ? name : { boundary: name, except: [] };
};

/**
 * What can be measured to; what the feature names and is not there stands among it.
 * @param {WholePart} document
 * @param {PartReference | undefined} current
 */
function choicesOf(document, current) {
  const choices = [
    ...shapesOf(document).map(({ name }) => ({ value: `shape ${name}`, text: name })),
    ...document.bodies.map(({ name }) => ({ value: `boundary ${name}`, text: words.reference.boundary(name) })),
  ];
  const value = valueOf(current);
  if (current === undefined || choices.some((each) => each.value === value)) return choices;
  const name = typeof current === "string" ? current : words.reference.boundary(current.boundary);
  return [{ value, text: words.reference.missing(name), disabled: true }, ...choices];
}

/**
 * @param {Bench} bench
 * @param {() => At | null} chosen
 */
export function createReference(bench, chosen) {
  /** @param {(document: WholePart, at: At) => WholePart} change @param {string} [run] */
  const commit = (change, run) => {
    const at = chosen();
    if (at) bench.commit((document) => change(document, at), run);
  };
  /** @type {PartFeature | null} */
  let feature = null;

  const main = picker({ label: words.reference.label, name: "part-reference" }, (value) => {
    if (value !== SEVERAL) return commit((document, at) => setReference(document, at, referenceOf(value)));
    commit((document, at) => {
      const first = feature?.reference ?? document.bodies[at.body].outline;
      const other = shapesOf(document).find(({ name }) => name !== first)?.name ?? first;
      return setReferences(document, at, { a: first, b: other }, "min(a, b)");
    });
  });
  const except = h("div", { class: "except", role: "group", "aria-label": words.reference.exceptLabel });
  const exceptRow = row(words.reference.except, { element: except });
  exceptRow.classList.add("top");
  const list = h("div", { class: "references" });
  const add = h("button", { type: "button", class: "command-word", "data-action": "add-reference" }, words.reference.add);
  add.addEventListener("click", () =>
    commit((document, at) => {
      const references = feature?.references ?? {};
      const name = NAMES.find((each) => !Object.hasOwn(references, each));
      const free = shapesOf(document).find((shape) => !Object.values(references).includes(shape.name)) ?? shapesOf(document)[0];
      if (!name || !free) return document;
      return setReferences(document, at, { ...references, [name]: free.name }, feature?.distance ?? name);
    }),
  );
  const text = expressionField({
    label: words.reference.expressionLabel,
    name: "part-distance",
    check: async (typed) => {
      const at = chosen();
      const names = Object.keys(feature?.references ?? {});
      return at ? faultOf(bench, at, "distance", (document) => setReferences(document, at, feature?.references ?? {}, typed), expression(typed, names) !== null) : null;
    },
    change: (typed, run) => commit((document, at) => setReferences(document, at, feature?.references ?? {}, typed), run),
    end: bench.endRun,
    cancel: (run) => void bench.app.store.cancel(run),
  });
  const several = h("div", {}, list, h("div", { class: "part-commands" }, add), row(words.reference.expression, text));

  /** @type {Map<string, ReturnType<typeof checkBox>>} */
  let boxes = new Map();
  /** @type {Map<string, {pick: ReturnType<typeof picker>, remove: HTMLButtonElement, element: HTMLElement}>} */
  const picks = new Map();

  /** @param {WholePart} document @param {number} body */
  function renderExcept(document, body) {
    const reference = feature?.reference;
    const boundary = typeof reference === "object" ? reference : null;
    const without = boundary?.except ?? [];
    const spec = boundary ? (document.bodies.find(({ name }) => name === boundary.boundary) ?? document.bodies[body]) : null;
    const names = spec ? [...new Set([spec.outline, ...(spec.holes ?? []), ...without, ...shapesOf(document).map(({ name }) => name)])] : [];
    exceptRow.hidden = !boundary;
    if (!boundary) return;
    if ([...boxes.keys()].join("\n") !== names.join("\n")) {
      boxes = new Map(
        names.map((name) => [
          name,
          checkBox({ name: `except-${name}`, text: [name] }, (on) =>
            commit((now, at) => {
              const before = feature?.reference;
              if (typeof before !== "object") return now;
              const others = (before.except ?? []).filter((each) => each !== name);
              return setReference(now, at, { ...before, except: on ? [...others, name] : others });
            }),
          ),
        ]),
      );
      except.replaceChildren(...[...boxes.values()].map(({ element }) => element));
    }
    for (const [name, box] of boxes) box.set(without.includes(name));
  }

  /** @param {WholePart} document */
  function renderSeveral(document) {
    const references = feature?.references;
    several.hidden = !references;
    if (!references) return;
    const names = Object.keys(references);
    for (const [name, { element }] of picks) {
      if (names.includes(name)) continue;
      element.remove();
      picks.delete(name);
    }
    for (const name of names) {
      let made = picks.get(name);
      if (!made) {
        const pick = picker({ label: words.reference.nth(name), name: `reference-${name}` }, (value) =>
          commit((now, at) => setReferences(now, at, { ...feature?.references, [name]: referenceOf(value) }, feature?.distance ?? "")),
        );
        const remove = h("button", { type: "button", class: "bare icon-only", "aria-label": words.reference.remove(name) }, "\u2212");
        remove.addEventListener("click", () =>
          commit((now, at) => {
            const { [name]: gone, ...rest } = feature?.references ?? {};
            return setReferences(now, at, rest, feature?.distance ?? "");
          }),
        );
        made = { pick, remove, element: h("div", { class: "row reference-row" }, h("span", { class: "row-label" }, h("code", {}, name)), h("span", { class: "row-controls" }, pick.element, remove)) };
        picks.set(name, made);
        list.append(made.element);
      }
      made.pick.set(valueOf(references[name]), choicesOf(document, references[name]));
      const isUsed = new RegExp(`(^|[^\\p{L}\\p{N}_])${name}($|[^\\p{L}\\p{N}_])`, "u").test(feature?.distance ?? "");
      made.remove.disabled = isUsed || names.length < 2;
      attribute(made.remove, "title", isUsed ? words.reference.used(name) : words.reference.remove(name));
    }
    add.disabled = names.length >= MOST;
  }

  return {
    element: h("div", {}, row(words.reference.label, main), exceptRow, several),
    /** @param {WholePart} document @param {At} at @param {PartFeature} next */
    render(document, at, next) {
      feature = next;
      const { reference, references, distance = "" } = next;
      main.set(valueOf(references ? undefined : reference), [...choicesOf(document, references ? undefined : reference), { value: SEVERAL, text: words.reference.several }]);
      renderExcept(document, at.body);
      renderSeveral(document);
      const { known, isCurrent } = bench.now();
      if (references) text.set(distance, isCurrent && known ? faultIn(known.part.diagnostics, at, "distance") : null);
    },
  };
}
