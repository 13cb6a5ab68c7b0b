/** Words of documents that the browser keeps. */
export const words = {
  copyOf: (/** @type {string} */ title) => `${title} (copy)`,
  openElsewhere: (/** @type {string} */ title) => `${title} is open in another tab. This is a copy.`,
  changedElsewhere: (/** @type {string} */ title) => `${title} was changed in another tab. This is a copy.`,
  gone: "it is no longer there",
};
