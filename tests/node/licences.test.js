/** The licences that About shows are those of what is shipped, no more and no less. */
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { join } from "node:path";
import { test } from "node:test";
import { crates, npmPackages, withoutRepeats } from "../../scripts/lib/licences.mjs";
import { root } from "../../scripts/lib/paths.mjs";

test("the crates are those that the modules are compiled from, without macros and what only tests use", async () => {
  const found = await crates();
  const names = found.map(({ name }) => name);
  const manifest = await readFile(join(root, "Cargo.toml"), "utf8");
  const section = (/** @type {string} */ head) => manifest.split(`\n[${head}]\n`)[1]?.split("\n[")[0] ?? "";
  const own = (/** @type {string} */ text) => [...text.matchAll(/^([\w-]+) *=/gm)].map(([, name]) => name);
  const direct = own(section("dependencies"));
  assert.ok(direct.length > 3);
  for (const name of direct) assert.ok(names.includes(name), name);
  for (const name of own(section("dev-dependencies"))) assert.ok(direct.includes(name) || !names.includes(name), name);
  for (const name of ["serde_derive", "wasm-bindgen-macro", "syn", "directrix", "xtask"]) assert.ok(!names.includes(name), name);
  const lock = await readFile(join(root, "Cargo.lock"), "utf8");
  for (const { name, version } of found) assert.ok(lock.includes(`name = "${name}"\nversion = "${version}"`), name);
});

test("every part states its licence and carries a text of it", async () => {
  for (const { name, licence, text } of await crates()) {
    assert.match(licence, /MIT|Apache|BSD|Zlib|ISC|Unicode|0BSD/, name);
    assert.ok(text.length > 500, `${name} carries ${text.length} characters`);
  }
});

test("a text that several parts have is written once", async () => {
  const parts = await crates();
  const written = withoutRepeats(parts);
  assert.deepEqual(written.map((part) => ("text" in part ? part.text : /** @type {{text: string}} */ (written[part.textOf]).text)), parts.map(({ text }) => text));
  assert.ok(written.some((part) => !("text" in part)));
});

test("packages are found from the files of a bundle, each once", async () => {
  const modules = join(root, "node_modules");
  const found = await npmPackages([
    join(modules, "katex/dist/fonts/KaTeX_Math-Italic.woff2"),
    join(modules, "katex/dist/katex.mjs"),
    join(modules, "@fontsource-variable/inter/files/inter-latin-wght-normal.woff2"),
    join(root, "www/src/main.js"),
    join(root, "js/pkg/fflate.js"),
  ]);
  assert.deepEqual(found.map(({ name }) => name).sort(), ["@fontsource-variable/inter", "fflate", "katex"]);
  assert.match(found.find(({ name }) => name === "katex")?.licence ?? "", /MIT/);
  const { text = "" } = found.find(({ name }) => name === "fflate") ?? {};
  assert.match(text, /MIT License[^]*Arjun Barrett/);
  assert.equal((await readFile(join(root, "js/pkg/fflate.LICENSE"), "utf8")).trim(), text, "the copy carries it as well");
});
