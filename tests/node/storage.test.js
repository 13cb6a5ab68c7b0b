/** Which versions and deleted documents the page keeps, and how it reads what it finds. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { moment, when } from "../../www/src/frame/when.js";
import { isHead } from "../../www/src/storage/records.js";
import { BIN_SIZE, BIN_TIME, expired, MOST_VERSIONS, replaced, saved, SPACING } from "../../www/src/storage/versions.js";

/** @typedef {import("../../www/src/storage/records.js").Head} Head */
/** @typedef {import("../../www/src/storage/records.js").Version} Version */

/** @type {Head} */
const HEAD = {
  version: 1, id: "x", title: "X", file: null, modified: null, edited: true, born: 0, time: 0, deleted: null,
  stamp: "a.1", thumbnail: null, versions: [],
};
const minute = 60_000;

test("a day of edits, one a minute, keeps one state in ten minutes, the ten newest", () => {
  /** @type {Pick<Head, "born" | "time" | "versions">} */
  let head = { born: 0, time: 0, versions: [] };
  const dropped = [];
  for (let now = minute; now <= 24 * 60 * minute; now += minute) {
    const { versions, keep, drop } = replaced(head, now);
    assert.equal(keep, versions.some(({ time }) => time === head.time) && !head.versions.some(({ time }) => time === head.time));
    dropped.push(...drop);
    assert.ok(versions.length <= MOST_VERSIONS);
    for (let i = 1; i < versions.length; i += 1) assert.ok(versions[i].time - versions[i - 1].time >= SPACING);
    head = { born: 0, time: now, versions };
  }
  assert.equal(head.versions.length, MOST_VERSIONS);
  assert.ok(head.time - head.versions[0].time < 12 * SPACING);
  assert.equal(new Set(dropped.map(({ time }) => time)).size, dropped.length, "nothing is dropped twice");
});

test("the last state of yesterday is kept by the first edit of today", () => {
  const { versions, keep } = replaced({ born: 0, time: 9 * minute, versions: [] }, 24 * 60 * minute);
  assert.ok(keep);
  assert.deepEqual(versions, [{ time: 9 * minute, kind: "kept" }]);
});

test("of saved states the last is kept, and does not count among the others", () => {
  /** @type {Version[]} */
  let versions = [{ time: 5, kind: "kept" }];
  for (const now of [10, 20, 30]) versions = saved(versions, now).versions;
  assert.deepEqual(versions, [{ time: 5, kind: "kept" }, { time: 30, kind: "saved" }]);
  assert.deepEqual(saved(versions, 40).drop, [{ time: 30, kind: "saved" }]);
});

test("the bin gives up what is too old or too much", () => {
  const now = 100 * BIN_TIME;
  const bin = Array.from({ length: BIN_SIZE + 3 }, (_, i) => ({ ...HEAD, id: `${i}`, deleted: now - i }));
  const old = { ...HEAD, id: "old", deleted: now - BIN_TIME - 1 };
  const gone = expired([...bin.slice(0, 5), old, HEAD, ...bin.slice(5)], now).map(({ id }) => id);
  assert.deepEqual(gone, ["20", "21", "22", "old"]);
  assert.deepEqual(expired([old, HEAD], now), [old]);
});

test("only whole records of this version are read", () => {
  assert.ok(isHead(HEAD));
  assert.ok(isHead({ ...HEAD, deleted: 3, file: "x.json", versions: [{ time: 1, kind: "saved" }], more: 1 }));
  const png = "data:image/png;base64,AAAA";
  assert.ok(isHead({ ...HEAD, thumbnail: { light: png, dark: png } }));
  for (const [key, value] of [
    ["version", 2], ["id", 7], ["title", null], ["stamp", undefined], ["born", "0"], ["time", Infinity], ["time", 1e17],
    ["deleted", "yes"], ["file", 3], ["modified", NaN], ["edited", 1], ["versions", {}], ["versions", [null]],
    ["versions", [{ time: 1, kind: "other" }]], ["thumbnail", png], ["thumbnail", { light: png, dark: "https://else.where/x.png" }],
  ]) {
    assert.equal(isHead({ ...HEAD, [/** @type {string} */ (key)]: value }), false, `${key} ${String(value)}`);
  }
  for (const value of [null, undefined, 1, "text", [], {}]) assert.equal(isHead(value), false);
});

test("moments are put into words", () => {
  const now = Date.UTC(2026, 5, 20, 12);
  const hour = 60 * minute;
  for (const [passed, words] of /** @type {const} */ ([
    [-5 * minute, "just now"], [59_000, "just now"], [minute, "1 minute ago"], [59 * minute, "59 minutes ago"],
    [hour, "1 hour ago"], [25 * hour, "yesterday"], [6 * 24 * hour, "6 days ago"],
  ])) assert.equal(when(now - passed, now), words);
  assert.equal(when(now - 40 * 24 * hour, now), "11 May 2026");
  assert.match(moment(now), /^(19|20|21) Jun 2026, \d\d:00$/);
});
