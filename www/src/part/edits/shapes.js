/**
 * Edits of shapes as pure functions from one document to the next. Each returns the document it was given when there is nothing to do.
 *
 * @import { PartReference, PartShape } from "../../../../js/directrix.js"
 * @import { Point } from "../../types.js"
 * @import { WholePart } from "../document.js"
 * @import { NamedShape } from "../shapes/geometry.js"
 *
 * @typedef {object} Use Where a shape is named.
 * @property {"outline" | "hole" | "reference" | "except"} as
 * @property {number} body index
 * @property {number | null} feature index in the queue of the body; null of outlines and holes
 */
import { withConditions } from "./conditions.js";
import { countOf, directionAt, FAR, handleCount, isClamped, isClosed, isReach, kept, keptPoint } from "../shapes/geometry.js";

/** Limits of the format. */
const MOST_SHAPES = 500;
export const MOST_POINTS = 10_000;
export const MOST_BODIES = 64;
export const MOST_HOLES = 100;
export const LONGEST_NAME = 100;

/** @param {WholePart} document @returns {readonly NamedShape[]} */
export const shapesOf = (document) => document.shapes ?? [];

/** @param {WholePart} document @param {string | null} name */
export const shapeOf = (document, name) => shapesOf(document).find((shape) => shape.name === name);

/** Points of all shapes, as the format counts them. @param {WholePart} document */
export const countAll = (document) => shapesOf(document).reduce((sum, shape) => sum + countOf(shape), 0);

/**
 * @param {WholePart} document
 * @param {string} name
 * @param {(shape: NamedShape) => NamedShape} change
 * @returns {WholePart}
 */
export function changeShape(document, name, change) {
  const shape = shapeOf(document, name);
  if (!shape) return document;
  const next = change(shape);
  return next === shape ? document : { ...document, shapes: shapesOf(document).map((other) => (other === shape ? next : other)) };
}

/** @param {Point} a @param {Point} b */
const isSame = (a, b) => a[0] === b[0] && a[1] === b[1];

/**
 * A shape with some of its points elsewhere. The last point of a clamped curve goes with the first.
 * @template {PartShape} Shape
 * @param {Shape} shape
 * @param {(at: Point, index: number) => Point} place
 * @returns {Shape}
 */
function withPoints(shape, place) {
  const put = (/** @type {Point} */ from, /** @type {number} */ index) => {
    const to = place(from, index);
    return isSame(from, to) ? from : keptPoint(to);
  };
  /** @param {string} field @param {number} index */
  const one = (field, index) => {
    const from = /** @type {Point} */ (Reflect.get(shape, field));
    const to = put(from, index);
    return to === from ? {} : { [field]: to };
  };
  const patched = (/** @type {object} */ patch) => (Object.keys(patch).length > 0 ? { ...shape, ...patch } : shape);
  switch (shape.kind) {
    case "point":
      return patched(one("at", 0));
    case "line":
      return patched(one("through", 0));
    case "circle":
      return patched(one("center", 0));
    case "segment":
      return patched({ ...one("from", 0), ...one("to", 1) });
    default: {
      const last = isClamped(shape) ? shape.points.length - 1 : -1;
      const points = shape.points.map((from, i) => put(from, i === last ? 0 : i));
      return points.every((point, i) => point === shape.points[i]) ? shape : { ...shape, points };
    }
  }
}

/** Moves a whole shape; the rim of a circle and the direction of a line are no points, and stay. @param {WholePart} document @param {string} name @param {Point} by */
export function moveShape(document, name, by) {
  return changeShape(document, name, (shape) => withPoints(shape, ([x, y]) => [x + by[0], y + by[1]]));
}

/** Moves several shapes. @param {WholePart} document @param {readonly string[]} names each counts once @param {Point} by */
export function moveShapes(document, names, by) {
  return [...new Set(names)].reduce((now, name) => moveShape(now, name, by), document);
}

/**
 * Names of the shapes that make a body together with its outline: its holes, and what its features are measured to.
 * @param {WholePart} document
 * @param {string} outline
 * @returns {string[]} the outline first; it alone where it is the outline of no body
 */
export function bodyShapes({ bodies }, outline) {
  const own = bodies.filter((body) => body.outline === outline);
  const named = own.flatMap(({ holes = [], features = [] }) => [...holes, ...features.flatMap(referencesOf).filter((each) => typeof each === "string")]);
  return [...new Set([outline, .../** @type {string[]} */ (named)])];
}

