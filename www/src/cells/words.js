/** What unit cells and amounts of materials say. */
const NARROW = "\u00a0";

/** @param {string} unit */
export const square = (unit) => (unit === "" ? "" : `${unit}²`);

export const words = {
  table: "Unit cells",
  content: "Content",
  contents: { document: "Document", cells: "Unit cells" },
  notes: {
    csv: "One row for each unit cell: corners, area, centroid, and its mean mix.",
    json: "Unit cells with corners, area, centroid and mean mix, and the amount of each material.",
  },
  none: "there are no unit cells, because the matching is not complete",

  caption: (/** @type {string} */ unit) => `Area of the band and what each material has of it${unit === "" ? "" : `, in ${square(unit)}`}`,
  share: (/** @type {string} */ percent) => `${percent}${NARROW}%`,
  void: (/** @type {string} */ name) => `${name} (empty)`,
  body: "Body",
  band: "Band",
  projected: "In the plane: the curves lie at different heights.",
  folded: (/** @type {number} */ lines) =>
    `Lines meet after ${lines === 1 ? "one of them" : `${lines} of them`}: what is turned over there is taken off.`,
};
