/**
 * What a part is worth, in numbers and in words.
 *
 * @import { Part, PartDocument } from "../../directrix.js"
 * @import { FigureResult } from "../../element.js"
 *
 * @typedef {object} Found
 * @property {PartDocument} document with every default
 * @property {ReturnType<Part["amounts"]>} amounts
 * @property {ReturnType<Part["violations"]>["rules"]} rules
 */
import { describePart } from "../../part-sentence.js";
import { NO_MATCHING } from "../no-matching.js";
import { words } from "./words.js";

/**
 * @param {Pick<Part, "bodies" | "diagnostics">} part
 * @param {Found} found
 * @returns {FigureResult}
 */
export function partResult(part, { document: { materials = [] }, amounts, rules }) {
  const made = part.bodies.filter(({ made }) => made);
  const features = made.flatMap((body) => body.features.filter(({ active }) => active)).length;
  const skipped = part.diagnostics.filter((diagnostic) => diagnostic.skipped).length;
  const broken = rules.filter(({ count }) => count > 0).length;
  const ok = skipped === 0;
  const facts = [
    made.length === 0 ? words.empty : `${words.bodies(made.length)}, ${words.features(features)}`,
    ...(skipped > 0 ? [words.skipped(skipped)] : []),
    ...(broken > 0 ? [words.broken(broken)] : []),
  ];
  return {
    ...NO_MATCHING,
    diagnostics: [...new Set(part.diagnostics.map(({ code }) => code))],
    ok,
    verified: ok && broken === 0 && made.length > 0,
    text: describePart(part, { materials, amounts, rules }),
    brief: facts.join(", "),
    part: {
      bodies: made.length,
      features,
      skipped,
      broken,
      area: amounts.area,
      fractions: amounts.amounts.map((amount) => (amounts.area > 0 ? amount / amounts.area : 0)),
    },
  };
}
