/** Bodies by lists of operations: what each makes, what is taken over, surfaces that follow, merging, hostile lists. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { DirectrixError, load, renewSurface } from "directrix";
import { body as remoteBody, merge as remoteMerge } from "../../js/remote-body.js";
import { inTurns } from "../../js/turns.js";
import { presets } from "../../scripts/hyperpatch-presets.mjs";
import { refused } from "./refused.js";

/**
 * @import { BodySurface, HyperpatchDocument, HyperpatchOperation } from "directrix"
 */

const dx = await load();
const documents = /** @type {Record<string, any>} */ (presets());
/** @type {HyperpatchDocument} */
const block = documents.block;
const materials = block.materials?.length ?? 2;
/** @param {number} n */
const pure = (n) => Array.from({ length: materials }, (_, k) => (k === n ? 1 : 0));

/** The document with further operations. @param {HyperpatchDocument} document @param {HyperpatchOperation[]} operations */
const after = (document, ...operations) => ({ ...document, operations: [...document.operations, ...operations] });

/** @param {number} cell @param {number} by @returns {HyperpatchOperation} */
const moved = (cell, by) => ({ op: "move", cell, at: [3, 3, 3], by: [by, 0, by / 2] });

test("operations say what came of them, and cells are numbered by them", () => {
  const document = after(
    block,
    moved(0, 0.05),
    { op: "extrude", faces: [{ cell: 0, face: "u0" }, { cell: 1, face: "u0" }], by: 0.5 },
    { op: "delete", cells: [7, 99] },
    { op: "copy", cells: [20001], by: [0, 0, 5], id: 40 },
    { op: "mirror", cells: [0], normal: [-2, 0, 0], offset: 8 },
  );
  const body = dx.hyperpatch(document);
  assert.deepEqual(body.operations.map(({ id, applied, made }) => [id, applied, made]), [
    [0, true, [0, 1, 2, 3, 4, 5, 6, 7]],
    [1, true, []],
    [2, true, [20000, 20001]],
    [3, false, []],
    [40, true, [400000]],
    [41, true, [410000]],
  ]);
  assert.match(body.operations[3].reason ?? "", /no cell 99/);
  assert.deepEqual([body.operations[0].reason, body.operations[1].touched.length], [null, 8]);
  assert.deepEqual(body.cells.map(({ id }) => id), [0, 1, 2, 3, 4, 5, 6, 7, 20000, 20001, 400000, 410000]);
  // The plane is that of the points whose product with the normal is the offset: x = -4.
  const xs = body.cells.slice(-1)[0].corners.map(([x]) => x);
  const own = body.cells[0].corners.map(([x]) => -8 - x);
  xs.sort((a, b) => a - b).forEach((x, n) => assert.ok(Math.abs(x - own.sort((a, b) => a - b)[n]) < 1e-12));
  // Without the operation that does not apply the body is the same.
  const { operations, ...rest } = document;
  const without = { ...rest, operations: operations.map((one, n) => ({ ...one, id: [0, 1, 2, 3, 40, 41][n] })).filter(({ op }) => op !== "delete") };
  assert.deepEqual(dx.hyperpatch(/** @type {any} */ (without)).cells, body.cells);
});

test("an operation is written once, and taking the last one away gives the same body", () => {
  let count = 0;
  const plain = moved(3, 0.125);
  const told = /** @type {any} */ ({ toJSON: () => (count++, plain) });
  const first = dx.hyperpatch(block);
  const before = [first.cells, first.verdicts(), first.relations(), first.volume()];
  const edited = dx.hyperpatch(after(block, told));
  assert.notDeepEqual(edited.cells, before[0]);
  assert.equal(edited.moves(0, [3, 3, 3]).length, 64, "eight blocks");
  dx.hyperpatch(after(block, told, moved(0, 0.25))).volume();
  assert.equal(count, 1);
  const undone = dx.hyperpatch({ ...block, operations: [...block.operations] });
  assert.deepEqual([undone.cells, undone.verdicts(), undone.relations(), undone.volume()], before);
  // And so does reading all of it anew.
  const again = dx.hyperpatch(JSON.stringify(after(block, plain)));
  assert.deepEqual([again.cells, again.verdicts(), again.volume()], [edited.cells, edited.verdicts(), edited.volume()]);
});

