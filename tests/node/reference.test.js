/** The published reference set: its tables say what the package gives. */
import assert from "node:assert/strict";
import { access, readFile } from "node:fs/promises";
import { test } from "node:test";
import { load } from "directrix";
import { reference, referencePage } from "../../scripts/lib/reference.mjs";

const page = await readFile(referencePage, "utf8");

test("docs/reference-curves.md is up to date: otherwise run npm run reference", async () => {
  const dx = await load({ module: "figure" });
  assert.deepEqual(page.split("\n"), (await reference(dx)).split("\n"));
});

test("its figures are those of the matching, and its links lead somewhere", async () => {
  const dx = await load({ module: "figure" });
  const read = async (/** @type {string} */ name) =>
    JSON.parse(await readFile(new URL(`../../www/presets/${name}.json`, import.meta.url), "utf8"));
  /** @type {{id: string, title: string, matched?: false}[]} */
  const listed = await read("index");
  const documents = await Promise.all(listed.map(({ id }) => read(id)));
  const index = listed.filter((_, k) => documents[k].curves.length === 2 && documents[k].curves[0].points[0].length === 2 && documents[k].blend?.kind !== "harmonic");
  for (const { id, title } of index) {
    const document = await read(id);
    const { lines } = dx.match({ ...document, matching: { ...document.matching, method: "greedy", oneToOne: false } }).totals;
    const row = page.split("\n").find((line) => line.startsWith(`| ${title} |`));
    assert.ok(row && lines, title);
    const cells = row.split("|").map((cell) => cell.trim());
    assert.equal(Number(cells[4]), lines.count, title);
    assert.ok(Number(cells[2]) >= lines.count, `${title}: growth is never smaller than what is left of it`);
    if (lines.eta !== null) assert.ok(Math.abs(Number(cells[8]) - lines.eta) <= 5e-5, title);
    assert.deepEqual([cells[9], cells[10]], ["0", "0"], title);
  }
  const oneToOne = page.split("## One to one")[1].split("\n").filter((line) => /^\| [^|]+\| \d/.test(line));
  assert.equal(oneToOne.length, index.filter(({ matched }) => matched !== false).length);
  for (const line of oneToOne) {
    const [, , count, , , , , verified, crossings, blocked] = line.split("|").map((cell) => cell.trim());
    assert.deepEqual([verified, crossings, blocked], [count, "0", "0"], line);
  }
  const methods = page.split("## Every method")[1].split("\n").filter((line) => /^\| (\*\*.*\*\*)? \| /.test(line));
  assert.equal(methods.length, 6 * index.length);
  for (const line of methods.filter((line) => /\| (greedy|exact, J) \| \d/.test(line))) {
    const cells = line.split("|").map((cell) => cell.trim());
    assert.deepEqual([cells[7], cells[8]], ["0", "0"], line);
    assert.match(cells[9], / %( \*)?$/, line);
  }
  for (const [, path] of page.matchAll(/(?:\]\(|src=")(\.\.\/[^)"]+)/g)) await access(new URL(path, new URL("../../docs/", import.meta.url)));
});
