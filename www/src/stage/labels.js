/**
 * Names on lines of the picture: the fraction on every second line of equal composition, and s on the in-betweens when asked for. They lie
 * on the lines as text over the canvas, few and apart, and are away while the curves move.
 *
 * @import { App } from "../state/app.js"
 * @import { CurvesDocument, Match, Point, Size, View } from "../types.js"
 * @import { Harmonic, Isoline } from "../../../js/directrix.js"
 */
import { find, h } from "../dom.js";
import { fixed, percent } from "../format.js";
import { symbol } from "../icons.js";
import { currentMatch } from "../state/app.js";
import { seen } from "../state/in-space.js";
import { Lane } from "../state/lane.js";
import { shownLines } from "../state/lines.js";
import { lookedAt } from "../state/look.js";
import { strings } from "../strings.js";
import { toScreen } from "../view.js";

/** Levels with a name; the picture has a line at the tenths between as well. */
const LEVELS = [0.2, 0.4, 0.6, 0.8];
/** Milliseconds of rest before lines are asked for. */
const REST = 200;
/** Least distance between two names, to the edge of the canvas, and to its lower furniture, CSS pixels. */
const APART = 44;
const CLEAR = 26;
const EDGE = 24;
const BELOW = 90;
/** Least distance between in-betweens with a name, CSS pixels. */
const ROOM = 17;
/** Places tried along a line. */
const TRIED = 24;

/** @typedef {{at: Point, text: string, isStage: boolean}} Label `at` in CSS pixels; on a stage the symbol s comes first */

/** @param {App} app */
export function createLabels(app) {
  const layer = h("div", { class: "overlay line-labels", "aria-hidden": "true" });
  find("#overlay").before(layer);
  /** @type {{document: CurvesDocument, material: number, lines: Isoline[]} | null} */
  let known = null;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let timer;
  let waitingFor = "";
  let drawn = "";

  /** @type {Lane<{document: CurvesDocument, material: number}, Isoline[]>} */
  const lane = new Lane({
    work: ({ document, material }, signal) =>
      app.kernel.isolines(document, { material, levels: LEVELS }, { signal }),
    done: (lines, { document, material }) => {
      known = { document, material, lines };
      render();
    },
    // The picture says what is wrong with the document.
    failed: () => {},
  });

  /** Asks for the lines of the document once it is at rest. */
  function ask() {
    const document = lookedAt(app);
    const { isoMaterial: material } = app.ui.value;
    if (known?.document === document && known.material === material) return;
    const wanted = `${ids.of(document)} ${material}`;
    if (wanted === waitingFor) return;
    waitingFor = wanted;
    clearTimeout(timer);
    timer = setTimeout(() => lane.push({ document, material }), REST);
  }

  /** Handles that names keep clear of, CSS pixels. @returns {Point[]} */
  function handlePlaces() {
    const { view, size, layers, composing } = app.ui.value;
    if (!view || composing || !layers.includes("controlPoints")) return [];
    return app.store.document.curves.flatMap((curve) => seen(curve).points.map((point) => toScreen(view, size, point)));
  }

  /** @type {{document: CurvesDocument, blend: Harmonic, places: typeof import("../harmonic/labels.js")["levelPlaces"]} | null} */
  let levels = null;
  /** @type {CurvesDocument | null} */
  let askedLevels = null;

  /** Names on the level curves of a harmonic blend, which come once the curves rest. @param {View} view @param {Size} size @param {Label[]} labels */
  function onLevels(view, size, labels) {
    const document = lookedAt(app);
    if (levels?.document === document) {
      let last = /** @type {Point} */ ([-ROOM, -ROOM]);
      for (const { s, at } of levels.places(levels.blend, (point) => toScreen(view, size, point), (point) => isFree(point, size))) {
        if (Math.hypot(at[0] - last[0], at[1] - last[1]) < ROOM) continue;
        labels.push({ at, text: ` ${fixed(s, 2)}`, isStage: true });
        last = at;
      }
      return;
    }
    if (askedLevels === document || app.store.running) return;
    askedLevels = document;
    void Promise.all([import("../harmonic/blend.js"), import("../harmonic/labels.js")]).then(async ([{ blendOf }, { levelPlaces }]) => {
      levels = { document, blend: await blendOf(app, document), places: levelPlaces };
      render();
    });
  }

  function render() {
    const { view, size, layers, stageLabels, isoMaterial } = app.ui.value;
    const match = currentMatch(app);
    /** @type {Label[]} */
    const labels = [];
    if (view && match?.ok) {
      if (layers.includes("isoComposition")) {
        ask();
        if (known?.document === lookedAt(app) && known.material === isoMaterial) {
          onIsolines(known.lines, view, size, handlePlaces(), labels);
        }
      }
      if (stageLabels && layers.includes("inBetweens")) {
        if (match.harmonic) onLevels(view, size, labels);
        const [spans, knots] = [match.spans ?? [match], match.knots ?? [0, 1]];
        spans.forEach((span, k) => onInBetweens(app.store.document, span, [knots[k], knots[k + 1]], view, size, labels));
      }
    }
    const key = JSON.stringify(labels);
    if (key === drawn) return;
    drawn = key;
    layer.replaceChildren(
      ...labels.map(({ at: [x, y], text, isStage }) => {
        const name = h("span", { class: "line-label number" }, isStage && symbol("s"), text);
        name.style.transform = `translate(${Math.round(x)}px, ${Math.round(y)}px) translate(-50%, -50%)`;
        return name;
      }),
    );
  }
  return { render };
}

