/**
 * Which states of a document are kept, and which deleted documents.
 *
 * @import { Head, Version } from "./records.js"
 */

/** Milliseconds between two kept versions, and how many of them there are at most. */
export const SPACING = 10 * 60_000;
export const MOST_VERSIONS = 10;
/** Milliseconds and number after which deleted documents are gone for good. */
export const BIN_TIME = 30 * 24 * 3_600_000;
export const BIN_SIZE = 20;

/**
 * What happens to the versions of a document when an edit replaces the state that is stored: that state is kept when it is
 * `SPACING` newer than the newest kept one, or when it rested for so long; the oldest make room.
 * @param {Pick<Head, "born" | "time" | "versions">} head as stored
 * @param {number} now
 * @returns {{versions: Version[], keep: boolean, drop: Version[]}} `keep`: whether the stored state becomes a version
 */
export function replaced({ born, time, versions }, now) {
  const newest = versions.filter(({ kind }) => kind === "kept").at(-1)?.time ?? born;
  const taken = versions.some((version) => version.time === time);
  const keep = !taken && (time - newest >= SPACING || now - time >= SPACING);
  const all = keep ? [...versions, /** @type {Version} */ ({ time, kind: "kept" })] : versions;
  const kept = all.filter(({ kind }) => kind === "kept");
  const drop = kept.slice(0, Math.max(0, kept.length - MOST_VERSIONS));
  return { versions: inOrder(all.filter((version) => !drop.includes(version))), keep, drop };
}

/**
 * What happens to them when the document is saved to a file: that state is kept in place of the one saved before.
 * @param {Version[]} versions
 * @param {number} now
 * @returns {{versions: Version[], drop: Version[]}}
 */
export function saved(versions, now) {
  const drop = versions.filter(({ kind, time }) => kind === "saved" || time === now);
  const rest = versions.filter((version) => !drop.includes(version));
  return { versions: inOrder([...rest, { time: now, kind: "saved" }]), drop };
}

/**
 * The deleted documents that are gone for good: older than `BIN_TIME`, or beyond the newest `BIN_SIZE`.
 * @param {Head[]} heads
 * @param {number} now
 */
export function expired(heads, now) {
  const bin = heads.filter(({ deleted }) => deleted !== null).sort((a, b) => (b.deleted ?? 0) - (a.deleted ?? 0));
  return bin.filter(({ deleted }, i) => i >= BIN_SIZE || now - (deleted ?? 0) > BIN_TIME);
}

/** @param {Version[]} versions */
function inOrder(versions) {
  return [...versions].sort((a, b) => a.time - b.time);
}
