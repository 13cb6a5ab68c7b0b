/**
 * A plane that cuts a body away, and what is seen of the cut: its face, hatched, and its outline in the colours of the surface.
 *
 * The face is found by counting the surfaces behind it in the stencil buffer: an odd number of them means that it is inside. So it is only
 * asked for where the body is closed.
 *
 * @import { BufferGeometry, ShaderMaterial } from "three"
 * @import { Plane } from "./plane.js"
 * @import { Bounds } from "./vector.js"
 */
import {
  BackSide,
  DecrementWrapStencilOp,
  FrontSide,
  IncrementWrapStencilOp,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  NotEqualStencilFunc,
  PlaneGeometry,
  Plane as ClippingPlane,
  ReplaceStencilOp,
  Vector3,
} from "three";
import { plainColor } from "./colors.js";
import { Lines } from "./lines.js";
import { hatchMaterial } from "./surface.js";
import { add, cross, diagonalOf, dot, middleOf, scaled, unit } from "./vector.js";

/** CSS pixels of the outline: the colours of the surface, and the line along them. */
const BAND = 7;
const LINE = 1.9;
/** The offset of a plane that cuts nothing away. */
const OFF = 1e30;

/** Planes of a body with as many cuts: none of them cuts at first. @param {number} count */
export function cuttingPlanes(count) {
  return Array.from({ length: count }, () => new ClippingPlane(new Vector3(0, 0, 1), OFF));
}

/** @param {ClippingPlane} target @param {Plane | null} plane */
export function movePlane(target, plane) {
  if (plane) target.normal.set(...plane.normal);
  target.constant = plane ? -plane.offset : OFF;
}

export class Cut {
  #plane;
  #passes;
  #face;
  #look;
  #band;
  #line;

  /**
   * @param {ClippingPlane} plane one of `planes`
   * @param {ClippingPlane[]} planes all that cut the body
   * @param {ShaderMaterial} [look] of the face; hatched where nothing else is given
   */
  constructor(plane, planes, look) {
    this.#plane = plane;
    const others = planes.filter((other) => other !== plane);
    const place = planes.indexOf(plane) + 1;
    this.#passes = /** @type {const} */ ([
      [BackSide, IncrementWrapStencilOp],
      [FrontSide, DecrementWrapStencilOp],
    ]).map(([side, operation]) => {
      const material = new MeshBasicMaterial({
        side,
        depthWrite: false,
        depthTest: false,
        colorWrite: false,
        stencilWrite: true,
        stencilFail: operation,
        stencilZFail: operation,
        stencilZPass: operation,
        clippingPlanes: [plane],
      });
      const pass = new Mesh(undefined, material);
      pass.renderOrder = -10 + place;
      return pass;
    });
    this.#look = look ?? hatchMaterial(others);
    Object.assign(this.#look, {
      stencilWrite: true,
      stencilRef: 0,
      stencilFunc: NotEqualStencilFunc,
      stencilFail: ReplaceStencilOp,
      stencilZFail: ReplaceStencilOp,
      stencilZPass: ReplaceStencilOp,
    });
    this.#face = new Mesh(new PlaneGeometry(1, 1), this.#look);
    this.#face.renderOrder = -10 + place + 0.5;
    this.#face.matrixAutoUpdate = false;
    this.#face.onAfterRender = (renderer) => renderer.clearStencil();
    this.#band = new Lines(others, { width: BAND, order: 20 });
    this.#line = new Lines(others, { color: "#101216", width: LINE, order: 21 });
    for (const pass of this.#passes) pass.frustumCulled = false;
    this.objects = [...this.#passes, this.#face, this.#band.object, this.#line.object];
  }

  /** @param {BufferGeometry} geometry of the whole body */
  setBody(geometry) {
    for (const pass of this.#passes) pass.geometry = geometry;
  }

  /**
   * @param {Plane | null} plane null to cut nothing
   * @param {Bounds} bounds of the body
   * @param {{positions: number[], values: number[]}} outline with its colours, sRGB from 0 to 1; without any it has no band beside its line
   * @param {boolean} hasFace whether the body is closed, so that its inside is known
   */
  set(plane, bounds, outline, hasFace) {
    movePlane(this.#plane, plane);
    for (const each of [...this.#passes, this.#face]) each.visible = plane !== null && hasFace;
    this.#band.set(plane && outline.values.length > 0 ? outline.positions : [], outline.values);
    this.#line.set(plane ? outline.positions : []);
    if (!plane) return;
    const { normal, offset } = plane;
    const middle = middleOf(bounds);
    const foot = add(middle, scaled(normal, offset - dot(normal, middle)));
    const [right, up] = planeAxes(normal);
    const side = 2 * diagonalOf(bounds);
    this.#face.matrix.copy(
      new Matrix4().set(
        ...[right[0] * side, up[0] * side, normal[0], foot[0]],
        ...[right[1] * side, up[1] * side, normal[1], foot[1]],
        ...[right[2] * side, up[2] * side, normal[2], foot[2]],
        ...[0, 0, 0, 1],
      ),
    );
    this.#face.matrixWorldNeedsUpdate = true;
  }

  /** @param {number} depth what one CSS pixel towards the eye is worth */
  raise(depth) {
    this.#band.raise(depth);
    this.#line.raise(depth);
  }

  /**
   * @param {{paper: string, ink: string, line: string}} colors `#rrggbb`
   * @param {number} pixelRatio
   */
  paint({ paper, ink, line }, pixelRatio) {
    const { uniforms } = this.#look;
    if (uniforms.paper) uniforms.paper.value = plainColor(paper);
    if (uniforms.ink) uniforms.ink.value = plainColor(ink);
    if (uniforms.pixelRatio) uniforms.pixelRatio.value = pixelRatio;
    this.#line.paint(line);
  }

  dispose() {
    for (const pass of this.#passes) pass.material.dispose();
    this.#face.geometry.dispose();
    this.#look.dispose();
    this.#band.dispose();
    this.#line.dispose();
  }
}

/** Two directions in a plane that make a right-handed frame with its normal. @param {import("./vector.js").Vector} normal */
export function planeAxes(normal) {
  const right = unit(cross(Math.abs(normal[2]) < 0.9 ? [0, 0, 1] : [0, 1, 0], normal));
  return /** @type {const} */ ([right, cross(normal, right)]);
}
