/** Words of the fields of curves in space. */

export const words = {
  name: "Name",
  assumed: (/** @type {string} */ normal, /** @type {string} */ deviation, /** @type {string | null} */ gap) =>
    `In space: matched as seen along (${normal}). A curve lies up to ${deviation} off its plane${gap === null ? "" : `, and lengths count the mean gap of ${gap}`}.`,
};
