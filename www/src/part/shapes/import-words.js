/** Every word of importing shapes into a part. */
import { plural } from "../../strings.js";

export const words = {
  as: "As",
  polygon: "Polygons",
  curve: "Curves",
  use: "For",
  reference: "Reference",
  body: "Bodies",
  hole: "Holes",
  center: "In the middle of the part",
  points: (/** @type {number} */ count) => plural(count, "point", "points"),
  add: (/** @type {number} */ count) => (count === 0 ? "Add" : `Add ${plural(count, "shape", "shapes")}`),
  choose: "Choose the shapes to add.",
  nested: "Shapes that lie in others become their holes.",
  noBody: "There is no body to cut them out of.",
  mostShapes: "A part has 500 shapes at most.",
  mostPoints: "The shapes of a part have 10 000 points at most; a larger tolerance takes fewer.",
  added: (/** @type {number} */ count) => `Added ${plural(count, "shape", "shapes")}`,
};
