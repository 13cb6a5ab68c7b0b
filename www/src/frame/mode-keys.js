/**
 * Keys of the modes besides the figure, and of the lessons, for the sheet of all keys; each mode listens to its own.
 */
export const MODE_KEYS = [
  {
    heading: "Steps",
    rows: [
      { text: "One step forward or back", keys: ["PageDown", "PageUp"] },
      { text: "First and last step", keys: ["Home", "End"] },
      { text: "Play or pause", keys: ["Space"] },
      { text: "Next vertex, from the canvas", keys: ["ArrowRight", "ArrowLeft"] },
      { text: "Other curve, from the canvas", keys: ["ArrowUp", "ArrowDown"] },
      { text: "Settle a prediction", keys: ["Enter"] },
      { text: "Follow the algorithm again", keys: ["Escape"] },
    ],
  },
  {
    heading: "Compare",
    rows: [
      { text: "Other method", keys: ["ArrowRight", "ArrowLeft", "ArrowUp", "ArrowDown"] },
      { text: "First and last method", keys: ["Home", "End"] },
      { text: "Light the next line in every picture", keys: ["PageDown", "PageUp"] },
      { text: "Go on working with the method", keys: ["Enter"] },
      { text: "Light no line", keys: ["Escape"] },
    ],
  },
  {
    heading: "Solid",
    rows: [
      { text: "Go round the body, from the picture", keys: ["ArrowRight", "ArrowLeft", "ArrowUp", "ArrowDown"] },
      { text: "Move it, from the picture", keys: ["Shift+\u2190\u2191\u2192\u2193"] },
      { text: "Nearer, farther", keys: ["+", "-"] },
      { text: "Fit the body", keys: ["F"] },
      { text: "From a corner, the front, the side, above", keys: ["5", "6", "7", "8"] },
      { text: "Build the body up", keys: ["Space"] },
      { text: "Read the place in the middle, end the reading", keys: ["Enter", "Escape"] },
    ],
  },
  {
    heading: "Hyperpatch",
    rows: [
      { text: "Next corner, corner before, from the picture", keys: ["PageDown", "PageUp"] },
      { text: "Move the chosen corner along x and y", keys: ["ArrowRight", "ArrowLeft", "ArrowUp", "ArrowDown"] },
      { text: "Raise and lower it along z", keys: ["Home", "End"] },
      { text: "Go round the body where no corner is chosen", keys: ["ArrowRight", "ArrowLeft", "ArrowUp", "ArrowDown"] },
      { text: "Choose nothing", keys: ["Escape"] },
    ],
  },
  {
    heading: "Part",
    rows: [
      { text: "Move the crosshair of the reader", keys: ["ArrowRight", "ArrowLeft", "ArrowUp", "ArrowDown"] },
      { text: "Say again what it reads, end the reading", keys: ["Enter", "Escape"] },
      { text: "Next row of the feature list", keys: ["ArrowDown", "ArrowUp"] },
      { text: "Move a feature or a body in the list", keys: ["Alt+ArrowUp", "Alt+ArrowDown"] },
      { text: "Rename, delete in the list", keys: ["F2", "Delete"] },
      { text: "Next key of a profile, add one, delete it", keys: ["PageDown", "Insert", "Delete"] },
      { text: "Other rule, of the three side by side", keys: ["ArrowRight", "ArrowLeft"] },
      { text: "Move what all three read", keys: ["Shift+\u2190\u2191\u2192\u2193"] },
    ],
  },
  {
    heading: "Laplace",
    rows: [
      { text: "Compare solvers, back to the solution", keys: ["C"] },
      { text: "Give the chosen group what is tapped", keys: ["P"] },
      { text: "Go round the body, or move the crosshair of the reader in the plane", keys: ["ArrowRight", "ArrowLeft", "ArrowUp", "ArrowDown"] },
      { text: "Read the place in the middle, end the reading", keys: ["Enter", "Escape"] },
      { text: "Move the plane of the section, from its handle", keys: ["ArrowUp", "ArrowDown", "PageUp", "PageDown"] },
      { text: "Read a plot, from the plot", keys: ["ArrowRight", "ArrowLeft", "Home", "End"] },
    ],
  },
  {
    heading: "Lessons",
    rows: [
      { text: "Next step, step before", keys: ["ArrowRight", "ArrowLeft", "PageDown", "PageUp"] },
      { text: "Present, end the presentation", keys: ["P", "Escape"] },
      { text: "Reset the figure", keys: ["R"] },
    ],
  },
];
