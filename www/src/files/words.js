/** Words of opening and saving. */
export const words = {
  saved: (/** @type {string} */ file) => `Saved ${file}`,
  copied: (/** @type {string} */ file) => `Saved a copy as ${file}`,
  changedOutside: (/** @type {string} */ file) => `${file} was changed outside this page. Save again to replace it, or save a copy.`,
  notSaved: (/** @type {string} */ file, /** @type {string} */ reason) => `Could not save ${file}: ${reason}. Save a copy elsewhere.`,
  notOpened: (/** @type {string} */ file, /** @type {string} */ reason) => `Could not open ${file}: ${reason}. The open document is unchanged.`,
  notJson: "it is not JSON",
  pasted: "Pasted shapes",
  onlyFirst: (/** @type {string} */ file, /** @type {number} */ count) => `${count} files were dropped; only ${file} was opened.`,
};
