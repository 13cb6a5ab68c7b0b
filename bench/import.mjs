/** Shapes from elsewhere, from text to a matching; with the module `full`, which alone reads them. */
import { load } from "../js/node.js";

/**
 * A closed path of cubic segments round a wavy ring, in tangents so that it is smooth.
 *
 * @param {number} segments
 * @param {number} radius
 * @param {number} waves
 */
function ring(segments, radius, waves) {
  const step = (2 * Math.PI) / segments;
  const at = (/** @type {number} */ t) => {
    const r = radius * (1 + 0.12 * Math.sin(waves * t));
    return [200 + r * Math.cos(t), 200 + r * Math.sin(t)];
  };
  const speed = (/** @type {number} */ t) => at(t + 1e-5).map((x, k) => (x - at(t - 1e-5)[k]) / 2e-5);
  const show = (/** @type {number[]} */ p) => p.map((x) => x.toFixed(3)).join(" ");
  let data = `M${show(at(0))}`;
  for (let i = 0; i < segments; i++) {
    const [a, b] = [i * step, (i + 1) * step];
    const [p, v, q, w] = [at(a), speed(a), at(b), speed(b)];
    data += `C${show(p.map((x, k) => x + (v[k] * step) / 3))} ${show(q.map((x, k) => x - (w[k] * step) / 3))} ${show(q)}`;
  }
  return `<path d="${data}z"/>`;
}

const drawing = `<svg xmlns="http://www.w3.org/2000/svg">${ring(1000, 170, 7)}${ring(1000, 80, 5)}</svg>`;
const options = { tolerance: 0.5, corners: /** @type {const} */ ("keep") };

/** A stroke as a pointer draws it: uneven steps, jitter, ends that overlap. */
function stroke() {
  let state = 7;
  const random = () => (state = (state * 16807) % 2147483647) / 2147483647;
  /** @type {import("../js/directrix.js").Point[]} */
  const points = [];
  for (let t = 0; t < 1.04; t += (0.2 + 1.6 * random()) / 500) {
    const [angle, jitter] = [2 * Math.PI * t, () => 2 * random() - 1];
    const radius = 100 + 25 * Math.cos(2 * angle) + 10 * Math.sin(5 * angle);
    points.push([radius * Math.cos(angle) + jitter(), radius * Math.sin(angle) + jitter()]);
  }
  return points;
}

/** @param {number} count */
const circle = (count) =>
  Array.from({ length: count }, (_, i) => {
    const angle = (2 * Math.PI * i) / count;
    return /** @type {import("../js/directrix.js").Point} */ ([30 * Math.cos(angle), 20 * Math.sin(angle)]);
  });

/** @param {import("../js/directrix.js").Directrix} dx @param {import("../js/directrix.js").Shape} shape */
const fitted = (dx, { points, corners }) => dx.fitCurve(points, { ...options, cornerIndices: corners }).curve;

/** @type {import("../scripts/lib/bench.mjs").Case[]} */
export default [
  {
    name: "SVG of 2,000 segments imported, fitted and matched",
    budget: 200,
    async prepare() {
      const dx = await load({ module: "full" });
      let run = 0;
      return () => {
        const { shapes } = dx.readShapes(drawing);
        const [outer, inner] = shapes.map((shape) => fitted(dx, shape));
        inner.points[0][0] += ++run * 1e-6;
        const match = dx.match({ directrix: 1, kind: "curves", curves: [inner, outer], matching: { method: "greedy" } });
        if (!match.ok) throw new Error("the drawing is not matched");
      };
    },
  },
  {
    name: "SVG of 2,000 segments read",
    budget: 50,
    async prepare() {
      const dx = await load({ module: "full" });
      return () => dx.readShapes(drawing);
    },
  },
  {
    name: "outline of 1,000 segments fitted",
    budget: 50,
    async prepare() {
      const dx = await load({ module: "full" });
      const [outer] = dx.readShapes(drawing).shapes;
      return () => fitted(dx, outer);
    },
  },
  {
    name: "stroke of 520 points fitted",
    budget: 20,
    async prepare() {
      const dx = await load({ module: "full" });
      const points = stroke();
      return () => dx.fitCurve(points, { tolerance: 3, corners: "smooth", through: false });
    },
  },
  {
    name: "20,000 points fitted to a ten-thousandth",
    budget: 50,
    async prepare() {
      const dx = await load({ module: "full" });
      const points = circle(20_000);
      return () => dx.fitCurve(points, { tolerance: 0.005, corners: "smooth" });
    },
  },
  {
    name: "curve through 1,000 points",
    budget: 50,
    async prepare() {
      const dx = await load({ module: "full" });
      const points = circle(1000);
      return () => dx.fitCurve(points, { tolerance: 0.1, through: true, corners: "smooth" });
    },
  },
  {
    name: "CSV of 20,000 points read",
    budget: 50,
    async prepare() {
      const dx = await load({ module: "full" });
      const text = circle(20_000).join("\n");
      return () => dx.readShapes(text);
    },
  },
  {
    name: "JSON of 20,000 points read",
    budget: 50,
    async prepare() {
      const dx = await load({ module: "full" });
      const text = JSON.stringify(circle(20_000));
      return () => dx.readShapes(text);
    },
  },
];
