/**
 * Triangles in space as pixels, nearest first, without a graphics card: a page may show any number of figures, and browsers give it few
 * contexts of one. Coloured between the vertices in Oklab, in which fractions mix.
 *
 * @import { Camera, Frame } from "../../space/camera.js"
 *
 * @typedef {object} Mesh
 * @property {Float32Array} positions three numbers a vertex
 * @property {Float32Array} labs Oklab, three numbers a vertex
 * @property {Uint32Array} indices three a triangle
 * @property {Float32Array} [normals] outwards; what has none is not lit
 *
 * @typedef {{ normal: readonly number[], offset: number }} Plane what has a product with the normal below the offset is away
 */
import { axesOf, middleOf, unitsPerPixel } from "../../space/camera.js";

/** The light comes from the upper left, before the picture: right, up, towards the eye. */
const LIGHT = [-0.42, 0.68, 0.6];
const LENGTH = Math.hypot(...LIGHT);
/** Least and most of it, and what the inner side of a wall gets; as in the workbench, see www/src/space/surface.js. */
const [DARKEST, BRIGHTEST, INNER] = [0.42, 1.06, 0.72];
/** Numbers that a vertex takes in the list of those that are placed. */
const WIDTH = 10;
/** The nearest depth that is drawn, as a share of the distance. */
const NEAREST = 1e-3;

/** Bytes of sRGB for linear light in steps of 1/4095 (IEC 61966-2-1). */
const ENCODED = Uint8ClampedArray.from({ length: 4096 }, (_, n) => {
  const c = n / 4095;
  return 255 * (c <= 0.0031308 ? 12.92 * c : 1.055 * c ** (1 / 2.4) - 0.055);
});

/** @param {number} light */
const byte = (light) => ENCODED[light <= 0 ? 0 : light >= 1 ? 4095 : (light * 4095 + 0.5) | 0];

/** What a share of a triangle may be below 0 at its rim, so that no pixel between two of them is left out. */
const SLACK = 1e-6;

/** The first place, not above it, from which on a share that grows by a step is no less than 0. @param {number} first @param {number} step */
const enters = (first, step) => (step > 0 ? Math.floor(-first / step) : step === 0 && first < -SLACK ? Infinity : 0);

/** The last place, not below it, until which a share that falls by a step is no less than 0. @param {number} first @param {number} step */
const leaves = (first, step) => (step < 0 ? Math.ceil(-first / step) : Infinity);

/** @param {number} x */
const cubed = (x) => x * x * x;

/** @param {number} toLight the cosine between a normal and the light */
function strength(toLight) {
  const t = Math.min(1, Math.max(0, (0.5 + 0.5 * toLight - 0.05) / 0.9));
  return DARKEST + (BRIGHTEST - DARKEST) * t * t * (3 - 2 * t);
}

/**
 * Where points of space are seen, in pixels of a raster.
 *
 * @param {Camera} camera
 * @param {Frame} frame
 * @param {number} ratio pixels for one of the frame
 */
export function projection(camera, frame, ratio) {
  const { right, up, back } = axesOf(camera);
  const { target, distance } = camera;
  const [x0, y0] = middleOf(frame).map((middle) => middle * ratio);
  const focal = (distance / unitsPerPixel(camera, frame)) * ratio;
  return {
    right,
    up,
    back,
    nearest: distance * NEAREST,
    /**
     * @param {ArrayLike<number>} points
     * @param {number} start
     * @param {Float32Array} into gets the place and, third, one over the depth, which is not positive before the eye
     * @param {number} at
     */
    place(points, start, into, at) {
      const [x, y, z] = [points[start] - target[0], points[start + 1] - target[1], points[start + 2] - target[2]];
      const depth = distance - (x * back[0] + y * back[1] + z * back[2]);
      const scale = focal / depth;
      into[at] = x0 + (x * right[0] + y * right[1] + z * right[2]) * scale;
      into[at + 1] = y0 - (x * up[0] + y * up[1] + z * up[2]) * scale;
      into[at + 2] = 1 / depth;
    },
  };
}

export class Raster {
  /** One over the depth of what is seen at each pixel; 0 where there is nothing. */
  nearness;
  /** sRGB and opacity. */
  pixels;

  /** @param {number} width @param {number} height */
  constructor(width, height) {
    this.width = width;
    this.height = height;
    this.nearness = new Float32Array(width * height);
    this.pixels = new Uint8ClampedArray(4 * width * height);
  }

  /**
   * @param {Mesh} mesh
   * @param {ReturnType<typeof projection>} seen
   * @param {Plane | null} [cut]
   */
  fill(mesh, seen, cut = null) {
    const placed = placedVertices(mesh, seen, cut);
    const { indices } = mesh;
    for (let k = 0; k < indices.length; k += 3) {
      this.#triangle(placed, WIDTH * indices[k], WIDTH * indices[k + 1], WIDTH * indices[k + 2], cut !== null);
    }
  }

