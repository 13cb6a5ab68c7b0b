/** Laplace's equation: against solutions that are known, over the turns of a worker, and what is refused. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { DirectrixError, load } from "directrix";
import { postedJob } from "../../js/laplace.js";
import { remoteLaplace } from "../../js/remote-laplace.js";
import { inTurns } from "../../js/turns.js";

/** @import { LaplaceCondition, LaplaceInput } from "directrix" */

const dx = await load();

/**
 * The unit cube with m steps along each edge.
 *
 * @param {number} m
 * @param {(normal: number[], centre: number[]) => LaplaceCondition} condition
 * @returns {LaplaceInput}
 */
function cube(m, condition) {
  /** @type {number[]} */
  const vertices = [];
  /** @type {number[]} */
  const elements = [];
  /** @type {LaplaceCondition[]} */
  const conditions = [];
  for (let axis = 0; axis < 3; axis++) {
    for (const end of [0, 1]) {
      const place = (/** @type {number} */ i, /** @type {number} */ j) => {
        const point = [0, 0, 0];
        point[axis] = end;
        point[(axis + 1) % 3] = i / m;
        point[(axis + 2) % 3] = j / m;
        return point;
      };
      for (let i = 0; i < m; i++) {
        for (let j = 0; j < m; j++) {
          const corners = [place(i, j), place(i + 1, j), place(i + 1, j + 1), place(i, j + 1)];
          for (const triangle of [[0, 1, 2], [0, 2, 3]]) {
            const own = (end ? triangle : triangle.toReversed()).map((k) => corners[k]);
            elements.push(...own.map((_, k) => vertices.length / 3 + k));
            vertices.push(...own.flat());
            const normal = [0, 0, 0];
            normal[axis] = end ? 1 : -1;
            conditions.push(condition(normal, [0, 1, 2].map((k) => (own[0][k] + own[1][k] + own[2][k]) / 3)));
          }
        }
      }
    }
  }
  return { dimension: 3, vertices, elements, conditions };
}

/** The cube of the paper: 1 above, 0.5 below, 0 at the sides. @param {number} m */
const paper = (m) => cube(m, ([, , z]) => ({ value: z > 0 ? 1 : z < 0 ? 0.5 : 0 }));

/** Circles about the origin, with the values 0 outside and 1 inside. @returns {LaplaceInput} */
function ring(radii = [1, 0.4], count = 160) {
  const points = radii.flatMap((radius, k) =>
    Array.from({ length: count }, (_, n) => [radius * Math.cos((2 * Math.PI * n) / count), (k ? -1 : 1) * radius * Math.sin((2 * Math.PI * n) / count)]),
  );
  return {
    dimension: 2,
    vertices: Float64Array.from(points.flat()),
    elements: Uint32Array.from(points.flatMap((_, n) => [n, n - (n % count) + ((n + 1) % count)])),
    conditions: [{ value: 0 }, { value: 1 }],
    groups: Uint32Array.from(points, (_, n) => Number(n >= count)),
  };
}

test("the cube has the values of its series, the ring those of the logarithm", () => {
  const solution = dx.solveLaplace(paper(8));
  assert.deepEqual([solution.elements, solution.converged, solution.parts, solution.ranges], [768, true, 1, [[0, 1]]]);
  assert.ok(Math.abs(solution.measure - 1) < 1e-12 && solution.closure < 1e-4);
  const known = [[0.1, 0.39762453840464], [0.25, 0.28005981203193], [0.5, 0.25], [0.75, 0.48359501695147], [0.9, 0.769167292367583]];
  const { values, clamped, outside } = solution.at(known.flatMap(([z]) => [0.5, 0.5, z]));
  known.forEach(([z, value], n) => assert.ok(Math.abs(values[n] - value) < 4e-3, `${values[n]} at ${z}`));
  assert.deepEqual([clamped, outside], [0, 0]);
  const [residuals] = solution.residuals;
  assert.deepEqual([residuals[0], residuals.length], [1, solution.iterations[0] + 1]);
  assert.ok(residuals[residuals.length - 1] <= 1e-6 && solution.times.assembly > 0 && solution.times.solve > 0);
  assert.equal(solution.values[0].length, 768);
  const annulus = dx.solveLaplace(ring());
  const radius = 0.7;
  const slope = 1 / Math.log(0.4);
  assert.ok(Math.abs(annulus.at([radius, 0]).values[0] - Math.log(radius) * slope) < 2e-3, "the unit circle is no trap");
  const gradient = annulus.gradientAt([0, radius]).values;
  assert.ok(Math.abs(gradient[0]) < 1e-3 && Math.abs(gradient[1] - slope / radius) < 1e-2, `${gradient}`);
});

