/**
 * The values of typed expressions, for the plot of a profile. What may be typed, and what is wrong with a text, the kernel says (`src/field/expression.rs`);
 * this reads the same language, and the tests compare the values of both.
 *
 * @typedef {(values: readonly number[]) => number} Value of an expression, for values of its variables in their order.
 */

/** As `f64::min` and `f64::max`: what is no number counts for nothing. */
const least = (/** @type {number} */ x, /** @type {number} */ y) => (Number.isNaN(x) ? y : Number.isNaN(y) ? x : Math.min(x, y));
const most = (/** @type {number} */ x, /** @type {number} */ y) => (Number.isNaN(x) ? y : Number.isNaN(y) ? x : Math.max(x, y));
const clamped = (/** @type {number} */ x, /** @type {number} */ lo, /** @type {number} */ hi) => least(most(x, lo), hi);

/** 3 t^2 - 2 t^3 between 0 and 1, and constant beyond. @param {number} t */
export function smoothstep(t) {
  const inside = Math.min(1, Math.max(0, t));
  return inside * inside * (3 - 2 * inside);
}

/** A power of 1 is 1, and one of a number by 0 as well, whatever the other is. @param {number} base @param {number} exponent */
const power = (base, exponent) => (base === 1 ? 1 : base ** exponent);

/** @type {{[name: string]: (...args: number[]) => number}} */
const FUNCTIONS = {
  sin: Math.sin,
  cos: Math.cos,
  exp: Math.exp,
  ln: Math.log,
  sqrt: Math.sqrt,
  abs: Math.abs,
  min: (x, y) => least(x, y),
  max: (x, y) => most(x, y),
  clamp: (x, lo, hi) => clamped(x, lo, hi),
  smoothstep: (lo, hi, x) => smoothstep((x - lo) / (hi - lo)),
};

/** @type {{[name: string]: number}} */
const CONSTANTS = { pi: Math.PI, e: Math.E };

const TOKEN = /\s*(?:((?:\d[\d.]*|\.[\d.]*)(?:[eE](?=[\d+-])[+-]?[\d.]*)?)|([\p{L}_][\p{L}\p{N}_]*)|(.))/uy;

/**
 * @param {string} text
 * @param {readonly string[]} variables
 * @returns {Value | null} null where the text is no expression
 */
export function expression(text, variables) {
  const tokens = tokensOf(text);
  let at = 0;
  let isWrong = false;
  const take = (/** @type {string} */ sign) => {
    const isThere = tokens[at] === sign;
    if (isThere) at += 1;
    return isThere;
  };
  /** @returns {Value} */
  const wrong = () => {
    isWrong = true;
    return () => Number.NaN;
  };

  /** @returns {Value} */
  function sum() {
    let value = product();
    for (;;) {
      const left = value;
      if (take("+")) value = joined(left, product(), (x, y) => x + y);
      else if (take("-")) value = joined(left, product(), (x, y) => x - y);
      else return value;
    }
  }
  /** @returns {Value} */
  function product() {
    let value = signed();
    for (;;) {
      const left = value;
      if (take("*")) value = joined(left, signed(), (x, y) => x * y);
      else if (take("/")) value = joined(left, signed(), (x, y) => x / y);
      else return value;
    }
  }
  /** @returns {Value} */
  function signed() {
    if (take("-")) {
      const value = signed();
      return (values) => -value(values);
    }
    const base = atom();
    return take("^") ? joined(base, signed(), power) : base;
  }
  /** @returns {Value} */
  function atom() {
    const token = tokens[at];
    at += 1;
    if (token === undefined) return wrong();
    if (token === "(") {
      const value = sum();
      return take(")") ? value : wrong();
    }
    if (/^[\d.]/.test(token)) {
      const number = Number(token);
      return Number.isFinite(number) ? () => number : wrong();
    }
    if (Object.hasOwn(FUNCTIONS, token)) return call(FUNCTIONS[token]);
    const index = variables.indexOf(token);
    if (index >= 0) return (values) => values[index];
    if (Object.hasOwn(CONSTANTS, token)) return () => CONSTANTS[token];
    return wrong();
  }
  /** @param {(...args: number[]) => number} of @returns {Value} */
  function call(of) {
    if (!take("(")) return wrong();
    /** @type {Value[]} */
    const given = [];
    do given.push(sum());
    while (!isWrong && take(","));
    if (!take(")") || given.length !== Math.max(1, of.length)) return wrong();
    return (values) => of(...given.map((value) => value(values)));
  }

  const value = sum();
  return isWrong || at < tokens.length ? null : value;
}

/** @param {Value} left @param {Value} right @param {(x: number, y: number) => number} by @returns {Value} */
const joined = (left, right, by) => (values) => by(left(values), right(values));

/** Numbers, names and signs. @param {string} text */
function tokensOf(text) {
  const tokens = [];
  TOKEN.lastIndex = 0;
  const rest = text.trimEnd();
  while (TOKEN.lastIndex < rest.length) {
    const found = TOKEN.exec(rest);
    if (!found) break;
    tokens.push(found[1] ?? found[2] ?? found[3]);
  }
  return tokens;
}
