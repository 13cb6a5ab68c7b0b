/**
 * What pages that are written for the repository need on the site.
 *
 * @typedef {import("vitepress").MarkdownRenderer} Markdown
 */
import { titleOf } from "./sidebar.mjs";

/** What of the repository is on the site, and where. @type {[RegExp, string][]} */
const places = [
  [/^\.\.\/www\/presets\/([\w-]+\.json)$/, "/app/presets/$1"],
  [/^\.\.\/README\.md$/, "./index.md"],
];

/**
 * Links that lead out of `docs`: one to a place that is not on the site leaves its words behind.
 *
 * @param {Markdown} md
 */
export function leadOutside(md) {
  md.core.ruler.push("lead-outside", ({ tokens }) => {
    for (const { children } of tokens) {
      let isDropped = false;
      for (const token of children ?? []) {
        if (token.type === "link_open") isDropped = !lead(token);
        if (isDropped && ["link_open", "link_close"].includes(token.type)) Object.assign(token, { type: "text", tag: "", content: "" });
      }
    }
  });
}

/**
 * Sets the address of a link on the site.
 *
 * @param {{attrGet(name: string): string | null, attrSet(name: string, value: string): void}} link
 * @returns {boolean} whether there is one
 */
function lead(link) {
  const href = link.attrGet("href") ?? "";
  if (!href.startsWith("../")) return true;
  const place = places.find(([pattern]) => pattern.test(href));
  if (place) link.attrSet("href", href.replace(...place));
  return place !== undefined;
}

/**
 * Tables need a head to be tables in Markdown: a head without words is none.
 *
 * @param {Markdown} md
 */
export function emptyHeads(md) {
  md.core.ruler.push("empty-heads", ({ tokens }) => {
    tokens.forEach((token, index) => {
      if (token.type === "th_open" && tokens[index + 1].content === "") token.tag = tokens[index + 2].tag = "td";
    });
  });
}

/**
 * Braces in code are code, and no templates of Vue.
 *
 * @param {Markdown} md
 */
export function plainCode(md) {
  md.core.ruler.push("plain-code", ({ tokens }) => {
    for (const token of tokens.flatMap(({ children }) => children ?? [])) if (token.type === "code_inline") token.attrSet("v-pre", "");
  });
}

/**
 * A link that is called by the file of a page is called by its title.
 *
 * @param {Markdown} md
 */
export function titles(md) {
  md.core.ruler.push("titles", ({ tokens }) => {
    for (const { children } of tokens) {
      for (const [index, token] of (children ?? []).entries()) {
        const words = token.type === "link_open" ? children?.[index + 1] : undefined;
        const file = /^(?:docs\/)?([\w-]+)\.md$/.exec(words?.content ?? "");
        if (words && file && token.attrGet("href")?.startsWith(`${file[1]}.md`)) words.content = titleOf(file[1]);
      }
    }
  });
}
