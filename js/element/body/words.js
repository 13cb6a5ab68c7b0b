/** What a figure of a body says to a person. */
export const words = {
  camera: "Camera",
  help:
    "Arrow keys go round the body, with Shift they move it. Plus and minus come nearer and go farther, F shows the whole body, 5 to 8 are standard views. " +
    "Escape leaves the picture.",
  drag: "Drag to turn",
  tap: "Tap, then drag to turn",
  nearer: "Nearer",
  farther: "Farther",
  fit: "The whole body",
  section: "Section",
  whole: "Whole body",
  cut: (/** @type {string} */ y) => `Cut at y ${y}`,
  seen: (/** @type {string} */ azimuth, /** @type {string} */ elevation) => `Seen from ${azimuth}°, ${elevation}° above`,
  zoomed: (/** @type {string} */ share) => `Zoom ${share} %`,
  cells: (/** @type {number} */ count) => (count === 1 ? "1 cell" : `${count} cells`),
  checking: "being checked",
  verified: "verified",
  certified: "certified",
  problems: (/** @type {number} */ count, /** @type {string} */ what) => `${count} ${what}`,
  invalid: "invalid",
  degenerate: "degenerate",
  overlaps: (/** @type {number} */ count) => (count === 1 ? "overlap" : "overlaps"),
  empty: "No cell yet",
};
