/** What a person reads in the workbench Part. */

/** @type {readonly {id: string, file: string, line: string}[]} */
export const PRESETS = [
  { id: "part-rectangle", file: "rectangle", line: "Two profiles, and the four leaves that they cut the body into." },
  { id: "part-base", file: "base", line: "A base and a cylinder in section, each graded, where both reach." },
  { id: "part-references", file: "references", line: "The same bar, graded from its axis and from its surface." },
  { id: "part-lens", file: "lens", line: "A lens in section, by the distances to its axis and its front." },
  { id: "part-scaffold", file: "scaffold", line: "A scaffold with many pores, graded from its sides." },
  { id: "part-tool", file: "tool", line: "A tool with cooling channels: from the channels, and from its outline." },
  { id: "part-coating", file: "coating", line: "A thin coating under a deep gradient, which the printed rule loses." },
];

export const words = {
  tree: "Features",
  cancelled: "Cancelled",
  exports: { heading: "Export" },
  gallery: { heading: "Gallery of parts", open: (/** @type {string} */ title) => `Opened ${title}` },
};
