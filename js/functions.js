/** The functions that both `load()` and `connect()` offer. */
export const FUNCTIONS = /** @type {const} */ ([
  "match",
  "stages",
  "cells",
  "isolines",
  "probe",
  "steps",
  "sets",
  "paint",
  "svg",
  "fit",
  "insertPoint",
  "defaults",
  "explain",
  "readShapes",
  "fitCurve",
  "morphPaths",
]);
