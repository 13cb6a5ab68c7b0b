/** The parts of the build scripts that could be wrong without anything failing. */
import assert from "node:assert/strict";
import { mkdir, mkdtemp, readFile, rm, writeFile } from "node:fs/promises";
import { join } from "node:path";
import { after, test } from "node:test";
import { countTests } from "../../scripts/lib/counts.mjs";
import { root, work } from "../../scripts/lib/paths.mjs";
import { CommandError } from "../../scripts/lib/run.mjs";
import { PASSED_LATER, secondChance } from "../../scripts/lib/second-chance.mjs";
import { serve } from "../../scripts/lib/serve.mjs";
import { inputs, isFresh, mark, unmark } from "../../scripts/lib/stamp.mjs";
import { runSteps } from "../../scripts/lib/steps.mjs";

await mkdir(work, { recursive: true });
const folder = await mkdtemp(join(work, "test-"));
after(() => rm(folder, { recursive: true }));

test("the closing lines of every runner are counted", () => {
  const output = [
    "     Summary [   0.012s] 4 tests run: 2 passed (1 slow), 1 failed, 1 timed out, 0 skipped",
    "test result: FAILED. 3 passed; 1 failed; 0 ignored; 0 measured; 0 filtered out; finished in 0.00s",
    "ℹ pass 5",
    "ℹ fail 0",
    "# cancelled 1",
    "test name ... ok",
  ];
  assert.deepEqual(countTests(output), { passed: 10, failed: 4 });
  assert.equal(countTests(["Finished"]), null);
});

test("steps wait for what they need and for their lane", async () => {
  /** @type {string[]} */
  const order = [];
  /** @param {string} name */
  const run = (name) => async () => {
    order.push(`${name} starts`);
    await new Promise((done) => setTimeout(done, 20));
    order.push(`${name} ends`);
  };
  await runSteps([
    { name: "b", needs: ["a", "elsewhere"], run: run("b") },
    { name: "a", lane: "one", run: run("a") },
    { name: "c", lane: "one", run: run("c") },
  ]);
  assert.ok(order.indexOf("b starts") > order.indexOf("a ends"));
  assert.ok(order.indexOf("c starts") > order.indexOf("a ends"));
});

/**
 * What is logged, and whether it fails, when these files fail in the first run and those in the second.
 * @param {string[]} first
 * @param {string[]} second
 */
async function twoRuns(first, second) {
  /** @type {string[]} */
  const lines = [];
  /** @type {string[]} */
  const ran = [];
  const runner = async (/** @type {string} */ file, /** @type {(line: string) => void} */ log) => {
    const isBroken = (ran.includes(file) ? second : first).includes(file);
    ran.push(file);
    log(`ℹ pass ${isBroken ? 2 : 3}`);
    log(`ℹ fail ${isBroken ? 1 : 0}`);
    // A test within another, in a file that is shared: the reporter names that one.
    if (isBroken) ["✖ failing tests:", "", "test at shared.js:7:1", "✖ a test", "  wrong", "  more"].forEach(log);
    if (isBroken) throw new CommandError("ended with code 1");
  };
  const error = await secondChance((line) => lines.push(line), 2, runner, ["a.test.js", "b.test.js", "c.test.js", "d.test.js"]).catch((each) => each);
  return { again: ran.slice(4), error: error?.message, counts: countTests(lines), later: lines.filter((line) => line.startsWith(PASSED_LATER)) };
}

