/**
 * The shadow tree of a figure: picture, result, controls, fallback.
 *
 * @import { LayerName } from "../directrix.js"
 * @import { FigureResult } from "../element.js"
 *
 * @typedef {object} Look
 * @property {string} state `waiting`, `loading`, `shown` or `failed`
 * @property {string} controls
 * @property {string} title
 * @property {FigureResult | null} result
 * @property {string | null} poster
 * @property {boolean} isRevealed
 * @property {boolean} hasLink
 * @property {LayerName[]} layers
 * @property {boolean} hasLayers
 * @property {{ step: number, steps: number } | null} growth the step that is shown of the greedy growth
 */
import { attribute, h, icon, write } from "./dom.js";
import { fixed, words } from "./words.js";

/**
 * @param {object} actions
 * @param {() => void} actions.reveal
 * @param {(name: LayerName, isOn: boolean) => void} actions.layer
 */
export function createFrame(actions) {
  const canvas = h("canvas", { role: "img" });
  const poster = h("img", { class: "poster", alt: "", hidden: "" });
  const paper = h("img", { class: "paper", alt: "" });
  const show = h("button", { type: "button" }, words.show);
  const revealed = h("div", { class: "reveal", hidden: "" }, show);
  const working = h("div", { class: "working", "aria-hidden": "true" });
  const picture = h("div", { class: "picture", part: "picture" }, poster, paper, canvas);
  const result = h("div", { class: "result", part: "result", "aria-hidden": "true" });
  const layers = createLayers(actions.layer);
  const head = h("div", { class: "head" }, layers.element, result);
  const open = h("a", { class: "open", part: "link", target: "_blank", rel: "noopener", title: words.opens }, words.open);
  const rule = h("span", { class: "rule", "aria-hidden": "true" });
  const bar = h("div", { class: "bar", part: "bar" }, rule, open);
  const problem = h("p", { class: "problem", role: "alert", hidden: "" });
  const speech = h("p", { class: "spoken", "aria-live": "polite" });
  const fallback = h("div", { class: "fallback" }, h("slot"));
  const ground = h("span", { class: "ground" });
  const body = h("div", { class: "body", part: "body" }, head, picture, bar, working, revealed, problem, speech);
  const inner = h("div", { class: "frame", role: "group" }, body);
  const element = h("div", { class: "whole" }, inner, fallback, ground);
  show.addEventListener("click", actions.reveal);
  let drawn = "";

  return {
    element,
    inner,
    ground,
    canvas,
    picture,
    poster,
    paper,
    bar,
    open,
    revealed,
    working,
    problem,

    /** @param {string} text */
    say(text) {
      speech.textContent = text;
    },

    /** @param {Look} look */
    render(look) {
      const { state, controls, title } = look;
      const isShown = state === "shown";
      const text = look.growth ? words.growth.step(look.growth.step, look.growth.steps) : (look.result?.text ?? "");
      attribute(inner, "data-state", state);
      attribute(inner, "data-controls", controls);
      attribute(inner, "aria-label", title);
      attribute(canvas, "aria-label", text ? `${title}. ${text}` : title);
      attribute(inner, "aria-busy", state === "loading" ? "true" : null);
      // A picture alone needs no group round it.
      attribute(inner, "role", controls === "none" && isShown ? "presentation" : "group");
      if (controls === "none" && isShown) attribute(inner, "aria-label", null);
      fallback.hidden = isShown;
      revealed.hidden = look.isRevealed || isShown;
      rule.hidden = open.hidden = !look.hasLink;
      layers.render(look);
      if (look.poster !== poster.getAttribute("src")) {
        attribute(poster, "src", look.poster);
        poster.hidden = look.poster === null;
      }
      const key = JSON.stringify([look.result, look.growth]);
      if (key === drawn) return;
      drawn = key;
      result.replaceChildren(...(look.growth ? [text] : look.result ? certificate(look.result) : []));
    },
  };
}

/** @param {FigureResult} result */
function certificate({ ok, lines, verified, eta, crossings, text, brief }) {
  if (lines === 0) return [...(verified ? [icon("check")] : []), h("span", { class: ok ? "fact" : "failed" }, brief ?? text)];
  const fact = (/** @type {string} */ name, /** @type {boolean} */ failed, /** @type {(Node | string)[]} */ ...content) =>
    h("span", { class: `${name}${failed ? " failed" : ""}` }, ...content);
  const says = words.result;
  return [
    ...(verified ? [icon("check")] : []),
    fact("lines", false, h("b", {}, String(lines)), ` ${says.lines(lines)}`),
    ...(eta === null ? [] : [fact("eta", false, h("i", {}, "η"), " ", h("b", {}, fixed(eta, 3)))]),
    fact("crossings", crossings > 0, `${says.crossings} `, h("b", {}, String(crossings))),
    ...(verified || crossings > 0 ? [] : [fact("rest", true, words.result.problems)]),
  ];
}

/** The switches of the layers. @param {(name: LayerName, isOn: boolean) => void} change */
function createLayers(change) {
  const boxes = Object.entries(words.layers.names).map(([name, text]) => {
    const input = h("input", { type: "checkbox" });
    input.addEventListener("change", () => change(/** @type {LayerName} */ (name), input.checked));
    return { name, input, label: h("label", {}, input, text) };
  });
  const summary = h("summary", {});
  write(summary, words.layers.button);
  const element = h("details", { class: "layers", hidden: "" }, summary, h("div", {}, ...boxes.map(({ label }) => label)));
  element.addEventListener("keydown", (event) => {
    if (event.key !== "Escape" || !element.open) return;
    element.open = false;
    summary.focus();
  });
  element.addEventListener("focusout", ({ relatedTarget }) => {
    if (relatedTarget instanceof Node && !element.contains(relatedTarget)) element.open = false;
  });
  return {
    element,
    /** @param {Look} look */
    render({ controls, layers, hasLayers, growth }) {
      element.hidden = controls !== "full" || growth !== null || !hasLayers;
      for (const { name, input } of boxes) input.checked = layers.includes(/** @type {LayerName} */ (name));
    },
  };
}
