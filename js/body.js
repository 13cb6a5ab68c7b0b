/**
 * Bodies of hyperpatches: what is asked of the module, and names for the lists of numbers that it answers with.
 *
 * @typedef {import("./directrix.js").Hyperpatch} Hyperpatch
 * @typedef {Exclude<keyof Hyperpatch, "cells" | "operations">} Question
 * @typedef {Question | "cells" | "body"} Asked
 */
import { toText } from "./text.js";

const VERDICTS = /** @type {const} */ (["regular", "valid", "locally-valid", "degenerate", "invalid"]);
const RELATIONS = /** @type {const} */ (["disjoint", "shares", "overlaps", "touches", "not-proven"]);
const CONTINUITY = /** @type {const} */ (["none", "C0", "C1"]);
const FACES = /** @type {const} */ (["u0", "u1", "v0", "v1", "w0", "w1"]);
const OPERATIONS = /** @type {const} */ ([
  "cells", "move", "continuity", "mix", "slope", "delete", "copy", "mirror", "reorient", "extrude", "subdivide",
]);
const AXES = /** @type {const} */ (["u", "v", "w"]);

/**
 * The arguments of each method, as the module takes them: options apart from what must be there.
 *
 * @type {Record<Question, (...args: any[]) => object>}
 */
const QUESTIONS = {
  sample: (cell, at) => ({ cell, at }),
  verdicts: (options = {}) => ({ options }),
  summary: () => ({}),
  volume: () => ({}),
  amounts: () => ({}),
  section: (plane, options = {}) => ({ options: { ...plane, ...options } }),
  surface: (options = {}) => ({ options }),
  probe: (point) => ({ point }),
  relations: () => ({}),
  continuity: () => ({}),
  sharing: () => ({}),
  grid: (cell, counts) => ({ cell, counts }),
  file: (options) => ({ options }),
  moves: (cell, at, reach = "block") => ({ cell, at, reach }),
  neighbourhood: (cell, corner) => ({ cell, corner }),
  checks: (operation) => ({ operation }),
  cellsDocument: () => ({}),
};

/**
 * The methods of a body.
 *
 * @param {(question: Question, args: any[]) => any} ask
 * @returns {any}
 */
export function methods(ask) {
  const names = /** @type {Question[]} */ (Object.keys(QUESTIONS));
  return Object.fromEntries(names.map((name) => [name, (/** @type {any[]} */ ...args) => ask(name, args)]));
}

/**
 * The arguments of a method as the module takes them.
 *
 * @param {Question} question
 * @param {any[]} args
 */
export const inNames = (question, args) => QUESTIONS[question](...args);

/**
 * A question under way.
 *
 * @param {import("./pkg/directrix_full.js").Engine} engine
 * @param {import("./operations.js").Packed} document
 * @param {Asked} question
 * @param {object} rest
 */
export function asking(engine, { head, keys, apart, write, known }, question, rest) {
  const name = question === "volume" ? "amounts" : question;
  const asked = engine.hyperpatch(head, keys, apart, name, toText(rest));
  for (const place of asked.missing()) {
    const { text, cells, count = 0 } = write(place);
    asked.supply(place, text, cells, count);
  }
  return {
    /** Goes on for about so many milliseconds; returns the share done. @param {number} budget */
    step: (budget) => engine.answer(asked, budget),
    /** The answer, once it is there. */
    answer: () => {
      known?.();
      return NAMED[question](asked.result(), rest);
    },
  };
}

