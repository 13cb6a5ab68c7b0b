/** What the build writes for use without a network. */
import assert from "node:assert/strict";
import { createHash } from "node:crypto";
import { mkdtemp, mkdir, readFile, rm, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { test } from "node:test";
import { changesIn, writeOffline } from "../../scripts/lib/offline.mjs";

/** @param {import("node:test").TestContext} t */
async function folder(t) {
  const made = await mkdtemp(join(tmpdir(), "directrix-build-"));
  t.after(() => rm(made, { recursive: true }));
  await mkdir(join(made, "assets"));
  await mkdir(join(made, ".vite"));
  await writeFile(join(made, "index.html"), "<title>x</title>");
  await writeFile(join(made, "assets/a.js"), "1");
  await writeFile(join(made, ".vite/manifest.json"), "{}");
  return made;
}

test("every file of the build is on the list with its hash, the page by the name of its folder", async (t) => {
  const made = await folder(t);
  const { files } = await writeOffline(made, "");
  assert.deepEqual(Object.keys(files), ["assets/a.js", "changes.json", "icon.svg", "", "manifest.webmanifest"]);
  for (const [path, integrity] of Object.entries(files)) {
    const content = await readFile(join(made, path || "index.html"));
    assert.equal(integrity, `sha256-${createHash("sha256").update(content).digest("base64")}`);
  }
  const worker = await readFile(join(made, "sw.js"), "utf8");
  for (const path of Object.keys(files)) assert.ok(worker.includes(JSON.stringify(path)));
});

test("a build has the same name again, and another one when a byte or a name differs", async (t) => {
  const made = await folder(t);
  const { id } = await writeOffline(made, "");
  assert.equal((await writeOffline(made, "")).id, id);
  await writeFile(join(made, "assets/a.js"), "2");
  const changed = (await writeOffline(made, "")).id;
  assert.notEqual(changed, id);
  await writeFile(join(made, "assets/b.js"), "");
  assert.notEqual((await writeOffline(made, "")).id, changed);
});

test("a page too large to be kept fails the build", async (t) => {
  const made = await folder(t);
  await writeFile(join(made, "large.bin"), new Uint8Array(12_000_001));
  await assert.rejects(writeOffline(made, ""), /at most/);
});

test("changes are the entries of the changelog as plain text", () => {
  const text = "# Changelog\n\nAll.\n\n## [2]\n### Added\n- `a` and\n  [b](c.md).\n### Fixed\n- d\n\n## [1]\n- e\n";
  assert.deepEqual(changesIn(text), ["a and b.", "d", "e"]);
});

test("the icon is the mark in ink for a white ground", async (t) => {
  const made = await folder(t);
  await writeOffline(made, "");
  const icon = await readFile(join(made, "icon.svg"), "utf8");
  assert.match(icon, /^<svg [^>]*viewBox="0 0 20 20"/);
  assert.doesNotMatch(icon, /prefers-color-scheme/);
  assert.match(icon, /<style>.*\.b\{stroke:#4a45c8\}<\/style><path/);
});
