import { fromModule } from "./errors.js";
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
]);

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
  /**
   * @param {import("./directrix.js").DocumentInput} document
   * @param {import("./directrix.js").PictureOptions} options
   */
  const start = (document, options) => ask(() => engine.painting(toText(document), toText(options, "options")));
  return {
    match: (document) => ask(() => engine.match(toText(document))),
    stages: (document, options = {}) => ask(() => engine.stages(toText(document), options.refine ?? 1)),
    cells: (document) => ask(() => engine.cells(toText(document))),
    probe: (document, [x, y]) => ask(() => engine.probe(toText(document), x, y)),
    paint(document, options) {
      const painting = start(document, options);
      return ask(() => {
        painting.step(Infinity);
        return painting.picture();
      });
    },
    svg: (document, options) => ask(() => engine.svg(toText(document), toText(options, "options"))),
    fit: (document, options) => ask(() => engine.fit(toText(document), toText(options, "options"))),
    insertPoint: (document, curve, u) => ask(() => engine.insertPoint(toText(document), curve, u)),
    defaults: (document) => ask(() => engine.defaults(toText(document))),
    job(document, { paint } = {}) {
      const text = ask(() => toText(document));
      /** @type {import("./pkg/directrix.js").Painting | undefined} */
      let painting;
      /** @type {import("./directrix.js").Progress | undefined} */
      let end;
      const solve = (/** @type {number} */ budget) => {
        const progress = ask(() => engine.step(text, budget));
        if (!paint) return { progress, done: progress === 1 };
        if (progress === 1) painting = start(text, paint);
        return { progress: progress / 2, done: false };
      };
      const go = (/** @type {import("./pkg/directrix.js").Painting} */ painting, /** @type {number} */ budget) => {
        const painted = ask(() => painting.step(budget));
        if (painted < 1) return { progress: (1 + painted) / 2, done: false };
        return (end = { progress: 1, done: true, picture: ask(() => painting.picture()) });
      };
      return { step: (budget) => end ?? (painting ? go(painting, budget) : solve(budget)) };
    },
  };
}
