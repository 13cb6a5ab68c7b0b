/** Every word of the panel Export of curves. */
export const words = {
  heading: "Export",
  format: "Format",
  morph: "Morph",
  solid: "Solid",
  scale: "Scale",
  table: "Table",
  tables: { lines: "Ruling lines", stages: "Stages" },
  notes: {
    png: "The figure as on screen, with its layers. Sides up to 4096 pixels.",
    svg: "The figure as on screen, with its layers, sharp at any size.",
    lines: "One row for each ruling line: parameters, ends, value, cosine of the normals, length.",
    stages: "One row for each point of the curves in between.",
    json: "The document with its view, to be opened again.",
  },
  noLines: "there are no ruling lines",
  noStages: "there are no stages, because the matching is not complete",
  download: "Download",
  downloaded: (/** @type {string} */ file) => `Downloaded ${file}`,
  copy: "Copy",
  copied: "Copied to the clipboard",
  failed: (/** @type {string} */ reason) => `That did not work: ${reason}.`,
};
