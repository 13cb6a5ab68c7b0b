/**
 * How cells continue each other, as it is drawn: half of each boundary curve between cells belongs to the corner that it ends in. Where
 * they continue smoothly nothing is added; a firm line is a crease (C0), a dashed one a jump of the material; and faces that part have
 * lines across their gap.
 *
 * @import { BodyContinuity, BodySharing } from "../../../js/directrix.js"
 * @import { Cell } from "./document.js"
 *
 * @typedef {"shape" | "material"} Aspect
 *
 * @typedef {object} Joints
 * @property {{points: number[], color: [number, number, number], cell: number, isFirst: boolean}[]} lines segments; `isFirst`: drawn while
 * the body is together
 * @property {number[]} signs of the shared corners, in their order: 0 nothing is shared, 1 C1, 2 C0, 3 none
 * @property {{C1: number, C0: number, none: number, contacts: number, gap: number}} counts corners of faces; contacts that are not whole
 * faces, with their largest gap
 */
import { plainColor } from "../space/colors.js";
import { bernstein, placeOf } from "./cell.js";

/** Segments of half a curve. */
const SEGMENTS = 8;
/** Lines across a gap along both axes of a face. */
const TIES = 4;
const INK = plainColor("#101216");
const APART = plainColor("#d55e00");
const AXES = ["u", "v", "w"];
const RANK = { C1: 1, C0: 2, none: 3 };

/**
 * @param {BodyContinuity} continuity
 * @param {BodySharing} sharing
 * @param {(id: number) => Cell | undefined} cellOf
 * @param {Aspect} aspect
 * @returns {Joints}
 */
export function jointsOf({ faces, contacts }, sharing, cellOf, aspect) {
  const cornerNumber = new Map(sharing.corners.flatMap(({ sides }, n) => sides.map(({ cell, corner }) => [`${cell} ${corner.join("")}`, n])));
  const edgeNumber = new Map(sharing.edges.flatMap(({ sides }, n) => sides.map(({ cell, axis, ends }) => [`${cell} ${axis}${ends.join("")}`, n])));
  const signs = sharing.corners.map(() => 0);
  const counts = { C1: 0, C0: 0, none: 0, contacts: contacts.length, gap: Math.max(0, ...contacts.map(({ gap }) => gap)) };
  /** The worst of each half of a curve, by the curve and the corner. @type {Map<string, number>} */
  const halves = new Map();
  for (const { sides, corners } of faces) {
    const [{ cell, face }] = sides;
    const across = AXES.indexOf(face[0]);
    for (const { corner, [aspect]: state } of corners) {
      const rank = RANK[state];
      counts[state] += 1;
      const at = cornerNumber.get(`${cell} ${corner.join("")}`) ?? -1;
      signs[at] = Math.max(signs[at] ?? 0, rank);
      for (const axis of [0, 1, 2].filter((each) => each !== across)) {
        const ends = corner.filter((_, k) => k !== axis);
        const edge = edgeNumber.get(`${cell} ${AXES[axis]}${ends.join("")}`);
        if (edge === undefined) continue;
        const key = `${edge} ${at}`;
        halves.set(key, Math.max(halves.get(key) ?? 0, rank));
      }
    }
  }
  /** @type {Joints["lines"]} */
  const lines = [];
  for (const [key, rank] of halves) {
    if (rank < RANK.C0) continue;
    const [edge, at] = key.split(" ").map(Number);
    sharing.edges[edge].sides.forEach(({ cell, axis, ends }, n) => {
      const found = cellOf(cell);
      if (!found) return;
      const along = AXES.indexOf(axis);
      const isStart = cornerNumber.get(`${cell} ${withAxis(ends, along, 0).join("")}`) === at;
      const points = halfCurve(found, along, ends, isStart);
      for (let k = 0; k < SEGMENTS; k += 1) {
        if (rank === RANK.none && k % 2 === 1) continue;
        lines.push({ points: [...points[k], ...points[k + 1]], color: INK, cell, isFirst: n === 0 });
      }
    });
  }
  for (const contact of contacts) lines.push(...ties(contact, cellOf));
  return { lines, signs, counts };
}

/** @param {readonly number[]} ends along the other axes @param {number} axis @param {number} value */
function withAxis(ends, axis, value) {
  const corner = [...ends];
  corner.splice(axis, 0, value);
  return corner;
}

/** From a corner to the middle of a curve. @param {Cell} cell @param {number} axis @param {readonly number[]} ends @param {boolean} isStart */
function halfCurve({ coefficients }, axis, ends, isStart) {
  const points = [0, 1, 2, 3].map((along) => {
    const [i, j, k] = withAxis(ends.map((end) => 3 * end), axis, along);
    return coefficients[placeOf(i, j, k)].position;
  });
  return Array.from({ length: SEGMENTS + 1 }, (_, n) => {
    const weights = bernstein(isStart ? n / SEGMENTS / 2 : 1 - n / SEGMENTS / 2);
    return [0, 1, 2].map((k) => points.reduce((sum, point, p) => sum + weights[p] * point[k], 0));
  });
}

/**
 * Lines between places of two faces that would be one if they did not part.
 * @param {BodyContinuity["contacts"][number]} contact
 * @param {(id: number) => Cell | undefined} cellOf
 */
function ties({ sides, swapped, reversed, gap }, cellOf) {
  const [first, second] = sides.map(({ cell, face }) => ({ cell: cellOf(cell), face }));
  if (!first.cell || !second.cell || gap === 0) return [];
  const found = [];
  for (let a = 0; a <= TIES; a += 1) {
    for (let b = 0; b <= TIES; b += 1) {
      const at = [a / TIES, b / TIES];
      const turned = swapped ? [at[1], at[0]] : at;
      const other = turned.map((t, k) => (reversed[k] ? 1 - t : t));
      const ends = [pointOn(first.cell, first.face, at), pointOn(second.cell, second.face, other)];
      if (Math.hypot(...ends[0].map((value, k) => value - ends[1][k])) < gap * 1e-3) continue;
      found.push({ points: ends.flat(), color: APART, cell: sides[0].cell, isFirst: true });
    }
  }
  return found;
}

/** A point of a face. @param {Cell} cell @param {string} face @param {number[]} at */
function pointOn({ coefficients }, face, at) {
  const across = AXES.indexOf(face[0]);
  const end = face[1] === "1" ? 3 : 0;
  const [p, q] = at.map(bernstein);
  const sum = [0, 0, 0];
  for (let a = 0; a < 4; a += 1) {
    for (let b = 0; b < 4; b += 1) {
      const [i, j, k] = withAxis([a, b], across, end);
      const { position } = coefficients[placeOf(i, j, k)];
      for (let axis = 0; axis < 3; axis += 1) sum[axis] += p[a] * q[b] * position[axis];
    }
  }
  return sum;
}
