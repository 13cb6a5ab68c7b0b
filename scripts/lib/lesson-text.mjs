/**
 * The prose of a lesson as HTML. Mathematics is set by KaTeX here, at build, with MathML beside it for who listens; nothing of KaTeX but
 * its style and fonts goes to the page.
 *
 * @typedef {(message: string) => never} Refuse
 *
 * @typedef {object} Fact A number of the text that the kernel can confirm.
 * @property {string} name
 * @property {number[]} arguments
 * @property {string} shown as it stands in the text
 *
 * @typedef {object} Prose
 * @property {string} html
 * @property {Fact[]} facts
 * @property {string[]} terms what the words of the text name in the figure
 */
import katex from "katex";
import { FACTS } from "./lesson-facts.mjs";

/** What a term may name in a figure of each view. */
const TERMS = {
  figure: ["first", "second", "lines", "line", "samples", "band", "stage", "stages", "normals", "faults"],
  body: ["coefficients", "coefficient", "corners", "inner", "net", "edges", "point", "through", "witness", "moving"],
  part: ["features", "feature", "place", "section"],
  grid: ["features", "pass", "wide"],
  laplace: ["boundary", "middles", "panel", "place", "circle"],
  steps: ["first", "second", "accepted", "visible", "valid", "candidates", "winner", "redundant", "bare", "moved"],
};

/** Pieces of prose that are not plain words, each between marks of its own; a formula keeps the signs that follow it. */
const PIECES = /\$([^$]+)\$([,.;:)?]*)|`([^`]+)`|\[([^\]]+)\]\(([^)\s]+)\)|\{([a-z-]+)((?: -?[\d.]+)*): ([^}]+)\}|\*\*([^*]+)\*\*|\*([^*]+)\*/g;

/** @param {string} text */
export const escaped = (text) => text.replace(/[&<>"]/g, (sign) => `&#${sign.charCodeAt(0)};`);

/**
 * @param {string} tex trusted: the attribute style is put by the name `data-style`, which the page turns back
 * @param {boolean} displayMode on a line of its own
 * @param {Refuse} refuse
 */
export function mathematics(tex, displayMode, refuse) {
  try {
    const html = katex.renderToString(tex, { displayMode, throwOnError: true, strict: "error", output: "htmlAndMathml" });
    return html.replaceAll(' style="', ' data-style="');
  } catch (error) {
    return refuse(`the formula ${tex.trim()} cannot be set: ${error instanceof Error ? error.message : error}`);
  }
}

/**
 * @param {string} text one paragraph
 * @param {keyof typeof TERMS} view of the figure that the terms name parts of
 * @param {Refuse} refuse
 * @returns {Prose}
 */
export function prose(text, view, refuse) {
  /** @type {Fact[]} */
  const facts = [];
  /** @type {string[]} */
  const terms = [];
  /** @param {string} part @returns {string} */
  const inline = (part) => {
    let html = "";
    let end = 0;
    for (const found of part.matchAll(PIECES)) {
      html += words(part.slice(end, found.index), refuse);
      end = found.index + found[0].length;
      const [, tex, punctuation = "", code, link, target = "", fact, given = "", shown = "", strong, emphasis] = found;
      if (tex !== undefined) html += `<span class="lesson-glued">${mathematics(tex, false, refuse)}${punctuation}</span>`;
      else if (code !== undefined) html += `<code>${escaped(code)}</code>`;
      else if (link !== undefined) html += linked(inline(link), target, view, terms, refuse);
      else if (fact !== undefined) {
        const numbers = given.trim().split(" ").filter(Boolean).map(Number);
        const count = Object.hasOwn(FACTS, fact) ? FACTS[fact]?.arguments : refuse(`there is no fact "${fact}"; there are: ${Object.keys(FACTS).join(", ")}`);
        if (numbers.length !== count) refuse(`the fact ${fact} has ${count} numbers behind its name, not ${numbers.length}`);
        facts.push({ name: fact, arguments: numbers, shown });
        html += `<span class="number">${escaped(shown.replace(" ", "\u00a0"))}</span>`;
      } else if (strong !== undefined) html += `<strong>${inline(strong)}</strong>`;
      else html += `<em>${inline(emphasis ?? "")}</em>`;
    }
    return html + words(part.slice(end), refuse);
  };
  return { html: inline(text), facts, terms };
}

/** Plain words, in which no mark of a piece may be left over. @param {string} text @param {Refuse} refuse */
function words(text, refuse) {
  const stray = /[$`{}*[\]]/.exec(text);
  if (stray) refuse(`the sign ${stray[0]} in "${text.trim().slice(0, 60)}" opens or ends nothing; see docs/lessons.md`);
  return escaped(text);
}

/**
 * @param {string} html
 * @param {string} target
 * @param {keyof typeof TERMS} view
 * @param {string[]} terms
 * @param {Refuse} refuse
 */
function linked(html, target, view, terms, refuse) {
  if (/^https:\/\//.test(target)) return `<a href="${escaped(target)}" rel="noreferrer">${html}</a>`;
  const lesson = /^lesson:([a-z0-9-]+)(?:\/([1-9]\d*))?$/.exec(target);
  if (lesson) return `<a href="#lesson=${lesson[1]}&#38;step=${lesson[2] ?? 1}">${html}</a>`;
  const name = target.split(":")[0] ?? "";
  if (!TERMS[view].includes(name) || (name === "line") !== /^line:\d+$/.test(target)) {
    refuse(`the term ${target} names nothing in a figure of the view ${view}; there are: ${TERMS[view].join(", ")} (line:NUMBER)`);
  }
  terms.push(target);
  return `<button type="button" class="term" data-term="${target}">${html}</button>`;
}
