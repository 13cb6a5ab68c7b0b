/** The documentation has the colours of the application, and lists its pages. */
import assert from "node:assert/strict";
import { readFile, readdir } from "node:fs/promises";
import { join } from "node:path";
import { test } from "node:test";
import { load } from "directrix";
import { code } from "../../docs/.vitepress/code.mjs";
import { sidebar, titleOf } from "../../docs/.vitepress/sidebar.mjs";
import { root } from "../../scripts/lib/paths.mjs";

/**
 * The colours that a rule of a style sheet sets.
 * @param {string} sheet
 * @param {string} selector
 */
function colors(sheet, selector) {
  const rule = sheet.split(`\n${selector} {\n`)[1]?.split("\n}")[0] ?? "";
  return Object.fromEntries([...rule.matchAll(/^ {2}(--[\w-]+): (#\w+);/gm)].map(([, name, value]) => [name, value]));
}

test("colours are those of the application, light and dark", async () => {
  const read = (/** @type {string} */ path) => readFile(join(root, path), "utf8");
  const [own, application] = await Promise.all([read("docs/.vitepress/theme/style.css"), read("www/styles/tokens.css")]);
  for (const [ours, theirs, type] of /** @type {const} */ ([
    [":root", ":root", "light"],
    [":root.dark", ':root[data-theme="dark"]', "dark"],
  ])) {
    const [found, expected] = [colors(own, ours), colors(application, theirs)];
    assert.ok(Object.keys(found).length > 15, ours);
    for (const [name, value] of Object.entries(found)) assert.equal(value, expected[name], `${name} of ${ours}`);
    const { colors: ground, settings } = /** @type {any} */ (code[type]);
    assert.equal(ground["editor.background"], found["--surface"]);
    const inks = settings.flatMap((/** @type {any} */ each) => each.settings.foreground ?? []);
    assert.deepEqual(inks, [found["--text"], found["--text-3"], found["--text-2"]]);
  }
});

test("every page stands in the list once, by its title", async () => {
  const items = sidebar().flatMap(({ items: pages = [] }) => pages);
  const links = items.map(({ link }) => link);
  assert.equal(new Set(links).size, links.length);
  for (const page of ["/", "/embedding", "/api", "/format", "/page", "/curves", "/export", "/architecture"]) assert.ok(links.includes(page), page);
  assert.equal(items.find(({ link }) => link === "/api")?.text, titleOf("api"));
  assert.equal(titleOf("api"), "JavaScript API");
});

test("every document on the pages is one", async () => {
  const dx = await load();
  /** @type {{[kind: string]: (document: any) => boolean}} */
  const isSound = {
    curves: (document) => dx.match(document).ok,
    part: (document) => dx.part(document).diagnostics.length === 0,
    laplace: (document) => dx.boundary(document).ready,
  };
  const folder = join(root, "docs");
  let count = 0;
  for (const name of (await readdir(folder)).filter((each) => each.endsWith(".md"))) {
    const text = await readFile(join(folder, name), "utf8");
    for (const [, json] of text.matchAll(/^```json\n([^]*?)^```$/gm)) {
      // What is cut short by dots, or is only a part of a document, cannot be read.
      if (json.includes("…") || !json.includes('"directrix"')) continue;
      const document = JSON.parse(json);
      assert.ok(isSound[document.kind](document), `${name}: ${document.title}`);
      count += 1;
    }
  }
  assert.ok(count >= 4, `${count} documents`);
});
