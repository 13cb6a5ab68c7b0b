/**
 * What the database holds. For each document one head, which lists it, and one body, the document itself; besides them the
 * versions it had, and its file where the page may write to one.
 *
 * @typedef {object} Version A state that the document had.
 * @property {number} time in milliseconds of the epoch; also its name
 * @property {"kept" | "saved"} kind `saved` went into a file, `kept` was replaced by later edits
 *
 * @typedef {object} Head
 * @property {1} version of this record
 * @property {string} id
 * @property {string} title
 * @property {string | null} file the name of the file it stands in
 * @property {number | null} modified when that file was last changed, as far as the page knew
 * @property {boolean} edited whether it differs from that file
 * @property {number} born when it was first kept
 * @property {number} time when it was last kept
 * @property {number | null} deleted when it went to the bin
 * @property {string} stamp changes with every write and begins with the page that wrote
 * @property {{light: string, dark: string} | null} thumbnail addresses of small pictures, as data
 * @property {Version[]} versions oldest first
 */

/** The version of the records that this page writes, and the only one it reads. */
export const VERSION = 1;

export const HEADS = "head/";

/** @param {string} id */
export const headKey = (id) => `${HEADS}${id}`;
/** @param {string} id */
export const bodyKey = (id) => `body/${id}`;
/** @param {string} id */
export const fileKey = (id) => `file/${id}`;
/** @param {string} id */
export const versionsOf = (id) => `past/${id}/`;
/** @param {string} id @param {number} time */
export const versionKey = (id, time) => `${versionsOf(id)}${time}`;

/** All keys that begin so. @param {string} prefix */
export const beginning = (prefix) => IDBKeyRange.bound(prefix, `${prefix}\uffff`);

/**
 * Whether a value of the database is a head that this page can read. The database belongs to the person, and to other
 * versions of the page: anything may stand in it.
 * @param {unknown} value
 * @returns {value is Head}
 */
export function isHead(value) {
  if (typeof value !== "object" || value === null) return false;
  const head = /** @type {{[key: string]: unknown}} */ (value);
  return (
    head.version === VERSION &&
    [head.id, head.title, head.stamp].every((each) => typeof each === "string") &&
    [head.born, head.time].every(isTime) &&
    (head.deleted === null || isTime(head.deleted)) &&
    (head.modified === null || isTime(head.modified)) &&
    (head.file === null || typeof head.file === "string") &&
    typeof head.edited === "boolean" &&
    (head.thumbnail === null || isThumbnail(head.thumbnail)) &&
    Array.isArray(head.versions) &&
    head.versions.every(isVersion)
  );
}

/** A moment that a calendar can show. @param {unknown} value */
const isTime = (value) => typeof value === "number" && Math.abs(value) <= 8.64e15;

/** @param {unknown} value */
function isThumbnail(value) {
  const { light, dark } = /** @type {{[key: string]: unknown}} */ (value ?? {});
  return [light, dark].every((each) => typeof each === "string" && each.startsWith("data:image/png;"));
}

/** @param {unknown} value */
function isVersion(value) {
  const { time, kind } = /** @type {{[key: string]: unknown}} */ (value ?? {});
  return isTime(time) && (kind === "kept" || kind === "saved");
}
