/**
 * The stages between the curves.
 *
 * @import { CurvesDocument } from "../types.js"
 */

/** As printed, stages are counted from the second curve. @param {CurvesDocument} document */
export const countsBack = (document) => document.matching.printed?.includes("stages") ?? false;

/** Parts into which the stages cut each line: as printed, the number of stages is that of the curves in between. @param {CurvesDocument} document */
export const segmentsOf = (document) => document.blend.stages + (countsBack(document) ? 1 : 0);
