/**
 * Numbers as they are written into a part document.
 */
export { written } from "../../state/mix.js";

/** Digits that are kept, so that no traces of binary fractions are written. */
const DIGITS = 10;

/** A number without the traces of binary arithmetic. @param {number} value */
export const tidy = (value) => Number(value.toPrecision(DIGITS)) + 0;
