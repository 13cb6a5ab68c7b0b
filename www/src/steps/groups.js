/**
 * The groups beside the picture: the pseudo-code with the line at work, the numbers of the step, the candidates with f and bars, the
 * lines accepted so far, and the exact optimum.
 *
 * @import { App } from "../state/app.js"
 * @import { Group } from "../inspector/group.js"
 * @import { Steps, VertexSets } from "../../../js/directrix.js"
 * @import { Prediction } from "./prediction.js"
 * @import { Line, Scene } from "./film.js"
 * @import { Vertex } from "./picture.js"
 *
 * @typedef {object} Now What the groups show.
 * @property {Steps} steps
 * @property {number} at
 * @property {Scene} scene
 * @property {boolean} hidden
 * @property {Vertex | null} focus
 * @property {boolean} pinned whether the person chose the vertex
 * @property {VertexSets | null} sets
 * @property {Prediction | null} prediction
 */
import "../../styles/step-groups.css";
import { h, write } from "../dom.js";
import { fixed } from "../format.js";
import { symbol } from "../icons.js";
import { numberNode } from "../number-node.js";
import { currentMatch } from "../state/app.js";
import { keptGaps, shownTotals } from "../state/lines.js";
import { lengths, lineName, phaseAt, vertexName } from "./film.js";
import { words } from "./words.js";

/** Candidates, and other visible vertices, that are listed. */
const LISTED = 12;
const OTHERS = 4;

/**
 * @param {App} app
 * @param {() => Now | null} now
 * @param {{goTo: (at: number) => void, follow: () => void}} acts
 * @returns {Group[]}
 */
export function createStepGroups(app, now, acts) {
  return [codeGroup(app, now), stepGroup(now, acts), candidatesGroup(app, now), acceptedGroup(now, acts), optimumGroup(app, now)];
}

/** @param {App} app @param {() => Now | null} now @returns {Group} */
function codeGroup(app, now) {
  const lines = words.code.map((text, k) =>
    h("li", { "data-code": String(k) }, ...text.split("*").map((part, odd) => (odd % 2 ? h("b", {}, part) : part))),
  );
  const note = h("p", { class: "steps-note", "data-steps-note": "" });
  return {
    name: "growth",
    heading: words.groups.growth,
    body: h("div", {}, h("ol", { class: "steps-code" }, ...lines), note),
    phrase: () => words.heuristic,
    render() {
      const { scene } = now() ?? {};
      const { method, printed = [] } = /** @type {{method: keyof typeof words.methods, printed?: string[]}} */ (app.store.document.matching);
      lines.forEach((line, k) => {
        if (k === scene?.code) line.setAttribute("aria-current", "step");
        else line.removeAttribute("aria-current");
      });
      const sentences = [
        method === "greedy" ? "" : words.otherMethod(words.methods[method]),
        printed.some((rule) => ["order", "stop", "removal"].includes(rule)) ? words.repaired : "",
      ];
      write(note, sentences.filter(Boolean).join(" "));
      note.hidden = note.textContent === "";
    },
  };
}

/** @param {() => Now | null} now @param {{follow: () => void}} acts @returns {Group} */
function stepGroup(now, { follow }) {
  const body = h("div", {});
  let drawn = "";
  const back = h("button", { type: "button", class: "command-word", "data-steps": "follow", onclick: follow }, words.follow);
  return {
    name: "step",
    heading: words.groups.step,
    body,
    commands: [back],
    phrase: () => phraseOf(now()),
    render() {
      const state = now();
      back.hidden = !state?.pinned;
      const key = JSON.stringify([state && { ...state, steps: state.at, scene: state.scene.chosen }]);
      if (key === drawn) return;
      drawn = key;
      body.replaceChildren(...(state ? factsOf(state) : []));
    },
  };
}

/** @param {Now | null} state */
function phraseOf(state) {
  if (!state) return "";
  const { scene, focus } = state;
  if (scene.phase === "growth" && focus) return words.vertexOf(vertexName(focus.curve, focus.vertex));
  return words.phases[scene.phase];
}

