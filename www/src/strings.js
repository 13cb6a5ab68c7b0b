/**
 * The words that the page shows or speaks from the beginning; what is fetched later brings its own (`words.js`), and what must be
 * shown without scripts stands in index.html. Functions take what changes.
 */

/** @param {number} count @param {string} one @param {string} many */
export const plural = (count, one, many) => `${count} ${count === 1 ? one : many}`;

/** A curve's name inside a sentence: "Inner" becomes "inner", "U" stays. @param {string} name */
export const inSentence = (name) => (/^.\p{Ll}/u.test(name) ? `${name.charAt(0).toLowerCase()}${name.slice(1)}` : name);

/** @type {{[degree: number]: string}} */
const DEGREES = { 2: "quadratic", 3: "cubic", 4: "quartic", 5: "quintic" };

/** What stands in the shortcut sheet and in tooltips: names of commands and of what is not a key. */
const commands = {
  new: "New",
  undo: "Undo",
  redo: "Redo",
  shortcuts: "Keyboard shortcuts",
  about: "About Directrix",
  share: "Share",
  figure: "Figure",
  steps: "Steps of the greedy growth",
  compare: "Compare methods",
  solid: "Solid in three dimensions",
  fit: "Fit the figure",
  zoomIn: "Zoom in",
  zoomOut: "Zoom out",
  pan: "Pan",
  wheel: "Zoom about the pointer",
  grid: "Grid",
  snap: "Snap to the grid",
  snapOn: "Snapping on",
  snapOff: "Snapping off",
  snapInvert: "Snap the other way while dragging",
  play: "Play or pause the morph",
  draw: "Draw a curve",
  drawSecond: "Draw the second curve",
  drawInside: "Draw a curve inside",
  drawOver: (/** @type {string} */ curve) => `Draw ${inSentence(curve)} anew`,
  drawPoint: "Set a point",
  drawMove: "Move the crosshair; with Shift far, with Alt finely",
  drawBack: "Take the last point back",
  drawClose: "Close the curve",
  drawCancel: "Give up the drawing",
  selectAll: "All points of the curve",
  selectCurve: "Whole curve",
  selectAdd: "Add a point or take it out",
  selectBox: "Points in a box",
  nextPoint: "Next and previous point",
  extend: "Add the next or previous point",
  nudge: "Move what is selected",
  nudgeFar: "Ten times as far, a tenth",
  takeBack: "Take the move back",
  insertPoint: "Add point",
  deletePoints: (/** @type {number} */ count) => (count === 1 ? "Remove point" : `Remove ${count} points`),
  duplicatePoint: "Double point",
  duplicateCurve: "Duplicate curve, nested",
  copyOver: (/** @type {string} */ curve) => `Copy over ${inSentence(curve)}`,
  rename: "Rename curve",
  swap: "Swap the curves",
  reverse: "Reverse direction",
  smooth: "Smooth corners",
  deleteCurve: "Delete curve",
  menu: "Commands for what is there",
  frameScale: "Scale by a handle of the frame",
  frameProportion: "Keep the proportion; turn in steps of 15°",
  frameCentre: "Scale about the centre",
  frameTurn: "Turn by 1°; with Shift 10°, with Alt 0.1°",
  frameNext: "Next and previous handle of the frame",
  readLine: "Next and previous ruling line",
  readAlong: "Along the line",
  readExplain: "Why this line",
  readClose: "Close the reading",
  fieldStep: "Step",
  fieldFar: "Ten steps, a tenth",
  fieldCommit: "Commit",
  fieldRestore: "Restore",
  needsTwo: "It needs two curves",
  duplicateInside: "Duplicate curve inside",
  addInside: "Add a curve inside",
  addCurve: "Add a curve at the end",
  insertCurve: "Insert a curve after this one",
  moveCurve: "Move the curve in the stack",
  sideBySide: "Curves of the harmonic blend lie side by side",
  lastCurve: "No curve follows this one",
  mostCurves: "A stack has at most 16 curves",
  needsCurve: "Select a curve first",
  noCorners: "It has no corner",
  planeOnly: "Not with curves in space",
  click: "Click",
  doubleClick: "Double click",
  doubleClickCurve: "Double click on a curve",
  rightClick: "Right click or long press",
  shiftClick: "Shift+Click",
  shiftDrag: "Shift+Drag",
  altDrag: "Alt+Drag",
  modDrag: "Ctrl+Drag",
  dragCanvas: "Drag",
  dragHandle: "Drag",
  turnWheel: "Wheel",
  arrows: "Arrows",
};

