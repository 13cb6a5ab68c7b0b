/** Words of the fields of the sampling. */

export const words = {
  scheme: "Scheme",
  arcLength: "Arc length",
  parameter: "Parameter",
  adaptive: "Adaptive",
  counts: "Samples",
  tolerance: "Tolerance",
  toleranceField: (/** @type {string} */ unit) => `Greatest distance from the chords, ${unit}`,
  maxTurn: "Greatest turn",
  degrees: "°",
  minCount: "Fewest",
  maxTurnField: "Greatest turn from one sample to the next, degrees",
  minCountField: "Fewest samples of a curve",
  taken: (/** @type {number[]} */ counts) => counts.join(" : "),
  count: (/** @type {string} */ curve) => `Samples on ${curve}`,
};
