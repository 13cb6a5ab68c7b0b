/** Words of the canvas without a curve. */
export const words = {
  line: "Draw two curves, or start from something ready.",
  gallery: "Gallery",
  import: "Import",
};