test("what moves, what lies round a corner, and the checks of added cells", () => {
  const body = dx.hyperpatch(after(block, { op: "extrude", faces: [{ cell: 0, face: "u0" }], by: 0.5, start: "C1" }, { op: "copy", cells: [0], by: [0.25, 0, 0] }));
  const { cells, regular, points, joints } = body.neighbourhood(7, [0, 0, 0]);
  const inner = cells.filter(({ cell }) => cell < 8);
  assert.deepEqual([inner.length, regular, points.length], [8, true, 27]);
  assert.equal(joints.length, 12);
  assert.ok(joints.every(({ shape, shapeMarked }) => shape === "C1" && !shapeMarked));
  const self = points.find(({ offset }) => offset?.every((n) => n === 0));
  assert.equal(self?.users.length, 8);
  const side = points.find(({ offset }) => offset?.join() === "1,0,0");
  const at = side?.users.find(({ cell }) => cell === 7)?.at;
  assert.deepEqual(at, [1, 0, 0]);
  const shares = body.moves(7, [1, 0, 0]).map(({ share }) => share);
  assert.deepEqual([shares.filter((share) => share === 1).length, shares.filter((share) => share === -1).length], [16, 16], "9 neighbours a side, in 16 places");
  assert.deepEqual(body.moves(7, [1, 0, 0], "single").map(({ share }) => share), [1, 1, 1, 1]);

  const extruded = body.checks(1);
  assert.deepEqual([extruded.cells, extruded.injective.ok, extruded.meetings.ok], [[10000], true, true]);
  assert.deepEqual([extruded.continuity.faces, extruded.continuity.corners, extruded.continuity.shape], [1, 4, 4]);
  const copied = body.checks(2);
  assert.deepEqual([copied.injective.ok, copied.meetings.ok], [true, false]);
  assert.match(copied.meetings.message, /cells 0 and 20000 overlap/);
  assert.match(body.checks(0).injective.message, /8 cells, proven/);
  assert.equal(refused(() => body.checks(9)).path, "operation");
  assert.equal(refused(() => body.neighbourhood(0, [0, 0, 2])).path, "corner[2]");
  assert.equal(refused(() => body.moves(0, [4, 0, 0])).path, "at[0]");
});

test("a surface follows an edit in place", () => {
  const surface = dx.hyperpatch(block).surface({ tolerance: 0.01 });
  const { positions, indices, edgePositions } = surface;
  let document = block;
  for (let n = 1; n < 6; n++) {
    document = after(block, moved(n, 0.03 * n), { op: "mix", cells: [0], mix: pure(n % materials) });
    const body = dx.hyperpatch(document);
    const change = body.surface({ tolerance: 0.01, since: surface.id });
    assert.equal(change.since, surface.id);
    const ranges = renewSurface(surface, change);
    assert.ok(ranges && ranges.vertices.length === change.patches.length);
    assert.equal(surface.id, change.id);
    assert.deepEqual([surface.positions, surface.indices, surface.edgePositions], [positions, indices, edgePositions], "the same arrays");
    for (let vertex = 0; vertex < surface.cells.length; vertex += 3) {
      const uvw = /** @type {[number, number, number]} */ ([...surface.parameters.subarray(3 * vertex, 3 * vertex + 3)]);
      const { position, mix } = body.sample(surface.cells[vertex], uvw);
      position.forEach((x, k) => assert.ok(Math.abs(x - positions[3 * vertex + k]) < 1e-5));
      mix.forEach((part, k) => assert.ok(Math.abs(part - surface.fractions[materials * vertex + k]) < 1e-5));
    }
    for (const { cell, corner, position } of surface.corners) {
      const { corners } = /** @type {any} */ (body.cells.find(({ id }) => id === cell));
      assert.deepEqual(position, corners[4 * corner[0] + 2 * corner[1] + corner[2]]);
    }
    assert.ok(isClosed(surface), "no cracks");
  }
  const whole = dx.hyperpatch(after(document, { op: "delete", cells: [2] })).surface({ tolerance: 0.01, since: surface.id });
  assert.deepEqual([whole.since, renewSurface(surface, whole)], [null, null]);
  assert.equal(dx.hyperpatch(block).surface({ since: 123456 }).since, null);
  assert.equal(refused(() => dx.hyperpatch(block).surface({ since: -1 })).path, "options.since");
});