/** @type {Record<Asked, (raw: any, rest: any) => any>} */
const NAMED = {
  cells: ({ ids, corners, margins, volumes }) =>
    Array.from(ids, (id, n) => ({
      id,
      corners: Array.from({ length: 8 }, (_, k) => three(corners, 24 * n + 3 * k)),
      margin: margins[n],
      volume: volumes[n],
    })),
  body: (raw, rest) => ({ cells: NAMED.cells(raw, rest), operations: operations(raw) }),
  moves: ({ moves }) => rows(moves, 3).map(([cell, at, share]) => ({ cell, at: [at >> 4, (at >> 2) & 3, at & 3], share })),
  neighbourhood,
  checks,
  cellsDocument,
  sample: ({ position, mix }) => ({ position, mix }),
  probe: (found) => found && { cell: found.cell, uvw: found.uvw, mix: found.mix },
  verdicts: ({ verdicts }) => rows(verdicts, 17).map(verdict),
  summary: (raw) => {
    const [worst = null] = rows(raw.verdicts, 17).map(verdict);
    return {
      cells: sum(raw.counts),
      verdicts: Object.fromEntries(VERDICTS.map((name, n) => [name, raw.counts[n]])),
      mirrored: raw.mirrored,
      worst,
      pairs: rows(raw.relations, 15).map(relation),
      sharedFaces: raw.sharedFaces,
      outerFaces: raw.outerFaces,
      sumError: raw.sumError,
    };
  },
  volume: ({ volume }) => volume,
  amounts: ({ amounts }) => Array.from(amounts),
  section: (raw) => ({ ...raw, patches: rows(raw.patches, 8).map((row) => patch(row, false)) }),
  surface: ({ cornerPositions, ...raw }) => ({
    since: null,
    ...raw,
    patches: rows(raw.patches, 8).map((row) => patch(row, true)),
    edges: rows(raw.edges, 6).map(([index, cell, number, cells, start, count]) => ({ index, ...edge(cell, number), cells, start, count })),
    corners: rows(raw.corners, 4).map(([index, cell, number, cells], n) => ({
      index,
      ...corner(cell, number),
      cells,
      position: three(cornerPositions, 3 * n),
    })),
  }),
  relations: ({ relations }) => rows(relations, 15).map(relation),
  continuity: ({ faces, contacts }) => ({
    faces: rows(faces, 19).map(([a, first, b, second, matching, shape, material, ...corners]) => ({
      sides: [face(a, first), face(b, second)],
      ...matched(matching),
      shape: CONTINUITY[shape],
      material: CONTINUITY[material],
      corners: rows(corners, 3).map(([number, shape, material]) => ({
        corner: bits(number, 3),
        shape: CONTINUITY[shape],
        material: CONTINUITY[material],
      })),
    })),
    contacts: rows(contacts, 7).map(([a, first, b, second, matching, gap, common]) => ({
      sides: [face(a, first), face(b, second)],
      ...matched(matching),
      corners: Array.from({ length: 8 }, (_, number) => number)
        .filter((number) => common & (1 << number))
        .map((number) => bits(number, 3)),
      gap,
    })),
  }),
  sharing: (raw) => {
    const corners = groups(raw.cornerCounts, raw.cornerUsers, corner);
    const lists = {
      corners: corners.map((sides, n) => ({ position: three(raw.positions, 3 * n), sides })),
      edges: groups(raw.edgeCounts, raw.edgeUsers, edge).map((sides) => ({ sides })),
      faces: groups(raw.faceCounts, raw.faceUsers, face).map((sides) => ({ sides })),
    };
    const shared = (/** @type {{ sides: unknown[] }[]} */ list) => list.filter(({ sides }) => sides.length > 1).length;
    return { ...lists, shared: { corners: shared(lists.corners), edges: shared(lists.edges), faces: shared(lists.faces) } };
  },
  grid: (raw, { counts }) => ({ counts, ...raw }),
  file: (bytes) => bytes,
};

/** A list of numbers in rows of so many. @param {ArrayLike<number>} list @param {number} width @returns {number[][]} */
const rows = (list, width) =>
  Array.from({ length: list.length / width }, (_, n) => Array.from({ length: width }, (_, k) => list[n * width + k]));

/** @param {ArrayLike<number>} list @param {number} at @returns {[number, number, number]} */
const three = (list, at) => [list[at], list[at + 1], list[at + 2]];

/** @param {Iterable<number>} list */
const sum = (list) => [...list].reduce((all, one) => all + one, 0);

/** The last bits of a number, from the highest on. @param {number} number @param {number} count */
const bits = (number, count) => Array.from({ length: count }, (_, n) => (number >> (count - 1 - n)) & 1);

/** @param {number} cell @param {number} number */
const face = (cell, number) => ({ cell, face: FACES[number] });

/** @param {number} cell @param {number} number */
const edge = (cell, number) => ({ cell, axis: AXES[number >> 2], ends: bits(number & 3, 2) });

/** @param {number} cell @param {number} number */
const corner = (cell, number) => ({ cell, corner: bits(number, 3) });

/** @param {number} number */
const matched = (number) => ({ swapped: number >= 4, reversed: [(number & 2) !== 0, (number & 1) !== 0] });

/**
 * @template T
 * @param {Uint32Array} counts
 * @param {Uint32Array} users
 * @param {(cell: number, number: number) => T} named
 */
function groups(counts, users, named) {
  let at = 0;
  return Array.from(counts, (count) =>
    Array.from({ length: count }, () => {
      at += 2;
      return named(users[at - 2], users[at - 1]);
    }),
  );
}

/** What came of each operation. @param {any} raw */
function operations({ operations, operationCells, reasons }) {
  let [at, refused] = [0, 0];
  const take = (/** @type {number} */ count) => Array.from(operationCells.subarray(at, (at += count)));
  return rows(operations, 6).map(([id, op, applied, touched, made, removed]) => ({
    id,
    op: OPERATIONS[op],
    applied: applied === 1,
    reason: applied ? null : reasons[refused++],
    touched: take(touched),
    made: take(made),
    removed: take(removed),
  }));
}

