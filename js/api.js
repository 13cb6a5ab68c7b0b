import { asking, inNames, methods } from "./body.js";
import { DirectrixError, fromModule } from "./errors.js";
import { asking as askingLaplace, askingBoundary, solving, told } from "./laplace.js";
import { merged } from "./merge.js";
import { packed, valueOf } from "./operations.js";
import { askingPart, partArguments, partMethods } from "./part.js";
import { received } from "./post.js";
import { describe } from "./sentence.js";
import { flatPoints, shapesOf } from "./shapes.js";
import { spanOf } from "./span.js";
import { greedyText, setsOf, stepsOf } from "./steps.js";
import { toText } from "./text.js";

/** Values of `options.format` of `readShapes`. */
const FORMATS = ["auto", "svg", "points"];

/**
 * The engine as that of the module `full`, which answers more than that of `figure`.
 *
 * @param {import("./pkg/directrix.js").Engine} engine
 * @param {string} name of the function
 * @param {string} [shown] as the package calls it
 * @returns {import("./pkg/directrix_full.js").Engine}
 */
function whole(engine, name, shown = name) {
  if (name in engine) return /** @type {any} */ (engine);
  throw new DirectrixError("not-in-module", "", `${shown} is not in the module "figure"; load the module "full"`);
}

/**
 * Work on a solved document, in steps.
 *
 * @typedef {object} Work
 * @property {(budget: number) => number} step goes on for about so many milliseconds; returns the share done
 * @property {() => Partial<import("./directrix.js").Progress>} end what is done
 */

/**
 * A harmonic blend with its numbers beside its lists.
 *
 * @param {any} found
 * @returns {import("./directrix.js").Harmonic}
 */
function harmonicOf({ summary, outer, ...rest }) {
  const none = { outer, segments: 0, crossings: 0, lost: 0, iterations: 0, residual: 0, flux: 0, fluxBalance: 0, area: 0, amounts: [], vertices: 0, triangles: 0 };
  const { lines: _, ...numbers } = summary ?? none;
  return { ...rest, ...numbers };
}

/** The levels of isolines that are not asked for. */
const TENTHS = [0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9];

/**
 * Isolines by level, from lists of numbers: the index of the level and 0 or 1 for closed, then x and y of each point.
 *
 * @param {number[]} levels
 * @param {number[][] | null} flat null without a complete matching
 * @returns {import("./directrix.js").Isoline[]}
 */