/**
 * A document with some shapes as another one has them.
 * @param {WholePart} document
 * @param {WholePart} other
 * @param {readonly string[]} names
 * @returns {WholePart}
 */
export function withShapesOf(document, other, names) {
  const shapes = mapped(shapesOf(document), (shape) => (names.includes(shape.name) ? (shapeOf(other, shape.name) ?? shape) : shape));
  return shapes === shapesOf(document) ? document : { ...document, shapes };
}

/**
 * Puts a handle where it is wanted: a point there, the rim of a circle and the direction of a line through there.
 * @param {WholePart} document
 * @param {string} name
 * @param {number} handle
 * @param {Point} to
 * @returns {WholePart}
 */
export function placeHandle(document, name, handle, to) {
  const shape = shapeOf(document, name);
  if (!shape || handle < 0 || handle >= handleCount(shape)) return document;
  if (shape.kind === "circle" && isReach(shape, handle)) return setRadius(document, name, Math.hypot(to[0] - shape.center[0], to[1] - shape.center[1]));
  if (shape.kind === "line" && isReach(shape, handle)) return setDirection(document, name, [to[0] - shape.through[0], to[1] - shape.through[1]]);
  return changeShape(document, name, (now) => withPoints(now, (at, i) => (i === handle ? to : at)));
}

/** @param {WholePart} document @param {string} name @param {number} point @param {0 | 1} axis @param {number} value */
export function setCoordinate(document, name, point, axis, value) {
  return changeShape(document, name, (shape) =>
    withPoints(shape, (at, i) => (i !== point ? at : axis === 0 ? [value, at[1]] : [at[0], value])),
  );
}

/** Gives a circle a radius; one that is not above 0 is none. @param {WholePart} document @param {string} name @param {number} radius */
export function setRadius(document, name, radius) {
  const next = kept(Math.min(FAR, radius));
  return changeShape(document, name, (shape) => (shape.kind === "circle" && next > 0 && next !== shape.radius ? { ...shape, radius: next } : shape));
}

/** Gives a line a direction, of any length but 0. @param {WholePart} document @param {string} name @param {Point} direction */
export function setDirection(document, name, direction) {
  const next = keptPoint(direction);
  return changeShape(document, name, (shape) =>
    shape.kind === "line" && (next[0] !== 0 || next[1] !== 0) && !isSame(next, shape.direction) ? { ...shape, direction: next } : shape,
  );
}

/** Gives a line a direction of length 1. @param {WholePart} document @param {string} name @param {number} degrees counter-clockwise from x */
export const setAngle = (document, name, degrees) => setDirection(document, name, directionAt(degrees));

/** Gives a shape another geometry under its name. @param {WholePart} document @param {string} name @param {PartShape} geometry */
export const setGeometry = (document, name, geometry) =>
  changeShape(document, name, () => ("name" in geometry && geometry.name === name ? /** @type {NamedShape} */ (geometry) : { ...geometry, name }));

/**
 * Why a document cannot take more shapes, or null.
 * @param {WholePart} document
 * @param {readonly PartShape[]} shapes
 * @returns {"shapes" | "points" | null}
 */
export function whyNotAdd(document, shapes) {
  if (shapesOf(document).length + shapes.length > MOST_SHAPES) return "shapes";
  return countAll(document) + shapes.reduce((sum, shape) => sum + countOf(shape), 0) > MOST_POINTS ? "points" : null;
}

/**
 * A name that nothing has yet: the wanted one, or the first number from `first` on after it.
 * @param {readonly string[]} taken
 * @param {string} wanted
 * @param {number} [first] 0 tries the name without a number
 */
export function freshName(taken, wanted, first = 0) {
  const base = wanted.slice(0, LONGEST_NAME - 5).trim();
  if (first === 0 && wanted.length <= LONGEST_NAME && !taken.includes(wanted)) return wanted;
  let number = Math.max(first, first === 0 ? 2 : 1);
  while (taken.includes(`${base} ${number}`)) number += 1;
  return `${base} ${number}`;
}

/** @param {WholePart} document */
export const shapeNames = (document) => shapesOf(document).map(({ name }) => name);

/** Adds a shape at the end, under a name of its own; one that the document cannot take is left out. @param {WholePart} document @param {NamedShape} shape @returns {WholePart} */
export function addShape(document, shape) {
  if (whyNotAdd(document, [shape]) || shapeOf(document, shape.name)) return document;
  return { ...document, shapes: [...shapesOf(document), shape] };
}

/**
 * Makes a shape of the document the outline of a new body of the first material, which lies over the others.
 * @param {WholePart} document
 * @param {string} name
 * @param {string} body its name
 * @returns {WholePart}
 */
