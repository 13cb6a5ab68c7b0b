/**
 * What is wrong with a part: what the kernel left out, and broken design rules.
 *
 * @import { PartDiagnostic } from "../../../js/directrix.js"
 * @import { Known, Shown } from "./state.js"
 * @import { WholePart } from "./document.js"
 *
 * @typedef {object} Faults
 * @property {PartDiagnostic[]} skipped what is left out
 * @property {PartDiagnostic[]} remarks what is only said
 * @property {{rule: number, name: string, count: number, area: number}[]} broken design rules
 * @property {boolean} isMixed whether all fractions are within 0 to 1 and sum to 1
 */

/** Distance of a sum of single-precision fractions from 1 that is rounding. */
const ROUNDING = 2e-6;

/** @param {Known} known @returns {Faults} */
export function faultsOf({ part, measured }) {
  return {
    skipped: part.diagnostics.filter(({ skipped }) => skipped),
    remarks: part.diagnostics.filter(({ skipped }) => !skipped),
    broken: measured?.rules.filter(({ count }) => count > 0) ?? [],
    isMixed: !measured || (measured.clamped === 0 && isOne(measured.sumError)),
  };
}

/** Whether sums that are at most so far from 1 are 1. @param {number} error */
export const isOne = (error) => error <= ROUNDING;

/**
 * What a diagnostic is about, as a choice: the feature, the blend, the shape or the design rule at its path, and the place that shows it.
 * @param {WholePart} document
 * @param {PartDiagnostic} diagnostic
 * @returns {Partial<Shown>}
 */
export function choiceOf({ shapes = [], bodies }, diagnostic) {
  const { path } = diagnostic;
  const [feature, witness] = [diagnostic.feature ?? null, diagnostic.at ?? null];
  const indexIn = (/** @type {string} */ list) => {
    const found = new RegExp(`^${list}\\[(\\d+)\\]`).exec(path);
    return found ? Number(found[1]) : null;
  };
  const shape = indexIn("shapes");
  const rule = indexIn("rules");
  if (shape !== null) return { shape: shapes[shape]?.name ?? null, point: null, rule: null, witness };
  if (rule !== null) return { rule, shape: null, point: null, witness };
  const of = diagnostic.body ?? indexIn("bodies");
  const isBlend = path.includes(".blend");
  if (of !== null && isBlend) return { body: of, feature: null, shape: null, point: null, rule: null, witness, lit: bodies[of]?.blend?.boundaries?.[diagnostic.boundary ?? -1]?.on ?? null };
  const outline = of !== null && witness && feature === null ? (bodies[of]?.outline ?? null) : null;
  return { body: of, feature, shape: shapes.some(({ name }) => name === outline) ? outline : null, point: null, rule: null, witness };
}
