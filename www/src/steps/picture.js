/**
 * The picture of a step: the lines that are there, what the chosen vertex sees and may have, and the line of the step. Strokes as the
 * design has them; vertices are rings while they have no line.
 *
 * @import { Curve, CurvesDocument, Point, Size, View } from "../types.js"
 * @import { Steps, VertexSets } from "../../../js/directrix.js"
 * @import { Line, Scene } from "./film.js"
 *
 * @typedef {{curve: 0 | 1, vertex: number}} Vertex
 *
 * @typedef {object} Shown
 * @property {View} view
 * @property {Size} size
 * @property {CurvesDocument} document
 * @property {Steps} steps
 * @property {Scene} scene
 * @property {boolean} hidden the chosen line is not told
 * @property {Vertex | null} focus the vertex whose sets are shown
 * @property {VertexSets | null} sets
 * @property {Vertex | null} aim the vertex under the pointer, or aimed at by a guess
 * @property {number | null} guess a wrong guess: vertex of the second curve
 */
import "../../styles/step-picture.css";
import { describe } from "../../../js/sentence.js";
import { attribute, svg, write } from "../dom.js";
import { ending, isOpen, outline, signedArea } from "../spline.js";
import { seen } from "../state/in-space.js";
import { joined, sideOf } from "../state/open.js";
import { toScreen } from "../view.js";
import { vertexName } from "./film.js";
import { words } from "./words.js";

/** Distance of the arc of valid vertices from the curve, and of names from their vertices, CSS pixels. */
const ARC = 9;
const NAME = 13;
const NAME_PAST_ARC = 18;
/** Share of a normal along the line of text from which a name stands beside its vertex, not above or below. */
const ASIDE = 0.4;