/** Every edge of a triangle is met once the other way round, by the bits of its ends. @param {BodySurface} surface */
function isClosed({ positions, indices }) {
  const ends = new Map();
  const key = (/** @type {number} */ vertex) => positions.subarray(3 * vertex, 3 * vertex + 3).join();
  for (let n = 0; n < indices.length; n += 3) {
    for (const k of [0, 1, 2]) {
      const [a, b] = [key(indices[n + k]), key(indices[n + ((k + 1) % 3)])];
      if (!ends.delete(`${b}|${a}`)) ends.set(`${a}|${b}`, true);
    }
  }
  return ends.size === 0;
}

test("documents merge by name and colour of their materials", async () => {
  const other = {
    ...documents.twisted,
    materials: [{ name: "glass", color: "#123456" }, { .../** @type {any} */ (block.materials)[1], color: block.materials?.[1].color.toUpperCase() }],
  };
  const document = after(block, { op: "mix", cells: [0], mix: pure(1) });
  const made = dx.merge(document, other);
  assert.deepEqual(made.materials?.map(({ name }) => name), [...(block.materials ?? []).map(({ name }) => name), "glass"]);
  const body = dx.hyperpatch(made);
  assert.deepEqual(body.cells.map(({ id }) => id), [0, 1, 2, 3, 4, 5, 6, 7, 20000]);
  const [before, added] = [dx.hyperpatch(document), dx.hyperpatch(other)];
  assert.ok(Math.abs(body.volume() - before.volume() - added.volume()) < 1e-9);
  const [glass, second] = added.amounts();
  const sums = [...before.amounts(), 0];
  sums[materials] += glass;
  sums[1] += second;
  body.amounts().forEach((amount, n) => assert.ok(Math.abs(amount - sums[n]) < 1e-9));
  assert.equal(dx.merge(block, block).operations[0], block.operations[0], "what need not change is the same object");
  const many = { ...other, materials: Array.from({ length: 15 }, (_, n) => ({ name: `m${n}`, color: "#000000" })), operations: [] };
  assert.equal(refused(() => dx.merge(block, many)).code, "limit");
  assert.deepEqual(await remoteMerge(connection(), document, other), made);
});

/** A connection to this very module, whose other side may lose what it was sent. */
function connection() {
  const client = {
    /** Numbers of operations that each call brought. @type {number[]} */
    brought: [],
    forgets: false,
    /** @param {string} name @param {any[]} args */
    async call(name, args) {
      const [document, question] = structuredClone(args);
      client.brought.push(document.written.length);
      if (client.forgets) document.written = [];
      client.forgets = false;
      const call = { name: /** @type {any} */ (name), args: [document, question] };
      const found = await inTurns(dx, call, { isWanted: () => true, onprogress: () => {} });
      return found?.value;
    },
  };
  return client;
}

test("over a connection operations are sent once, and again to a side that lost them", async () => {
  const client = connection();
  const document = { ...block, title: "sent", operations: [...structuredClone(block.operations), moved(0, 0.01)] };
  const body = await remoteBody(client, document);
  assert.deepEqual(body.operations, dx.hyperpatch(document).operations);
  await body.volume();
  const next = { ...document, operations: [...document.operations, moved(1, 0.01)] };
  await (await remoteBody(client, next)).verdicts();
  assert.deepEqual(client.brought, [2, 0, 1, 0]);
  // A side that was started again has nothing: it is sent all of it.
  client.forgets = true;
  client.brought.length = 0;
  const lost = { ...document, operations: structuredClone(next.operations) };
  assert.deepEqual((await remoteBody(client, lost)).cells, dx.hyperpatch(next).cells);
  assert.deepEqual(client.brought, [3, 3]);
  await assert.rejects(remoteBody(client, after(block, /** @type {any} */ ({ op: "melt" }))), { code: "range", path: "operations[1].op" });
});

test("cells are read one by one, and operations carried out one by one", () => {
  const [{ coefficients }] = documents.cell.operations[0].cells;
  const shifted = (/** @type {number} */ n) => ({ coefficients: coefficients.map((/** @type {any} */ one) => ({ ...one, position: [one.position[0] + 9 * n, ...one.position.slice(1)] })) });
  const cells = Array.from({ length: 50 }, (_, n) => shifted(n));
  const document = { ...documents.cell, operations: [{ op: "cells", cells }, ...Array.from({ length: 30 }, (_, n) => moved(n, 0.01))] };
  const job = dx.job(document, { hyperpatch: { question: "volume" } });
  let turns = 1;
  let last = 0;
  for (let state = job.step(0); !state.done; state = job.step(0), turns++) {
    if (turns < 110) assert.ok(state.progress >= last, `${state.progress} after ${last}`);
    last = state.progress;
  }
  assert.ok(turns > 50 + 30 + 31 + 50, `${turns} turns`);
});

