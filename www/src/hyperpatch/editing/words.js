/** What a person reads while a body is edited. */

/** @typedef {import("../../../../js/directrix.js").HyperpatchOperation} Operation */

import { editable } from "../../format.js";

/** @param {readonly number[]} values */
const list = (values) => values.map((value) => editable(Number(value.toPrecision(5)), 0)).join(", ");

/** @param {readonly number[]} cells */
const cellsOf = (cells) => (cells.length === 1 ? `cell ${cells[0]}` : cells.length <= 4 ? `cells ${cells.join(", ")}` : `${cells.length} cells`);

/** @param {readonly number[]} at */
const coefficient = (at) => (at.every((along) => along === 0 || along === 3) ? "corner" : `coefficient ${at.join("")}`);

/** @param {readonly number[]} mix */
const shares = (mix) => mix.map((fraction) => `${editable(Number((fraction * 100).toPrecision(4)), 0)}`).join(" : ");

/** The sentence of each operation in the list. @type {{[K in Operation["op"]]: (operation: any) => string}} */
const sentences = {
  cells: ({ cells }) => (cells.length === 1 ? "1 cell as given" : `${cells.length} cells as given`),
  move: ({ cell, at, by, reach }) => `Move ${coefficient(at)} of cell ${cell} by ${list(by)}${reach === "single" ? ", alone" : ""}`,
  continuity: ({ cell, face, corner, shape, material }) =>
    `${corner ? `Corner ${corner.join("")}` : "All"} of face ${face} of cell ${cell}: ${[shape && `shape ${shape}`, material && `material ${material}`].filter(Boolean).join(", ")}`,
  mix: ({ cells, cell, corner, at, within, mix }) =>
    `Mix ${shares(mix)} in ${cells ? cellsOf(cells) : at ? `${coefficient(at)} of cell ${cell}` : `corner ${corner.join("")} of cell ${cell}${within ? `, within ${cellsOf(within)}` : ""}`}`,
  slope: ({ cell, corner, rule }) => `${rule === "flat" ? "Flat" : "Natural"} slope of material at corner ${corner.join("")} of cell ${cell}`,
  delete: ({ cells }) => `Delete ${cellsOf(cells)}`,
  copy: ({ cells, by }) => `Copy ${cellsOf(cells)} by ${list(by)}`,
  mirror: ({ cells, normal, offset = 0, keep = true }) => `Mirror ${cellsOf(cells)} across ${planeOf(normal, offset)}${keep ? "" : ", without the original"}`,
  reorient: ({ cells }) => `Turn the parameters of ${cellsOf(cells)} round`,
  extrude: ({ faces, by }) => `Extrude ${faces.length === 1 ? `face ${faces[0].face} of cell ${faces[0].cell}` : `${faces.length} faces`} by ${list([by])}`,
  subdivide: ({ cell, axis, at = 0.5 }) => `Subdivide cell ${cell} along ${axis} at ${list([at])}`,
};

/** @param {readonly number[]} normal @param {number} offset */
function planeOf(normal, offset) {
  const axis = normal.findIndex((value) => value !== 0);
  const isAxis = normal.filter((value) => value !== 0).length === 1;
  return isAxis ? `${"xyz"[axis]} = ${list([offset / normal[axis]])}` : `the plane with normal ${list(normal)} at ${list([offset])}`;
}