export function makeBody(document, name, body) {
  const { bodies, materials = [] } = document;
  const shape = shapeOf(document, name);
  if (!shape || !isClosed(shape) || bodies.length >= MOST_BODIES || bodies.some((each) => each.name === body)) return document;
  const pure = Array.from({ length: Math.max(1, materials.length) }, (_, i) => (i === 0 ? 1 : 0));
  return { ...document, bodies: [...bodies, { name: body, outline: name, holes: [], default: pure, rule: "repaired", features: [] }] };
}

/** Adds a shape as the outline of a new body; both or nothing. @param {WholePart} document @param {NamedShape} shape @param {string} body its name */
export function addBody(document, shape, body) {
  const added = addShape(document, shape);
  const made = added === document ? document : makeBody(added, shape.name, body);
  return made === added ? document : made;
}

/** Cuts a shape of the document out of a body. @param {WholePart} document @param {number} body @param {string} name @returns {WholePart} */
export function makeHole(document, body, name) {
  const spec = document.bodies[body];
  const holes = spec?.holes ?? [];
  if (!spec || !shapeOf(document, name) || spec.outline === name || holes.includes(name) || holes.length >= MOST_HOLES) return document;
  return { ...document, bodies: document.bodies.with(body, { ...spec, holes: [...holes, name] }) };
}

/** Fills a hole of a body; the shape stays. @param {WholePart} document @param {number} body @param {string} name @returns {WholePart} */
export function fillHole(document, body, name) {
  const spec = document.bodies[body];
  if (!spec?.holes?.includes(name)) return document;
  return { ...document, bodies: document.bodies.with(body, { ...spec, holes: spec.holes.filter((hole) => hole !== name) }) };
}

/**
 * A name for the copy of something: the next free number in place of its own, or after its name.
 * @param {readonly string[]} taken
 * @param {string} name
 */
export function copyName(taken, name) {
  const numbered = /^(.*\S) (\d{1,6})$/.exec(name);
  return numbered ? freshName(taken, numbered[1], Number(numbered[2]) + 1) : freshName(taken, name);
}

/**
 * A copy of a shape, beside it. That of a hole is one as well.
 * @param {WholePart} document
 * @param {string} name
 * @param {string} as name of the copy
 * @param {Point} by where it lies beside it
 */
export function duplicateShape(document, name, as, by) {
  const shape = shapeOf(document, name);
  if (!shape || shapeOf(document, as)) return document;
  const added = addShape(document, { ...shape, name: as });
  if (added === document) return document;
  const holes = usesOf(document, name).filter((use) => use.as === "hole");
  return holes.reduce((now, { body }) => makeHole(now, body, as), moveShape(added, as, by));
}

/** The references of a feature. @param {{reference?: PartReference, references?: {[name: string]: PartReference}}} feature */
const referencesOf = ({ reference, references = {} }) => [...(reference === undefined ? [] : [reference]), ...Object.values(references)];

/**
 * Where a shape is named.
 * @param {WholePart} document
 * @param {string} name
 * @returns {Use[]} by body, in each outline, holes and features
 */
export function usesOf({ bodies }, name) {
  return bodies.flatMap(({ outline, holes = [], features = [] }, body) => {
    /** @type {Use[]} */
    const uses = outline === name ? [{ as: "outline", body, feature: null }] : [];
    if (holes.includes(name)) uses.push({ as: "hole", body, feature: null });
    features.forEach((each, feature) => {
      const references = referencesOf(each);
      if (references.includes(name)) uses.push({ as: "reference", body, feature });
      else if (references.some((reference) => typeof reference === "object" && reference.except?.includes(name))) uses.push({ as: "except", body, feature });
    });
    return uses;
  });
}

/**
 * Names that some body, feature or blend has for a shape.
 * @param {WholePart} document
 * @returns {Set<string>}
 */
export function usedNames({ bodies }) {
  return new Set(
    bodies.flatMap(({ outline, holes = [], features = [], blend }) => [
      outline,
      ...holes,
      ...(blend?.boundaries ?? []).map(({ on }) => on),
      ...features.flatMap((feature) => referencesOf(feature).flatMap((each) => (typeof each === "string" ? [each] : (each.except ?? [])))),
    ]),
  );
}

/** A list in which what stays the same stays the same object. @template T @param {readonly T[]} list @param {(item: T) => T} change @returns {T[]} */
function mapped(list, change) {
  const next = list.map(change);
  return next.every((item, i) => item === list[i]) ? /** @type {T[]} */ (list) : next;
}

