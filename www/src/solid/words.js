/** What the picture of the solid says. */

/** @param {string} name */
const inSentence = (name) => (/^.\p{Ll}/u.test(name) ? `${name.charAt(0).toLowerCase()}${name.slice(1)}` : name);

export const words = {
  picture: (/** @type {string} */ title, /** @type {string} */ text) => `${title} in three dimensions: ${text}`,
  keyboard: "Solid",
  keyboardHelp:
    "Arrow keys go round the body, with Shift they move it, with Alt they go finely. Plus and minus zoom, F fits. 5 to 8 choose a view. Enter " +
    "reads the place in the middle of the picture, Escape ends the reading. Space builds the body up.",
  loading: "Loading",
  working: "Working",
  cancel: "Cancel",
  cancelled: "Cancelled. The last picture stays.",
  tryAgain: "Try again",

  noWebGl:
    "This browser draws nothing in three dimensions here: WebGL 2 is missing or switched off. The numbers beside, and the export of STL, PLY and OBJ, work all the same.",
  lost: "The graphics card was taken away. The picture comes back with it.",
  needsTwo: "A solid needs two curves.",
  level: (/** @type {string} */ height) => `All curves lie at the height ${height}. Give one of them another, and the surface between them rises.`,
  raise: (/** @type {string} */ curve, /** @type {string} */ by) => `Raise ${inSentence(curve)} by ${by}`,
  raised: (/** @type {string} */ curve, /** @type {string} */ by) => `Raised ${inSentence(curve)} by ${by}`,
  unmatched: "The curves are not matched completely, so nothing joins them.",

  groups: { region: "Groups of the solid", body: "Body", heights: "Heights", show: "Show", section: "Section" },

  body: {
    size: "Size",
    volume: "Volume",
    area: "Area",
    triangles: "Triangles",
    twist: "Greatest twist",
    flank: "Greatest flank angle",
    none: "no body",
    phrase: (/** @type {string[]} */ sides, /** @type {string} */ unit) => `${sides.join(" × ")}\u00a0${unit}`.trim(),
    open: "an open surface has no volume",
  },

  heights: {
    of: (/** @type {string} */ curve) => `Height of ${curve}`,
    phrase: (/** @type {string[]} */ heights) => heights.join(", "),
    note: "Heights count in the lengths of ruling lines, so that the matching may change with them.",
    inSpace: "in space",
    space: "Points of a curve have heights of their own.",
  },

  show: {
    color: "Colour",
    colors: { material: "Material", fraction: "One fraction", twist: "Twist", flank: "Flank angle" },
    material: "Fraction of",
    layers: {
      rulings: "Ruling lines",
      stages: "Stages",
      curves: "Curves",
      caps: "Caps",
      light: "Light",
      wireframe: "Wireframe",
    },
    view: "View",
    views: { iso: "Iso", front: "Front", side: "Side", top: "Top" },
    viewsLong: { iso: "From a corner", front: "From the front", side: "From the side", top: "From above" },
    notes: {
      material: "",
      fraction: "",
      twist: "Twist: the angle between the tangents of the curves at the two ends of a ruling line.",
      flank: "Flank angle: between the normals of the surface at the two ends of a ruling line; 0 where a cylinder mills it exactly.",
    },
  },

  section: {
    axis: "Across",
    axes: { off: "Off", x: "x", y: "y", z: "z", view: "View" },
    at: "Place",
    field: "Place of the section",
    other: "Other side",
    handle: "Section plane",
    value: (/** @type {string} */ axis, /** @type {string} */ at) => (axis === "view" ? `${at} from the middle` : `${axis} = ${at}`),
    off: "off",
    note: "The outline of the cut has the colours of the surface. The document gives no composition inside, so the face is hatched.",
    openNote: "The outline of the cut has the colours of the surface. It bounds no body, so there is no face.",
  },

  upTo: {
    region: "Build-up",
    slider: "Built up to",
    play: "Build up",
    pause: "Pause",
    step: "Next stage",
    stage: (/** @type {number} */ stage, /** @type {number} */ of) => `stage ${stage} of ${of}`,
    between: (/** @type {number} */ stage, /** @type {number} */ of) => `after stage ${stage} of ${of}`,
    notFlat: "It needs flat curves whose heights rise from one to the next",
  },

  zoom: { region: "Camera", in: "Nearer", out: "Farther", fit: "Fit the body" },

  read: {
    cap: (/** @type {string} */ curve) => `Cap of ${inSentence(curve)}`,
    twist: "twist",
    flank: "flank angle",
    nothing: "Nothing there",
    inside: "Inside, no composition is given",
  },

  legend: {
    fraction: (/** @type {string} */ name) => `fraction of ${name}`,
    twist: "twist",
    flank: "flank angle",
  },

  angles: (/** @type {string} */ name, /** @type {string} */ low = "", /** @type {string} */ high = "") => `${name}, ${low}° to ${high}°`,

  status: {
    watertight: "Watertight",
    open: "Open surface",
    leaks: "Not watertight",
    size: "size",
    volume: "volume",
    area: "area",
    triangles: (/** @type {number} */ count) => (count === 1 ? "triangle" : "triangles"),
    twist: "twist to",
    flank: "flank angle to",
    ms: "ms",
    projected: (/** @type {string} */ deviation) => `matched in the best-fit plane, curves up to ${deviation} off it`,
  },

  spoken: {
    summary: (/** @type {string[]} */ parts) => parts.join(", "),
    size: (/** @type {string[]} */ sides, /** @type {string} */ unit) => `${sides.join(" by ")} ${unit}`,
    volume: (/** @type {string} */ volume) => `volume ${volume}`,
    area: (/** @type {string} */ area) => `area ${area}`,
    twist: (/** @type {string} */ degrees) => `twist up to ${degrees} degrees`,
    flank: (/** @type {string} */ degrees) => `flank angle up to ${degrees} degrees`,
    view: (/** @type {string} */ view) => `Seen ${inSentence(view)}`,
    turned: (/** @type {string} */ azimuth, /** @type {string} */ elevation) => `Azimuth ${azimuth}, elevation ${elevation} degrees`,
    fitted: "The whole body",
    zoomed: (/** @type {string} */ percent) => `Zoom ${percent}`,
  },

  exports: {
    kind: "As",
    kinds: { stl: "STL", ply: "PLY", obj: "OBJ", png: "PNG" },
    color: "Colour",
    caps: "Caps",
    closed: "closed",
    download: "Download",
    copy: "Copy",
    copied: "The picture is copied",
    downloaded: (/** @type {string} */ file) => `Downloaded ${file}`,
    failed: (/** @type {string} */ reason) => `That did not work: ${reason}.`,
    notes: {
      stl: "Binary triangles. STL holds the shape alone, no colours.",
      ply: "Triangles with the colour of each vertex and its fractions.",
      obj: "Text, with the colour of each vertex after its coordinates.",
      png: "The solid as on screen, from where it was last seen. Sides up to 4096 pixels.",
    },
    tooLarge: "the graphics card draws no picture of that size",
    noPicture: "the browser made no picture",
  },
};