/** @param {Now} state @returns {Node[]} */
function factsOf({ steps, scene, hidden, focus, sets }) {
  const { chosen, left, degrees, redundant } = scene;
  if (focus && (scene.phase === "growth" || scene.phase === "start")) {
    const name = vertexName(focus.curve, focus.vertex);
    const best = sets?.visible.find(({ candidate }) => candidate);
    const isNext = chosen && (focus.curve === 0 ? chosen.from : chosen.to) === focus.vertex;
    return [
      ...(sets
        ? [
            fact(words.seen(name), String(sets.visible.length), "visible"),
            fact(words.valid, String(sets.valid.length), "valid"),
            fact(words.both, String(sets.visible.filter(({ candidate }) => candidate).length), "both"),
          ]
        : []),
      ...(best ? [fact(isNext ? words.winnerFact : words.bestFact, [vertexName(1 - focus.curve, best.vertex), ", ", symbol("f"), " ", numberNode(best.value)], "best")] : []),
      ...(chosen && !isNext ? [lineFact(chosen)] : []),
    ];
  }
  if (scene.phase === "start") return [h("p", { class: "steps-note" }, words.startText)];
  if (hidden) return [h("p", { class: "steps-note" }, words.hiddenNow)];
  if (scene.phase === "end") return endOf(steps);
  if (!chosen) return [];
  if (scene.phase === "removal") {
    const ends = /** @type {const} */ ([chosen.from, chosen.to]);
    return [
      lineFact(chosen),
      ...ends.map((vertex, curve) => fact(words.linesAt(vertexName(curve, vertex)), String(degrees[curve === 0 ? 0 : 1][vertex ?? 0]), `degree-${curve}`)),
      fact(words.redundant, String(redundant.length + 1), "redundant"),
    ];
  }
  const curve = scene.phase === "first" ? 0 : 1;
  const kept = vertexName(1 - curve, curve === 0 ? chosen.to : chosen.from);
  const old = vertexName(curve, left && (curve === 0 ? left.from : left.to));
  const vertices = [words.newVertex(curve), kept];
  return [
    fact(words.leaves(kept), old, "left"),
    fact(vertices[0] ?? "", String(scene.inserted.length), "inserted"),
    ...(left ? [fact(h("span", {}, symbol("f"), " ", words.before), numberNode(left.value), "before")] : []),
    fact(h("span", {}, symbol("f"), " ", words.after), numberNode(chosen.value), "after"),
  ];
}

/** @param {Steps} steps @returns {Node[]} */
function endOf(steps) {
  const totals = shownTotals(steps);
  if (!totals) return [];
  const [a, b] = totals.uncovered;
  const gaps = keptGaps(steps).length;
  const text =
    a.length + b.length > 0 ? words.endText.stuck(a.length, b.length) : gaps > 0 ? words.endText.gaps(gaps) : words.endText.whole;
  return [
    fact(words.linesLeft, String(totals.count), "lines"),
    ...(totals.mean === null ? [] : [fact(h("span", {}, `${words.mean} `, symbol("f")), numberNode(totals.mean), "mean")]),
    ...(totals.eta === null ? [] : [fact(symbol("η"), fixed(totals.eta, 3), "eta")]),
    fact(words.crossings, String(totals.crossings), "crossings"),
    fact(words.blocked, String(totals.blocked), "blocked"),
    h("p", { class: "steps-note" }, text),
  ];
}

/** @param {Line} line */
const lineFact = (line) => fact(words.theLine, [lineName(line), ", ", symbol("f"), " ", numberNode(line.value)], "line");

/**
 * @param {string | Node} label
 * @param {string | Node | (string | Node)[]} value
 * @param {string} name
 */
function fact(label, value, name) {
  const parts = Array.isArray(value) ? value : [value];
  return h("div", { class: "steps-fact", "data-fact": name }, h("span", {}, label), h("span", { class: "strong number" }, ...parts));
}

