/**
 * Why a ruling line is one: the parts of its value, its rank at either end, and its nearest rivals with what became of them.
 *
 * @import { App } from "../state/app.js"
 * @import { Panel } from "../frame/panel.js"
 * @import { Explanation, Point, Standing } from "../types.js"
 */
import "../../styles/push.css";
import { h } from "../dom.js";
import { fixed, length } from "../format.js";
import { openPanel } from "../frame/panel.js";
import { symbol } from "../icons.js";
import { numberNode } from "../number-node.js";
import { problem } from "../painter.js";
import { spanOf } from "../../../js/span.js";
import { words as stackWords } from "../stack/words.js";
import { curveName, currentMatch } from "../state/app.js";
import { inSpan, shownLines } from "../state/lines.js";
import { inSentence } from "../strings.js";
import { toScreen } from "../view.js";
import { pinLine, pinsOf } from "./pin-edits.js";
import { pinAt, pinOf } from "./pins.js";
import { words as all } from "./words.js";

const words = all.explain;

/**
 * @param {App} app
 * @param {(rivals: [Point, Point][]) => void} contend draws the rivals
 */
export function createExplainPanel(app, contend) {
  /** @type {Panel | null} */
  let panel = null;
  /** @type {number | null} */
  let shown = null;
  const body = h("div", { class: "explain" });

  /** @param {number} line */
  async function fill(line) {
    const { document } = app.store;
    let found;
    const place = inSpan(currentMatch(app), line);
    try {
      const isStack = document.curves.length > 2;
      found = counted(await app.kernel.explain(isStack ? spanOf(document, place.span) : document, place.line), line - place.line);
    } catch (error) {
      found = problem(error).message;
    }
    if (shown !== line || app.store.document !== document || !panel) return;
    if (found === null || typeof found === "string") {
      body.replaceChildren(h("p", {}, found ?? words.gone));
      return;
    }
    contend(found.ends.flatMap(({ rivals }) => rivals.map(({ from, to }) => /** @type {[Point, Point]} */ ([from, to]))));
    body.replaceChildren(...partsOf(app, found), ...found.ends.map((end, i) => standing(app, found, end, place.span + i)), acts(app, line));
    app.say(spoken(app, found, place.span));
  }

  /** Puts the panel where the line is not. @param {number} line */
  function stand(line) {
    const { view, size } = app.ui.value;
    const ends = shownLines(currentMatch(app))[line];
    if (!panel || !view || !ends) return;
    const [a, b] = [ends.from, ends.to].map((at) => toScreen(view, size, at));
    panel.element.dataset.across = a[0] + b[0] < size.width ? "right" : "left";
    panel.element.dataset.down = a[1] + b[1] < size.height ? "bottom" : "top";
  }

  function close() {
    shown = null;
    contend([]);
    const open = panel;
    panel = null;
    open?.close();
  }

  return {
    render() {
      const { line } = app.ui.value;
      if (line === shown) return;
      if (line === null) {
        close();
        return;
      }
      shown = line;
      const heading = words.heading(line);
      if (panel) {
        const title = panel.element.querySelector("h2");
        if (title) title.textContent = heading;
      } else {
        panel = openPanel({
          name: "explain",
          heading,
          body: [body],
          onclose: () => {
            panel = null;
            if (shown !== null) app.ui.set({ line: null });
          },
        });
      }
      stand(line);
      void fill(line);
    },
  };
}

/** @param {Node | string} label @param {Node | string} value @param {Node | string} factor */
const part = (label, value, factor) =>
  h("div", { class: "explain-row" }, h("span", {}, label), h("span", { class: "number" }, value), h("span", { class: "number" }, factor));

/**
 * The value, and what it is the product of.
 * @param {App} app
 * @param {Explanation} found
 */
function partsOf(app, { value, cosine, length: long, alignment, factors }) {
  const { matching, unit } = app.store.document;
  const times = (/** @type {number} */ factor) => h("span", {}, "× ", numberNode(factor));
  return [
    h("div", { class: "explain-value" }, symbol("f"), h("span", {}, " = "), h("strong", {}, numberNode(value))),
    part(words.normals, fixed(cosine, 3), times(factors[0])),
    part(words.length, length(long, unit), times(factors[1])),
    ...(matching.alignmentWeight > 0
      ? [part(words.alignment, fixed(alignment, 3), times(factors[2]))]
      : []),
  ];
}

/**
 * @param {App} app
 * @param {Explanation} found
 * @param {Standing} standing
 * @param {number} end
 */
function standing(app, { value }, { rank, visible, rivals }, end) {
  const { document } = app.store;
  const match = currentMatch(app);
  const toLines = ((match?.spans?.[0] ?? match)?.pairs.length ?? 0) > 0;
  return h(
    "section",
    { "data-end": end },
    h("h3", {}, words.from(inSentence(curveName(document, end)))),
    h("p", { class: "explain-rank" }, rank === null ? words.unseen(visible) : words.rank(rank, visible)),
    h(
      "ul",
      { class: "explain-rivals", "aria-label": words.rivals },
      ...rivals.map((rival) =>
        h(
          "li",
          { class: "explain-row" },
          h("span", {}, (toLines ? words.toLine : words.toSample)(rival.other)),
          h("span", { class: "number" }, numberNode(rival.value)),
          h("span", { class: "explain-fate" }, fateOf(rival, value)),
        ),
      ),
    ),
  );
}

/**
 * Why a rival lost.
 * @param {Standing["rivals"][number]} rival
 * @param {number} value of the line that won
 */
function fateOf({ fate, line, value: its }, value) {
  if (fate === "free") return its <= value ? words.fates.lower() : words.fates.free();
  return words.fates[fate](line ?? 0);
}

/**
 * An explanation of a line of a span with all lines counted on through the stack.
 * @param {Explanation | null} found
 * @param {number} before lines of the spans before
 */
function counted(found, before) {
  if (!found || before === 0) return found;
  const ends = found.ends.map((end) => ({
    ...end,
    rivals: end.rivals.map((rival) => ({ ...rival, ...(rival.line === null ? {} : { line: rival.line + before }) })),
  }));
  return { ...found, line: found.line + before, ends: /** @type {Explanation["ends"]} */ (ends) };
}

/** @param {App} app @param {number} line */
function acts(app, line) {
  const count = shownLines(currentMatch(app)).length;
  const match = currentMatch(app);
  const ends = match && pinOf(app.store.document, match, line);
  const pinned = ends !== null && pinsOf(app).length > 0 && pinAt(app.store.document, ends) >= 0;
  const button = (/** @type {string} */ name, /** @type {string} */ text, /** @type {() => void} */ act) =>
    h("button", { type: "button", class: "push", "data-explain": name, onclick: act }, text);
  const go = (/** @type {number} */ by) => app.ui.set({ line: (line + by + count) % count });
  return h(
    "div",
    { class: "explain-acts" },
    app.store.document.curves.length > 2 ? h("p", {}, stackWords.noPins) : pinned ? h("p", {}, words.pinned) : button("pin", words.pin, () => void pinLine(app, line)),
    button("previous", words.previous, () => go(-1)),
    button("next", words.next, () => go(1)),
  );
}

/** @param {App} app @param {Explanation} found @param {number} span */
function spoken(app, { line, ends }, span) {
  const ranks = ends.map(({ rank, visible }, i) => {
    const where = words.from(inSentence(curveName(app.store.document, span + i)));
    return `${where} ${rank === null ? words.unseen(visible) : words.rank(rank, visible)}`;
  });
  return [words.heading(line), ...ranks].join(". ");
}
