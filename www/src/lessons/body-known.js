/**
 * What the kernel says of the body of a figure.
 *
 * @import { BodySurface, CellVerdict, CornerNeighbourhood } from "../../../js/directrix.js"
 * @import { Figure } from "../../../scripts/lib/lesson.mjs"
 * @import { BodyDocument, Cell } from "../hyperpatch/document.js"
 * @import { Kernel } from "../types.js"
 * @import { Chosen, Reach } from "./body-edits.js"
 *
 * @typedef {{document: BodyDocument, chosen: Chosen, reach: Reach | null}} Job
 *
 * @typedef {object} Known
 * @property {Job} job what it is about
 * @property {Cell[]} cells as the operations of the document have made them
 * @property {BodySurface} surface
 * @property {CellVerdict[]} verdicts
 * @property {CornerNeighbourhood | null} around the corner of the figure, where it shows that
 * @property {Chosen[]} moving what moves with the chosen coefficient, where moving is an operation
 * @property {{amounts: number[], volume: number} | null} measures where they are read
 */
import { cellsOf } from "../hyperpatch/document.js";
import { cornerOf, oppositeOf } from "./body-edits.js";

/** Readings that say how cells continue each other at the corner. @param {Figure} figure */
const asksCorner = ({ net, reading }) => net === "corner" || reading === "joints" || reading === "row";

/** A surface with all faces but those of one cell, behind which the others are seen. @param {BodySurface} surface @param {number} without @returns {BodySurface} */
function lackOf(surface, without) {
  const stretches = surface.patches.filter(({ cell }) => cell !== without).map(({ start, count }) => surface.indices.subarray(start, start + count));
  const indices = new Uint32Array(stretches.reduce((sum, { length }) => sum + length, 0));
  let at = 0;
  for (const stretch of stretches) {
    indices.set(stretch, at);
    at += stretch.length;
  }
  return { ...surface, indices };
}

/**
 * @param {Kernel} kernel
 * @param {Figure} figure
 * @param {Job} job
 * @param {AbortSignal} signal
 * @returns {Promise<Known>}
 */
export async function known(kernel, figure, job, signal) {
  const { document, chosen, reach } = job;
  const body = await kernel.hyperpatch(document, { signal });
  const { without } = figure;
  const surface = without === null ? await body.surface({}, { signal }) : lackOf(await body.surface({ faces: "all" }, { signal }), without);
  const verdicts = await body.verdicts({}, { signal });
  const isWritten = document.operations.every(({ op }) => op === "cells");
  const cells = cellsOf(isWritten ? document : /** @type {BodyDocument} */ (await body.cellsDocument({ signal })));
  const corner = cornerOf(figure.coefficient ?? [3, 3, 3]);
  const around = asksCorner(figure) ? await body.neighbourhood(figure.cell, corner, { signal }) : null;
  const measures = figure.reading === "amounts" ? { amounts: await body.amounts({ signal }), volume: await body.volume({ signal }) } : null;
  /** @type {Chosen[]} */
  const moving = [];
  const opposite = reach === "pair" ? oppositeOf(document, chosen) : null;
  for (const each of reach ? [chosen, ...(opposite ? [opposite] : [])] : []) {
    const found = await body.moves(each.cell, each.at, reach === "block" ? "block" : "single", { signal });
    moving.push(...found.map(({ cell, at }) => ({ cell, at })));
  }
  return { job, cells, surface, verdicts, around, moving, measures };
}
