/**
 * The three checks of cells that an operation made, as lines: each with its sign and the module's message.
 *
 * @import { AdditionChecks } from "../../../../js/directrix.js"
 */
import { h } from "../../dom.js";
import { sign } from "../verdict.js";
import { words } from "./words.js";

const said = words.build;

/** @param {string} text */
const sentence = (text) => text.charAt(0).toUpperCase() + text.slice(1);

export function checkLines() {
  const element = h("dl", { class: "check-lines", "data-checks": "", hidden: true });
  let drawn = "";
  return {
    element,
    /** @param {AdditionChecks | null} checks */
    render(checks) {
      element.hidden = !checks;
      if (!checks) return;
      const lines = /** @type {const} */ (["injective", "meetings", "continuity"]).map((name) => ({ name, ok: name === "continuity" || checks[name].ok, message: sentence(checks[name].message) }));
      const key = JSON.stringify(lines);
      if (key === drawn) return;
      drawn = key;
      element.replaceChildren(
        ...lines.map(({ name, ok, message }) => {
          const mark = name === "continuity" ? h("span", { class: "check-dot" }) : sign(ok ? "regular" : "invalid");
          const attributes = { class: ok ? "check-line" : "check-line failed", "data-check": name, "data-ok": String(ok) };
          return h("div", attributes, h("dt", {}, /** @type {any} */ (mark), said[name]), h("dd", {}, message));
        }),
      );
    },
  };
}
