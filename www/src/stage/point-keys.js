/**
 * The point that a key leads to from one of a row of points, or from the whole of them: null is the whole, undefined what is no such key.
 * @param {string} key
 * @param {number | null} point
 * @param {number} count
 * @returns {number | null | undefined}
 */
export function pointBy(key, point, count) {
  if (key === "PageDown") return point === null ? 0 : (point + 1) % count;
  if (key === "PageUp") return point === null ? count - 1 : (point + count - 1) % count;
  if (key === "Home") return null;
  return key === "End" ? count - 1 : undefined;
}