test("limits are stated and kept", () => {
  const [operation] = documents.cell.operations;
  const with_ = (/** @type {any[]} */ ...operations) => ({ ...documents.cell, operations });
  const moves = Array.from({ length: 9999 }, (_, n) => moved(0, n % 2 ? 1e-3 : -1e-3));
  const long = dx.hyperpatch(with_(operation, ...moves));
  assert.equal(long.operations.length, 10000);
  assert.ok(long.operations.every(({ applied }) => applied));
  const { code, path } = refused(() => dx.hyperpatch(with_(operation, ...moves, moved(0, 0))));
  assert.deepEqual([code, path], ["limit", "operations"]);
  // Copies fill the body; what does not fit is passed over whole.
  const doubled = [operation];
  let cells = [0];
  for (let id = 1; id <= 14; id++) {
    doubled.push({ op: "copy", cells, by: [10 * 2 ** id, 0, 0] });
    cells = [...cells, ...cells.map((_, n) => 10000 * id + n)];
  }
  const full = dx.hyperpatch(with_(...doubled));
  assert.deepEqual([full.cells.length, full.operations[14].applied], [8192, false]);
  assert.match(full.operations[14].reason ?? "", /10000 cells/);
  const many = { op: "cells", cells: Array(10001).fill(null) };
  const refusal = refused(() => dx.hyperpatch(with_(operation, many)));
  assert.deepEqual([refusal.code, refusal.path], ["limit", "operations[1].cells"]);
  const twice = refused(() => dx.hyperpatch(with_({ ...operation, id: 3 }, { ...moved(0, 1), id: 3 })));
  assert.deepEqual([twice.code, twice.path], ["range", "operations[1].id"]);
  const last = refused(() => dx.hyperpatch(with_({ ...operation, id: 9999 }, moved(0, 1))));
  assert.deepEqual([last.code, last.path], ["limit", "operations[1].id"]);
});

/** @type {HyperpatchOperation[]} */
const EVERY = [
  moved(0, 0.05),
  { op: "continuity", cell: 0, face: "u1", corner: [1, 0, 0], shape: "none", material: "C1" },
  { op: "continuity", cell: 0, face: "u1", shape: "C1" },
  { op: "mix", mix: pure(0), cells: [1, 2] },
  { op: "mix", mix: pure(1), cell: 0, corner: [1, 1, 1], within: [0] },
  { op: "mix", mix: pure(1), cell: 0, at: [1, 2, 3] },
  { op: "slope", cell: 0, corner: [1, 1, 1], rule: "natural" },
  { op: "extrude", faces: [{ cell: 0, face: "u0" }], by: 0.5, start: "C1", normals: "surface", mix: pure(0) },
  { op: "copy", cells: [0], by: [9, 0, 0] },
  { op: "mirror", cells: [1], normal: [1, 0, 0], offset: -5, keep: false },
  { op: "reorient", cells: [1] },
  { op: "subdivide", cell: 2, axis: "v", at: 0.25 },
  { op: "delete", cells: [3], id: 20 },
];

