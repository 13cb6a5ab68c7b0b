/**
 * What happens when an edit makes a cell invalid: while something is dragged it is said in red beside the picture; once the edit is over the
 * person keeps it or takes it back, or one of both happens by itself where that is set.
 *
 * @import { CellVerdict } from "../../../../js/directrix.js"
 * @import { App } from "../../state/app.js"
 * @import { Known } from "../runner.js"
 *
 * @typedef {"ask" | "refuse" | "keep"} Policy
 */
import { h, write } from "../../dom.js";
import { words } from "./words.js";

const said = words.refusal;

/**
 * Cells that are invalid and were not before.
 * @param {readonly CellVerdict[]} verdicts
 * @param {ReadonlySet<number>} accepted
 */
export const newlyInvalid = (verdicts, accepted) => verdicts.filter(({ cell, verdict }) => verdict === "invalid" && !accepted.has(cell));

/** What is wrong, in words. @param {readonly CellVerdict[]} bad */
export function reasonOf(bad) {
  const [{ cell, witness }] = bad;
  const first = witness?.kind === "meeting" ? said.meeting(cell) : said.folded(cell);
  return bad.length > 1 ? first + said.others(bad.length - 1) : first;
}

/**
 * @param {App} app
 * @param {() => Policy} policy
 */
export function createRefusal(app, policy) {
  const { store } = app;
  /** Cells that may be invalid: they were when the document was opened, or the person has kept them. @type {Set<number>} */
  let accepted = new Set();
  let opened = "";
  /** @type {CellVerdict[]} */
  let bad = [];
  let asked = "";
  /** Whether every check of the document as it stands has run, and whether a pointer holds something. */
  let [hasRested, isHeld] = [false, false];
  const over = new AbortController();
  const hold = (/** @type {boolean} */ next) => () => {
    isHeld = next;
  };
  addEventListener("pointerdown", hold(true), { signal: over.signal, capture: true });
  for (const type of ["pointerup", "pointercancel"]) addEventListener(type, hold(false), { signal: over.signal, capture: true });

  const text = h("span", { role: "status" });
  const keep = h("button", { type: "button", class: "push", "data-invalid": "keep" }, said.keep);
  const back = h("button", { type: "button", class: "push", "data-invalid": "back" }, said.back);
  const element = h("div", { class: "body-refusal", role: "group", "aria-label": said.region, hidden: true, "data-refusal": "" }, text, back, keep);
  keep.addEventListener("click", () => {
    accept();
    app.say(said.kept);
    render();
  });
  back.addEventListener("click", takeBack);

  function accept() {
    accepted = new Set([...accepted, ...bad.map(({ cell }) => cell)]);
    bad = [];
  }

  function takeBack() {
    const why = reasonOf(bad);
    bad = [];
    store.endRun();
    store.undo();
    app.say(said.refused(why));
    render();
  }

  function render() {
    element.hidden = bad.length === 0;
    if (bad.length === 0) {
      asked = "";
      return;
    }
    write(text, reasonOf(bad));
    // A run of keys is over for the person once it rests, though the next press would go on with it.
    const isOver = !store.running || (hasRested && !isHeld);
    keep.hidden = back.hidden = !isOver;
    if (!isOver) return;
    if (policy() === "keep") {
      accept();
      element.hidden = true;
    } else if (policy() === "refuse" && store.canUndo) takeBack();
    else {
      back.disabled = !store.canUndo;
      const reason = reasonOf(bad);
      if (reason !== asked) app.say(`${reason}. ${said.back}? ${said.keep}?`);
      asked = reason;
    }
  }

  return {
    element,
    render,
    /** Cells of the edit at hand that are invalid. */
    get cells() {
      return bad.map(({ cell }) => cell);
    },
    /** What is known of the document as it stands. @param {Known} known */
    know(known) {
      const invalid = known.verdicts.filter(({ verdict }) => verdict === "invalid");
      const { name } = store.origin;
      if (name !== opened) {
        opened = name;
        accepted = new Set(invalid.map(({ cell }) => cell));
      }
      bad = newlyInvalid(known.verdicts, accepted);
      hasRested = known.summary !== null;
      render();
    },
    close: () => over.abort(),
  };
}
