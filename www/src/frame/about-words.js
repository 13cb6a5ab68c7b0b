/** Words of the panel about Directrix. */
export const words = {
  heading: "About Directrix",
  version: (/** @type {string} */ version) => `Version ${version}`,
  line: "Curves that match, shapes that morph, materials that blend. Nothing leaves your machine.",
  own: "Directrix itself: MIT or Apache-2.0, at your choice.",
  parts: "What it is made of",
  loading: "Reading the licences",
  missing: "The licences are collected when the page is built; this is a development server.",
};