test("test files that fail are run once more, alone, and what passes only then is said", async () => {
  assert.deepEqual(await twoRuns([], []), { again: [], error: undefined, counts: { passed: 12, failed: 0 }, later: [] });
  const later = await twoRuns(["b.test.js"], []);
  assert.deepEqual(later, {
    ...{ again: ["b.test.js"], error: undefined, counts: { passed: 12, failed: 0 } },
    later: [`${PASSED_LATER}b.test.js  ✖ a test  wrong`],
  });
  const twice = await twoRuns(["b.test.js", "d.test.js"], ["d.test.js"]);
  assert.deepEqual([twice.again, twice.error, twice.counts], [["b.test.js", "d.test.js"], "tests failed in d.test.js", { passed: 11, failed: 1 }]);
  const many = await twoRuns(["a.test.js", "b.test.js", "c.test.js"], []);
  assert.deepEqual([many.again, many.error, many.counts], [[], "tests failed in a.test.js, b.test.js, c.test.js", { passed: 9, failed: 3 }]);
});

test("a failed step stops only the steps that need it", async () => {
  const results = await runSteps([
    {
      name: "broken",
      async run() {
        throw new Error("no");
      },
    },
    { name: "next", needs: ["broken"], async run() {} },
    { name: "last", needs: ["next"], async run() {} },
    { name: "other", async run() {} },
  ]);
  const states = Object.fromEntries(results.map(({ name, state }) => [name, state]));
  assert.deepEqual(states, { broken: "failed", next: "not run", last: "not run", other: "done" });
});

test("steps in a circle are refused", async () => {
  const steps = [
    { name: "a", needs: ["b"], async run() {} },
    { name: "b", needs: ["a"], async run() {} },
  ];
  await assert.rejects(runSteps(steps), /wait for each other: a, b/);
});

test("a stamp is stale after a change of input, output or option, and after an edit during the work", async () => {
  const [from, to] = [join(folder, "from"), join(folder, "to")];
  const made = { from: [from, join(folder, "missing")], to: [to], with: [1] };
  /** @param {string} path @param {string} text */
  const write = (path, text) => writeFile(path, text);
  await mkdir(from);
  await write(join(from, "a"), "1");
  await write(to, "1");
  const name = folder.slice(work.length + 1);

  assert.equal(await isFresh(name, made), false);
  await mark(name, made, await inputs(made));
  assert.equal(await isFresh(name, made), true);
  assert.equal(await isFresh(name, { ...made, with: [2] }), false);
  await write(join(from, "a"), "2");
  assert.equal(await isFresh(name, made), false);
  await write(join(from, "a"), "1");
  assert.equal(await isFresh(name, made), true);
  await write(join(from, "b"), "");
  assert.equal(await isFresh(name, made), false);

  const before = await inputs(made);
  await write(join(from, "b"), "edited");
  await mark(name, made, before);
  assert.equal(await isFresh(name, made), false);
  await mark(name, made, await inputs(made));
  await write(to, "2");
  assert.equal(await isFresh(name, made), false);
  await unmark(name);
});

test("the server gives the files of its folder with their types, and nothing else", async () => {
  const site = join(folder, "site");
  await mkdir(site);
  await writeFile(join(site, "index.html"), "<!doctype html>");
  await writeFile(join(site, "module.wasm"), "");
  await writeFile(join(folder, "secret.txt"), "");
  const served = await serve(site, { base: "/a/b/", headers: { "x-test": "1" } });
  /** @param {string} path */
  const get = async (path) => {
    const response = await fetch(new URL(path, served.url));
    await response.arrayBuffer();
    return response;
  };
  try {
    const index = await get("");
    assert.equal(index.headers.get("content-type"), "text/html; charset=utf-8");
    assert.equal(index.headers.get("x-test"), "1");
    assert.equal((await get("module.wasm?v=1")).headers.get("content-type"), "application/wasm");
    for (const path of ["missing.js", "/", "/a/", "%2e%2e%2fsecret.txt", "..%2fsecret.txt", "%00", "%"]) {
      assert.equal((await get(path)).status, 404, path);
    }
    await assert.rejects(serve(site, { port: served.port }), /EADDRINUSE/);
  } finally {
    await served.close();
  }
});

test("the lock file of the packages names no place to download from", async () => {
  const lock = await readFile(join(root, "package-lock.json"), "utf8");
  assert.doesNotMatch(lock, /"resolved"/);
});