/** Numbers that tell documents apart. */
const ids = {
  next: 1,
  /** @type {WeakMap<CurvesDocument, number>} */
  given: new WeakMap(),
  /** @param {CurvesDocument} document */
  of(document) {
    const id = this.given.get(document) ?? this.next++;
    this.given.set(document, id);
    return id;
  },
};

/**
 * One name on each level, where it is farthest from the others.
 * @param {Isoline[]} isolines
 * @param {View} view
 * @param {Size} size
 * @param {Point[]} handles
 * @param {Label[]} labels
 */
function onIsolines(isolines, view, size, handles, labels) {
  for (const { level, lines } of isolines) {
    const longest = lines.reduce((best, line) => (line.length > best.length ? line : best), /** @type {Point[]} */ ([]));
    /** @type {Point | null} */
    let best = null;
    let most = APART;
    for (let i = 0; i < TRIED && longest.length > 2; i += 1) {
      const at = toScreen(view, size, longest[Math.floor(((i + 0.5) * longest.length) / TRIED)]);
      if (!isFree(at, size) || handles.some(([x, y]) => Math.hypot(x - at[0], y - at[1]) < CLEAR)) continue;
      const room = Math.min(4 * APART, ...labels.map((other) => Math.hypot(other.at[0] - at[0], other.at[1] - at[1])));
      if (room > most) [most, best] = [room, at];
    }
    if (best) labels.push({ at: best, text: percent(level), isStage: false });
  }
}

/**
 * s on the in-betweens, along the ruling line that goes most steeply over the screen, so that the names stand one above the other. Where both
 * curves hold one pure material each, the fraction of the second follows.
 * @param {CurvesDocument} document
 * @param {Match} match of one span
 * @param {[number, number]} ends of s on it
 * @param {View} view
 * @param {Size} size
 * @param {Label[]} labels
 */
function onInBetweens(document, match, [low, high], view, size, labels) {
  const ends = shownLines(match).map(({ from, to }) => [toScreen(view, size, from), toScreen(view, size, to)]);
  const rise = (/** @type {Point[]} */ [a, b]) =>
    isFree(a, size) && isFree(b, size) ? Math.abs(a[1] - b[1]) - Math.abs(a[0] - b[0]) / 2 : -Infinity;
  const line = ends.reduce((best, other) => (rise(other) > rise(best) ? other : best), ends[0]);
  if (!line || rise(line) === -Infinity) return;
  const [[ax, ay], [bx, by]] = line;
  const { stages } = document.blend;
  const stride = Math.ceil((ROOM * stages) / Math.max(1, Math.hypot(bx - ax, by - ay)));
  const blend = homogeneous(document);
  for (let j = stride; j < stages; j += stride) {
    const s = j / stages;
    const parts = [` ${fixed(low + s * (high - low), 2)}`, ...(blend ? [strings.mixing.share(blend.name, percent(blend.at(s)))] : [])];
    labels.push({ at: [ax + (bx - ax) * s, ay + (by - ay) * s], text: parts.join(" · "), isStage: true });
  }
}

/**
 * The material that grows from the first curve to the second, where both have one composition all along. Null otherwise.
 * @param {CurvesDocument} document
 */
function homogeneous({ curves, materials }) {
  if (curves.length !== 2) return null;
  const [first, second] = curves.map(({ composition }) =>
    composition.every(({ mix }) => mix.every((part, i) => part === composition[0].mix[i])) ? composition[0].mix : null,
  );
  if (!first || !second) return null;
  const gains = second.map((part, i) => part - first[i]);
  const index = gains.indexOf(Math.max(...gains));
  if (gains[index] <= 0) return null;
  return { name: materials[index].name, at: (/** @type {number} */ s) => first[index] + s * gains[index] };
}

/** Whether a name may stand here. @param {Point} at @param {Size} size */
function isFree([x, y], size) {
  return x > EDGE && x < size.width - EDGE && y > EDGE && y < size.height - BELOW;
}
