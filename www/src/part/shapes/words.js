/** Every word of shapes: on the canvas, in the tools that draw them, and in the inspector. */
import { plural } from "../../strings.js";

/** @typedef {import("./geometry.js").Kind} Kind */

/** Kinds as a person names them, by the form of a curve. @type {{[kind: string]: string}} */
const KINDS = {
  point: "Point",
  line: "Line",
  segment: "Segment",
  circle: "Circle",
  polygon: "Polygon",
  polyline: "Polyline",
  periodic: "Closed curve",
  clamped: "Closed curve",
  open: "Open curve",
};

export const words = {
  /** @param {import("../../../../js/directrix.js").PartShape} shape */
  kind: (shape) => KINDS[shape.kind === "curve" ? shape.form : shape.kind],
  handles: {
    help:
      "Arrow keys move what is chosen, with Shift far, with Alt finely. Page keys go from point to point, Home takes the whole shape. Insert adds a point, " +
      "Delete removes it, or the whole shape. Escape takes the moves back.",
    region: "Shapes",
    group: (/** @type {string} */ name) => `Shape ${name}`,
    whole: (/** @type {string} */ name, /** @type {string} */ kind, /** @type {string} */ x, /** @type {string} */ y) => `${name}, ${kind.toLowerCase()}, middle x ${x}, y ${y}`,
    nth: (/** @type {string} */ name, /** @type {number} */ point) => `${name}, point ${point + 1}`,
    point: (/** @type {string} */ name, /** @type {string} */ x, /** @type {string} */ y) => `${name}, x ${x}, y ${y}`,
    radius: (/** @type {string} */ name, /** @type {string} */ radius) => `${name}, radius ${radius}`,
    angle: (/** @type {string} */ name, /** @type {string} */ degrees) => `${name}, direction ${degrees}°`,
    inserted: (/** @type {string} */ point) => `Added ${point}`,
    removed: (/** @type {string} */ point) => `Removed ${point}`,
    tooFew: (/** @type {string} */ name, /** @type {number} */ fewest) => `${name} needs its ${plural(fewest, "point", "points")}`,
    noList: (/** @type {string} */ kind) => `A ${kind.toLowerCase()} has no list of points`,
    deleted: (/** @type {string} */ name) => `Deleted ${name}`,
    mostPoints: "The shapes of a part have 10 000 points at most",
    mostShapes: "A part has 500 shapes at most",
  },
  group: {
    heading: "Shape",
    none: "None is chosen. Choose one on the canvas, or draw one.",
    phrase: "none",
    name: "Name",
    kind: "Kind",
    place: "Middle",
    at: "Place",
    centre: "Centre",
    radius: "Radius",
    from: "From",
    to: "To",
    through: "Through",
    direction: "Direction",
    angle: "Angle",
    point: (/** @type {number} */ point, /** @type {number} */ count) => `Point ${point + 1} of ${count}`,
    points: (/** @type {number} */ count) => plural(count, "point", "points"),
    previous: "Previous point",
    next: "Next point",
    add: "Add",
    remove: "Remove",
    along: "Holes and references move along",
    used: "Used by",
    unused: "nothing yet",
    uses: {
      outline: (/** @type {string} */ body) => `${body}: outline`,
      hole: (/** @type {string} */ body) => `${body}: hole`,
      reference: (/** @type {string} */ body, /** @type {string} */ feature) => `${body}: ${feature}`,
      except: (/** @type {string} */ body, /** @type {string} */ feature) => `${body}: ${feature} leaves it out`,
    },
    duplicate: "Duplicate",
    delete: "Delete",
    deleteAll: "Delete with what uses it",
    hole: (/** @type {string} */ body) => `Cut out of ${body}`,
    fill: (/** @type {string} */ body) => `Fill in ${body}`,
    body: "Make a body",
    convert: "Turn into",
    choose: "Choose",
    targets: { polygon: "Polygon", polyline: "Polyline", curve: "Curve through its points", control: "Curve on its points", outline: "Polygon", controlBack: "Its control points" },
    outlineOpen: "Polyline",
    curveOfCircle: "Closed curve",
    flat: "Its points lie on one line, which no closed curve passes.",
    names: { empty: "A name is needed.", long: "At most 100 characters.", taken: "Another shape has this name." },
    copied: (/** @type {string} */ name) => `Made ${name}`,
    became: (/** @type {string} */ name, /** @type {string} */ kind) => `${name} is a ${kind.toLowerCase()} now`,
    orphans: (/** @type {string} */ name, /** @type {number} */ count) => `Deleted ${name}, which ${plural(count, "place still names", "places still name")}`,
  },
};
