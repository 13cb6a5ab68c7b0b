/**
 * Points of the simplex as pure functions: whatever is asked for, fractions stay at least 0 and sum to 1.
 */

/** Parts of one that fractions are written in: four decimals. */
const PARTS = 10_000;

/**
 * Fractions with four decimals and the sum 1: the largest one takes the rest. What is negative or no number counts as 0; without
 * any positive fraction the first material has all.
 * @param {number[]} fractions
 * @returns {number[]}
 */
export function written(fractions) {
  const positive = fractions.map((fraction) => (fraction > 0 && Number.isFinite(fraction) ? fraction : 0));
  const sum = positive.reduce((all, fraction) => all + fraction, 0);
  if (sum === 0) return positive.map((_, i) => (i === 0 ? 1 : 0));
  const parts = positive.map((fraction) => Math.round((fraction / sum) * PARTS));
  const largest = parts.indexOf(Math.max(...parts));
  parts[largest] += PARTS - parts.reduce((all, part) => all + part, 0);
  return parts.map((part) => part / PARTS);
}

/**
 * The mix with one fraction set, the others scaled in proportion. Where they are all 0 they share the rest evenly, among `others` when
 * some are named.
 * @param {number[]} mix
 * @param {number} index
 * @param {number} fraction
 * @param {number[]} [others] indices that take a rest no other material has a share in
 */
export function withFraction(mix, index, fraction, others = []) {
  if (mix.length === 1) return [1];
  const value = Math.min(1, Math.max(0, fraction));
  const rest = mix.reduce((all, other, i) => (i === index ? all : all + other), 0);
  if (rest > 0) return written(mix.map((other, i) => (i === index ? value : (other / rest) * (1 - value))));
  const named = others.filter((i) => i !== index);
  const takers = named.length > 0 ? named : mix.map((_, i) => i).filter((i) => i !== index);
  const share = (1 - value) / takers.length;
  return written(mix.map((_, i) => (i === index ? value : takers.includes(i) ? share : 0)));
}

/**
 * The straight blend from one mix to another.
 * @param {number[]} from
 * @param {number[]} to
 * @param {number} t 0 to 1
 */
export const blended = (from, to, t) => from.map((fraction, i) => fraction * (1 - t) + to[i] * t);

/**
 * The place of a mix of three materials in their triangle: the first at the lower left, the second at the lower right, the third on top. The
 * side has the length 1.
 * @param {number[]} three
 * @returns {[number, number]} from the lower left corner, y up
 */
export function inTriangle([, b, c]) {
  return [b + c / 2, (c * Math.sqrt(3)) / 2];
}

/**
 * The mix at a place of the triangle; a place outside goes to the nearest one of it.
 * @param {[number, number]} place as `inTriangle` gives it
 * @returns {number[]}
 */
export function fromTriangle([x, y]) {
  const c = (2 * y) / Math.sqrt(3);
  const b = x - c / 2;
  return nearest([1 - b - c, b, c]);
}

/**
 * The point of the simplex nearest to fractions that sum to 1, some of which may be negative: equal parts are taken off until
 * none is.
 * @param {number[]} fractions
 */
function nearest(fractions) {
  const sorted = [...fractions].sort((a, b) => b - a);
  let [sum, off] = [0, 0];
  sorted.forEach((fraction, i) => {
    sum += fraction;
    if (fraction > (sum - 1) / (i + 1)) off = (sum - 1) / (i + 1);
  });
  return written(fractions.map((fraction) => Math.max(0, fraction - off)));
}