export const words = {
  groups: { operations: "Operations", build: "Build" },
  sentence: (/** @type {Operation} */ operation) => /** @type {any} */ (sentences)[operation.op](operation),
  operations: {
    list: "Operations of the body, in order",
    help: "Up and Down choose, Alt with Up or Down changes the order, Delete removes.",
    phrase: (/** @type {number} */ count, /** @type {number} */ idle) => `${count}${idle > 0 ? `, ${idle} not applied` : ""}`,
    earlier: "Earlier",
    later: "Later",
    remove: "Remove",
    first: "It is the first.",
    last: "It is the last.",
    idle: "Does not apply",
    more: (/** @type {number} */ count) => `${count} older ones`,
    showAll: "Show all",
    removed: (/** @type {string} */ text) => `Removed: ${text}`,
    shifted: (/** @type {number} */ place, /** @type {number} */ count) => `Now number ${place} of ${count}`,
    by: (/** @type {string} */ axis) => `Displacement ${axis}`,
    normal: (/** @type {string} */ axis) => `Normal ${axis}`,
    offset: "Offset",
    length: "Length",
    at: "Place",
    rule: "Slope",
    shape: "Shape",
    material: "Material",
  },
  cells: {
    several: "Choose several",
    all: "All",
    none: "None",
    chosen: (/** @type {number} */ count) => `${count} chosen`,
  },
  grid: {
    region: "Coefficients at the corner",
    help: "Arrow keys go along u and v, Page Up and Page Down along w. Enter chooses.",
    layer: (/** @type {number} */ offset) => (offset === 0 ? "w" : offset > 0 ? "w +1" : "w \u22121"),
    corner: "Corner",
    point: (/** @type {readonly number[]} */ offset) => `Neighbour ${["u", "v", "w"].map((axis, k) => `${axis} ${offset[k] > 0 ? "+" : offset[k] < 0 ? "\u2212" : ""}${Math.abs(offset[k])}`).join(", ")}`,
    inner: (/** @type {readonly number[]} */ at) => `Coefficient ${at.join("")}`,
    spoken: (/** @type {string} */ name, /** @type {string} */ place, /** @type {string} */ mix) => `${name}, ${place}, ${mix}`,
    regular: (/** @type {number} */ cells, /** @type {number} */ neighbours) => `${cells === 1 ? "One cell" : `${cells} cells`}, ${neighbours} neighbours`,
    crease: (/** @type {number} */ cells) => `A crease: ${cells} cells meet here out of the grid, so a neighbour moves with its equal copies alone.`,
    moves: (/** @type {number} */ count) => (count === 1 ? "Moves alone" : `Moves ${count} coefficients, ringed in the picture`),
  },
  also: {
    count: (/** @type {number} */ count) => (count === 1 ? "1 more corner" : `${count} more corners`),
    several: "Choose several corners",
    clear: "Only this one",
    mirror: "Mirror",
    planes: { off: "Off", x: "x", y: "y", z: "z" },
    middle: "through the middle of the body",
    partner: "The mirrored one moves as well.",
    itself: "It lies in the mirror plane and stays there.",
    alone: "Nothing of the body lies opposite.",
  },
  continuity: {
    heading: "Continuity",
    joint: "Cells",
    name: (/** @type {{cell: number, face: string}} */ a, /** @type {{cell: number, face: string}} */ b) => `${a.cell} and ${b.cell}, face ${a.face}`,
    none: "No other cell shares a face here.",
    where: "Where",
    wheres: { corner: "This corner", face: "Whole face" },
    shape: "Shape",
    material: "Material",
    kinds: { C1: "C1", C0: "C0", none: "None" },
    marked: "set",
    found: "as it is",
    says: (/** @type {string} */ shape, /** @type {string} */ material) => `Shape ${shape}, material ${material}.`,
    set: (/** @type {string} */ what, /** @type {string} */ kind) => `${what}: ${kind}`,
  },
  material: {
    heading: "Mix",
    mode: "In",
    modes: { cells: "Chosen cells", corner: "Corner, in all its cells", within: "Corner, in chosen cells", at: "One coefficient" },
    needs: {
      cells: "Choose cells in the list or in the picture.",
      corner: "Choose a corner in the picture.",
      within: "Choose cells and one of their corners.",
      at: "Choose a corner, and a neighbour if that is meant.",
    },
    about: {
      cells: (/** @type {number} */ count) => (count === 1 ? "All 64 coefficients of one cell" : `All 64 coefficients of ${count} cells`),
      corner: "The corner's block in each of its cells",
      within: "The corner's block in the chosen cells alone, where others join it with a jump",
      at: "The chosen coefficient and nothing else",
    },
    slope: "Slope",
    flat: "Flat",
    natural: "Natural",
    slopeNote: "Flat is the paper's rule: no slope at any corner, so a gradient over several cells is a staircase. Natural takes the mean slope, as far as the mixes allow.",
    profile: (/** @type {number} */ a, /** @type {number} */ b) => `From cell ${a} through the corner into cell ${b}`,
    profileNote: "Dashed: with the flat rule",
    sloped: (/** @type {string} */ rule) => `${rule} slope`,
  },
  build: {
    what: "Do",
    kinds: { copy: "Copy", mirror: "Mirror", extrude: "Extrude faces", subdivide: "Subdivide", reorient: "Turn parameters round", delete: "Delete", import: "Add from a file" },
    apply: { copy: "Copy", mirror: "Mirror", extrude: "Extrude", subdivide: "Subdivide", reorient: "Turn round", delete: "Delete" },
    needsCells: "Choose cells in the list or in the picture.",
    needsCell: "Choose a cell.",
    needsFaces: "Choose faces on the outside of the body.",
    importNote: "A body saved as JSON is added where it lies: choose its file, drop it here, or paste it here. Materials of the same name and colour are taken as one.",
    choose: "Choose a file…",
    pasted: "what was pasted",
    of: (/** @type {readonly number[]} */ cells) => cellsOf(cells).replace(/^c/, "C"),
    by: "By",
    plane: "Across",
    place: "Plane at",
    keep: "Keep the original",
    faces: "Faces",
    inPicture: "Choose them in the picture",
    face: (/** @type {number} */ cell, /** @type {string} */ name) => `Face ${name} of cell ${cell}`,
    facesChosen: (/** @type {number} */ count) => (count === 1 ? "1 face" : `${count} faces`),
    length: "Length",
    start: "Start",
    starts: { C1: "Smooth", free: "Straight" },
    startNote: { C1: "Goes on with the slope of the cell behind it.", free: "Leaves the face along its normal." },
    axis: "Along",
    at: "At",
    sheet: "Goes through every cell of the sheet, so that the mesh stays conforming.",
    reorientNote: "One parameter runs the other way, which turns a mirrored cell round. Its shape stays.",
    injective: "Injective",
    meetings: "Meets others properly",
    continuity: "Continuity",
    merged: (/** @type {number} */ count, /** @type {string} */ name) => `Added ${count === 1 ? "1 cell" : `${count} cells`} of ${name}`,
    empty: "That body has no cells.",
    notBody: "That is no document of hyperpatches; expected the JSON of one, as Export writes it.",
  },
  refusal: {
    region: "Invalid edit",
    folded: (/** @type {number} */ cell) => `Cell ${cell} is turned inside out at the cross`,
    meeting: (/** @type {number} */ cell) => `Cell ${cell} runs through itself at the cross`,
    others: (/** @type {number} */ count) => (count === 1 ? ", and 1 other is invalid" : `, and ${count} others are invalid`),
    keep: "Keep",
    back: "Take back",
    refused: (/** @type {string} */ why) => `Taken back: ${why}`,
    kept: "Kept",
    setting: "Invalid edits",
    settings: { ask: "Ask", refuse: "Refuse", keep: "Keep" },
  },
};
