/** Words of drawing an open curve. */
export const words = {
  finish: "Finish",
  leave: "Leave open",
  more: "Click on; 1 more point to finish.",
  close: "Click on, or finish with Enter or a double click.",
  touchMore: "Tap on; 1 more point to finish.",
  touchClose: "Tap on, or finish with the button.",
  either: "Click on, close with Enter or a click on the first point, or leave it open with Shift and Enter.",
  touchEither: "Tap on, close with a tap on the first point, or leave it open.",
  stroke: "Press, draw one line from end to end, and let go.",
  tooShort: "That line is too short. Press and draw from end to end.",
};
