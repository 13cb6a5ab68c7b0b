/**
 * The group of the blend of a body: whether it has one, and what each piece of its boundary has. The piece that the pointer or the focus is on is lit in the picture.
 *
 * @import { Group } from "../../inspector/group.js"
 * @import { Bench } from "../state.js"
 */
import "../../../styles/part-blend.css";
import { segment } from "../../controls/choices.js";
import { numberField } from "../../controls/number-field.js";
import { row } from "../../controls/row.js";
import { h, write } from "../../dom.js";
import { fixed } from "../../format.js";
import { attachMenu } from "../../frame/menu-button.js";
import { addPiece, boundariesOf, ELEMENTS, loopsOf, MOST_BLENDS, MOST_BOUNDARIES, piecesOf, removePiece, setBlend, setElements } from "../edits/blend.js";
import { shapesOf } from "../edits/shapes.js";
import { createPiece } from "./piece.js";
import { words } from "./words.js";

/** The body that the group is about: the chosen one, else the first. @param {Bench} bench */
function bodyOf(bench) {
  const { document, shown } = bench.now();
  const index = shown.body !== null && document.bodies[shown.body] ? shown.body : 0;
  return { index, body: document.bodies[index] };
}

/** @param {Bench} bench @returns {Group} */
export function blendGroup(bench) {
  const { app } = bench;
  /** The piece that is open, and of which body. */
  let opened = { body: -1, key: /** @type {string | null} */ (null) };

  const choice = segment({ label: words.interior, name: "part-blend", choices: /** @type {const} */ (["none", "laplace"]).map((value) => ({ value, text: words.kinds[value] })) }, (kind) => {
    const { index, body } = bodyOf(bench);
    if (!body) return;
    bench.commit((document) => setBlend(document, index, kind === "laplace"));
    const isOn = bodyOf(bench).body?.blend !== undefined;
    app.say(isOn ? words.spoken.on(body.name) : words.spoken.off(body.name));
  });
  const about = h("p", { class: "part-note" });
  const list = h("div", { class: "design-rules", role: "group", "aria-label": words.list });
  const fault = h("p", { class: "part-fault", hidden: true, "data-blend-fault": "" });
  const add = h("button", { type: "button", class: "command-word", "data-action": "add-piece" }, words.add);
  attachMenu(add, () => {
    const { index, body } = bodyOf(bench);
    const { document } = bench.now();
    const taken = new Set(body ? [...loopsOf(body), ...boundariesOf(body).map(({ on }) => on)] : []);
    const free = shapesOf(document).filter(({ name }) => !taken.has(name));
    const isFull = boundariesOf(body).length >= MOST_BOUNDARIES;
    if (free.length === 0 || isFull) return [{ name: "none", text: words.noPiece, disabled: true, act() {} }];
    return free.map(({ name }) => ({
      name: `piece-${name}`,
      text: name,
      act: () => {
        bench.commit((now) => addPiece(now, index, name));
        open(`piece ${boundariesOf(bodyOf(bench).body).length - 1}`);
        app.say(words.spoken.added(name));
      },
    }));
  });
  const elements = numberField(
    { label: words.elementsLabel, name: "blend-elements", min: ELEMENTS.least, max: ELEMENTS.most, step: 50, decimals: 0, whole: true },
    {
      change: (value, run) => bench.commit((document) => setElements(document, bodyOf(bench).index, value), run),
      end: bench.endRun,
      cancel: (run) => void app.store.cancel(run),
    },
  );
  const found = h("p", { class: "part-note number" });
  const rows = h("div", {}, list, fault, h("div", { class: "part-commands" }, add), row(words.elements, elements), found);
  const choiceRow = row(words.interior, choice);
  const element = h("div", {}, choiceRow, about, rows);

  /** @type {ReturnType<typeof createPiece>[]} */
  const pieces = [];

  /** @param {string | null} key */
  function open(key) {
    opened = { body: bodyOf(bench).index, key };
    bench.request();
  }

  return {
    name: "blend",
    heading: words.heading,
    body: element,
    phrase() {
      const { body } = bodyOf(bench);
      return body?.blend ? words.phrase.laplace(piecesOf(body).length) : words.phrase.none;
    },
    render() {
      const { document, known, isCurrent } = bench.now();
      const { index, body } = bodyOf(bench);
      element.hidden = !body;
      if (!body) return;
      const { blend } = body;
      choice.set(blend ? "laplace" : "none");
      const isFull = !blend && document.bodies.filter((each) => each.blend).length >= MOST_BLENDS;
      const isPrinted = body.rule === "printed";
      write(about, isPrinted ? words.about.printed : isFull ? words.about.full(MOST_BLENDS) : blend ? words.about.laplace(body.name) : words.about.none(body.name));
      rows.hidden = !blend;
      if (!blend) {
        if (bench.now().shown.lit !== null) bench.change({ lit: null });
        return;
      }
      const all = piecesOf(body);
      if (opened.body !== index) opened = { body: index, key: null };
      while (pieces.length < all.length) {
        const piece = createPiece(bench, { index: () => bodyOf(bench).index, open, remove });
        pieces.push(piece);
        list.append(piece.element);
      }
      while (pieces.length > all.length) pieces.pop()?.element.remove();
      const faults = isCurrent ? (known?.part.diagnostics.filter((each) => each.body === index && each.path.includes(".blend")) ?? []) : [];
      all.forEach((piece, k) => {
        const key = piece.isLoop ? `loop ${piece.on}` : `piece ${piece.index}`;
        const own = piece.index === null ? null : (faults.find(({ boundary }) => boundary === piece.index) ?? null);
        pieces[k].render(body, piece, { key, isOpen: opened.key === key, fault: own });
      });
      const whole = faults.find(({ boundary }) => boundary === undefined) ?? null;
      write(fault, whole?.message ?? "");
      fault.hidden = whole === null;
      fault.classList.toggle("remark", whole?.skipped === false);
      elements.set(blend.elements ?? ELEMENTS.usual);
      const count = isCurrent ? (known?.part.bodies[index]?.blend ?? null) : null;
      if (isCurrent) write(found, count === null ? "" : words.found(fixed(count, 0)));
      found.hidden = found.textContent === "";
    },
  };

  /** @param {number} piece index of the condition @param {string} name */
  function remove(piece, name) {
    bench.commit((document) => removePiece(document, bodyOf(bench).index, piece));
    bench.change({ lit: null });
    open(null);
    app.say(words.spoken.removed(name));
    add.focus();
  }
}
