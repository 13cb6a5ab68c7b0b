/**
 * Presets in the order of the list: what each is there for.
 * @type {readonly {id: string, file: string, line: string}[]}
 */
export const PRESETS = [
  { id: "laplace-cube", file: "cube", line: "One material above, half of it below: its series is known, so every error is." },
  { id: "laplace-mug", file: "mug", line: "Slivers as CAD systems make them: without a preconditioner nothing converges." },
  { id: "laplace-shell", file: "shell", line: "Between two spheres the exact solution is A + B/r." },
  { id: "laplace-hollow-box", file: "hollow-box", line: "Opposite walls are close, and SSOR is worse than nothing." },
  { id: "laplace-fillet-block", file: "fillet-block", line: "Two ends have materials; through the rest nothing flows." },
  { id: "laplace-cylinder", file: "cylinder", line: "A formula on the top, carried inside." },
  { id: "laplace-square", file: "square", line: "The cube in the plane, and not a cut through it." },
  { id: "laplace-annulus", file: "annulus", line: "Between two circles the exact solution is A + B ln r." },
];
