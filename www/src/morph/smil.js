/**
 * Animations inside SVG. They need no scripts, and so play inside an image as well; tried in Chromium.
 *
 * @import { Motion } from "./motion.js"
 */
import { HANDLES, eased, round } from "./motion.js";

/** Colours between the ends: between two of them renderers mix in sRGB, which hardly differs over so short a way. */
const STOPS = 8;

/** How long, and how often. @param {Motion} motion */
export function timing(motion) {
  const ends = motion.repeat === "once" ? ' fill="freeze"' : ' repeatCount="indefinite"';
  return `dur="${Number(round(motion).toFixed(3))}s"${ends}`;
}

/**
 * A change of one attribute from one value to another: numbers are blended evenly, and the easing is that of the motion.
 * @param {string} name
 * @param {string} from
 * @param {string} to
 * @param {Motion} motion
 */
export function animate(name, from, to, motion) {
  const values = motion.repeat === "swing" ? [from, to, from] : [from, to];
  const spline = HANDLES[motion.easing].map((handle) => Number(handle.toFixed(6))).join(" ");
  const splines = values.slice(1).map(() => spline).join(";");
  const times = values.map((_, i) => i / (values.length - 1)).join(";");
  const easing = motion.easing === "linear" ? "" : ` calcMode="spline" keyTimes="${times}" keySplines="${splines}"`;
  return `<animate attributeName="${name}" values="${values.join(";")}" ${timing(motion)}${easing}/>`;
}

/**
 * A change of colour.
 * @param {string} name
 * @param {(s: number) => string} color at a place between the curves
 * @param {Motion} motion
 */
export function animateColor(name, color, motion) {
  const there = Array.from({ length: STOPS + 1 }, (_, k) => color(eased(motion.easing, k / STOPS)));
  const values = motion.repeat === "swing" ? [...there, ...there.slice(0, -1).reverse()] : there;
  return `<animate attributeName="${name}" values="${values.join(";")}" ${timing(motion)}/>`;
}
