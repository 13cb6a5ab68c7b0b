/**
 * A field for a typed expression. What is typed is asked about as it is typed; what is an expression takes effect at once, and of what is none it says why,
 * and where, while the last one that was goes on to work.
 *
 * @import { PartDiagnostic } from "../../../../js/directrix.js"
 * @import { WholePart } from "../document.js"
 * @import { At } from "../edits/features.js"
 * @import { Bench } from "../state.js"
 *
 * @typedef {{message: string, character: number | null}} Fault
 */
import { newRun } from "../../controls/run.js";
import { attribute, h, write } from "../../dom.js";
import { hideFeature } from "../edits/features.js";
import { words } from "./words.js";

/** Most characters of an expression, as in docs/format.md. */
const LONGEST = 1000;

/**
 * @param {object} options
 * @param {string} options.label
 * @param {string} options.name
 * @param {string} [options.help]
 * @param {(text: string) => Promise<Fault | null>} options.check what is wrong with a text
 * @param {(text: string, run: string) => void} options.change
 * @param {() => void} options.end of a run
 * @param {(run: string) => void} options.cancel
 */
export function expressionField({ label, name, help = "", check, change, end, cancel }) {
  const id = `error-${name}`;
  const input = h("input", { type: "text", class: "expression-input", maxLength: LONGEST, autocomplete: "off", autocapitalize: "off", spellcheck: false, "aria-label": label, "data-field": name });
  const field = h("span", { class: "field" }, input);
  const [before, fault, after] = [h("span", {}), h("mark", {}), h("span", {})];
  const place = h("code", { class: "expression-place", "aria-hidden": "true" }, before, fault, after);
  const message = h("span", {});
  const error = h("div", { class: "field-error", id, hidden: true }, place, message);
  const note = h("p", { class: "part-note" }, help);
  let value = "";
  let run = newRun(name);
  let asked = 0;
  let isTyped = false;

  /** @param {Fault | null} found */
  function complain(found) {
    error.hidden = found === null;
    field.classList.toggle("wrong", found !== null);
    attribute(input, "aria-invalid", found ? "true" : null);
    attribute(input, "aria-describedby", found ? id : null);
    if (!found) return;
    const characters = [...input.value];
    const { character } = found;
    place.hidden = character === null;
    if (character !== null) {
      write(before, characters.slice(0, character).join(""));
      write(fault, characters[character] ?? "\u00a0");
      write(after, characters.slice(character + 1).join(""));
    }
    write(message, found.message);
  }

  async function ask() {
    asked += 1;
    const own = asked;
    const text = input.value;
    const found = await check(text);
    if (own !== asked) return;
    complain(found);
    if (found || text === value) return;
    value = text;
    change(text, run);
  }

  /** What is no expression gives way to the last one that was. */
  function settle() {
    asked += 1;
    isTyped = false;
    complain(null);
    input.value = value;
    run = newRun(name);
    end();
  }

  input.addEventListener("input", () => {
    isTyped = true;
    void ask();
  });
  input.addEventListener("blur", settle);
  input.addEventListener("keydown", (event) => {
    if (event.key === "Escape") {
      event.stopPropagation();
      cancel(run);
      settle();
    } else if (event.key === "Enter" && error.hidden) input.select();
  });

  return {
    element: h("div", { class: "expression" }, field, error, help ? note : null),
    /** @param {string} text @param {Fault | null} known what is wrong with the document's own text */
    set(text, known) {
      value = text;
      if (isTyped && document.activeElement === input) return;
      if (input.value !== text) input.value = text;
      complain(known);
    },
  };
}

/**
 * What the kernel would say is wrong with an expression of a feature. It says nothing of a body that cannot be made; what is no expression at all is known here too.
 * @param {Bench} bench
 * @param {At} at
 * @param {"course.text" | "distance"} field that has the text
 * @param {(document: WholePart) => WholePart} change that gives it the text
 * @param {boolean} isReadable
 * @returns {Promise<Fault | null>}
 */
export async function faultOf({ app, now }, at, field, change, isReadable) {
  const candidate = hideFeature(change(now().document), at, false);
  try {
    const { diagnostics } = await app.kernel.part(candidate);
    return faultIn(diagnostics, at, field) ?? (isReadable ? null : { message: words.noExpression, character: null });
  } catch (error) {
    return { message: error instanceof Error ? error.message : String(error), character: null };
  }
}

/**
 * What was said of an expression of a feature.
 * @param {readonly PartDiagnostic[]} diagnostics
 * @param {At} at
 * @param {"course.text" | "distance"} field
 * @returns {Fault | null}
 */
export function faultIn(diagnostics, at, field) {
  const found = diagnostics.find(({ path }) => path === `bodies[${at.body}].features[${at.feature}].${field}`);
  return found ? { message: found.message, character: found.character ?? null } : null;
}
