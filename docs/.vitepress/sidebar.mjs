/** The list of all pages, in the order of reading. */
import { readFileSync, readdirSync } from "node:fs";

const docs = new URL("../", import.meta.url);

/** Pages by the topic they belong to, as far as they are there; one that is not listed stands at the end of the last topic. */
const topics = [
  { text: "Guide", pages: ["index", "what-it-is", "first-steps", "five-pictures"] },
  { text: "The application", pages: ["page", "curves", "solid", "parts", "hyperpatches", "laboratory", "lessons", "export"] },
  { text: "For your own pages and scripts", pages: ["embedding", "api", "format"] },
  { text: "Background", pages: ["architecture", "decisions", "reference-curves", "benchmarks"] },
];

/** The first heading of a page. @param {string} name */
export function titleOf(name) {
  const heading = /^# (.+)$/m.exec(readFileSync(new URL(`${name}.md`, docs), "utf8"));
  if (!heading) throw new Error(`docs/${name}.md has no heading of the first level`);
  return heading[1].trim();
}

/** @returns {import("vitepress").DefaultTheme.SidebarItem[]} */
export function sidebar() {
  const present = readdirSync(docs).flatMap((file) => (file.endsWith(".md") ? [file.slice(0, -3)] : []));
  const listed = new Set(topics.flatMap(({ pages }) => pages));
  const others = present.filter((name) => !listed.has(name)).sort();
  return topics.map(({ text, pages }, index) => {
    const names = pages.filter((name) => present.includes(name));
    if (index === topics.length - 1) names.push(...others);
    return { text, items: names.map((name) => ({ text: titleOf(name), link: name === "index" ? "/" : `/${name}` })) };
  });
}
