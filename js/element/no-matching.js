/** What the result of a figure says of matchings, for a document that has none. */
export const NO_MATCHING = /** @type {const} */ ({
  lines: 0,
  crossings: 0,
  blocked: 0,
  uncovered: 0,
  eta: null,
  integral: null,
  gap: null,
  gapKind: null,
  method: null,
});
