/** Links that lead out of `docs`: they work on the repository, and here as far as their aim is on the site. */

/** What of the repository is on the site, and where. @type {[RegExp, string][]} */
const places = [
  [/^\.\.\/www\/presets\/([\w-]+\.json)$/, "/app/presets/$1"],
  [/^\.\.\/README\.md$/, "./index.md"],
];

/**
 * A plugin of markdown-it: a link to a place that is not on the site leaves its words behind.
 *
 * @param {import("vitepress").MarkdownRenderer} md
 */
export function leadOutside(md) {
  md.core.ruler.push("lead-outside", ({ tokens }) => {
    for (const { children } of tokens) {
      if (!children) continue;
      let isDropped = false;
      for (const token of children) {
        if (token.type === "link_open") isDropped = !lead(token);
        if (isDropped && (token.type === "link_open" || token.type === "link_close")) token.hidden = true;
        if (isDropped && token.type === "link_open") Object.assign(token, { type: "text", content: "", tag: "" });
        if (isDropped && token.type === "link_close") Object.assign(token, { type: "text", content: "", tag: "" });
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
