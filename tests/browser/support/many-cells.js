/**
 * A document of the kind `hyperpatch` with many cells: a bent block, of three materials.
 *
 * @param {number} along
 * @param {number} across
 * @param {number} high
 */
export function manyCells(along, across, high) {
  /** @param {number} x @param {number} y @param {number} z */
  const bent = (x, y, z) => [x, y + 0.08 * x * x, z + 0.04 * x * y].map((value) => Number(value.toFixed(6)));
  const cells = [];
  for (let n = 0; n < along * across * high; n += 1) {
    const [x, y, z] = [n % along, Math.floor(n / along) % across, Math.floor(n / along / across)];
    const coefficients = Array.from({ length: 64 }, (_, c) => {
      const at = [x + (c >> 4) / 3, y + ((c >> 2) & 3) / 3, z + (c & 3) / 3];
      const [first, second] = [at[0] / along, at[1] / across];
      const mix = [(1 - first) * (1 - second), first * (1 - second)].map((value) => Number(value.toFixed(9)));
      return { position: bent(at[0], at[1], at[2]), mix: [...mix, Number((1 - mix[0] - mix[1]).toFixed(9))] };
    });
    cells.push({ coefficients });
  }
  const materials = ["#f0e442", "#009e73", "#0072b2"].map((color, i) => ({ name: `material ${i + 1}`, color }));
  return { directrix: 1, kind: "hyperpatch", title: "Many cells", materials, operations: [{ op: "cells", cells }] };
}
