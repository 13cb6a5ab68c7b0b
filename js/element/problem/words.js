/** What a figure of a boundary value problem says to a person. */
export const words = {
  plane: "Problem in the plane",
  space: "Problem in space",
  section: "Section of a solution in space",
  elements: (/** @type {number} */ count, /** @type {2 | 3} */ dimension) => `${count} ${dimension === 3 ? (count === 1 ? "triangle" : "triangles") : count === 1 ? "segment" : "segments"}`,
  solved: "solved",
  notConverged: "not converged",
  iterations: (/** @type {number} */ count) => (count === 0 ? "by elimination" : count === 1 ? "1 iteration" : `${count} iterations`),
  named: (/** @type {string} */ title, /** @type {string[]} */ facts) => `${title ? `${title}: ` : ""}${facts.join(", ")}.`,
};
