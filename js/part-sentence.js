/** Parts in words, apart from those of curves, which every page has. */
import { counted, list } from "./sentence.js";

/**
 * What is known of a part, in one sentence without a full stop, such as `1 body, 2 features, red 16.2 %, green 14.1 % and yellow 69.7 %`.
 *
 * @param {Pick<import("./directrix.js").Part, "bodies" | "diagnostics">} part
 * @param {object} found
 * @param {readonly { name: string }[]} found.materials
 * @param {{ area: number, amounts: number[] }} found.amounts
 * @param {readonly { name: string, count: number }[]} [found.rules] design rules, with the pixels that break each
 * @returns {string}
 */
export function describePart({ bodies, diagnostics }, { materials, amounts, rules = [] }) {
  const made = bodies.filter(({ made }) => made);
  const features = made.flatMap((body) => body.features.filter(({ active }) => active)).length;
  const blends = made.filter(({ blend }) => blend !== null && blend !== undefined).length;
  const skipped = diagnostics.filter((diagnostic) => diagnostic.skipped).length;
  if (made.length === 0) return skipped > 0 ? `No body that can be made, ${skipped} left out` : "No body yet";
  const share = (/** @type {number} */ k) => (amounts.area > 0 ? (100 * amounts.amounts[k]) / amounts.area : 0);
  const held = materials.flatMap(({ name }, k) => (share(k) >= 0.05 ? [`${name} ${share(k).toFixed(1)} %`] : []));
  const broken = rules.filter(({ count }) => count > 0);
  return [
    counted(made.length, "body", "bodies"),
    counted(features, "feature", "features"),
    blends > 0 && counted(blends, "blend", "blends"),
    skipped > 0 && `${skipped} left out`,
    list(held),
    rules.length > 0 && (broken.length === 0 ? "design rules kept" : `broken: ${list(broken.map(({ name }) => name))}`),
  ]
    .filter(Boolean)
    .join(", ");
}
