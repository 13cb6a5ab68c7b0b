/** Matching through the API, at the size of a preset and at the largest that has a budget. */
import { readFile } from "node:fs/promises";

/**
 * @param {number} count of samples on each curve
 * @param {number} [budget] milliseconds
 * @returns {import("../scripts/lib/bench.mjs").Case}
 */
const match = (count, budget) => ({
  name: `match ${count} x ${count} samples`,
  budget,
  async prepare(dx) {
    const document = JSON.parse(await readFile(new URL("../www/presets/amoeba.json", import.meta.url), "utf8"));
    document.sampling = { scheme: "arc-length", counts: [count, count] };
    let run = 0;
    return () => {
      // A document that was solved before is answered from memory.
      document.curves[0].points[0][0] += run++ % 2 === 0 ? 1e-6 : -1.5e-6;
      return dx.match(document);
    };
  },
});

export default [match(44), match(200, 40)];
