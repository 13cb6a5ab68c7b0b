/** Closed B-splines evaluated and measured in plain JavaScript: nothing of the kernels is used, so that the two can check each other. */

/** @import { Curve, Point } from "../../js/directrix.js" */

/** A point of a curve with its outward unit normal. @typedef {{point: Point, normal: Point}} End */

/** Pieces, at least, into which a curve is cut to measure its length. */
const leastPieces = 4000;

/**
 * A closed B-spline turned counter-clockwise: where it is drawn clockwise the parameter u becomes lo + hi − u, as in results.
 * A *share* is a fraction of its arc length from the start of the domain.
 */
export class ClosedCurve {
  /** @param {Pick<Curve, "degree" | "form" | "points" | "knots">} spec */
  constructor(spec) {
    this.degree = spec.degree;
    this.control = spec.form === "clamped" ? spec.points : [...spec.points, ...spec.points.slice(0, spec.degree)];
    this.knots = allKnots(spec);
    this.low = this.knots[this.degree];
    this.high = this.knots[this.control.length];
    this.scratch = [new Float64Array(spec.degree + 1), new Float64Array(spec.degree + 1)];
    this.isReversed = false;
    const spans = [...new Set(this.knots)].filter((u) => u >= this.low && u <= this.high);
    const cuts = Math.ceil(leastPieces / (spans.length - 1));
    /** Ascending, from one end of the domain to the other; every knot is one. @type {number[]} */
    this.parameters = spans
      .slice(1)
      .flatMap((u, k) => Array.from({ length: cuts }, (_, i) => spans[k] + ((u - spans[k]) * i) / cuts));
    this.parameters.push(this.high);
    this.isReversed = polygonArea(this.parameters.map((u) => this.evaluate(u).point)) < 0;
    if (this.isReversed) this.parameters = this.parameters.map((u) => this.low + this.high - u).reverse();
    /** A fine polygon, by the same parameters without the last. */
    this.polygon = this.parameters.slice(0, -1).map((u) => this.evaluate(u).point);
    /** Arc length from the start to each of the parameters. */
    this.lengths = [0];
    this.parameters.slice(1).forEach((u, k) => {
      const from = this.parameters[k];
      const hair = (u - from) * 1e-9;
      // By Simpson's rule, from within the piece: at its ends there may be corners.
      const [a, b, c] = [from + hair, (from + u) / 2, u - hair].map((at) => Math.hypot(...this.evaluate(at).derivative));
      this.lengths.push(this.lengths[k] + ((a + 4 * b + c) / 6) * (u - from));
    });
  }

  get length() {
    return this.lengths[this.lengths.length - 1];
  }

  /**
   * By de Boor's algorithm.
   *
   * @param {number} parameter
   * @returns {{point: Point, derivative: Point}}
   */
  evaluate(parameter) {
    const { degree: p, knots } = this;
    const period = this.high - this.low;
    const wrapped = parameter - Math.floor((parameter - this.low) / period) * period;
    const u = this.isReversed ? this.low + this.high - wrapped : wrapped;
    let [span, beyond] = [p, this.control.length];
    while (beyond - span > 1) {
      const middle = (span + beyond) >> 1;
      if (knots[middle] <= u) span = middle;
      else beyond = middle;
    }
    // The end of the domain belongs to the last span of any length.
    while (knots[span] === knots[span + 1]) span--;
    const [x, y] = this.scratch;
    for (let j = 0; j <= p; j++) [x[j], y[j]] = this.control[span - p + j];
    let [dx, dy] = [0, 0];
    for (let r = 1; r <= p; r++) {
      if (r === p) {
        const scale = (this.isReversed ? -p : p) / (knots[span + 1] - knots[span]);
        dx = scale * (x[p] - x[p - 1]);
        dy = scale * (y[p] - y[p - 1]);
      }
      for (let j = p; j >= r; j--) {
        const i = span - p + j;
        const t = (u - knots[i]) / (knots[i + p - r + 1] - knots[i]);
        x[j] = (1 - t) * x[j - 1] + t * x[j];
        y[j] = (1 - t) * y[j - 1] + t * y[j];
      }
    }
    return { point: [x[p], y[p]], derivative: [dx, dy] };
  }

  /**
   * @param {number} share
   * @returns {End}
   */
  at(share) {
    const u = this.parameterAt(share);
    const { point, derivative } = this.evaluate(u);
    const step = (this.high - this.low) * 1e-7;
    const speed = Math.hypot(...derivative);
    const [x, y] = speed > 0 ? derivative : difference(this.evaluate(u + step).point, this.evaluate(u - step).point);
    const size = Math.hypot(x, y);
    return { point, normal: [y / size, -x / size] };
  }

  /** @param {number} share beyond [0, 1] it goes round again */
  parameterAt(share) {
    return interpolate(this.lengths, this.parameters, (share - Math.floor(share)) * this.length);
  }

  /** Of a parameter beyond the domain: the laps are kept. @param {number} parameter */
  shareAt(parameter) {
    const laps = Math.floor((parameter - this.low) / (this.high - this.low));
    const within = parameter - laps * (this.high - this.low);
    return laps + interpolate(this.parameters, this.lengths, within) / this.length;
  }

  /**
   * Samples of equal arcs, or of equal parameter steps, from the start of the domain.
   *
   * @param {number} count
   * @param {"arc-length" | "parameter"} [scheme]
   * @returns {number[]} shares
   */
  samples(count, scheme = "arc-length") {
    const fractions = Array.from({ length: count }, (_, k) => k / count);
    if (scheme === "arc-length") return fractions;
    return fractions.map((fraction) => this.shareAt(this.low + fraction * (this.high - this.low)));
  }
}

/** @param {Pick<Curve, "degree" | "form" | "points" | "knots">} spec */
function allKnots({ degree: p, form, points, knots }) {
  const n = points.length;
  if (form === "clamped") {
    return knots ?? Array.from({ length: n + p + 1 }, (_, i) => Math.min(Math.max(i - p, 0), n - p) / (n - p));
  }
  if (knots?.length === n + 2 * p + 1) return knots;
  const domain = knots ?? Array.from({ length: n + 1 }, (_, i) => i / n);
  return Array.from({ length: n + 2 * p + 1 }, (_, i) => {
    const laps = Math.floor((i - p) / n);
    return domain[i - p - laps * n] + laps * (domain[n] - domain[0]);
  });
}

/**
 * @param {number[]} from ascending
 * @param {number[]} to
 * @param {number} value
 */
function interpolate(from, to, value) {
  let [low, high] = [0, from.length - 1];
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (from[middle] <= value) low = middle;
    else high = middle;
  }
  const t = (value - from[low]) / (from[high] - from[low]);
  return to[low] + t * (to[high] - to[low]);
}

/** @param {Point} a @param {Point} b @returns {Point} */
const difference = (a, b) => [a[0] - b[0], a[1] - b[1]];

/** Signed area of a polygon, positive when it runs counter-clockwise. @param {Point[]} points */
export function polygonArea(points) {
  return points.reduce((sum, [x, y], i) => {
    const [nx, ny] = points[(i + 1) % points.length];
    return sum + (x * ny - nx * y) / 2;
  }, 0);
}