/**
 * A reference with the names of shapes changed; null takes one out of `except`.
 * @param {PartReference} reference
 * @param {(name: string) => string} rename
 * @returns {PartReference}
 */
function renamedIn(reference, rename) {
  if (typeof reference === "string") return rename(reference);
  const { except } = reference;
  if (!except) return reference;
  const next = mapped(except, rename);
  return next === except ? reference : { ...reference, except: next };
}

/**
 * Why a shape cannot have a name, or null.
 * @param {WholePart} document
 * @param {string} from its name
 * @param {string} to
 * @returns {"empty" | "long" | "taken" | null}
 */
export function whyNotName(document, from, to) {
  if (to.trim() === "") return "empty";
  if (to.length > LONGEST_NAME) return "long";
  return to !== from && shapeOf(document, to) ? "taken" : null;
}

/**
 * Renames a shape in its place and wherever it is named: outlines, holes, references, and what boundaries leave out.
 * @param {WholePart} document
 * @param {string} from
 * @param {string} to nothing happens where another shape has it, or it is no name
 * @returns {WholePart}
 */
export function renameShape(document, from, to) {
  if (from === to || !shapeOf(document, from) || whyNotName(document, from, to)) return document;
  const rename = (/** @type {string} */ name) => (name === from ? to : name);
  const bodies = mapped(document.bodies, (before) => {
    const body = withConditions(before, (boundary) => (boundary.on === from ? { ...boundary, on: to } : boundary));
    const holes = body.holes && mapped(body.holes, rename);
    const features = body.features && mapped(body.features, (feature) => {
      const { reference, references } = feature;
      const one = reference === undefined ? reference : renamedIn(reference, rename);
      const entries = references && mapped(Object.entries(references), (entry) => {
        const next = renamedIn(entry[1], rename);
        return next === entry[1] ? entry : /** @type {[string, PartReference]} */ ([entry[0], next]);
      });
      const isKept = one === reference && (entries ?? []).every(([name, each]) => each === references?.[name]);
      return isKept ? feature : { ...feature, ...(one === undefined ? {} : { reference: one }), ...(entries ? { references: Object.fromEntries(entries) } : {}) };
    });
    const outline = rename(body.outline);
    if (outline === body.outline && holes === body.holes && features === body.features) return body;
    return { ...body, outline, ...(holes ? { holes } : {}), ...(features ? { features } : {}) };
  });
  return { ...document, shapes: shapesOf(document).map((shape) => (shape.name === from ? { ...shape, name: to } : shape)), bodies };
}

/**
 * Takes a shape away, with its name among holes, in what boundaries leave out and in blends. Features and outlines keep the name of what is gone, which the kernel says of
 * them, and get it back with undo or with another shape of that name; `withUses` takes them away as well: features measured to it, bodies with that outline,
 * and features measured to the boundary of such a body.
 * @param {WholePart} document
 * @param {string} name
 * @param {{withUses?: boolean}} [options]
 * @returns {WholePart}
 */
export function deleteShape(document, name, { withUses = false } = {}) {
  if (!shapeOf(document, name)) return document;
  const gone = withUses ? document.bodies.filter(({ outline }) => outline === name).map((body) => body.name) : [];
  const isGone = (/** @type {PartReference} */ reference) =>
    typeof reference === "string" ? reference === name : gone.includes(reference.boundary);
  const without = (/** @type {PartReference} */ reference) =>
    typeof reference === "object" && reference.except?.includes(name)
      ? { ...reference, except: reference.except.filter((each) => each !== name) }
      : reference;
  const bodies = document.bodies
    .filter((body) => !gone.includes(body.name))
    .map((before) => {
      const body = withConditions(before, (boundary) => (boundary.on === name && before.outline !== name ? null : boundary));
      const holes = body.holes?.filter((hole) => hole !== name);
      const features = body.features
        ?.filter((feature) => !withUses || !referencesOf(feature).some(isGone))
        .map((feature) => {
          const { reference, references } = feature;
          if (referencesOf(feature).every((each) => without(each) === each)) return feature;
          return {
            ...feature,
            ...(reference === undefined ? {} : { reference: without(reference) }),
            ...(references ? { references: Object.fromEntries(Object.entries(references).map(([key, each]) => [key, without(each)])) } : {}),
          };
        });
      return { ...body, ...(holes ? { holes } : {}), ...(features ? { features } : {}) };
    });
  return { ...document, shapes: shapesOf(document).filter((shape) => shape.name !== name), bodies };
}
