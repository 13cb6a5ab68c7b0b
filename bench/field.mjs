/** Distance transforms of features of different shapes, beside the transform inside npm's `@mapbox/tiny-sdf`. */
import { readFile } from "node:fs/promises";
import { load } from "../js/node.js";

/** Whether a place of [-1, 1]^3 belongs to a feature: distances are those inside the shapes. @type {Record<string, (p: number[]) => boolean>} */
const SHAPES = {
  cube: (p) => p.some((x) => Math.abs(x) > 0.9),
  sphere: (p) => p.reduce((sum, x) => sum + x * x, 0) > 0.81,
  cone: ([x, y, z]) => Math.hypot(x, z) > 0.45 * (1 - y),
  random: (p) => {
    const hash = p.reduce((sum, x) => Math.sin((sum + x) * 12.9898) * 43758.5453, 0);
    return hash - Math.floor(hash) < 0.001;
  },
};

/** @param {number[]} size @param {(p: number[]) => boolean} isFeature */
function features([nx, ny, nz = 1], isFeature) {
  const place = (/** @type {number} */ k, /** @type {number} */ count) => (count === 1 ? 0 : (2 * k + 1) / count - 1);
  return Uint8Array.from({ length: nx * ny * nz }, (_, n) =>
    Number(isFeature([place(n % nx, nx), place(Math.floor(n / nx) % ny, ny), place(Math.floor(n / (nx * ny)), nz)])),
  );
}

/** @param {[number, number] | [number, number, number]} size @param {string} shape @param {number} [limit] */
const transform = (size, shape, limit) => async () => {
  const dx = await load({ module: "full" });
  const found = features(size, SHAPES[shape]);
  return () => dx.distanceTransform({ size, features: found, limit });
};

/** The longest turn of a transform over a connection. @param {[number, number, number]} size */
const turns = (size) => async () => {
  const dx = await load({ module: "full" });
  const found = features(size, SHAPES.sphere);
  return function* () {
    const job = dx.job(null, { distanceTransform: { size, features: found } });
    while (!job.step(12).done) yield;
  };
};

/**
 * The transform inside `@mapbox/tiny-sdf`, which the package does not export: cut out of its installed source.
 *
 * @returns {Promise<(grid: Float64Array, width: number, height: number) => void>}
 */
export async function tinySdf() {
  const source = await readFile(new URL("../node_modules/@mapbox/tiny-sdf/index.js", import.meta.url), "utf8");
  const start = source.indexOf("function edt(");
  if (start < 0) throw new Error("@mapbox/tiny-sdf has no function edt any more");
  const edt = new Function("INF", `${source.slice(start)}; return edt;`)(1e20);
  return (grid, width, height) => {
    const length = Math.max(width, height);
    edt(grid, 0, 0, width, height, width, new Float64Array(length), new Uint16Array(length), new Float64Array(length + 1));
  };
}

/** @param {number} n @param {string} shape */
const peer = (n, shape) => async () => {
  const edt = await tinySdf();
  const found = features([n, n], SHAPES[shape]);
  return () => {
    const grid = Float64Array.from(found, (feature) => (feature ? 0 : 1e20));
    edt(grid, n, n);
    return Float32Array.from(grid, Math.sqrt);
  };
};

/** @type {import("../scripts/lib/bench.mjs").Case[]} */
export default [
  { name: "distances, 512 x 512, circle", prepare: transform([512, 512], "sphere") },
  { name: "distances, 1024 x 1024, circle", prepare: transform([1024, 1024], "sphere") },
  { name: "distances, 1024 x 1024, circle, transform of @mapbox/tiny-sdf", prepare: peer(1024, "sphere") },
  { name: "distances, 1024 x 1024, random", prepare: transform([1024, 1024], "random") },
  { name: "distances, 1024 x 1024, random, transform of @mapbox/tiny-sdf", prepare: peer(1024, "random") },
  { name: "distances, 128³, sphere", budget: 60, prepare: transform([128, 128, 128], "sphere") },
  { name: "distances, 256³, cube", budget: 450, prepare: transform([256, 256, 256], "cube") },
  { name: "distances, 256³, sphere", budget: 450, prepare: transform([256, 256, 256], "sphere") },
  { name: "distances, 256³, random", budget: 450, prepare: transform([256, 256, 256], "random") },
  { name: "distances, 256³, sphere, up to 16 voxels", prepare: transform([256, 256, 256], "sphere", 16) },
  { name: "distances, 128³, longest call", budget: 50, prepare: turns([128, 128, 128]) },
];
