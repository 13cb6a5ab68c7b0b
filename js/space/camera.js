/**
 * A camera that goes round a point: where it stands, how it is moved, and what it sees where. Pure functions; z is up.
 *
 * @import { Vector } from "./vector.js"
 *
 * @typedef {[number, number]} Point CSS pixels from the upper left corner
 * @typedef {{width: number, height: number}} Size CSS pixels
 *
 * @typedef {object} Camera
 * @property {Vector} target the point that it goes round and looks at
 * @property {number} azimuth degrees from the x axis to the eye, counter-clockwise seen from above
 * @property {number} elevation degrees of the eye above the horizon, -90 to 90
 * @property {number} distance from the eye to the target, document units
 *
 * @typedef {object} Frame What the camera is seen through.
 * @property {Size} size CSS pixels
 * @property {number} top CSS pixels that something covers at the upper edge
 * @property {number} bottom CSS pixels that something covers at the lower edge
 *
 * @typedef {"iso" | "front" | "side" | "top"} StandardView
 */
import { add, between, dot, scaled, subtract } from "./vector.js";

/** Degrees that the picture is high. */
export const FIELD = 21;
/** Half the height of the picture at the distance 1. */
const SLOPE = Math.tan((FIELD * Math.PI) / 360);
/** Degrees for one CSS pixel of a drag. */
const TURN = 0.4;
/** Free space round what is fitted, as a share of the room. */
const MARGIN = 0.06;
/** Distances, as multiples of the fitted one. */
const NEAREST = 1 / 60;
const FARTHEST = 12;

/** Where the eye stands: isometric, before the x axis, at its end, above. @type {Readonly<{[name in StandardView]: Pick<Camera, "azimuth" | "elevation">}>} */
export const STANDARD = {
  iso: { azimuth: -60, elevation: 28 },
  front: { azimuth: -90, elevation: 0 },
  side: { azimuth: 0, elevation: 0 },
  top: { azimuth: -90, elevation: 90 },
};

/**
 * The directions to the right, up, and from the target to the eye; unit vectors.
 * @param {Pick<Camera, "azimuth" | "elevation">} camera
 * @returns {{right: Vector, up: Vector, back: Vector}}
 */
export function axesOf({ azimuth, elevation }) {
  const [a, e] = [(azimuth * Math.PI) / 180, (elevation * Math.PI) / 180];
  return {
    right: [-Math.sin(a), Math.cos(a), 0],
    up: [-Math.sin(e) * Math.cos(a), -Math.sin(e) * Math.sin(a), Math.cos(e)],
    back: [Math.cos(e) * Math.cos(a), Math.cos(e) * Math.sin(a), Math.sin(e)],
  };
}

/** @param {Camera} camera @returns {Vector} */
export const eyeOf = (camera) => add(camera.target, scaled(axesOf(camera).back, camera.distance));

/**
 * Turned by a drag: what is in front follows the pointer.
 * @param {Camera} camera
 * @param {number} x CSS pixels to the right
 * @param {number} y CSS pixels down
 * @returns {Camera}
 */
export const dragged = (camera, x, y) => turned(camera, -x * TURN, y * TURN);

/** @param {Camera} camera @param {number} azimuth degrees more @param {number} elevation degrees more @returns {Camera} */
export function turned(camera, azimuth, elevation) {
  return {
    ...camera,
    azimuth: around(camera.azimuth + azimuth),
    elevation: Math.min(90, Math.max(-90, camera.elevation + elevation)),
  };
}

/** An angle from -180 to 180 degrees. @param {number} degrees */
const around = (degrees) => ((((degrees + 180) % 360) + 360) % 360) - 180;

/**
 * Document units for a CSS pixel at the distance of the target.
 * @param {Camera} camera
 * @param {Frame} frame
 */
export const unitsPerPixel = ({ distance }, { size }) => (2 * SLOPE * distance) / size.height;

/**
 * Moved across the picture: what is at the distance of the target follows the pointer.
 * @param {Camera} camera
 * @param {Frame} frame
 * @param {number} x CSS pixels to the right
 * @param {number} y CSS pixels down
 * @returns {Camera}
 */
