/**
 * How much of each material the band holds, below the materials: asked for when nothing moves. What stands there stays until the new figures come.
 *
 * @import { App } from "../state/app.js"
 * @import { Amounts, CurvesDocument, Match } from "../types.js"
 */
import "../../styles/amounts.css";
import { attribute, h, write } from "../dom.js";
import { fixed } from "../format.js";
import { numberNode } from "../number-node.js";
import { currentMatch } from "../state/app.js";
import { square, words } from "./words.js";

/** Milliseconds after the last edit before the amounts are asked for. */
const PAUSE = 300;
/** Share of a material that is not there, but for rounding. */
const NOTHING = 1e-9;
/** Digits of an area, and the numbers that are written without a power of ten. */
const DIGITS = 4;
const PLAIN = /** @type {const} */ ([0.01, 1e7]);

/**
 * @param {App} app
 * @param {HTMLElement} place
 */
export function createAmounts(app, place) {
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let timer;
  /** The document that was asked for last. @type {CurvesDocument | null} */
  let asked = null;
  /** What the running pause is for. @type {{document: CurvesDocument, match: Match | null} | null} */
  let awaited = null;
  const rows = h("tbody", {});
  const table = h("table", { class: "amounts", "data-amounts": "" }, rows);
  const note = h("p", { class: "amounts-note", hidden: true });
  place.append(table, note);
  place.hidden = true;

  async function refresh() {
    const { document } = app.store;
    if (app.store.running) {
      timer = setTimeout(() => void refresh(), PAUSE);
      return;
    }
    const match = currentMatch(app);
    // A refinement is still to come, with a match of its own.
    if (match?.coarse) return;
    asked = document;
    const found = match ? await app.kernel.amounts(document).catch(() => null) : null;
    if (asked === document && app.store.document === document) show(found);
  }

  /** @param {Amounts | null} found */
  function show(found) {
    place.hidden = found === null;
    if (!found) return;
    const { unit, area, body, materials, rise, cells } = found;
    attribute(table, "aria-label", words.caption(unit));
    const row = (/** @type {string} */ name, /** @type {number} */ amount, /** @type {number} */ share, total = false) =>
      h(
        "tr",
        total ? { class: "amounts-total" } : {},
        h("th", { scope: "row", title: name }, name),
        h("td", { class: "number" }, areaNode(amount), unit === "" ? "" : `\u00a0${square(unit)}`),
        h("td", { class: "number" }, words.share(fixed(100 * share, 1))),
      );
    const held = materials.filter(({ share }) => share > NOTHING);
    const hasVoid = held.some((material) => material.void);
    rows.replaceChildren(
      ...held.map(({ name, amount, share, void: empty }) => row(empty ? words.void(name) : name, amount, share)),
      ...(hasVoid ? [row(words.body, body, area > 0 ? body / area : 0, true)] : []),
      row(words.band, area, 1, !hasVoid),
    );
    const remarks = [...(rise > 0 ? [words.projected] : []), ...(cells.folded > 0 ? [words.folded(cells.folded)] : [])];
    write(note, remarks.join(" "));
    note.hidden = remarks.length === 0;
  }

  return {
    render() {
      const { document } = app.store;
      const match = currentMatch(app);
      // Its match may come after the pause, and is asked about then.
      if (awaited?.document === document && awaited.match === match) return;
      awaited = { document, match };
      clearTimeout(timer);
      timer = setTimeout(() => void refresh(), PAUSE);
    },
  };
}

/** An area as plain digits where they are few. @param {number} value */
function areaNode(value) {
  if (value < PLAIN[0] || value >= PLAIN[1]) return numberNode(value);
  const whole = Math.floor(Math.log10(value)) + 1;
  return h("span", {}, fixed(value, Math.max(0, DIGITS - whole)));
}
