/**
 * The shadow that a body leaves on the ground below it: the outline of what stands there, blurred.
 *
 * @import { Bounds } from "./vector.js"
 */
import { CanvasTexture, Mesh, MeshBasicMaterial, PlaneGeometry } from "three";

/** Pixels of its picture, and the opacity of its darkest place. */
const SIDE = 256;
const DARKEST = 0.15;
/** Free space round the body and the radius of the blur, as shares of the longer side of its box. */
const ROOM = 0.35;
const BLUR = 0.16;

export class Shadow {
  #canvas = new OffscreenCanvas(SIDE, SIDE);
  #texture = new CanvasTexture(this.#canvas);
  #material = new MeshBasicMaterial({ map: this.#texture, transparent: true, depthWrite: false, opacity: DARKEST });

  constructor() {
    this.object = new Mesh(new PlaneGeometry(1, 1), this.#material);
    this.object.renderOrder = -20;
  }

  /**
   * @param {Float32Array[]} outlines closed polylines of the body, three numbers a point, all wound the same way
   * @param {Bounds} bounds
   */
  set(outlines, { min, max }) {
    const longer = Math.max(max[0] - min[0], max[1] - min[1]);
    const side = longer * (1 + 2 * ROOM);
    const [x, y] = [(min[0] + max[0]) / 2, (min[1] + max[1]) / 2];
    const context = this.#canvas.getContext("2d");
    if (!context || !(side > 0)) return;
    context.clearRect(0, 0, SIDE, SIDE);
    context.shadowColor = "#000000";
    context.shadowBlur = (2 * BLUR * longer * SIDE) / side;
    // Only the shadow of what is drawn falls into the picture.
    context.shadowOffsetX = 2 * SIDE;
    context.beginPath();
    for (const points of outlines) {
      for (let k = 0; k < points.length; k += 3) {
        const at = /** @type {const} */ ([((points[k] - x) / side + 0.5) * SIDE - 2 * SIDE, (0.5 - (points[k + 1] - y) / side) * SIDE]);
        if (k === 0) context.moveTo(...at);
        else context.lineTo(...at);
      }
      context.closePath();
    }
    context.fill();
    this.#texture.needsUpdate = true;
    this.object.scale.set(side, side, 1);
    this.object.position.set(x, y, min[2] - (max[2] - min[2]) * 1e-3);
  }

  /**
   * @param {boolean} isShown none is seen from below the ground
   * @param {boolean} isCut whether part of the body is taken away
   */
  show(isShown, isCut) {
    this.object.visible = isShown;
    this.#material.opacity = isCut ? DARKEST / 2 : DARKEST;
  }

  dispose() {
    this.object.geometry.dispose();
    this.#material.dispose();
    this.#texture.dispose();
  }
}