/** What there is round a corner. @param {any} raw */
function neighbourhood({ cells, regular, points, mixes, users, joints }) {
  let user = 0;
  const list = rows(points, 9);
  const count = mixes.length / Math.max(1, list.length);
  const place = (/** @type {number} */ cell, /** @type {number} */ number, /** @type {number} */ at) => ({ ...face(cell, number), corner: bits(at, 3) });
  return {
    cells: rows(cells, 2).map(([cell, number]) => corner(cell, number)),
    regular,
    points: list.map(([known, a, b, c, x, y, z, jumps, length], n) => ({
      offset: known ? [a, b, c] : null,
      position: [x, y, z],
      mix: Array.from(mixes.subarray(count * n, count * (n + 1))),
      jumps: jumps === 1,
      users: Array.from({ length }, () => {
        user += 2;
        const at = users[user - 1];
        return { cell: users[user - 2], at: [at >> 4, (at >> 2) & 3, at & 3] };
      }),
    })),
    joints: rows(joints, 10).map(([a, first, p, b, second, q, shape, material, shapeMarked, materialMarked]) => ({
      sides: [place(a, first, p), place(b, second, q)],
      shape: CONTINUITY[shape],
      material: CONTINUITY[material],
      shapeMarked: shapeMarked === 1,
      materialMarked: materialMarked === 1,
    })),
  };
}

/** The three checks of added cells, with what they say. @param {any} raw */
function checks(raw) {
  const cells = Array.from(raw.cells);
  const verdicts = rows(raw.verdicts, 17).map(verdict);
  const pairs = rows(raw.relations, 15).map(relation);
  const [faces, corners, shape, material] = raw.counts;
  const number = (/** @type {number} */ count, /** @type {string} */ one) => `${count} ${one}${count === 1 ? "" : "s"}`;
  const is = (/** @type {{ verdict: string, mirrored: boolean }} */ { verdict, mirrored }) => (mirrored ? `${verdict} and mirrored` : verdict);
  const named = verdicts.map((one) => `cell ${one.cell} is ${is(one)}`);
  const SAYS = /** @type {Record<string, string>} */ ({ overlaps: "overlap", touches: "touch besides what they share", "not-proven": "may meet: nothing was proven" });
  const met = pairs.map((pair) => `cells ${pair.cells.join(" and ")} ${SAYS[pair.relation]}`);
  const none = "the operation made no cells that are still there";
  return {
    cells,
    injective: {
      ok: verdicts.length === 0,
      verdicts,
      message: cells.length === 0 ? none : named.join("; ") || `${number(cells.length, "cell")}, proven to meet themselves nowhere`,
    },
    meetings: {
      ok: pairs.length === 0,
      pairs,
      message: cells.length === 0 ? none : met.join("; ") || "the cells meet others only in corners, edges and faces that they share",
    },
    continuity: {
      faces,
      corners,
      shape,
      material,
      message: faces === 0 ? "no face is shared" : `of ${number(corners, "corner")} of ${number(faces, "shared face")} ${shape} run on in shape and ${material} in material`,
    },
  };
}

/** A document with one operation that writes all cells out. @param {any} raw */
function cellsDocument({ title, unit, materials, positions, mixes }) {
  const count = materials.length;
  const coefficient = (/** @type {number} */ n) => ({
    position: three(positions, 3 * n),
    mix: Array.from(mixes.subarray(count * n, count * (n + 1))),
  });
  const cells = Array.from({ length: positions.length / 192 }, (_, cell) => ({
    coefficients: Array.from({ length: 64 }, (_, n) => coefficient(64 * cell + n)),
  }));
  return { directrix: 1, kind: "hyperpatch", title, unit, materials, operations: cells.length ? [{ op: "cells", cells }] : [] };
}

/** @param {number[]} row @param {boolean} isFace */
function patch([cell, number, vertexStart, vertexCount, start, count, outlineStart, outlineCount], isFace) {
  const common = { cell, vertexStart, vertexCount, start, count };
  return isFace ? { ...common, face: FACES[number] } : { ...common, outlineStart, outlineCount };
}

/** @param {number[]} row */
function verdict(row) {
  const [cell, number, mirrored, margin, leastJacobian, leastJacobianBound, kind] = row;
  const [first, second, jacobian, point] = [three(row, 7), three(row, 10), row[13], three(row, 14)];
  const witnesses = [null, { kind: "folded", at: first, jacobian, point }, { kind: "meeting", at: first, other: second, point }];
  const common = { cell, verdict: VERDICTS[number], margin, leastJacobian, leastJacobianBound };
  return { ...common, witness: witnesses[kind], mirrored: mirrored === 1 };
}

/** @param {number[]} row */
function relation(row) {
  const [a, b, kind, faces, edges, corners] = row;
  const common = { cells: [a, b], relation: RELATIONS[kind] };
  const [point, first, second] = [three(row, 6), three(row, 9), three(row, 12)];
  if (kind === 1) return { ...common, faces, edges, corners };
  if (kind === 2) return { ...common, point, at: [first, second] };
  return kind === 3 ? { ...common, at: [first] } : common;
}
