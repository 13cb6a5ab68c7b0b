/** Words of the control of a mix. */
export const words = {
  group: "Mix of materials",
  bar: (/** @type {string} */ name) => `Share of ${name}`,
  percent: (/** @type {string} */ name) => `Per cent of ${name}`,
  triangle: "Mix of three materials",
};
