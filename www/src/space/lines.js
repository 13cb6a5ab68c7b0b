/**
 * Lines of a width in pixels, as separate segments or as polylines, which planes cut as they cut surfaces.
 *
 * @import { Plane as ClippingPlane } from "three"
 *
 * @typedef {object} LineLook
 * @property {string} [color] CSS; without it the segments have colours of their own
 * @property {number} width CSS pixels
 * @property {number} [opacity]
 * @property {number} order lines of a higher one are drawn over those of a lower
 */
import { Color } from "three";
import { LineMaterial } from "three/addons/lines/LineMaterial.js";
import { LineSegments2 } from "three/addons/lines/LineSegments2.js";
import { LineSegmentsGeometry } from "three/addons/lines/LineSegmentsGeometry.js";

/** Pixels that lines are nearer to the eye than what they lie on, besides as many as they are wide: half of them dips into a slanted surface. */
const NEARER = 1.5;

export class Lines {
  #material;
  #nearer;
  #geometry = new LineSegmentsGeometry();

  /** @param {ClippingPlane[]} clippingPlanes @param {LineLook} look */
  constructor(clippingPlanes, { color, width, opacity = 1, order }) {
    this.#material = new LineMaterial({
      linewidth: width,
      vertexColors: color === undefined,
      transparent: true,
      opacity,
      depthWrite: false,
      clipping: true,
      clippingPlanes,
    });
    if (color !== undefined) this.#material.color.setStyle(color);
    this.#nearer = NEARER + 1.5 * width;
    this.#material.uniforms.nearer = { value: 0 };
    this.#material.vertexShader = `uniform float nearer;\n${this.#material.vertexShader.replace("gl_Position = clip;", "clip.z -= nearer;\ngl_Position = clip;")}`;
    this.object = new LineSegments2(this.#geometry, this.#material);
    this.object.renderOrder = order;
    this.object.frustumCulled = false;
    this.set([]);
  }

  /**
   * @param {Float32Array | number[]} segments six numbers each
   * @param {Float32Array | number[]} [colors] six numbers a segment, linear light
   */
  set(segments, colors) {
    // A geometry of another length is another one to the graphics card.
    this.#geometry.dispose();
    this.#geometry = new LineSegmentsGeometry();
    if (segments.length > 0) {
      this.#geometry.setPositions(segments);
      if (colors) this.#geometry.setColors(colors);
    }
    this.object.geometry = this.#geometry;
    this.object.userData.isEmpty = segments.length === 0;
    this.show(this.object.userData.isWanted !== false);
  }

  /** @param {boolean} isWanted */
  show(isWanted) {
    this.object.userData.isWanted = isWanted;
    this.object.visible = isWanted && this.object.userData.isEmpty !== true;
  }

  /** @param {number} depth what one CSS pixel towards the eye is worth, see `Space` */
  raise(depth) {
    this.#material.uniforms.nearer.value = this.#nearer * depth;
  }

  /** @param {string} css */
  paint(css) {
    this.#material.color.copy(new Color().setStyle(css));
  }

  dispose() {
    this.#geometry.dispose();
    this.#material.dispose();
  }
}

/**
 * Polylines as segments.
 * @param {Float32Array[]} polylines three numbers a point
 * @param {boolean} closed whether the last point is joined to the first, where it does not repeat it
 */
export function segmentsOf(polylines, closed) {
  /** @type {number[]} */
  const segments = [];
  for (const points of polylines) {
    const count = points.length / 3;
    if (count < 2) continue;
    for (let i = 0; i < count; i += 1) {
      const [a, b] = [3 * i, 3 * ((i + 1) % count)];
      const isLast = i === count - 1;
      const isSame = points[a] === points[b] && points[a + 1] === points[b + 1] && points[a + 2] === points[b + 2];
      if (isLast && (!closed || isSame)) continue;
      segments.push(points[a], points[a + 1], points[a + 2], points[b], points[b + 1], points[b + 2]);
    }
  }
  return segments;
}
