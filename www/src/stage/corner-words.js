/** Every word about corners of curves. */
export const words = {
  /** In the status line, which is short. */
  note: (/** @type {number} */ number, /** @type {number} */ count, /** @type {string} */ turn, /** @type {string | null} */ loss) =>
    `${which(number, count)}: ${turn}, with the bisector for its normal.${loss === null ? "" : ` J is ${loss} below its bound.`}`,
  /** Spoken after it. */
  place: (/** @type {string} */ curve, /** @type {string} */ x, /** @type {string} */ y) => `On ${curve}, x ${x}, y ${y}.`,
};

/** @param {number} number @param {number} count */
const which = (number, count) => (count === 1 ? "The corner" : `Corner ${number} of ${count}`);