/** @param {App} app @param {() => Now | null} now @returns {Group} */
function candidatesGroup(app, now) {
  const body = h("div", {});
  let drawn = "";
  return {
    name: "candidates",
    heading: words.groups.candidates,
    body,
    phrase() {
      const { sets } = now() ?? {};
      return sets ? String(sets.visible.filter(({ candidate }) => candidate).length) : "";
    },
    render() {
      const state = now();
      const key = JSON.stringify([state?.at, state?.hidden, state?.focus, state?.sets]);
      if (key === drawn) return;
      drawn = key;
      body.replaceChildren(...tableOf(app, state));
    },
  };
}

/** @param {App} app @param {Now | null} state @returns {Node[]} */
function tableOf(app, state) {
  const { focus, sets, scene, hidden, steps } = state ?? {};
  const note = (/** @type {string} */ text) => [h("p", { class: "steps-note" }, text)];
  if (hidden) return note(words.hiddenNow);
  if (!focus || !sets || !scene || !steps) return note(words.onlyGrowth);
  const candidates = sets.visible.filter(({ candidate }) => candidate);
  const others = sets.visible.filter(({ candidate }) => !candidate);
  const most = Math.max(...sets.visible.map(({ value }) => value), 0);
  const power = most > 0 ? Math.floor(Math.log10(most)) : 0;
  const exponent = power < -1 || power > 2 ? power : 0;
  const shown = (/** @type {number} */ value) => fixed(value / 10 ** exponent, most / 10 ** exponent < 1 ? 3 : 2);
  const { chosen } = scene;
  const isNext = chosen && (focus.curve === 0 ? chosen.from : chosen.to) === focus.vertex;
  const highest = candidates[0]?.value ?? 0;
  const name = (/** @type {number} */ vertex) => vertexName(1 - focus.curve, vertex);
  const has = (/** @type {number} */ vertex) =>
    scene.lines.some(({ from, to }) => (focus.curve === 0 ? from === focus.vertex && to === vertex : to === focus.vertex && from === vertex));

  const rows = candidates.slice(0, LISTED).map(({ vertex, value }, k) => {
    const bar = h("span", { class: "steps-bar" });
    bar.style.width = `${highest > 0 ? Math.max(0, (100 * value) / highest) : 0}%`;
    const first = k === 0;
    return h(
      "tr",
      { class: first ? "first" : "", "data-candidate": String(vertex) },
      h("th", { scope: "row" }, name(vertex), first ? ` ${isNext ? words.winner : words.best}` : ""),
      h("td", { class: "number" }, shown(value)),
      h("td", { "aria-hidden": "true" }, bar),
    );
  });
  const rest = others.slice(0, OTHERS).map(({ vertex, value }) =>
    h(
      "tr",
      { class: "other", "data-other": String(vertex) },
      h("th", { scope: "row" }, `${name(vertex)} ${has(vertex) ? words.has : words.breaks}`),
      h("td", { class: "number" }, shown(value)),
      h("td", { "aria-hidden": "true" }),
    ),
  );
  const more = Math.max(0, candidates.length - LISTED) + Math.max(0, others.length - OTHERS);
  return [
    ...(candidates.length === 0 ? note(words.noCandidates) : []),
    ...(sets.visible.length === 0
      ? []
      : [
          h(
            "table",
            { class: "steps-table" },
            h(
              "thead",
              {},
              h(
                "tr",
                {},
                h("th", { scope: "col" }, words.vertex),
                h("th", { scope: "col", class: "number", colSpan: 2 }, symbol("f"), ...unitOf(app, exponent)),
              ),
            ),
            h("tbody", {}, ...rows, ...rest),
          ),
        ]),
    ...(more > 0 ? note(words.more(more)) : []),
  ];
}

/** The power of ten and the unit of f. @param {App} app @param {number} exponent @returns {(Node | string)[]} */
function unitOf(app, exponent) {
  const { unit, matching } = app.store.document;
  const power = matching.distanceWeight;
  return [
    ...(exponent === 0 ? [] : [" × 10", h("sup", {}, fixed(exponent, 0))]),
    ...(power === 0 || unit === "" ? [] : [` ${unit}`, h("sup", {}, String(-power).replace("-", "\u2212"))]),
  ];
}

