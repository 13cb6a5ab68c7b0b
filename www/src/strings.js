/**
 * Every word the page shows or speaks, in one place; only what must be shown without scripts stands in index.html.
 * Functions take what changes.
 */

/** @param {number} count @param {string} one @param {string} many */
const plural = (count, one, many) => `${count} ${count === 1 ? one : many}`;

/** A curve's name inside a sentence: "Inner" becomes "inner", "U" stays. @param {string} name */
export const inSentence = (name) => (/^.\p{Ll}/u.test(name) ? `${name.charAt(0).toLowerCase()}${name.slice(1)}` : name);

/** @type {{[degree: number]: string}} */
const DEGREES = { 2: "quadratic", 3: "cubic", 4: "quartic", 5: "quintic" };

export const strings = {
  app: "Directrix",
  workbench: "Curves",
  untitled: "Untitled",

  bar: {
    workbenches: "Workbenches",
    title: "Document title",
    edited: "Edited",
    saved: "Saved",
    undo: "Undo",
    redo: "Redo",
    gallery: "Gallery",
    file: "File",
    export: "Export",
    menu: "Menu",
    panel: "Settings",
    toDark: "Use the dark theme",
    toLight: "Use the light theme",
  },

  file: {
    open: "Open or import…",
    save: "Save",
    saveCopy: "Save a copy…",
    openKind: "Documents and drawings",
    saveKind: "Directrix document",
    chosen: "the file",
    saved: (/** @type {string} */ file) => `Saved ${file}`,
    copied: (/** @type {string} */ file) => `Saved a copy as ${file}`,
    notAllowed: "the page may not write to it",
  },

  exports: {
    svg: "Picture as SVG",
    png: "Picture as PNG",
    json: "Document as JSON",
  },

  canvas: {
    region: "Figure",
    picture: (/** @type {string} */ title) => `${title}: two curves, their ruling lines and the material between them`,
    zoomIn: "Zoom in",
    zoomOut: "Zoom out",
    fit: "Fit the figure (F)",
    zoom: "Zoom",
    probe: "Ruling lines",
    probeHelp: "Left and right go from one ruling line to the next, up and down along it. Escape closes the reading.",
    drop: "Drop a document to open it",
  },

  handles: {
    group: (/** @type {string} */ curve) => `Control points of ${curve}`,
    help:
      "Arrow keys move the point, with Shift ten times as far, with Alt a tenth. Page up and page down go to the " +
      "previous and the next point, Home takes the whole curve. Insert adds a point after this one, Delete removes " +
      "it, Escape takes the move back.",
    point: (/** @type {string} */ name, /** @type {string} */ x, /** @type {string} */ y) => `${name}, x ${x}, y ${y}`,
    curve: (/** @type {string} */ name, /** @type {string} */ x, /** @type {string} */ y) =>
      `Whole curve ${name}, centre x ${x}, y ${y}`,
    inserted: (/** @type {string} */ name) => `Added ${name}`,
    removed: (/** @type {string} */ name) => `Removed ${name}`,
    tooFew: (/** @type {number} */ degree) => `A curve of degree ${degree} keeps at least ${degree + 1} points`,
  },

  curves: {
    heading: "Curves",
    inner: "Inner",
    outer: "Outer",
    shape: (/** @type {number} */ degree, /** @type {number} */ points) =>
      `${DEGREES[degree] ?? `degree ${degree}`} · ${plural(points, "point", "points")}`,
    phrase: (/** @type {number} */ a, /** @type {number} */ b) => `${a} and ${b} points`,
    point: (/** @type {string} */ name) => `Point ${name}`,
    center: "Centre",
    name: "Name, height",
    nameField: "Curve name",
    height: "Height",
    add: "Add point",
    addHelp: "Add a control point, keeping the shape",
    remove: "Remove point",
    removeHelp: "Remove the selected control point",
    removeNone: "Select a control point first",
  },

  sampling: {
    heading: "Sampling",
    scheme: "Scheme",
    arcLength: "Arc length",
    parameter: "Parameter",
    counts: "Samples",
    count: (/** @type {string} */ curve) => `Samples on ${curve}`,
    phrase: (/** @type {string} */ scheme, /** @type {number} */ a, /** @type {number} */ b) =>
      `${scheme} · ${a} : ${b}`,
  },

  matching: {
    heading: "Matching",
    method: "Method",
    greedy: "Greedy growth",
    normalWeight: "Normal weight",
    distanceWeight: "Distance weight",
    alignmentWeight: "Alignment",
    alignmentField: "Alignment weight",
    negative: "Negative",
    negativeField: "Negative products",
    signed: "Signed",
    clamp: "Clamp",
    half: "Half",
    phrase: (/** @type {string} */ normal, /** @type {string} */ distance) => `greedy · ${normal}, ${distance}`,
  },

  blend: {
    heading: "Blend",
    stages: "Stages",
    phrase: (/** @type {number} */ stages) => `${plural(stages, "stage", "stages")} · Oklab`,
  },

  materials: {
    heading: "Materials",
    color: (/** @type {string} */ name) => `Colour of ${name}`,
    name: (/** @type {number} */ index) => `Name of material ${index + 1}`,
    on: (/** @type {string} */ curve, /** @type {string} */ name) => `${curve} curve: ${name}`,
    add: "Add material",
    remove: (/** @type {string} */ name) => `Remove ${name}`,
    fresh: (/** @type {number} */ index) => `Material ${index + 1}`,
    along: (/** @type {string} */ curve) => `composition along the ${inSentence(curve)} curve`,
    stops: (/** @type {number} */ count) => plural(count, "stop", "stops"),
    phrase: (/** @type {string[]} */ names) => (names.length > 3 ? `${names.length} materials` : names.join(", ")),
  },

  layers: {
    heading: "Layers",
    phrase: (/** @type {number} */ shown, /** @type {number} */ all) => `${shown} of ${all}`,
    names: {
      material: "Material",
      rulingLines: "Ruling lines",
      inBetweens: "In-betweens",
      samples: "Samples",
      controlPoints: "Control points",
      normals: "Normals",
      grid: "Grid",
      value: "Value",
      unitCells: "Unit cells",
      unconnected: "Unconnected",
    },
  },

  morph: {
    region: "Morph",
    play: "Play",
    pause: "Pause",
    step: "Next stage",
    slider: "Place between the curves",
    stage: (/** @type {number} */ stage, /** @type {number} */ of) => `stage ${stage} of ${of}`,
    between: (/** @type {number} */ stage, /** @type {number} */ of) => `after stage ${stage} of ${of}`,
    spoken: (/** @type {string} */ s, /** @type {string} */ stage) => `s ${s}, ${stage}`,
  },

  probe: {
    line: (/** @type {number} */ line) => `Line ${line}`,
    value: "value",
    cosine: "normals, cos",
    length: "length",
    spoken: (/** @type {string[]} */ parts) => parts.join(", "),
  },

  status: {
    region: "Certificates",
    verified: "Verified",
    problems: (/** @type {number} */ count) => plural(count, "problem", "problems"),
    lines: (/** @type {number} */ count) => (count === 1 ? "line" : "lines"),
    mean: "mean",
    crossings: "crossings",
    blocked: "blocked",
    uncovered: "uncovered",
    ms: "ms",
    show: (/** @type {string} */ what) => `Show ${what}`,
    heuristic: "heuristic, gap unknown",
    working: "Working",
    cancel: "Cancel",
    cancelled: "Cancelled. The last picture stays.",
    tryAgain: "Try again",
    loading: "Loading",
  },

  advice: {
    notCovered: (/** @type {number} */ a, /** @type {number} */ b) =>
      `Not covered: ${a} + ${b} vertices. Raise the samples or move the curves apart.`,
    orphan: "Some vertices see nothing of the other curve. Move a point, or raise the samples.",
    stuck: "The growth came to a dead end. Raise the samples or change a weight.",
    disjoint: "No line connects the two curves. Move one nearer to the other.",
    crossing: "Some lines cross. Raise the samples.",
    "coarse-sampling": "The samples are too coarse for this shape. Raise them.",
    corner: "A corner has no single normal; its bisector is used.",
    "opposed-normals": "Some lines join normals that point against each other.",
  },

  errors: {
    selfIntersection: (/** @type {string} */ curve, /** @type {string} */ where) =>
      `${curve} crosses itself${where}. Move a point, or undo.`,
    contact: (/** @type {string} */ where) =>
      `The two curves touch${where}. Move one away, give them different heights, or undo.`,
    near: (/** @type {string} */ x, /** @type {string} */ y) => ` near (${x}, ${y})`,
    curve: (/** @type {string} */ name) => `The ${inSentence(name)} curve`,
    aCurve: "A curve",
    zeroLength: "A curve has no length. Move a point, or undo.",
    document: (/** @type {string} */ path, /** @type {string} */ message) =>
      path && !message.startsWith(path) ? `${path}: ${message}` : message,
    trap: "The computation stopped unexpectedly and was started again. Your document is unchanged.",
    open: (/** @type {string} */ file, /** @type {string} */ reason) =>
      `Could not open ${file}: ${reason}. The open document is unchanged.`,
    notJson: "it is not JSON",
    export: (/** @type {string} */ reason) => `Could not export: ${reason}.`,
    save: (/** @type {string} */ file, /** @type {string} */ reason) =>
      `Could not save ${file}: ${reason}. Save a copy elsewhere.`,
  },

  field: {
    notNumber: "Enter a number",
    range: (/** @type {string} */ low, /** @type {string} */ high) => `Enter a number from ${low} to ${high}`,
    whole: (/** @type {string} */ low, /** @type {string} */ high) => `Enter a whole number from ${low} to ${high}`,
  },

  panel: {
    close: "Close",
  },

  sheet: {
    resize: "Resize the panel",
    tabs: "Groups",
    region: "Settings",
  },
};
