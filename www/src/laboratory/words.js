/**
 * What a person reads in the solver laboratory.
 *
 * @import { Side } from "../space/box-mark.js"
 */

const elements = (/** @type {number} */ count, /** @type {2 | 3} */ dimension) =>
  dimension === 3 ? (count === 1 ? "triangle" : "triangles") : count === 1 ? "segment" : "segments";

export const words = {
  region: "Groups of the problem",
  loading: "Working…",
  picture: (/** @type {string} */ title, /** @type {string} */ summary) => `${title || "Problem"}. ${summary}`,
  look: { label: "Laboratory", solution: "Solution", solvers: "Compare solvers" },
  kinds: {
    plane: ["Problem in the plane", "2D: segments round an area. Nothing of it is a cut through a body."],
    space: ["Problem in space", "3D: triangles round a body."],
    section: ["Section of a solution in space", "3D: triangles round a body, shown on one plane through it."],
  },
  keyboard: "Picture of the problem",
  keyboardHelp:
    "Arrow keys go round the body, with Shift they move it. Plus and minus zoom, F fits, 5 to 8 are standard views. Enter reads the place in the middle, Escape ends that. The plane of the section has a handle of its own.",
  planeHelp: "Arrow keys move a crosshair that reads the solution, with Shift far, with Alt finely. Escape ends the reading. Plus and minus zoom, F fits.",
  noWebGl: "This browser shows no 3D pictures here: WebGL 2 is missing or switched off. Numbers, conditions and the comparison of solvers work all the same.",
  lost: "The graphics card has dropped the picture. It comes back by itself, or when the page is loaded again.",
  cancelled: "Cancelled",
  tryAgain: "Try again",
  cancel: "Cancel",
  zoom: { region: "Zoom", in: "Zoom in", out: "Zoom out", fit: "Fit the body" },

  model: {
    heading: "Body",
    kind: "Shape",
    kinds: /** @type {{[kind: string]: string}} */ ({
      cube: "Cube",
      "sliver-cube": "Cube with slivers",
      "hollow-box": "Hollow box",
      shell: "Shell of spheres",
      sphere: "Sphere",
      mug: "Mug",
      cylinder: "Cylinder",
      "fillet-block": "Block with fillets",
      square: "Square (plane)",
      annulus: "Annulus (plane)",
      mesh: "Triangles of a file",
    }),
    fields: /** @type {{[field: string]: string}} */ ({
      divisions: "Divisions",
      width: "Sliver width",
      wall: "Wall",
      inner: "Inner radius",
      outer: "Outer radius",
      level: "Refinement",
      radius: "Radius",
      sectors: "Sectors",
      sliver: "Sliver width",
      segments: "Segments",
    }),
    none: "none",
    import: "Import STL…",
    importNote: "A closed STL of your own, binary or text. It can be dropped on the picture as well.",
    imported: (/** @type {string} */ name, /** @type {string} */ count, /** @type {string} */ told) => `${name}: ${count} triangles. ${told}`,
    tooLarge: (/** @type {number} */ size, /** @type {number} */ most) => `it has ${size} MiB; expected at most ${most}`,
    refused: (/** @type {string} */ name, /** @type {string} */ reason) => `${name} was not opened: ${reason}`,
    count: "Elements",
    size: (/** @type {2 | 3} */ dimension) => (dimension === 3 ? "Volume" : "Area"),
    elements,
    phrase: (/** @type {string} */ name, /** @type {string} */ count, /** @type {string} */ what) => `${name} · ${count} ${what}`,
  },

  first: {
    /** The ends of a body along x, y and z. */
    ends: [
      ["left end", "right end"],
      ["front end", "back end"],
      ["lower end", "upper end"],
    ],
    two: (/** @type {string[][]} */ ends) => `A first problem is set: ${ends.map(([material, end]) => `${material} at the ${end}`).join(", ")}, everything else insulated.`,
    undo: (/** @type {string} */ told) => `${told} Undo brings the former body back.`,
    one: (/** @type {string} */ material) => `A first problem is set: ${material} everywhere.`,
  },

  boundary: {
    heading: "Boundary",
    list: "Boundary groups",
    rest: "Everything else",
    add: "Add group",
    name: "Name",
    group: (/** @type {number} */ nth) => `group ${nth}`,
    about: (/** @type {string} */ name, /** @type {string} */ message) => `${name}: ${message}`,
    remove: "Delete group",
    turn: "Turn all triangles over",
    condition: "Condition",
    kinds: { value: "Value", flux: "Flux", insulated: "Insulated" },
    kindsOfRest: { none: "None", value: "Value", flux: "Flux", insulated: "Insulated" },
    formula: "Formula",
    formulaNote: "Numbers or formulas of x, y, z and r, one for each material; they have to sum to 1.",
    fluxNote: "Outward flux of each material; the fluxes have to sum to 0.",
    flux: (/** @type {string} */ name) => `Flux of ${name}`,
    where: "Elements",
    by: { direction: "Facing", box: "In a box", both: "Facing, in a box", positive: "By a formula", elements: "Listed" },
    direction: "Facing",
    angle: "Within",
    box: ["Box from", "to"],
    positive: "Where this is above 0",
    positiveNote: "A formula of x, y, z and r, the distance to the z axis, at the middle of each element.",
    listed: (/** @type {number} */ runs) => (runs === 1 ? "1 run of elements" : `${runs} runs of elements`),
    pick: "Pick in the picture",
    picks: { direction: "All facing alike", patch: "Connected patch" },
    picking: "Tap the boundary: the group becomes what lies round the place, within the angle. Escape ends it.",
    picked: (/** @type {number} */ count) => (count === 1 ? "1 element" : `${count} elements`),
    count: (/** @type {string} */ count, /** @type {string} */ area) => `${count} · ${area}`,
    phrase: (/** @type {number} */ count) => (count === 1 ? "1 group" : `${count} groups`),
    none: "Tap a group to change it.",
    axes: ["x", "y", "z"],
  },

  box: {
    label: (/** @type {Side} */ { axis, end }) => `Box, ${"xyz"[axis]} ${end === "min" ? "from" : "to"}`,
    value: (/** @type {Side} */ { axis, end }, /** @type {string} */ place) => `${"xyz"[axis]} ${end === "min" ? "from" : "to"} ${place}`,
    /** `count`: elements of the group; null where that is not known yet. */
    said: (/** @type {Side} */ side, /** @type {string} */ place, /** @type {number | null} */ count) =>
      `${words.box.value(side, place)}${count === null ? "" : `, ${words.boundary.picked(count)}`}`,
  },

  solver: {
    heading: "Solver",
    method: "Method",
    methods: { gmres: "GMRES", lu: "LU" },
    preconditioner: "Precondition",
    preconditioners: { none: "None", jacobi: "Jacobi", ssor: "SSOR" },
    omega: "ω of SSOR",
    tolerance: "Tolerance",
    tolerances: { "0.0001": "1 × 10⁻⁴", "0.000001": "1 × 10⁻⁶", "1e-8": "1 × 10⁻⁸", "1e-10": "1 × 10⁻¹⁰" },
    restart: "Restart after",
    mostLu: "LU takes up to 2000 elements.",
    phrase: (/** @type {string} */ method, /** @type {string} */ preconditioner) => (preconditioner ? `${method} · ${preconditioner}` : method),
    compare: "Compare solvers",
  },

  section: {
    heading: "Section",
    axis: "Across",
    axes: { off: "Off", x: "x", y: "y", z: "z", own: "View" },
    at: "Place",
    field: "Place of the section plane",
    handle: "Plane of the section",
    other: "Show the other side",
    off: "off",
    none: "A problem in the plane is no section of anything: what is seen is the whole of it.",
    value: (/** @type {string} */ axis, /** @type {string} */ place) => (axis === "own" ? `${place} along its normal` : `${axis} = ${place}`),
    area: "Area cut",
    pixels: "Pixels",
    note: "The face shows the solution inside, unlit: fractions mixed to colours.",
  },

  display: {
    heading: "Display",
    color: "Boundary",
    colors: { given: "Given", solved: "Solved" },
    edges: "Edges of elements",
    light: "Light",
    lines: "Lines of",
    off: "none",
    noLines: "no lines",
    linesOf: (/** @type {string} */ name) => `lines of ${name}`,
    given: "Conditions as they are given; grey and hatched where a flux is.",
    solved: "The composition that was found on each element.",
  },

  materials: {
    heading: "Materials",
    add: "Add material",
    remove: "Delete material",
    used: "A condition holds some of it",
    fewest: "A composition has two materials at least",
    note: "All share one matrix: each material but the last is solved for, and the last follows from the others.",
  },

  show: {
    views: { iso: "Corner", front: "Front", side: "Side", top: "Top" },
    viewsLong: { iso: "Seen from a corner", front: "Seen from the front", side: "Seen from the side", top: "Seen from above" },
    view: "Standard views",
  },

  card: {
    inside: "inside",
    element: (/** @type {number} */ index) => `element ${index}`,
    group: "group",
    flux: (/** @type {string} */ name) => `flux of ${name}`,
    error: "error",
  },

  status: {
    verified: "Solved",
    elements,
    iterations: "iterations",
    residual: "true residual",
    closure: "closure",
    balance: "flux balance",
    clamped: "clamped",
    error: "error",
    ms: "ms",
    show: "Shows where",
    notConverged: (/** @type {number} */ iterations) => `Not converged after ${iterations} iterations`,
    imbalance: (/** @type {string} */ share) => `${share} of the flux was missing and is spread evenly`,
    lu: "elimination",
  },

  faults: /** @type {{[code: string]: (count: number) => string}} */ ({
    missing: (count) => (count === 1 ? "1 element has no condition" : `${count} elements have no condition`),
    conflict: (count) => (count === 1 ? "1 element in two groups" : `${count} elements in two groups`),
  }),

  spoken: {
    fitted: "The whole body",
    zoomed: (/** @type {string} */ share) => `Zoom ${share}`,
    turned: (/** @type {string} */ azimuth, /** @type {string} */ elevation) => `Seen from ${azimuth}°, ${elevation}° above`,
    nothing: "Nothing of the problem here",
    reading: (/** @type {string[]} */ parts) => parts.join(", "),
    both: (/** @type {string} */ first, /** @type {string} */ second) => `${first}. ${second}`,
    summary: (/** @type {string[]} */ parts) => `${parts.join(", ")}.`,
  },

  legend: { flux: "given flux", insulated: "insulated" },

  gallery: { heading: "Problems", open: (/** @type {string} */ title) => `Opened ${title}` },

  exports: {
    heading: "Export",
    json: ["Document", "JSON, opens here again"],
    elements: ["Boundary, CSV", "centre, area, group, fractions and fluxes of every element"],
    section: ["Section, CSV", "fractions on the pixels of the plane"],
    tooLarge: "The graphics card draws no picture of that size.",
    noPicture: "There is no picture of the problem now.",
    noSolution: "There is no solution to be written now.",
    done: (/** @type {string} */ name) => `${name} is written`,
  },
};
