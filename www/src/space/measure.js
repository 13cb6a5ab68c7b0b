/** Areas and volumes in words. */
import { significant } from "../format.js";

/**
 * An area or a volume with its unit.
 * @param {number} value
 * @param {string} unit of lengths
 * @param {2 | 3} power
 */
export function measure(value, unit, power) {
  const number = numberText(value);
  return unit === "" ? number : `${number}\u00a0${unit}${power === 2 ? "²" : "³"}`;
}

/** Three significant figures, in powers of ten when small or large. @param {number} value */
export function numberText(value) {
  const { mantissa, exponent } = significant(value);
  return exponent === null ? mantissa : `${mantissa} × 10${raised(exponent)}`;
}

/** @param {string} exponent */
const raised = (exponent) => [...exponent].map((sign) => (sign === "\u2212" ? "⁻" : "⁰¹²³⁴⁵⁶⁷⁸⁹"[Number(sign)])).join("");