test("solvers agree, and tell their residuals and the condition number", () => {
  const solve = (/** @type {LaplaceInput["solver"]} */ solver) => dx.solveLaplace({ ...paper(4), solver });
  const lu = solve({ method: "lu", condition: true });
  assert.ok(lu.condition !== null && lu.condition > 10 && lu.condition < 1000 && lu.iterations[0] === 0);
  for (const preconditioner of /** @type {const} */ (["none", "jacobi", "ssor"])) {
    const found = solve({ preconditioner, tolerance: 1e-10 });
    found.fluxes[0].forEach((flux, n) => assert.ok(Math.abs(flux - lu.fluxes[0][n]) < 1e-6));
    assert.equal(found.residuals[0].length, found.preconditionedResiduals[0].length);
  }
  const free = solve({ dense: 0, tolerance: 1e-6 });
  free.fluxes[0].forEach((flux, n) => assert.ok(Math.abs(flux - lu.fluxes[0][n]) < 1e-3 * Math.max(1, Math.abs(flux))));
  const slow = solve({ preconditioner: "none", maxIterations: 2 });
  assert.deepEqual([slow.converged, slow.iterations], [false, [2]]);
});

test("fractions share a matrix and sum to one; sections show them", () => {
  const input = cube(5, ([x, , z]) => ({ value: z > 0 ? [1, 0, 0] : x > 0 ? [0, 1, 0] : [0, 0.25, 0.75] }));
  const solution = dx.solveLaplace({ ...input, composition: true });
  assert.deepEqual([solution.materials, solution.iterations.length, solution.fluxes.length], [3, 2, 3]);
  const section = solution.section({ origin: [-0.25, 0.5, -0.25], sides: [[1.5, 0, 0], [0, 0, 1.5]], size: [48, 40] });
  assert.deepEqual([section.size, section.values.length], [[48, 40], 3]);
  let inside = 0;
  for (let n = 0; n < 48 * 40; n++) {
    const at = [-0.25 + (1.5 * ((n % 48) + 0.5)) / 48, 0.5, -0.25 + (1.5 * (Math.floor(n / 48) + 0.5)) / 40];
    const found = section.values.map((list) => list[n]);
    if ([at[0], at[2]].every((x) => x > 0 && x < 1)) {
      inside += 1;
      assert.ok(Math.abs(found[0] + found[1] + found[2] - 1) < 1e-6 && found.every((x) => x >= 0 && x <= 1));
      const { values } = solution.at(at);
      found.forEach((x, k) => assert.ok(Math.abs(x - values[k]) < 2e-3, `${found}, not ${values}`));
    } else {
      assert.ok(found.every(Number.isNaN));
    }
  }
  assert.equal(section.inside, inside);
  assert.deepEqual(dx.solveLaplace(ring()).section({ longest: 32 }).size, [32, 32]);
});

test("solving and questions go in short turns over a connection, and a worker that forgot is sent the problem again", async () => {
  const input = paper(8);
  /** @type {any[]} */
  const sent = [];
  /** @type {number[]} */
  const shares = [];
  const send = async (/** @type {any[]} */ args) => {
    const plain = args.slice(0, 2);
    sent.push(plain);
    const found = await inTurns(dx, { name: "solveLaplace", args: plain }, { isWanted: () => true, onprogress: (share) => shares.push(share) });
    return found?.value;
  };
  const remote = await remoteLaplace(send, input);
  const local = dx.solveLaplace(input);
  assert.deepEqual(remote.fluxes, local.fluxes);
  assert.deepEqual((await remote.at([0.5, 0.5, 0.9])).values, local.at([0.5, 0.5, 0.9]).values);
  assert.ok(sent[0][0].input && !sent[1][0].input, "the problem was sent once");
  assert.ok(shares.length > 0 && shares.every((share, n) => share < 1 && share >= (shares[n - 1] ?? 0)));
  for (let k = 0; k < 4; k++) await remoteLaplace(send, paper(2));
  const before = sent.length;
  const frame = { origin: [0, 0, 0.5], sides: /** @type {[number[], number[]]} */ ([[1, 0, 0], [0, 1, 0]]), size: /** @type {[number, number]} */ ([20, 20]) };
  assert.deepEqual(await remote.section(frame, { onprogress: () => {} }), local.section(frame));
  assert.equal(sent.length, before + 2, "it was asked, refused, and sent again");
  const stopped = await inTurns(dx, { name: "solveLaplace", args: [{ key: -1, input: paper(12) }, { question: "solve", rest: {} }] }, { isWanted: () => false, onprogress: () => {} });
  assert.equal(stopped, null, "cancelled between turns");
  assert.throws(() => postedJob(dx, { key: -2 }, { question: "at", rest: { first: [] } }), (error) => error instanceof DirectrixError && error.code === "unsent");
});

test("indices and coordinates may be in any typed array", () => {
  const input = paper(2);
  const typed = { ...input, vertices: Float32Array.from(input.vertices), elements: Uint16Array.from(input.elements) };
  assert.deepEqual(dx.solveLaplace(/** @type {any} */ (typed)).fluxes, dx.solveLaplace(input).fluxes);
});

test("a job solves in steps", () => {
  const job = dx.job(null, { solveLaplace: paper(6) });
  let steps = 1;
  let state = job.step(0);
  for (; !state.done; state = job.step(0)) steps += 1;
  assert.ok(steps > 10, `${steps} steps`);
  assert.deepEqual(state.answer.fluxes, dx.solveLaplace(paper(6)).fluxes);
});