export function createPicture() {
  const path = (/** @type {string} */ name) => svg("path", { class: name });
  const layers = {
    band: path("step-band"),
    visible: path("step-visible"),
    accepted: path("step-accepted"),
    redundant: path("step-candidates"),
    candidates: path("step-candidates"),
    left: path("step-left"),
    curves: path("step-curves"),
    valid: path("step-valid"),
    orphans: path("step-orphans"),
    vertices: path("step-vertices"),
    bare: path("step-bare"),
    inserted: path("step-vertices small"),
    under: path("step-winner-under"),
    guessUnder: path("step-winner-under"),
    guess: path("step-guess"),
    winner: path("step-winner"),
    dots: path("step-dots"),
    ends: path("step-ends"),
    aim: path("step-aim"),
  };
  const names = svg("g", { class: "step-names" });
  const result = svg("desc");
  const element = svg("svg", { class: "step-picture", role: "img" }, result, ...Object.values(layers), names);
  /** @type {WeakMap<Curve, Point[]>} */
  const known = new WeakMap();

  /** @param {Curve} curve */
  const polyline = (curve) => {
    const points = known.get(curve) ?? outline(curve).map(({ at }) => at);
    known.set(curve, points);
    return points;
  };

  return {
    element,
    clear() {
      for (const layer of Object.values(layers)) attribute(layer, "d", "");
      names.replaceChildren();
    },
    /** The curves alone. @param {CurvesDocument} document @param {View} view @param {Size} size */
    outlines(document, view, size) {
      this.clear();
      const d = document.curves.map((curve) => drawn(curve, polyline(curve).map((point) => toScreen(view, size, point)))).join("");
      attribute(layers.curves, "d", d);
    },
    /** @param {Shown} shown */
    draw({ view, size, document, steps, scene, hidden, focus, sets, aim, guess }) {
      write(result, words.outcome(describe(steps)));
      const at = (/** @type {Point} */ point) => toScreen(view, size, point);
      const sample = (/** @type {number} */ curve, /** @type {number} */ vertex) => steps.samples[curve]?.points[vertex] ?? [0, 0];
      const lines = (/** @type {Line[]} */ all) => all.map(({ ends: [p, q] }) => segment(at(p), at(q))).join("");
      const put = (/** @type {keyof typeof layers} */ name, /** @type {string} */ d) => attribute(layers[name], "d", d);

      const outlines = document.curves.map((curve) => drawn(curve, polyline(curve).map(at))).join("");
      const [first, second] = document.curves;
      put("band", isOpen(first) && second ? `${way(joined(polyline(first), polyline(second)).map(at))}Z` : outlines);
      put("curves", outlines);
      const redundant = new Set(scene.redundant);
      put("accepted", lines(scene.lines.filter((line) => !redundant.has(line))));
      put("redundant", lines(scene.redundant));
      put("left", scene.left ? lines([scene.left]) : "");

      const winner = hidden ? null : scene.chosen;
      const here = focus ? at(sample(focus.curve, focus.vertex)) : null;
      const other = focus ? /** @type {0 | 1} */ (1 - focus.curve) : 1;
      const rays = (/** @type {boolean} */ candidate) => (sets?.visible ?? []).filter((each) => each.candidate === candidate);
      const ray = (/** @type {number} */ vertex) => (here ? segment(here, at(sample(other, vertex))) : "");
      put("visible", rays(false).map(({ vertex }) => ray(vertex)).join(""));
      put("candidates", rays(true).map(({ vertex }) => ray(vertex)).join(""));
      put("dots", rays(true).map(({ vertex }) => dot(at(sample(other, vertex)))).join(""));
      put("valid", sets ? arc(steps, document, other, sets.valid, at) : "");

      const [covered, bare] = [0, 1].map((want) =>
        steps.samples.flatMap(({ points }, curve) =>
          points.filter((_, k) => ((scene.degrees[curve]?.[k] ?? 0) > (hidden && isEnd(scene.chosen, curve, k) ? 1 : 0)) === (want === 0)),
        ),
      );
      const rings = (/** @type {Point[]} */ points = []) => points.map((point) => dot(at(point))).join("");
      put("vertices", rings([...(covered ?? []), ...(bare ?? [])]));
      put("bare", rings(bare));
      put("orphans", scene.phase === "growth" || scene.phase === "start" ? "" : rings(bare));
      put("inserted", rings(scene.inserted));
      put("under", winner ? lines([winner]) : "");
      put("winner", winner ? lines([winner]) : "");
      const ends = winner ? winner.ends.map(at) : [];
      put("ends", [...ends, ...(here ? [here] : [])].map(dot).join(""));
      const missed = guess !== null && scene.chosen ? segment(at(scene.chosen.ends[0]), at(sample(1, guess))) : "";
      put("guess", missed);
      put("guessUnder", missed);
      const aimed = aim ? at(sample(aim.curve, aim.vertex)) : null;
      put("aim", aimed ? `${circle(aimed, 9)}${hidden && scene.chosen ? segment(at(scene.chosen.ends[0]), aimed) : ""}` : "");

      /** @type {Vertex[]} */
      const named = [];
      const add = (/** @type {0 | 1} */ curve, /** @type {number | null | undefined} */ vertex) => {
        if (vertex === null || vertex === undefined || named.some((each) => each.curve === curve && each.vertex === vertex)) return;
        named.push({ curve, vertex });
      };
      if (focus) add(focus.curve, focus.vertex);
      if (winner) {
        add(0, winner.from);
        add(1, winner.to);
      }
      if (guess !== null) add(1, guess);
      if (aim) add(aim.curve, aim.vertex);
      const clear = (/** @type {Vertex} */ { curve }) => (sets && curve === other ? NAME_PAST_ARC : NAME);
      names.replaceChildren(...named.map((vertex) => nameOf(steps, document, vertex, at, clear(vertex))));
    },
  };
}

/** @param {Line | null} line @param {number} curve @param {number} vertex */
const isEnd = (line, curve, vertex) => line !== null && (curve === 0 ? line.from : line.to) === vertex;

/**
 * The side of a curve that lies away from the other one: 1 outside, or to the right of an open curve, -1 inside.
 * @param {Steps} steps
 * @param {CurvesDocument} document
 * @param {number} curve
 */
