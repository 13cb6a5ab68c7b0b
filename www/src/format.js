/**
 * Numbers as the page writes them: true minus, thin space in thousands, three significant figures.
 */

const MINUS = "\u2212";
const THIN = "\u2009";
const SPACE = "\u00a0";

/**
 * A number with a fixed count of decimals; never a negative zero.
 * @param {number} value
 * @param {number} decimals
 */
export function fixed(value, decimals) {
  const text = Math.abs(value).toFixed(decimals);
  const sign = value < 0 && Number(text) !== 0 ? MINUS : "";
  const [whole = "", fraction] = text.split(".");
  const grouped = whole.length > 4 ? whole.replace(/\B(?=(\d{3})+$)/g, THIN) : whole;
  return sign + (fraction === undefined ? grouped : `${grouped}.${fraction}`);
}

/**
 * Three significant figures, in powers of ten when small or large.
 * @param {number} value
 * @returns {{mantissa: string, exponent: string | null}}
 */
export function significant(value) {
  if (value === 0) return { mantissa: "0", exponent: null };
  const [lead = "0", power = "0"] = value.toExponential(2).split("e");
  const exponent = Number(power);
  if (exponent < -2 || exponent > 4) {
    return { mantissa: fixed(Number(lead), 2), exponent: fixed(exponent, 0) };
  }
  return { mantissa: fixed(Number(value.toPrecision(3)), Math.max(0, 2 - exponent)), exponent: null };
}

/**
 * The same as one line of text, for speech and file names.
 * @param {number} value
 */
export function significantText(value) {
  const { mantissa, exponent } = significant(value);
  return exponent === null ? mantissa : `${mantissa} × 10^${exponent}`;
}

/** @param {number} value document units */
export const coordinate = (value) => fixed(value, 2);

/**
 * @param {number} value document units
 * @param {string} unit
 */
export const length = (value, unit) => `${fixed(value, 1)}${SPACE}${unit}`;

/** @param {number} value in [0, 1] */
export const percent = (value) => `${fixed(value * 100, 0)}${SPACE}%`;

/** @param {number} value milliseconds */
export const milliseconds = (value) => (value < 1 ? "<1" : fixed(value, 0));

/**
 * Reads a number as a person types it: comma or point, true minus, spaces. Null when it is none.
 * @param {string} text
 */
export function parse(text) {
  const plain = text
    .trim()
    .replace(/[\u2009\u202f\u00a0 ]/g, "")
    .replace(MINUS, "-")
    .replace(",", ".");
  if (!/^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i.test(plain)) return null;
  const value = Number(plain);
  return Number.isFinite(value) ? value : null;
}

/**
 * The number as it stands in a field: at least `decimals`, and as many more as the value has, up to six.
 * @param {number} value
 * @param {number} decimals
 */
export function editable(value, decimals) {
  const exact = Number(value.toFixed(6));
  const written = String(Math.abs(exact)).split(".")[1]?.length ?? 0;
  return fixed(exact, Math.max(decimals, Math.min(6, written)));
}
