/**
 * A piece of the boundary of a body: a line that opens, with the choice of what the piece has and the controls of that.
 *
 * @import { PartBody, PartBoundary, PartDiagnostic } from "../../../../js/directrix.js"
 * @import { Condition, piecesOf } from "../edits/blend.js"
 * @import { Bench } from "../state.js"
 *
 * @typedef {ReturnType<typeof piecesOf>[number]} Piece
 *
 * @typedef {object} Host
 * @property {() => number} index of the body
 * @property {(key: string | null) => void} open opens the piece of a key in place of any other
 * @property {(piece: number, name: string) => void} remove
 */
import { mixingControl } from "../../controls/mixing.js";
import { numberField } from "../../controls/number-field.js";
import { row } from "../../controls/row.js";
import { attribute, h, write } from "../../dom.js";
import { mixed } from "../../oklab.js";
import { percent } from "../../format.js";
import { boundariesOf, conditionOf, firstCondition, setBoundary, withSlope } from "../edits/blend.js";
import { FAR, queueOf } from "../edits/features.js";
import { isUsed, materialsOf } from "../edits/materials.js";
import { picker } from "../profile/picker.js";
import { words } from "./words.js";

const CONDITIONS = /** @type {Condition[]} */ (Object.keys(words.conditions));

/** @param {Bench} bench @param {Host} host */
export function createPiece(bench, host) {
  const { app } = bench;
  /** @type {Piece} */
  let piece = { on: "", index: null, isLoop: true };
  let key = "";
  let isOpen = false;

  const current = () => {
    const { document } = bench.now();
    const boundaries = boundariesOf(document.bodies[host.index()]);
    return /** @type {PartBoundary} */ ((piece.index === null ? undefined : boundaries[piece.index]) ?? { on: piece.on, within: 0 });
  };
  /** @param {PartBoundary} next @param {string} [run] */
  const commit = (next, run) => bench.commit((document) => setBoundary(document, host.index(), piece.on, piece.index, next), run);
  const end = bench.endRun;
  const cancel = (/** @type {string} */ run) => void app.store.cancel(run);

  const swatch = h("span", { class: "part-swatch", "aria-hidden": "true" });
  const name = h("span", { class: "design-name" });
  const spokenRole = h("span", { class: "spoken" });
  const has = h("span", { class: "design-count" });
  const line = h("button", { type: "button", class: "design-rule" }, swatch, name, spokenRole, has);
  line.addEventListener("click", () => host.open(isOpen ? null : key));

  const condition = picker({ label: words.condition, name: "blend-condition" }, (value) => {
    const { document } = bench.now();
    const kind = /** @type {Condition} */ (value);
    const next = firstCondition(document, host.index(), current(), kind);
    if (!next) return;
    commit(next);
    app.say(words.spoken.has(piece.on, words.conditions[kind]));
  });
  const means = h("p", { class: "part-note" });
  const mixing = mixingControl({ change: (value, run) => commit({ on: piece.on, within: current().within ?? 0, value }, run), end, cancel });
  const slopes = h("div", { class: "blend-slopes" });
  const source = picker({ label: words.from, name: "blend-from" }, (value) => {
    const before = current();
    const as = conditionOf(before) === "body" ? "body" : "feature";
    commit({ on: before.on, within: before.within ?? 0, from: /** @type {{body: string} | {feature: string}} */ ({ [as]: value }) });
  });
  const sourceRow = row(words.from, source);
  const within = numberField(
    { label: words.withinLabel, name: "blend-within", min: 0, max: FAR, step: 1, decimals: 2 },
    { change: (value, run) => commit({ ...current(), within: value }, run), end, cancel },
  );
  const withinRow = row(words.within, within);
  const remove = h("button", { type: "button", class: "command-word", "data-action": "remove-piece" }, words.remove);
  remove.addEventListener("click", () => {
    if (piece.index !== null) host.remove(piece.index, piece.on);
  });
  const removeRow = h("div", { class: "part-commands" }, remove);
  const details = h("div", { class: "design-details" }, row(words.condition, condition), means, mixing.element, slopes, sourceRow, withinRow, removeRow);
  const fault = h("p", { class: "part-fault", hidden: true });
  const element = h("div", { class: "blend-piece" }, line, details, fault);
  /** @type {{field: ReturnType<typeof numberField>, element: HTMLElement}[]} */
  let fields = [];
  let fieldsOf = "";

  const light = (/** @type {string | null} */ on) => {
    if (bench.now().shown.lit !== on) bench.change({ lit: on });
  };
  element.addEventListener("pointerenter", () => light(piece.on));
  element.addEventListener("pointerleave", () => light(element.contains(document.activeElement) ? piece.on : null));
  element.addEventListener("focusin", () => light(piece.on));
  element.addEventListener("focusout", (event) => {
    if (!(event.relatedTarget instanceof Node && element.contains(event.relatedTarget))) light(null);
  });

  /** A number for the gradient of each material; the last one follows. @param {readonly number[]} flux */
  function renderSlopes(flux) {
    const materials = materialsOf(bench.now().document);
    const next = JSON.stringify(materials.map((each) => each.name));
    if (next !== fieldsOf) {
      fieldsOf = next;
      fields = materials.slice(0, -1).map((material, k) => {
        const field = numberField(
          { label: words.slope(material.name), name: `blend-slope-${k}`, min: -FAR, max: FAR, step: 0.01, decimals: 3 },
          { change: (value, run) => commit({ on: piece.on, within: current().within ?? 0, flux: withSlope(current().flux ?? [], k, value) }, run), end, cancel },
        );
        return { field, element: row(material.name, field) };
      });
      slopes.replaceChildren(...fields.map((each) => each.element), h("div", { class: "row" }, h("span", { class: "row-label" }, materials.at(-1)?.name ?? ""), h("span", { class: "row-controls" }, h("span", { class: "fact number", "data-blend-rest": "" }))));
    }
    fields.forEach(({ field }, k) => field.set(flux[k] ?? 0));
    const rest = slopes.querySelector("[data-blend-rest]");
    if (rest instanceof HTMLElement) write(rest, String(flux.at(-1) ?? 0));
  }

  /** What the piece has, in a word or two. @param {PartBoundary} boundary */
  function shortly(boundary) {
    const kind = conditionOf(boundary);
    const materials = materialsOf(bench.now().document);
    if (kind === "value") {
      const of = (boundary.value ?? []).flatMap((fraction, k) => (fraction > 0 && materials[k] ? [fraction === 1 ? materials[k].name : `${materials[k].name} ${percent(fraction)}`] : []));
      return of.length > 2 ? words.short.mixture : of.join(", ");
    }
    const { from } = boundary;
    if (from) return "body" in from ? words.short.body(from.body) : words.short.feature(from.feature);
    return kind === "flux" ? words.short.flux : words.short.insulated;
  }

  return {
    element,
    /** @param {PartBody} body @param {Piece} next @param {{key: string, isOpen: boolean, fault: PartDiagnostic | null}} state */
    render(body, next, state) {
      [piece, key, isOpen] = [next, state.key, state.isOpen];
      const { document } = bench.now();
      const boundary = current();
      const kind = conditionOf(boundary);
      const materials = materialsOf(document);
      const role = piece.on === body.outline ? words.roles.outline : piece.isLoop ? words.roles.hole : words.roles.piece;
      const text = shortly(boundary);
      attribute(line, "data-blend-piece", piece.on);
      attribute(line, "aria-expanded", String(isOpen));
      write(spokenRole, words.role(role));
      write(name, piece.on);
      write(has, text);
      swatch.style.backgroundColor = boundary.value ? mixed(materials.map(({ color }) => color), boundary.value) : "transparent";
      swatch.classList.toggle("blend-open", !boundary.value);
      write(fault, state.fault?.message ?? "");
      fault.hidden = state.fault === null;
      details.hidden = !isOpen;
      if (!isOpen) return;
      const others = document.bodies.filter((each) => each.name !== body.name).map((each) => each.name);
      const features = [...new Set(queueOf(body).map((each) => each.name ?? ""))];
      const isOff = (/** @type {Condition} */ each) => (each === "body" ? others.length === 0 : each === "feature" && features.length === 0);
      condition.set(kind, CONDITIONS.map((value) => ({ value, text: words.conditions[value], disabled: isOff(value) && kind !== value })));
      const said = kind === "value" ? "" : kind === "flux" ? words.means.flux(document.unit ?? "") : words.means[kind];
      write(means, said);
      means.hidden = said === "";
      mixing.element.hidden = kind !== "value";
      if (boundary.value) mixing.render({ materials: /** @type {any} */ (materials), mix: boundary.value, used: materials.map((_, k) => k).filter((k) => isUsed(document, k)), three: null });
      slopes.hidden = kind !== "flux";
      if (boundary.flux) renderSlopes(boundary.flux);
      sourceRow.hidden = !boundary.from;
      if (boundary.from) {
        const [list, chosen] = "body" in boundary.from ? [others, boundary.from.body] : [features, boundary.from.feature];
        const choices = list.map((value) => ({ value, text: value }));
        source.set(chosen, list.includes(chosen) ? choices : [{ value: chosen, text: chosen }, ...choices]);
      }
      withinRow.hidden = piece.isLoop;
      within.set(boundary.within ?? 0);
      removeRow.hidden = piece.isLoop;
    },
  };
}
