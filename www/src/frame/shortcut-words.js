/** Headings of the sheet of all keys, by the topics of the commands, in the order of the sheet. */
export const TOPICS = {
  document: "Document",
  mode: "Modes",
  view: "View and grid",
  draw: "Drawing",
  select: "Selection",
  points: "Points and curves",
  frame: "Frame of a selection",
  reading: "Reading of ruling lines",
  fields: "Number fields",
};
