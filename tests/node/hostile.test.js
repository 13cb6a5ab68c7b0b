import assert from "node:assert/strict";
import { test } from "node:test";
import { DirectrixError, load } from "../../js/node.js";
import { base, cases, garbled, mutated, numbers } from "./hostile.js";

const SEED = 20_261_123;
const RUNS = 400;
const SIZE = { width: 60, height: 40 };

const dx = await load({ module: "full" });

/** The base document still gives what it gave: the module is as good as new. */
const good = dx.match(base);
const picture = dx.paint(base, SIZE);
function isWell() {
  assert.deepEqual(dx.match(base), good);
  assert.deepEqual(dx.paint(base, SIZE), picture);
}

/**
 * The error of a call; anything but a `DirectrixError` with words and without a trap fails.
 *
 * @param {() => unknown} call
 */
function refusal(call) {
  try {
    call();
    return null;
  } catch (error) {
    if (!(error instanceof DirectrixError)) throw error;
    assert.notEqual(error.code, "trap", error.message);
    assert.ok(error.message.length > 0 && error.message.length < 1000, error.message);
    return error;
  }
}

for (const { name, text, code, path, says } of cases) {
  test(`bad input is refused with its reason: ${name}`, () => {
    const start = performance.now();
    const error = refusal(() => dx.match(text));
    assert.ok(error, "it was not refused");
    if (code) assert.equal(error.code, code, error.message);
    if (path !== undefined) assert.equal(error.path, path, error.message);
    for (const words of says) assert.ok(error.message.includes(words), `"${error.message}" does not say "${words}"`);
    assert.ok(performance.now() - start < 5000, "it took too long");
    isWell();
  });
}

/**
 * Asks everything about a text; returns whether it was answered.
 *
 * @param {string} text
 * @param {(below: number) => number} number
 */
function ask(text, number) {
  const point = /** @type {[number, number]} */ ([number(60) - 30, number(60) - 30]);
  const calls = [
    () => dx.match(text),
    () => dx.paint(text, SIZE),
    () => dx.svg(text, SIZE),
    () => dx.stages(text),
    () => dx.cells(text),
    () => dx.probe(text, point),
    () => dx.fit(text, SIZE),
    () => dx.defaults(text),
    () => dx.insertPoint(text, number(3), number(100) / 100),
  ];
  return calls.map(refusal)[0] === null;
}

const full = {
  ...base,
  sampling: { scheme: "adaptive", tolerance: 0.2, maxTurn: 20, minCount: 5 },
  matching: { method: "greedy", normalWeight: 1, distanceWeight: 2, oneToOne: true },
  blend: { kind: "ruled", stages: 3 },
  view: { s: 0.5, center: [0, 0], span: 90, layers: ["grid", "normals", "value", "unitCells", "controlPoints"] },
};

test(`mutated documents are refused or answered (seed ${SEED})`, () => {
  const number = numbers(SEED);
  let answered = 0;
  for (let run = 0; run < RUNS; run++) answered += Number(ask(JSON.stringify(mutated(full, number)), number));
  assert.ok(answered > RUNS / 50 && answered < RUNS, `${answered} of ${RUNS} answered`);
  isWell();
});

test(`garbled texts are refused or answered (seed ${SEED})`, () => {
  const number = numbers(SEED + 1);
  let answered = 0;
  for (let run = 0; run < RUNS; run++) answered += Number(ask(garbled(JSON.stringify(full), number), number));
  assert.ok(answered > 0 && answered < RUNS, `${answered} of ${RUNS} answered`);
  isWell();
});

test(`random bytes are refused (seed ${SEED})`, () => {
  const number = numbers(SEED + 2);
  for (let run = 0; run < RUNS; run++) {
    const bytes = Uint8Array.from({ length: number(300) }, () => number(256));
    assert.ok(refusal(() => dx.match(new TextDecoder().decode(bytes))));
  }
  isWell();
});

test(`mutated options are refused or painted (seed ${SEED})`, () => {
  const number = numbers(SEED + 3);
  const options = { ...SIZE, pixelRatio: 1.5, theme: "dark", s: 0.4, line: 3, view: { center: [1, 2], scale: 2 }, layers: ["grid", "material"] };
  let painted = 0;
  for (let run = 0; run < RUNS; run++) {
    const changed = /** @type {any} */ (mutated(options, number));
    painted += Number(refusal(() => dx.paint(base, changed)) === null);
    refusal(() => dx.svg(base, changed));
  }
  assert.ok(painted > 20, `${painted} painted`);
  isWell();
});