/** What is wrong in each operation has its path. */
test("operations are refused by code and path", () => {
  /** @type {[number, object, string, string][]} */
  const wrong = [
    [0, { at: [0, 0, 4] }, "range", "at[2]"],
    [0, { at: [0, 0] }, "range", "at"],
    [0, { by: [0, 0] }, "type", "by"],
    [0, { by: [0, 2e9, 0] }, "range", "by[1]"],
    [0, { cell: -1 }, "type", "cell"],
    [0, { cell: 1e8 }, "range", "cell"],
    [0, { cell: undefined }, "missing", "cell"],
    [0, { reach: "all" }, "range", "reach"],
    [0, { id: 10000 }, "range", "id"],
    [0, { id: 0.5 }, "type", "id"],
    [0, { speed: 1 }, "unknown-field", "speed"],
    [1, { corner: [0, 0, 0] }, "range", "corner"],
    [1, { face: "x0" }, "range", "face"],
    [1, { shape: "C2" }, "range", "shape"],
    [2, { shape: undefined }, "missing", "shape"],
    [3, { mix: [0.5, 0.6, 0] }, "range", "mix"],
    [3, { cells: [] }, "range", "cells"],
    [3, { cells: [1, 1] }, "range", "cells[1]"],
    [3, { cell: 0 }, "range", "cell"],
    [4, { at: [0, 0, 0] }, "range", "corner"],
    [4, { corner: undefined }, "missing", "corner"],
    [6, { rule: "steep" }, "range", "rule"],
    [7, { by: 0 }, "range", "by"],
    [7, { by: -1 }, "range", "by"],
    [7, { faces: [{ cell: 0, face: "u0" }, { cell: 0, face: "u0" }] }, "range", "faces[1]"],
    [9, { normal: [0, 0, 0] }, "range", "normal"],
    [9, { keep: 1 }, "type", "keep"],
    [11, { at: 1 }, "range", "at"],
    [11, { axis: "x" }, "range", "axis"],
  ];
  for (const [n, change, code, path] of wrong) {
    const operations = /** @type {any[]} */ ([EVERY[0], { ...EVERY[n], ...change }]);
    const error = refused(() => dx.hyperpatch(after(block, ...operations)));
    assert.deepEqual([error.code, error.path], [code, `operations[2].${path}`], error.message);
  }
  for (const value of [null, 3, "cells", [], true]) {
    const error = refused(() => dx.hyperpatch(after(block, /** @type {any} */ (value))));
    assert.match(error.path, /^operations\[1\]/);
  }
  assert.equal(refused(() => dx.hyperpatch("{")).code, "syntax");
  assert.equal(refused(() => dx.hyperpatch(" ".repeat((4 << 20) + 1))).code, "limit");
  assert.equal(refused(() => dx.hyperpatch(/** @type {any} */ ({ directrix: 1, kind: "hyperpatch" }))).path, "operations");
  assert.equal(refused(() => dx.hyperpatch(/** @type {any} */ ({ ...block, operations: {} }))).path, "operations");
});

/** Documents with anything put anywhere are refused in words, or are bodies; nothing stops the module. */
test("mutated documents are refused or carried out", () => {
  const base = after(block, ...EVERY);
  const applied = dx.hyperpatch(base).operations.filter((row) => row.applied).length;
  assert.ok(applied >= 12, `${applied} of them apply`);
  const values = [null, true, "", "u0", -1, 0, 0.5, 3, 7, 1e8, 1e300, -1e9, NaN, Infinity, [], {}, [0, 0, 0], [1e9, 1e9, 1e9], undefined];
  let [bodies, refusals] = [0, 0];
  for (let seed = 1; seed <= 400; seed++) {
    let state = seed;
    const random = (/** @type {number} */ count) => {
      state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
      return Math.floor((state / 2 ** 32) * count);
    };
    const document = structuredClone(base);
    for (let edits = 1 + random(2); edits > 0; edits--) {
      /** @type {any} */
      let holder = document;
      let keys = ["operations"];
      for (let depth = 0; depth < 9; depth++) {
        const key = keys[random(keys.length)];
        const inner = holder[key];
        if (typeof inner !== "object" || inner === null || Object.keys(inner).length === 0 || (depth > 1 && random(3) === 0)) {
          const value = values[random(values.length)];
          if (random(4) === 0 && Array.isArray(holder)) holder.splice(Number(key), 1);
          else if (random(4) === 0 && typeof inner === "number") holder[key] = inner * -1.5;
          else holder[key] = value;
          break;
        }
        holder = inner;
        keys = Object.keys(inner);
      }
    }
    try {
      const body = dx.hyperpatch(document);
      const sums = body.amounts();
      assert.ok(sums.every(Number.isFinite), `seed ${seed}`);
      bodies++;
    } catch (error) {
      assert.ok(error instanceof DirectrixError && error.code !== "trap" && error.message, `seed ${seed}: ${error}`);
      refusals++;
    }
  }
  assert.ok(bodies > 20 && refusals > 100, `${bodies} bodies, ${refusals} refusals`);
  // A collapsed cell among others is a body as well, with its verdict.
  const flat = structuredClone(block);
  for (const one of /** @type {any} */ (flat).operations[0].cells[0].coefficients) one.position = [0, 0, 0];
  const verdicts = dx.hyperpatch(after(flat, moved(0, 0.5), { op: "subdivide", cell: 0, axis: "w" })).verdicts({ global: false });
  assert.ok(verdicts.some(({ verdict }) => ["degenerate", "invalid"].includes(verdict)));
});