function awaySide({ reversed }, { curves }, curve) {
  if (isOpen(curves[curve])) return reversed[curve] ? sideOf(curves, curve) : -sideOf(curves, curve);
  const [own, other] = [curve, 1 - curve].map((k) => Math.abs(signedArea(curves[k] ? seen(curves[k]).points : [])));
  return (own ?? 0) >= (other ?? 0) ? 1 : -1;
}

/**
 * The arc along the vertices that keep the order, beside the curve.
 * @param {Steps} steps
 * @param {CurvesDocument} document
 * @param {0 | 1} curve
 * @param {number[]} valid
 * @param {(point: Point) => Point} at
 */
function arc(steps, document, curve, valid, at) {
  const samples = steps.samples[curve];
  if (!samples || valid.length === 0) return "";
  const side = awaySide(steps, document, curve) * ARC;
  const points = valid.map((vertex) => beside(at(samples.points[vertex] ?? [0, 0]), samples.normals[vertex] ?? [0, 0], side));
  const [first] = points;
  if (!first) return "";
  if (points.length === 1) return dot(first);
  return smooth(points, !isOpen(document.curves[curve]) && valid.length >= samples.points.length);
}

/**
 * A place some pixels along the outward normal; y is down on the screen.
 * @param {Point} point CSS pixels
 * @param {Point} normal
 * @param {number} by
 * @returns {Point}
 */
const beside = (point, normal, by) => [point[0] + by * normal[0], point[1] - by * normal[1]];

/**
 * @param {Steps} steps
 * @param {CurvesDocument} document
 * @param {Vertex} vertex
 * @param {(point: Point) => Point} at
 * @param {number} by CSS pixels from the vertex
 */
function nameOf(steps, document, { curve, vertex }, at, by) {
  const { samples } = steps;
  const normal = samples[curve]?.normals[vertex] ?? [0, 0];
  const side = awaySide(steps, document, curve);
  const [x, y] = beside(at(samples[curve]?.points[vertex] ?? [0, 0]), normal, side * by);
  const aside = side * normal[0];
  const anchor = aside > ASIDE ? "start" : aside < -ASIDE ? "end" : "middle";
  return svg("text", { x: x.toFixed(1), y: (y + 4).toFixed(1), "text-anchor": anchor }, vertexName(curve, vertex));
}

/** @param {Point} point */
const written = ([x, y]) => `${x.toFixed(1)} ${y.toFixed(1)}`;

/** @param {Point} p @param {Point} q */
const segment = (p, q) => `M${written(p)}L${written(q)}`;

/** A point that round caps make a disc. @param {Point} point */
const dot = (point) => `M${written(point)}h.01`;

/** @param {Point} center @param {number} radius */
const circle = ([x, y], radius) => `M${written([x - radius, y])}a${radius} ${radius} 0 1 0 ${2 * radius} 0a${radius} ${radius} 0 1 0 ${-2 * radius} 0`;

/** @param {Point[]} points */
const way = (points) => `M${points.map(written).join("L")}`;

/** @param {Curve} curve @param {Point[]} points */
const drawn = (curve, points) => way(points) + ending(curve);

/**
 * A smooth line through points (Catmull and Rom's).
 * @param {Point[]} points
 * @param {boolean} isClosed
 */
function smooth(points, isClosed) {
  const n = points.length;
  const point = (/** @type {number} */ k) =>
    /** @type {Point} */ (points[isClosed ? (k + n) % n : Math.min(n - 1, Math.max(0, k))]);
  let d = `M${written(point(0))}`;
  for (let k = 0; k < (isClosed ? n : n - 1); k++) {
    const [before, from, to, after] = [k - 1, k, k + 1, k + 2].map(point);
    if (!before || !from || !to || !after) break;
    const lean = (/** @type {Point} */ at, /** @type {Point} */ a, /** @type {Point} */ b) =>
      /** @type {Point} */ ([at[0] + (b[0] - a[0]) / 6, at[1] + (b[1] - a[1]) / 6]);
    d += `C${written(lean(from, before, to))} ${written(lean(to, after, from))} ${written(to)}`;
  }
  return d;
}
