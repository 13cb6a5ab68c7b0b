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
    heading: "Lessons",
    rows: [
      { text: "Next step, step before", keys: ["ArrowRight", "ArrowLeft", "PageDown", "PageUp"] },
      { text: "Present, end the presentation", keys: ["P", "Escape"] },
      { text: "Reset the figure", keys: ["R"] },
    ],
  },
];
