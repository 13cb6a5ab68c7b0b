/** What the switch of modes says. */
export const words = {
  region: "Modes",
  figure: "Figure",
  steps: "Steps",
  compare: "Compare",
  solid: "Solid",
  failed: (/** @type {string} */ reason) => `That mode could not be loaded: ${reason}.`,
};
