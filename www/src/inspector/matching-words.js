/** Words of the matching group. */
import { plural } from "../strings.js";

export const words = {
  method: "Method",
  methods: {
    integral: "Exact, maximise J",
    sum: "Exact, largest sum",
    "sum-less-price": "Exact, sum less a price",
    greedy: "Greedy",
    "one-per-vertex": "One per vertex",
    shift: "Shift",
    parameter: "Same parameter",
  },
  /** What each method is, in one line below it. */
  about: {
    integral: "",
    sum: "The most value in all lines together; many lines add up.",
    "sum-less-price": "Each line has to earn its price.",
    greedy: "Best line first, as the papers grow them. A heuristic.",
    "one-per-vertex": "The papers' dynamic programme: at most one line a sample.",
    shift: "Sample to sample, turned by a fixed number of samples.",
    parameter: "Sample to sample by number, as lofting tools do.",
  },
  pinsDropped: (/** @type {number} */ count) =>
    `${plural(count, "pin was", "pins were")} removed: only exact methods keep pins`,
  price: "Price of a line",
  shift: "Shift",
  shiftBy: { best: "Best", number: "Number" },
  shiftField: "Shift in samples",
  rules: "Rules",
  repaired: "Repaired",
  asPrinted: "As printed",
  single: "Single rules as printed",
  printed: {
    normals: "Second normal inwards",
    negative: "Negative products as c^w",
    heights: "Heights ignored",
    order: "Order by index interval",
    removal: "Lowest line removed first",
    stop: "Stop at the best line again",
    stages: "Stages counted from the second curve",
  },
  normalWeight: "Normal weight",
  distanceWeight: "Distance weight",
  more: "Single rules, alignment, negative",
  alignmentWeight: "Alignment",
  alignmentField: "Alignment weight",
  negative: "Negative",
  negativeField: "Negative products",
  signed: "Signed",
  clamp: "Clamp",
  half: "Half",
  infeasible: "If infeasible",
  strict: "Strict",
  repair: "Repair",
  ends: "Ends",
  tied: "Tied",
  free: "Free",
  lines: "Lines",
  oneToOne: "one to one",
  count: "Number of one-to-one lines",
  /** The plot of v over u. */
  correspondence: {
    over: "over",
    pairs: (/** @type {number} */ count) => plural(count, "one-to-one line", "one-to-one lines"),
    lines: (/** @type {number} */ count) => plural(count, "line", "lines"),
    off: (/** @type {string} */ share) => `up to ${share}\u00a0% off the diagonal`,
    name: (/** @type {string} */ lines, /** @type {string} */ off, /** @type {number} */ gaps) =>
      `Plot of v over u for ${lines}: v rises with u all round and departs from equal shares of the parameters by at most ${off} %` +
      (gaps > 0 ? `; ${plural(gaps, "gap keeps", "gaps keep")} lines that share ends.` : "."),
  },
};
