/** Closed curves for the tests, and a slow evaluation of them by the definition of the basis functions. */

/**
 * Points round the origin, counter-clockwise.
 * @param {number} count
 * @param {number} radius
 * @returns {[number, number][]}
 */
export const loop = (count, radius) =>
  Array.from({ length: count }, (_, i) => {
    const angle = (2 * Math.PI * i) / count;
    return [radius * Math.cos(angle), radius * Math.sin(angle)];
  });

/**
 * Signed area of a polygon.
 * @param {readonly (readonly number[])[]} points
 */
export const polygonArea = (points) =>
  points.reduce((sum, [x, y], i) => {
    const [nx, ny] = points[(i + 1) % points.length];
    return sum + (x * ny - nx * y) / 2;
  }, 0);

/**
 * The point of a curve at a fraction of its domain, summed over all basis functions by the recursion of Cox and de Boor.
 * @param {{degree: number, form: string, points: [number, number][], knots?: number[]}} curve
 * @param {number} t in [0, 1]
 * @returns {[number, number]}
 */
export function deBoorAt({ degree: p, form, points, knots }, t) {
  const n = points.length;
  /** @type {number[]} */
  let full;
  /** @type {[number, number][]} */
  let control;
  if (form === "clamped") {
    full = knots ?? Array.from({ length: n + p + 1 }, (_, i) => Math.min(Math.max(i - p, 0), n - p) / (n - p));
    control = points;
  } else {
    control = Array.from({ length: n + p }, (_, i) => points[i % n]);
    if (knots?.length === n + 2 * p + 1) full = knots;
    else {
      const domain = knots ?? Array.from({ length: n + 1 }, (_, i) => i / n);
      const period = domain[n] - domain[0];
      full = Array.from({ length: n + 2 * p + 1 }, (_, i) => {
        const turns = Math.floor((i - p) / n);
        return domain[i - p - turns * n] + turns * period;
      });
    }
  }
  const [low, high] = [full[p], full[control.length]];
  // The end of the domain belongs to the last span before it.
  const u = t >= 1 ? high - (high - low) * 1e-13 : low + (high - low) * t;
  /** @type {(i: number, degree: number) => number} */
  const basis = (i, degree) => {
    if (degree === 0) return full[i] <= u && u < full[i + 1] ? 1 : 0;
    const left = full[i + degree] > full[i] ? ((u - full[i]) / (full[i + degree] - full[i])) * basis(i, degree - 1) : 0;
    const span = full[i + degree + 1] - full[i + 1];
    const right = span > 0 ? ((full[i + degree + 1] - u) / span) * basis(i + 1, degree - 1) : 0;
    return left + right;
  };
  return control.reduce(
    (sum, [x, y], i) => {
      const b = basis(i, p);
      return /** @type {[number, number]} */ ([sum[0] + b * x, sum[1] + b * y]);
    },
    /** @type {[number, number]} */ ([0, 0]),
  );
}
