/** Every word of the frame round a selection. */
export const words = {
  group: (/** @type {string} */ curve) => `Frame of ${curve}`,
  help:
    "Arrow keys drag a handle of the frame or turn it, with Shift ten times as far, with Alt a tenth. Page up and page " +
    "down go from handle to handle, Escape takes the change back.",
  turn: "Turn",
  scale: {
    nw: "Scale at the upper left",
    n: "Scale at the top",
    ne: "Scale at the upper right",
    e: "Scale at the right",
    se: "Scale at the lower right",
    s: "Scale at the bottom",
    sw: "Scale at the lower left",
    w: "Scale at the left",
  },
  turned: (/** @type {string} */ degrees) => `Turned by ${degrees}°`,
  scaled: (/** @type {string} */ x, /** @type {string} */ y) => (x === y ? `Scaled to ${x}` : `Scaled to ${x} across, ${y} up`),
};