export const strings = {
  app: "Directrix",
  commands,

  untitled: "Untitled",

  bar: {
    workbenches: "Workbenches",
    curves: "Curves",
    part: "Part",
    hyperpatch: "Hyperpatch",
    laplace: "Laplace",
    lessons: "Lessons",
    title: "Document title",
    edited: "Edited",
    saved: "Saved",
    unkept: "Not saved",
    gallery: "Gallery",
    galleryItem: "Gallery…",
    file: "File",
    export: "Export",
    exportItem: "Export…",
    menu: "Menu",
    panel: "Settings",
    toDark: "Use the dark theme",
    toLight: "Use the light theme",
  },

  file: {
    open: "Open or import…",
    save: "Save",
    saveCopy: "Save a copy…",
    recent: "Recent documents…",
    openKind: "Documents and drawings",
    saveKind: "Directrix document",
    chosen: "the file",
    notAllowed: "the page may not write to it",
  },

  storage: {
    /** Why nothing was kept, by the name of the browser's error. */
    problem: (/** @type {string} */ name) =>
      name === "QuotaExceededError"
        ? "This browser has no room left to keep the document. Save it to a file."
        : "This browser does not keep the document here. Save it to a file.",
  },

  canvas: {
    region: "Figure",
    picture: (/** @type {string} */ title, /** @type {number} */ curves) =>
      `${title}: ${["no curve yet", "one curve", "two curves"][curves] ?? `${curves} curves`}${curves > 1 ? ", their ruling lines and the material between them" : ""}`,
    pointer: (/** @type {string} */ x, /** @type {string} */ y) => `x ${x}  y ${y}`,
    zoom: "Zoom and grid",
    probe: "Ruling lines",
    probeHelp: "Left and right go from one ruling line to the next, up and down along it. Enter says why it is one, Escape closes the reading.",
    drop: "Drop a document, a drawing or points to open them",
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
    phrase: (/** @type {number[]} */ counts) =>
      counts.length === 1 ? plural(counts[0], "point", "points") : counts.length === 0 ? "none" : counts.length > 2 ? `${counts.length} curves` : `${counts.join(" and ")} points`,
    one: "Curve",
    nth: (/** @type {string} */ letter) => `Curve ${letter}`,
    nthInner: (/** @type {string} */ letter) => `Inner ${letter}`,
    none: "No curve yet.",
    several: (/** @type {number} */ count) => plural(count, "point", "points"),
    point: (/** @type {string} */ name) => `Point ${name}`,
    center: "Centre",
    name: "Name, height",
    nameField: "Curve name",
    height: "Height",
    removeNone: "Select a control point first",
    more: "More commands",
    turnScale: "Turn, scale",
    turn: "Turn by degrees",
    scale: "Scale in percent",
    degree: "Degree",
    degreeRange: (/** @type {number} */ most) => `With these points the degree is at most ${most}`,
    align: "Align",
    spread: "Spread",
    alignments: {
      left: "Align at the left",
      center: "Align at the middle across",
      right: "Align at the right",
      top: "Align at the top",
      middle: "Align at the middle of the height",
      bottom: "Align at the bottom",
      across: "Spread evenly across",
      down: "Spread evenly up and down",
    },
    corners: (/** @type {number} */ count) => plural(count, "corner", "corners"),
    smooth: "Smooth",
    selected: (/** @type {number} */ count) => `${plural(count, "point", "points")} selected`,
    noneInBox: "No point in the box",
  },

  sampling: {
    heading: "Sampling",
    phrase: (/** @type {string} */ scheme, /** @type {number[]} */ counts) => `${scheme} · ${counts.join(" : ")}`,
  },

  matching: {
    heading: "Matching",
    phrase: (/** @type {string} */ method, /** @type {string} */ normal, /** @type {string} */ distance) =>
      `${method.replaceAll("-", " ")} · ${normal}, ${distance}`,
  },

  blend: {
    heading: "Blend",
    phrase: (/** @type {number} */ stages, /** @type {string} */ kind) => `${plural(stages, "stage", "stages")} · ${kind}`,
    unused: "not used",
  },

  materials: {
    heading: "Materials",
    color: (/** @type {string} */ name) => `Colour of ${name}`,
    name: (/** @type {number} */ index) => `Name of material ${index + 1}`,
    on: (/** @type {string} */ curve, /** @type {string} */ name) => `${curve} curve: ${name}`,
    add: "Add",
    details: (/** @type {string} */ name) => `Colour, order and removal of ${name}`,
    palette: ["Yellow", "Green", "Blue", "Orange", "Sky", "Vermilion", "Purple", "Silver"],
    void: "Empty space",
    up: "Up",
    down: "Down",
    moved: (/** @type {string} */ name, /** @type {number} */ place, /** @type {number} */ of) =>
      `${name} is material ${place} of ${of}`,
    removeWord: "Remove",
    removed: (/** @type {string} */ name) => `Removed ${name}`,
    onlyOne: "A document keeps at least one material",
    replace: (/** @type {string} */ name) => `What replaces ${name}`,
    replaceBy: "Replace by",
    keep: "Keep it",
    fresh: (/** @type {number} */ index) => `Material ${index + 1}`,
    along: (/** @type {string} */ curve) => `composition along the ${inSentence(curve)} curve`,
    stops: (/** @type {number} */ count) => plural(count, "stop", "stops"),
    phrase: (/** @type {string[]} */ names) => (names.length > 3 ? `${names.length} materials` : names.join(", ")),
  },

  layers: {
    heading: "Layers",
    snap: "Snapping",
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
      isoComposition: "Equal mix",
      difference: "Difference",
    },
    patterns: "Patterns",
    patternsHelp: "Hatches in place of colours: the angle tells the material, the density its fraction",
    isoMaterial: "Equal mix of",
    isoMaterialField: "Material of the lines of equal mix",
  },

  legend: {
    more: (/** @type {number} */ count) => `and ${count} more`,
  },

  composition: {
    toggle: "Edit on curve",
    toggleHelp: "Edit the composition along the curves, on the curves themselves",
    entered: "Composition keys are on the curves",
    left: "Control points are on the curves",
    group: (/** @type {string} */ curve) => `Composition along ${curve}`,
    help:
      "Arrow keys slide the key along the curve, with Shift ten times as far, with Alt a tenth. Page up and page down go to " +
      "the previous and the next key. Insert adds a key after this one, Delete removes it, Escape takes the move back, and once more leaves the keys.",
    key: (/** @type {number} */ index, /** @type {number} */ of, /** @type {string} */ curve) =>
      `Key ${index} of ${of} on ${curve}`,
    spoken: (/** @type {string} */ name, /** @type {string} */ at, /** @type {string} */ mix) => `${name}, at ${at}, ${mix}`,
    place: "Place",
    add: "Add key",
    remove: "Remove key",
    added: (/** @type {string} */ key) => `Added. ${key}`,
    removed: (/** @type {string} */ key) => `Removed. ${key}`,
    lastStays: "A curve keeps at least one key",
  },

  mixing: {
    share: (/** @type {string} */ name, /** @type {string} */ percent) => `${name} ${percent}`,
  },

  morph: {
    region: "Morph",
    needsTwo: "The morph needs two curves",
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
    gradient: "gradient",
    cosine: "normals, cos",
    length: "length",
    spoken: (/** @type {string[]} */ parts) => parts.join(", "),
    onCurve: (/** @type {string} */ curve) => `On ${inSentence(curve)}`,
    at: "at",
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
    gaps: "gaps kept",
    occluded: "occluded",
    corners: (/** @type {number} */ count) => (count === 1 ? "corner" : "corners"),
    ms: "ms",
    show: (/** @type {string} */ what) => `Show ${what}`,
    gap: "gap to optimum",
    rated: (/** @type {boolean} */ isBaseline, /** @type {string | null} */ gap) =>
      `${isBaseline ? "baseline" : "heuristic"}, gap ${gap ?? "unknown"}`,
    refining: "refining",
    repair: "Repair",
    working: "Working",
    cancel: "Cancel",
    cancelled: "Cancelled. The last picture stays.",
    tryAgain: "Try again",
    loading: "Loading",
  },

  incomplete: {
    verdict: ["No curve yet", "One curve"],
    reason: ["Draw a curve, or open something ready.", "A second one inside or round it makes the figure."],
    crossed: "The curve crosses itself. Move a point, or undo.",
  },

  advice: {
    notCovered: (/** @type {number} */ a, /** @type {number} */ b) =>
      `Not covered: ${a} + ${b} vertices.`,
    openPocket: "Some see nothing of the other curve: widen the mouth of the pocket.",
    moveApart: "Raise the samples or move the curves apart.",
    solvable: "Greedy lines are in their own way: an exact method reaches every vertex.",
    jammed: "Each sees the other curve, but not all can have lines at once: raise the samples or widen the passage.",
    unpaired: "This method may leave vertices out.",
    order: "A curve is out of order: curves of one height have to lie one inside the next, as the list has them.",
    overlap: "The cubic blend lies over itself: choose linear, or move the curves apart.",
    "no-thread": "No line leads through all curves: tie the ends.",
    pins: (/** @type {string} */ pins, /** @type {"blocked" | "cross" | "no-room"} */ reason) =>
      ({
        blocked: `Pin ${pins} meets a curve on its way.`,
        cross: `Pins ${pins} cross.`,
        "no-room": `Some vertices can have no line beside pin ${pins}.`,
      })[reason],
    occluded: (/** @type {number} */ count) =>
      `Repaired: ${plural(count, "line passes", "lines pass")} through a curve, so nothing is blended.`,
    unverified: "Some lines meet a curve or cross another. Choose an exact method.",
    orphan: "Some vertices see nothing of the other curve. Move a point, or raise the samples.",
    stuck: "The growth came to a dead end. Raise the samples or change a weight.",
    disjoint: "No line connects the two curves. Move one nearer to the other.",
    crossing: "Some lines cross. Raise the samples.",
    "coarse-sampling": "The samples are too coarse for this shape. Raise them.",
    "unverified-gap": "Some gaps do not fit one to one; their lines share ends. Raise the samples.",
    "sample-limit": "A curve has all 1000 samples and would need more. Raise the tolerance or the turn.",
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