/** @param {() => Now | null} now @param {{goTo: (at: number) => void}} acts @returns {Group} */
function acceptedGroup(now, { goTo }) {
  const list = h("div", { class: "steps-lines" });
  const empty = h("p", { class: "steps-note" }, words.noneYet);
  /** @type {Steps | null} */
  let listed = null;
  /** @type {HTMLButtonElement[]} */
  let rows = [];
  return {
    name: "accepted",
    heading: words.groups.accepted,
    body: h("div", {}, empty, list),
    phrase() {
      const state = now();
      if (!state) return "";
      const [a = 0, b = 0] = state.steps.samples.map(({ points }) => points.length);
      return words.acceptedOf(countOf(state), a + b);
    },
    render() {
      const state = now();
      if (state?.steps !== listed) {
        listed = state?.steps ?? null;
        rows = (listed?.growth ?? []).map((line, k) =>
          h(
            "button",
            { type: "button", class: "steps-line", onclick: () => goTo(k + 1) },
            h("span", { class: "number" }, h("span", { class: "spoken" }, words.goTo), String(k + 1)),
            " ",
            h("span", { class: "number" }, lineName(line)),
            " ",
            h("span", { class: "number" }, numberNode(line.value)),
          ),
        );
        list.replaceChildren(...rows);
      }
      const count = state ? countOf(state) : 0;
      rows.forEach((row, k) => {
        row.hidden = k >= count;
        if (k === count - 1) row.setAttribute("aria-current", "step");
        else row.removeAttribute("aria-current");
      });
      empty.hidden = count > 0;
      const last = rows[count - 1];
      if (last && !list.matches(":hover, :focus-within")) list.scrollTop = last.offsetTop - list.clientHeight + last.offsetHeight;
    },
  };
}

/** Lines accepted so far whose ends are told. @param {Now} state */
function countOf({ steps, at, hidden }) {
  return Math.min(at, lengths(steps).growth) - Number(hidden && phaseAt(steps, at).phase === "growth");
}

/** @param {App} app @param {() => Now | null} now @returns {Group} */
function optimumGroup(app, now) {
  const body = h("div", {});
  /** @type {unknown} */
  let drawn;
  return {
    name: "optimum",
    heading: words.groups.optimum,
    body,
    phrase() {
      const { gap } = now()?.steps ?? {};
      return gap === null || gap === undefined ? words.gapUnknown : words.gapPhrase(gapText(gap));
    },
    render() {
      const steps = now()?.steps;
      const match = currentMatch(app);
      if (drawn === (match ?? steps)) return;
      drawn = match ?? steps;
      const totals = steps && shownTotals(steps);
      if (!steps || !totals || steps.gap === null || totals.integral === null) {
        body.replaceChildren(h("p", { class: "steps-note" }, words.unknownWhy));
        return;
      }
      const { method } = /** @type {{method: keyof typeof words.methods}} */ (app.store.document.matching);
      const own = match && method !== "greedy" ? shownTotals(match) : null;
      const worth = (/** @type {number} */ integral, /** @type {number | null} */ eta) => [
        symbol("J"),
        " ",
        numberNode(integral),
        ...(eta === null ? [] : [", ", symbol("η"), ` ${fixed(eta, 3)}`]),
      ];
      const share = 1 - steps.gap;
      const eta = totals.eta === null ? null : totals.eta / share;
      body.replaceChildren(
        fact(words.greedyJ, worth(totals.integral, totals.eta), "greedy"),
        fact(words.optimumJ, worth(totals.integral / share, eta), "optimum"),
        fact(words.gap, gapText(steps.gap), "gap"),
        ...(own && own.integral !== null ? [fact(words.ownEta(words.methods[method]), worth(own.integral, own.eta), "own")] : []),
        ...(steps.gap < -5e-5 ? [h("p", { class: "steps-note" }, words.negativeGap)] : []),
      );
    },
  };
}

/** @param {number} gap */
const gapText = (gap) => `${fixed(100 * gap, Math.abs(gap) < 0.001 ? 2 : 1)}\u00a0%`;