export function panned(camera, frame, x, y) {
  const { right, up } = axesOf(camera);
  const units = unitsPerPixel(camera, frame);
  return { ...camera, target: add(camera.target, add(scaled(right, -x * units), scaled(up, y * units))) };
}

/**
 * Nearer by a factor; the place under the pointer at the distance of the target stays where it is.
 * @param {Camera} camera
 * @param {Frame} frame
 * @param {Point} at CSS pixels
 * @param {number} factor above 1 to come nearer
 * @param {number} fitted the distance that counts as 1
 * @returns {Camera}
 */
export function zoomed(camera, frame, at, factor, fitted) {
  const distance = Math.min(fitted * FARTHEST, Math.max(fitted * NEAREST, camera.distance / factor));
  const { right, up } = axesOf(camera);
  const units = unitsPerPixel(camera, frame);
  const [x, y] = middleOf(frame);
  const under = add(camera.target, add(scaled(right, (at[0] - x) * units), scaled(up, (y - at[1]) * units)));
  return { ...camera, target: between(under, camera.target, distance / camera.distance), distance };
}

/** The place of the target on the screen. @param {Frame} frame @returns {Point} */
export const middleOf = ({ size, top, bottom }) => [size.width / 2, (size.height + top - bottom) / 2];

/**
 * A camera in a direction that sees all points as large as there is room.
 * @param {Pick<Camera, "azimuth" | "elevation">} direction
 * @param {Frame} frame
 * @param {Vector[]} points at least one
 * @returns {Camera}
 */
export function fitted({ azimuth, elevation }, { size, top, bottom }, points) {
  const { right, up, back } = axesOf({ azimuth, elevation });
  const free = { width: size.width * (1 - 2 * MARGIN), height: (size.height - top - bottom) * (1 - 2 * MARGIN) };
  const slope = [(SLOPE * Math.max(1, free.width)) / size.height, (SLOPE * Math.max(1, free.height)) / size.height];
  const seen = points.map((point) => [dot(point, right), dot(point, up), dot(point, back)]);
  // Across, as upwards: both outer rays have to clear every point; where they cross is the eye.
  const reach = [0, 1].map((axis) => {
    const high = Math.max(...seen.map((at) => at[axis] + slope[axis] * at[2]));
    const low = Math.max(...seen.map((at) => -at[axis] + slope[axis] * at[2]));
    return { middle: (high - low) / 2, depth: (high + low) / (2 * slope[axis]) };
  });
  const depths = seen.map((at) => at[2]);
  const middle = (Math.min(...depths) + Math.max(...depths)) / 2;
  const eye = Math.max(reach[0].depth, reach[1].depth);
  const target = add(add(scaled(right, reach[0].middle), scaled(up, reach[1].middle)), scaled(back, middle));
  const size3 = Math.max(...depths.map((depth) => Math.abs(depth - middle)), Number.MIN_VALUE);
  return { target, azimuth, elevation, distance: Math.max(eye - middle, size3 * 1.01) };
}

/**
 * Where a point is seen, with its depth along the view; the depth is not positive behind the eye.
 * @param {Camera} camera
 * @param {Frame} frame
 * @param {readonly number[]} point
 * @returns {{at: Point, depth: number}}
 */
export function seenAt(camera, frame, point) {
  const { right, up, back } = axesOf(camera);
  const from = subtract(point, camera.target);
  const depth = camera.distance - dot(from, back);
  const pixels = frame.size.height / (2 * SLOPE * depth);
  const [x, y] = middleOf(frame);
  return { at: [x + dot(from, right) * pixels, y - dot(from, up) * pixels], depth };
}

/**
 * The ray through a place of the screen.
 * @param {Camera} camera
 * @param {Frame} frame
 * @param {Point} at CSS pixels
 * @returns {{from: Vector, along: Vector}} `along` has the length 1 along the view
 */
export function rayAt(camera, frame, at) {
  const { right, up, back } = axesOf(camera);
  const [x, y] = middleOf(frame);
  const pixel = (2 * SLOPE) / frame.size.height;
  const along = add(add(scaled(right, (at[0] - x) * pixel), scaled(up, (y - at[1]) * pixel)), scaled(back, -1));
  return { from: eyeOf(camera), along };
}
