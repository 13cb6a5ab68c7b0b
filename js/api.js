import { DirectrixError, fromModule } from "./errors.js";
import { flatPoints, shapesOf } from "./shapes.js";
import { toText } from "./text.js";

/** The functions that both `load()` and `connect()` offer. */
export const FUNCTIONS = /** @type {const} */ ([
  "match",
  "stages",
  "cells",
  "probe",
  "paint",
  "svg",
  "fit",
  "insertPoint",
  "defaults",
  "readShapes",
  "fitCurve",
]);

/** Values of `options.format` of `readShapes`. */
const FORMATS = ["auto", "svg", "points"];

/**
 * The engine as one that reads shapes, which that of the module `figure` does not.
 *
 * @param {import("./pkg/directrix.js").Engine} engine
 * @param {string} name of the function
 * @returns {import("./pkg/directrix_full.js").Engine}
 */
function importer(engine, name) {
  if (name in engine) return /** @type {any} */ (engine);
  throw new DirectrixError("not-in-module", "", `${name} is not in the module "figure"; load the module "full"`);
}

/**
 * Wraps an engine of the module: documents go in as objects or as text, errors come out as `DirectrixError`.
 *
 * @param {import("./pkg/directrix.js").Engine} engine
 * @returns {import("./directrix.js").Directrix}
 */
export function createApi(engine) {
  /**
   * @template T
   * @param {() => T} call
   * @returns {T}
   */
  const ask = (call) => {
    try {
      return call();
    } catch (error) {
      throw fromModule(error);
    }
  };
  return {
    match: (document) => ask(() => engine.match(toText(document))),
    stages: (document, options = {}) => ask(() => engine.stages(toText(document), options.refine ?? 1)),
    cells: (document) => ask(() => engine.cells(toText(document))),
    probe: (document, [x, y]) => ask(() => engine.probe(toText(document), x, y)),
    paint: (document, options) => ask(() => engine.paint(toText(document), toText(options, "options"))),
    svg: (document, options) => ask(() => engine.svg(toText(document), toText(options, "options"))),
    fit: (document, options) => ask(() => engine.fit(toText(document), toText(options, "options"))),
    insertPoint: (document, curve, u) => ask(() => engine.insertPoint(toText(document), curve, u)),
    defaults: (document) => ask(() => engine.defaults(toText(document))),
    readShapes: (text, options = {}) =>
      ask(() => {
        const { format = "auto" } = options;
        if (typeof text !== "string") throw new DirectrixError("type", "text", `${String(text)} was found; expected a text`);
        if (!FORMATS.includes(format)) {
          throw new DirectrixError("range", "options.format", `"${format}" was found; expected ${FORMATS.join(", ")}`);
        }
        return shapesOf(importer(engine, "readShapes").readShapes(text, format));
      }),
    fitCurve: (points, options) =>
      ask(() => importer(engine, "fitCurve").fitCurve(flatPoints(points), toText(options, "options"))),
    job(document) {
      const text = ask(() => toText(document));
      return {
        step(budget) {
          const progress = ask(() => engine.step(text, budget));
          return { progress, done: progress === 1 };
        },
      };
    },
  };
}
