/** Words of the list of recent documents. */
export const words = {
  heading: "Recent documents",
  deleted: "Deleted",
  empty: "Nothing yet. A document is listed here once it is edited, saved or opened from a file.",
  where:
    "Documents are kept by this browser on this machine, and nowhere else. Deleted ones stay for 30 days, at most 20 of them.",
  here: "open here",
  elsewhere: "open in another tab",
  noFile: "not in a file",
  versionsOf: (/** @type {string} */ title) => `Earlier versions of ${title}`,
  kinds: { saved: "as saved", kept: "before later edits" },
  delete: (/** @type {string} */ title) => `Delete ${title}`,
  gone: (/** @type {string} */ title) => `Deleted ${title}`,
  undo: "Undo",
  since: (/** @type {string} */ when) => `deleted ${when}`,
  restore: "Restore",
  restored: (/** @type {string} */ title) => `Restored ${title}`,
  erase: "Delete for good",
  erased: (/** @type {string} */ title) => `Deleted ${title} for good`,
};