test("wrong input is refused with its path and its place", async () => {
  /** @param {(input: any) => void} change @param {string} code @param {string} path */
  const refused = (change, code, path) => {
    const input = paper(2);
    change(input);
    /** @type {DirectrixError | undefined} */
    let found;
    try {
      dx.solveLaplace(input);
    } catch (error) {
      found = /** @type {DirectrixError} */ (error);
    }
    assert.ok(found instanceof DirectrixError, path);
    assert.deepEqual([found.code, found.path], [code, path], found.message);
    return found;
  };
  const open = refused((input) => (input.elements.splice(9, 3), input.conditions.splice(3, 1)), "mesh", "elements[2]");
  assert.equal(open.place?.length, 3);
  refused((input) => input.elements.splice(9, 3, input.elements[10], input.elements[9], input.elements[11]), "mesh", "elements[3]");
  refused((input) => input.elements.reverse(), "mesh", "elements[0]");
  refused((input) => (input.elements[4] = input.elements[3]), "mesh", "elements[1]");
  refused((input) => (input.elements[4] = 9999), "range", "elements[1]");
  refused((input) => (input.elements[4] = 1.5), "type", "elements[4]");
  refused((input) => input.elements.pop(), "range", "elements");
  refused((input) => (input.vertices[4] = Number.NaN), "range", "vertices[1]");
  refused((input) => (input.vertices = "none"), "type", "vertices");
  refused((input) => (input.conditions[7] = undefined), "missing", "conditions[7]");
  refused((input) => (input.conditions[7] = {}), "missing", "conditions[7]");
  refused((input) => (input.conditions[7] = { value: 1, flux: 0 }), "range", "conditions[7]");
  refused((input) => (input.conditions[7] = { value: Infinity }), "non-finite", "conditions[7].value");
  refused((input) => (input.conditions[7] = { flux: [1, 2] }), "range", "conditions[7]");
  refused((input) => (input.conditions[7] = { value: 1, colour: 2 }), "unknown-field", "conditions[7].colour");
  refused((input) => input.conditions.pop(), "range", "conditions");
  refused((input) => (input.conditions = input.conditions.map(() => ({ flux: 1 }))), "range", "conditions");
  refused((input) => (input.composition = true), "range", "conditions");
  refused((input) => (input.groups = input.conditions.map(() => 99)), "range", "groups[0]");
  refused((input) => Object.assign(input, { composition: true, conditions: [{ value: [1, 0] }, { value: [1, 0.5] }], groups: input.conditions.map((/** @type {any} */ _, /** @type {number} */ n) => Number(n > 5)) }), "range", "conditions[1]");
  refused((input) => (input.dimension = 4), "range", "dimension");
  refused((input) => (input.solver = { method: "qr" }), "range", "solver.method");
  refused((input) => (input.solver = { preconditioner: "ssor", dense: 10 }), "range", "solver");
  refused((input) => (input.speed = 1), "unknown-field", "speed");
  refused((input) => (input.conditions = input.conditions.map(() => ({ value: [] }))), "range", "conditions[0].value");
  refused((input) => (input.conditions[7] = { value: 1e101 }), "range", "conditions[7]");
  const negative = (/** @type {any} */ input) => Object.assign(input, { composition: true, conditions: input.conditions.map(() => ({ value: [1.5, -0.5] })) });
  assert.match(refused(negative, "range", "conditions[0]").message, /^1\.5 was found; expected a fraction/);
  const long = refused((input) => (input.elements = new DataView(new ArrayBuffer(4096))), "type", "elements");
  assert.ok(long.message.length < 100, "messages do not repeat long lists");
  const solution = dx.solveLaplace(paper(2));
  const outside = (/** @type {() => void} */ call, /** @type {string} */ code, /** @type {string} */ path) =>
    assert.throws(call, (error) => error instanceof DirectrixError && error.code === code && error.path === path);
  outside(() => solution.at([0.5, 0.5, 0.5, 2, 2, 2]), "outside", "points[1]");
  outside(() => solution.at([0.5, 0.5]), "range", "points");
  outside(() => solution.at([0.5, 0.5, Number.NaN]), "range", "points[0]");
  outside(() => solution.section({ longest: 9 }), "range", "longest");
  outside(() => solution.section({ origin: [0, 0, 0], sides: [[1, 0, 0], [2, 0, 0]], size: [9, 9] }), "range", "sides");
  outside(() => solution.at([0.5, 0.5, 0.5], /** @type {any} */ ({ outsid: "skip" })), "unknown-field", "options.outsid");
  outside(() => solution.at(new Float64Array(3 * (2 ** 22 + 1))), "range", "points");
  assert.ok(Number.isNaN(solution.at([2, 2, 2], { outside: "skip" }).values[0]));
  const figure = await load({ module: "figure" });
  outside(() => figure.solveLaplace(paper(2)), "not-in-module", "");
});
