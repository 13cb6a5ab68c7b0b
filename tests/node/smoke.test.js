/** The package as a program in Node uses it: by its name, without a browser. */
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { homedir } from "node:os";
import { test } from "node:test";
import { DirectrixError, load } from "directrix";
import { root } from "../../scripts/lib/paths.mjs";

const corners = 8;
const samples = 12;

/**
 * A closed curve round the origin, nearly a circle.
 *
 * @param {number} radius of the circle that its control points lie on
 */
function ring(radius) {
  const angles = Array.from({ length: corners }, (_, index) => (2 * Math.PI * index) / corners);
  return { degree: 3, form: "periodic", points: angles.map((angle) => [radius * Math.cos(angle), radius * Math.sin(angle)]) };
}

/** A document of two rings, one inside the other, with nothing in it that has a default. */
function rings() {
  return {
    directrix: 1,
    kind: "curves",
    curves: [ring(1), ring(2)],
    sampling: { scheme: "arc-length", counts: [samples, samples] },
    matching: { method: "greedy", oneToOne: false },
  };
}

for (const module of /** @type {const} */ (["figure", "full"])) {
  test(`the module ${module} matches two rings`, async () => {
    const dx = await load({ module });
    const match = dx.match(/** @type {any} */ (rings()));
    assert.deepEqual(match.diagnostics, []);
    assert.equal(match.ok, true);
    assert.deepEqual(match.samples.map(({ points }) => points.length), [samples, samples]);
    assert.ok(match.lines.length >= samples, `${match.lines.length} lines for ${samples} vertices`);
    assert.equal(match.totals.lines?.crossings, 0);
    assert.equal(match.totals.lines?.blocked, 0);
  });
}

test("a curve with too few points is refused with its path", async () => {
  const dx = await load({ module: "figure" });
  const document = rings();
  document.curves[1].points.length = 3;
  assert.throws(
    () => dx.match(/** @type {any} */ (document)),
    (error) => error instanceof DirectrixError && error.code === "points" && /^curves\b.*1/.test(error.path),
  );
});

for (const file of ["directrix_bg.wasm", "directrix_full_bg.wasm"]) {
  test(`${file} holds no path of the machine that built it`, async () => {
    const text = await readFile(new URL(import.meta.resolve(`directrix/${file}`)), "latin1");
    for (const path of [homedir(), root]) assert.ok(!text.includes(path), `it holds ${path}`);
  });
}