function grouped(levels, flat) {
  if (!flat) return [];
  const groups = levels.map((level) => /** @type {import("./directrix.js").Isoline} */ ({ level, lines: [], closed: [] }));
  for (const [k, closed, ...numbers] of flat) {
    const points = Array.from({ length: numbers.length / 2 }, (_, i) => numbers.slice(2 * i, 2 * i + 2));
    groups[k].lines.push(/** @type {import("./directrix.js").Point[]} */ (points));
    groups[k].closed.push(closed === 1);
  }
  return groups;
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
  /**
   * @param {import("./directrix.js").DocumentInput} document
   * @param {import("./directrix.js").PictureOptions} options
   */
  const start = (document, { coarse = false, ...options }) =>
    ask(() => engine.painting(toText(document), coarse, toText(options, "options")));
  /**
   * @param {string} text
   * @param {import("./directrix.js").PictureOptions} options
   * @returns {Work}
   */
  const drawn = (text, options) => {
    const painting = start(text, options);
    return { step: (budget) => ask(() => painting.step(budget)), end: () => ask(() => ({ picture: painting.picture() })) };
  };
  /**
   * A picture, before which blends are compared where it shows how they differ.
   *
   * @param {string} text
   * @param {import("./directrix.js").PictureOptions} options
   * @param {boolean} coarse
   * @returns {Work}
   */
  const painted = (text, options, coarse) => {
    const { coarse: _, ...rest } = options;
    const needs = "showsDifference" in engine && ask(() => whole(engine, "harmonic").showsDifference(text, coarse, toText(rest, "options")));
    if (!needs) return drawn(text, options);
    /** @type {Work | undefined} */
    let work;
    const first = compared(text, coarse, true);
    const step = (/** @type {number} */ budget) => {
      if (work) return 0.5 + work.step(budget) / 2;
      const share = first.step(budget);
      if (share === 1) work = drawn(text, options);
      return share / 2;
    };
    return { step, end: () => /** @type {Work} */ (work).end() };
  };
  /**
   * A harmonic blend, compared with the ruled one where that is asked for.
   *
   * @param {string} text
   * @param {boolean} coarse
   * @param {boolean} difference
   * @returns {Work}
   */
  const compared = (text, coarse, difference) => {
    const own = ask(() => whole(engine, "harmonic"));
    return {
      step: (budget) => (difference ? ask(() => own.compare(text, coarse, budget)) : 1),
      end: () => ({ harmonic: ask(() => harmonicOf(own.harmonic(text, coarse, difference))) }),
    };
  };
  /**
   * @param {"solid" | "solidFile"} name
   * @param {string} text
   * @param {object} options
   */
  const model = (name, text, options) => {
    const modelling = ask(() => whole(engine, name)[name](text, toText(options, "options")));
    const step = (/** @type {number} */ budget) => ask(() => modelling.step(budget));
    const result = () => ask(() => modelling.result());
    const run = () => {
      step(Infinity);
      return result();
    };
    return { step, run, end: () => (name === "solid" ? { solid: result() } : { file: result() }) };
  };
  /**
   * @param {import("./operations.js").Packed} document
   * @param {import("./body.js").Asked} question
   * @param {object} rest
   */
  const body = (document, question, rest) => {
    const work = ask(() => asking(whole(engine, "hyperpatch"), document, question, rest));
    return {
      step: (/** @type {number} */ budget) => ask(() => work.step(budget)),
      end: () => ({ answer: ask(() => work.answer()) }),
    };
  };
  /** @type {import("./directrix.js").Directrix["hyperpatch"]} */
  const bodyOf = (document) => {
    const parts = packed(document);
    const answer = (/** @type {any} */ question, /** @type {object} */ rest) => {
      const work = body(parts, question, rest);
      work.step(Infinity);
      return work.end().answer;
    };
    return { ...answer("body", {}), ...methods((question, args) => answer(question, inNames(question, args))) };
  };
  /**
   * @param {string} text
   * @param {import("./part.js").Question | "part"} question
   * @param {object} rest
   */
  const parted = (text, question, rest) => {
    const work = ask(() => askingPart(whole(engine, "part"), text, question, rest));
    return {
      step: (/** @type {number} */ budget) => ask(() => work.step(budget)),
      end: () => ({ answer: ask(() => work.answer()) }),
    };
  };
  /**
   * The boundary of a document, or with points the exact fractions there.
   *
   * @param {string} text
   * @param {unknown} [points]
   */
  const bounded = (text, points) => {
    const work = ask(() => askingBoundary(whole(engine, "boundary", points === undefined ? "boundary" : "exact"), text, points));
    return {
      step: (/** @type {number} */ budget) => ask(() => work.step(budget)),
      end: () => ({ answer: ask(() => work.answer()) }),
    };
  };
  /** @param {unknown} document @param {unknown} [points] */
  const boundaryOf = (document, points) => {
    const work = bounded(ask(() => toText(document)), points);
    work.step(Infinity);
    return work.end().answer;
  };
  /**
   * Options and features of a transform. Without a limit the field is left out, which JSON has no infinity for.
   *
   * @param {import("./directrix.js").TransformInput} input
   * @returns {[string, Uint8Array]}
   */
  const transformInput = ({ features, limit = Infinity, ...rest }) => {
    const options = toText(limit === Infinity ? rest : { ...rest, limit });
    if (!(features instanceof Uint8Array)) {
      throw new DirectrixError("type", "features", `${String(features)} was found; expected a Uint8Array`);
    }
    return [options, features];
  };
  /**
   * A transform under way.
   *
   * @param {import("./directrix.js").TransformInput} input
   */
  const transforming = (input) =>
    ask(() => {
      const transform = whole(engine, "transform").transform(...transformInput(input));
      return {
        step: (/** @type {number} */ budget) => ask(() => transform.step(budget)),
        end: () => ({ distances: ask(() => transform.result()) }),
      };
    });
  /**
   * A problem of Laplace's equation, or a question about its solution.
   *
   * @param {import("./laplace.js").Work} work
   * @returns {Work}
   */
  const laplace = (work) => ({ step: work.step, end: () => ({ answer: work.answer() }) });
  return {
    match: (document, { coarse = false } = {}) => ask(() => engine.match(toText(document), coarse)),
    stages: (document, options = {}) => ask(() => engine.stages(toText(document), options.refine ?? 1)),
    cells: (document) => ask(() => whole(engine, "cells").cells(toText(document))),
    isolines: (document, options = {}) =>
      ask(() => {
        const { levels = TENTHS } = options;
        const flat = engine.isolines(toText(document), toText({ ...options, levels }, "options"));
        return grouped(levels, flat);
      }),
    probe: (document, [x, y]) => ask(() => engine.probe(toText(document), x, y)),
    steps: (document) => ask(() => stepsOf(engine, document)),
    sets: (document, options) => ask(() => setsOf(engine, document, options)),
    paint(document, options) {
      const painting = start(document, options);
      return ask(() => {
        painting.step(Infinity);
        return painting.picture();
      });
    },
    svg: (document, options) =>
      ask(() => {
        const text = toText(document);
        return whole(engine, "svg").svg(text, toText(options, "options"), describe(engine.match(text, false)));
      }),
    fit: (document, options) => ask(() => engine.fit(toText(document), toText(options, "options"))),
    insertPoint: (document, curve, u) => ask(() => whole(engine, "insertPoint").insertPoint(toText(document), curve, u)),
    defaults: (document) => ask(() => engine.defaults(toText(document))),
    span: (document, span) => ask(() => spanOf(engine.defaults(toText(document)), span)),
    explain: (document, line) =>
      ask(() => {
        if (!Number.isInteger(line) || line < 0) {
          throw new DirectrixError("range", "line", `${String(line)} was found; expected the index of a line`);
        }
        return whole(engine, "explain").explain(toText(document), line);
      }),
    readShapes: (text, options = {}) =>
      ask(() => {
        const { format = "auto" } = options;
        if (typeof text !== "string") throw new DirectrixError("type", "text", `${String(text)} was found; expected a text`);
        if (!FORMATS.includes(format)) {
          throw new DirectrixError("range", "options.format", `"${format}" was found; expected ${FORMATS.join(", ")}`);
        }
        return shapesOf(whole(engine, "readShapes").readShapes(text, format));
      }),
    readMesh: (bytes) =>
      ask(() => {
        const list = bytes instanceof ArrayBuffer ? new Uint8Array(bytes) : bytes;
        if (!(list instanceof Uint8Array)) {
          throw new DirectrixError("type", "bytes", `${told(list)} was found; expected a Uint8Array or an ArrayBuffer`);
        }
        return whole(engine, "readMesh").readMesh(list);
      }),
    fitCurve: (points, options) =>
      ask(() => whole(engine, "fitCurve").fitCurve(flatPoints(points), toText(options, "options"))),
    morphPaths: (document, options = {}) =>
      ask(() => whole(engine, "morphPaths").morphPaths(toText(document), toText(options, "options"))),
    harmonic: (document, { coarse = false, difference = false } = {}) =>
      ask(() => harmonicOf(whole(engine, "harmonic").harmonic(toText(document), coarse, difference))),
    amounts: (document) => ask(() => whole(engine, "amounts").amounts(toText(document))),
    solid: (document, options = {}) => model("solid", ask(() => toText(document)), options).run(),
    solidFile: (document, options) => model("solidFile", ask(() => toText(document)), options).run(),
    hyperpatch: bodyOf,
    merge(document, other) {
      const own = /** @type {import("./directrix.js").HyperpatchDocument} */ (valueOf(document));
      const { materials = [] } = bodyOf({ ...own, operations: [] }).cellsDocument();
      bodyOf(own);
      const made = merged(own, materials, bodyOf(other).cellsDocument());
      bodyOf(made);
      return made;
    },
    distanceTransform(input) {
      const work = transforming(input);
      work.step(Infinity);
      return work.end().distances;
    },
    solveLaplace(input) {
      const work = solving(ask(() => whole(engine, "laplace", "solveLaplace")), input, ask);
      work.step(Infinity);
      return work.answer();
    },
    boundary: (document) => boundaryOf(document),
    exact: (document, points) => boundaryOf(document, points ?? null),
    transformSteps: (input) => ask(() => whole(engine, "transformSteps").transformSteps(...transformInput(input))),
    part(document) {
      const text = ask(() => toText(document));
      const answer = (/** @type {any} */ question, /** @type {object} */ rest) => {
        const work = parted(text, question, rest);
        work.step(Infinity);
        return work.end().answer;
      };
      return { ...answer("part", {}), ...partMethods((question, args) => answer(question, partArguments(question, args))) };
    },
    job(document, options = {}) {
      const { paint, solid, solidFile, harmonic, hyperpatch, part, distanceTransform, solveLaplace, boundary } = options;
      const { coarse = paint?.coarse ?? harmonic?.coarse ?? false, greedy = false } = options;
      const ofLaplace = options.laplace
        ? askingLaplace(options.laplace.solution, options.laplace.question, options.laplace, ask)
        : solveLaplace && solving(ask(() => whole(engine, "laplace", "solveLaplace")), solveLaplace, ask);
      const free = ofLaplace ? laplace(ofLaplace) : distanceTransform && transforming(distanceTransform);
      const ofPart = part && parted(ask(() => toText(document)), /** @type {any} */ (part.question), part.rest ?? {});
      const ofBoundary = boundary && bounded(ask(() => toText(document)), boundary.points);
      const asked = free ?? ofPart ?? ofBoundary ?? (hyperpatch && body(received(document) ?? packed(document), hyperpatch.question, hyperpatch.rest ?? {}));
      if (asked) {
        /** @type {import("./directrix.js").Progress | undefined} */
        let last;
        const step = (/** @type {number} */ budget) => {
          const progress = asked.step(budget);
          return progress < 1 ? { progress, done: false } : (last = { progress, done: true, ...asked.end() });
        };
        return { step: (budget) => last ?? step(budget) };
      }
      const text = ask(() => (greedy ? greedyText(engine, /** @type {any} */ (document)) : toText(document)));
      /** @type {(() => Work) | undefined} */
      let next;
      if (paint) next = () => painted(text, paint, coarse);
      else if (harmonic) next = () => compared(text, coarse, harmonic.difference ?? false);
      else if (solid) next = () => model("solid", text, solid);
      else if (solidFile) next = () => model("solidFile", text, solidFile);
      /** @type {Work | undefined} */
      let work;
      /** @type {import("./directrix.js").Progress | undefined} */
      let end;
      const solve = (/** @type {number} */ budget) => {
        const progress = ask(() => engine.step(text, coarse, budget));
        if (!next) return { progress, done: progress === 1 };
        if (progress === 1) work = next();
        return { progress: progress / 2, done: false };
      };
      const go = (/** @type {Work} */ work, /** @type {number} */ budget) => {
        const share = work.step(budget);
        if (share < 1) return { progress: (1 + share) / 2, done: false };
        return (end = { progress: 1, done: true, ...work.end() });
      };
      return { step: (budget) => end ?? (work ? go(work, budget) : solve(budget)) };
    },
  };
}
