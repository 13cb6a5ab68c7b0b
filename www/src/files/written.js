/**
 * JSON with one line for each array of numbers, so that a document is easy to read and to compare.
 * @param {unknown} value
 */
export function written(value) {
  const text = JSON.stringify(value, null, 2);
  return `${text.replace(/\[[^[\]{}]*\]/g, (list) => list.replace(/\s*\n\s*/g, " ").replace(/\[ | \]/g, (edge) => edge.trim()))}\n`;
}