  /** @param {Float32Array} v @param {number} a @param {number} b @param {number} c @param {boolean} isCut */
  #triangle(v, a, b, c, isCut) {
    if (v[a + 2] <= 0 || v[b + 2] <= 0 || v[c + 2] <= 0) return;
    if (isCut && v[a + 9] < 0 && v[b + 9] < 0 && v[c + 9] < 0) return;
    const [ax, ay, bx, by, cx, cy] = [v[a], v[a + 1], v[b], v[b + 1], v[c], v[c + 1]];
    const area = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);
    if (area === 0 || !Number.isFinite(area)) return;
    const { width, height, nearness, pixels } = this;
    const left = Math.max(0, Math.ceil(Math.min(ax, bx, cx) - 0.5));
    const right = Math.min(width - 1, Math.floor(Math.max(ax, bx, cx) - 0.5));
    const top = Math.max(0, Math.ceil(Math.min(ay, by, cy) - 0.5));
    const bottom = Math.min(height - 1, Math.floor(Math.max(ay, by, cy) - 0.5));
    // Counter-clockwise from outside, and y runs down here.
    const side = area < 0 ? 7 : 8;
    const stepA = (by - cy) / area;
    const stepB = (cy - ay) / area;
    const stepC = (ay - by) / area;
    for (let y = top; y <= bottom; y += 1) {
      const px = left + 0.5;
      const py = y + 0.5;
      const firstA = ((bx - px) * (cy - py) - (by - py) * (cx - px)) / area;
      const firstB = ((cx - px) * (ay - py) - (cy - py) * (ax - px)) / area;
      const firstC = 1 - firstA - firstB;
      // Thin triangles are much smaller than their boxes: of the row only what may lie inside all three edges.
      const from = Math.max(0, enters(firstA, stepA), enters(firstB, stepB), enters(firstC, stepC));
      const to = Math.min(right - left, leaves(firstA, stepA), leaves(firstB, stepB), leaves(firstC, stepC));
      for (let n = from, at = y * width + left + from; n <= to; n += 1, at += 1) {
        const wa = firstA + n * stepA;
        const wb = firstB + n * stepB;
        const wc = firstC + n * stepC;
        if (wa < -SLACK || wb < -SLACK || wc < -SLACK) continue;
        const near = wa * v[a + 2] + wb * v[b + 2] + wc * v[c + 2];
        if (near <= nearness[at]) continue;
        if (isCut && wa * v[a + 9] + wb * v[b + 9] + wc * v[c + 9] < 0) continue;
        nearness[at] = near;
        // Straight in space, not on the screen: what was divided by the depth is multiplied by it again.
        const fa = wa / near;
        const fb = wb / near;
        const fc = wc / near;
        const light = fa * v[a + side] + fb * v[b + side] + fc * v[c + side];
        const L = fa * v[a + 3] + fb * v[b + 3] + fc * v[c + 3];
        const A = fa * v[a + 4] + fb * v[b + 4] + fc * v[c + 4];
        const B = fa * v[a + 5] + fb * v[b + 5] + fc * v[c + 5];
        const l = cubed(L + 0.3963377774 * A + 0.2158037573 * B);
        const m = cubed(L - 0.1055613458 * A - 0.0638541728 * B);
        const s = cubed(L - 0.0894841775 * A - 1.291485548 * B);
        const pixel = 4 * at;
        pixels[pixel] = byte((4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s) * light);
        pixels[pixel + 1] = byte((-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s) * light);
        pixels[pixel + 2] = byte((-0.0041960863 * l - 0.7034186147 * m + 1.707614701 * s) * light);
        pixels[pixel + 3] = 255;
      }
    }
  }

  /**
   * The picture with so many pixels of the raster for each of its own, either way.
   *
   * @param {number} count
   * @returns {ImageData}
   */
  image(count) {
    const [width, height] = [this.width / count, this.height / count];
    if (count === 1) return new ImageData(this.pixels, width, height);
    const image = new ImageData(width, height);
    for (let y = 0, to = 0; y < height; y += 1) {
      for (let x = 0; x < width; x += 1, to += 4) {
        let [red, green, blue, opacity] = [0, 0, 0, 0];
        for (let n = 0; n < count * count; n += 1) {
          const from = 4 * ((y * count + Math.floor(n / count)) * this.width + x * count + (n % count));
          if (this.pixels[from + 3] === 0) continue;
          red += this.pixels[from];
          green += this.pixels[from + 1];
          blue += this.pixels[from + 2];
          opacity += 1;
        }
        if (opacity === 0) continue;
        image.data[to] = red / opacity;
        image.data[to + 1] = green / opacity;
        image.data[to + 2] = blue / opacity;
        image.data[to + 3] = (255 * opacity) / (count * count);
      }
    }
    return image;
  }
}

/**
 * For each vertex: its place on the screen, one over its depth, and, each divided by the depth, its colour, what light it has as part of a
 * wall seen from outside and from inside, and how far it is before the plane.
 *
 * @param {Mesh} mesh
 * @param {ReturnType<typeof projection>} seen
 * @param {Plane | null} cut
 */
function placedVertices({ positions, labs, normals }, seen, cut) {
  const count = positions.length / 3;
  const placed = new Float32Array(WIDTH * count);
  const { right, up, back } = seen;
  const towards = [0, 1, 2].map((k) => (LIGHT[0] * right[k] + LIGHT[1] * up[k] + LIGHT[2] * back[k]) / LENGTH);
  for (let n = 0, p = 0, at = 0; n < count; n += 1, p += 3, at += WIDTH) {
    seen.place(positions, p, placed, at);
    const near = placed[at + 2];
    if (!(near > 0) || 1 / near < seen.nearest) {
      placed[at + 2] = 0;
      continue;
    }
    for (let k = 0; k < 3; k += 1) placed[at + 3 + k] = labs[p + k] * near;
    const cosine = normals ? normals[p] * towards[0] + normals[p + 1] * towards[1] + normals[p + 2] * towards[2] : 0;
    placed[at + 7] = (normals ? strength(cosine) : 1) * near;
    placed[at + 8] = (normals ? strength(-cosine) * INNER : 1) * near;
    if (!cut) continue;
    const [a, b, c] = cut.normal;
    placed[at + 9] = (positions[p] * a + positions[p + 1] * b + positions[p + 2] * c - cut.offset) * near;
  }
  return placed;
}
