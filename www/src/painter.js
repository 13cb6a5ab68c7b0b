/**
 * Keeps picture and results up with the document: whatever changes, the newest state is asked for, one request at a
 * time.
 *
 * @import { App } from "./state/app.js"
 * @import { CurvesDocument, Match, PaintOptions, Picture, Problem, Size } from "./types.js"
 *
 * @typedef {object} Outcome
 * @property {CurvesDocument} document
 * @property {PromiseSettledResult<Match> | null} match null when the match was there already
 * @property {PromiseSettledResult<Picture>} picture
 * @property {number} ms
 */
import { seenAlong } from "./state/in-space.js";
import { Lane } from "./state/lane.js";
import { isHarmonic, lookedAt } from "./state/look.js";
import { strings } from "./strings.js";

/** Device pixels painted at most while something moves, and the pause after which all of them are. */
const MOVING_PIXELS = 1_000_000;
const IDLE = 250;
/** Longest side of a picture that the kernel paints. */
const LARGEST = 4096;

/**
 * @param {App} app
 * @returns {{update: () => void, retry: () => void, cancel: () => void}}
 */
export function createPainter(app) {
  const { store, ui, results, kernel } = app;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let idle;
  /** @type {PaintOptions | null} */
  let asked = null;
  /** @type {CurvesDocument | null} */
  let askedFor = null;

  /**
   * `fine` pictures have all pixels of the screen; `coarse` ones do without the refinement on the curves, which a drag cannot wait for.
   * @type {Lane<{fine: boolean, coarse: boolean}, Outcome>}
   */
  const lane = new Lane({
    async work({ fine, coarse }, signal) {
      const document = lookedAt(app);
      const started = performance.now();
      const onprogress = (/** @type {number} */ progress) => results.set({ progress });
      const [match, picture] = await Promise.allSettled([
        answered(document, coarse) ? null : kernel.match(document, { coarse }, { signal, onprogress }),
        kernel.paint(document, { ...options(fine), coarse }, { signal }),
      ]);
      const solved = match.status === "fulfilled" && match.value === null ? null : match;
      return {
        document,
        match: /** @type {PromiseSettledResult<Match> | null} */ (solved),
        picture,
        ms: performance.now() - started,
      };
    },
    done: ({ document, match, picture, ms }) => {
      const failure = [match, picture].find((r) => r?.status === "rejected" && isInterruption(r.reason));
      if (failure?.status === "rejected") {
        interrupted(failure.reason);
        return;
      }
      if (match?.status === "fulfilled") seenAlong(match.value.projection);
      if (picture.status === "fulfilled") results.set({ picture: picture.value });
      if (match) {
        const refined = results.value.matched === document;
        results.set({
          matched: document,
          match: match.status === "fulfilled" ? match.value : null,
          problem: match.status === "rejected" ? problem(match.reason) : null,
          ms: refined ? results.value.ms : ms,
        });
      }
      if (!store.running) refine();
    },
    failed: interrupted,
    slow: (slow) => results.set(slow ? { slow } : { slow, progress: 0 }),
  });

  /** Whether the match of a document is there. @param {CurvesDocument} document @param {boolean} coarse */
  function answered(document, coarse) {
    const { matched, match } = results.value;
    return matched === document && (coarse || !match?.coarse);
  }

  /** Asks for what a drag left out, unless the next picture is asked for anyway. */
  function refine() {
    if (!lane.waits && !answered(lookedAt(app), false)) lane.push({ fine: false, coarse: false });
  }

  /** @param {PaintOptions} options */
  const isFine = ({ pixelRatio = 1 }) => pixelRatio >= (window.devicePixelRatio || 1);

  /** @param {unknown} error */
  function interrupted(error) {
    const { name, code, message } = problem(error);
    if (name === "AbortError" && busyElsewhere()) return;
    if (name === "AbortError") ui.set({ note: { tone: "plain", text: strings.status.cancelled } });
    else if (code === "trap") ui.set({ note: { tone: "error", text: strings.errors.trap } });
    else ui.set({ note: { tone: "error", text: message } });
  }

  const busyElsewhere = () => ["compare", "solid"].includes(ui.value.mode) || ui.value.workbench === "lessons";

  /** @param {boolean} fine @returns {PaintOptions & {pixelRatio: number}} */
  function options(fine) {
    const { size, view, layers, theme, s, probe, line, isoMaterial, patterns, composing } = ui.value;
    const shown = layers.filter((name) => (name !== "controlPoints" || !composing) && (name !== "difference" || isHarmonic(lookedAt(app))));
    const full = window.devicePixelRatio || 1;
    const moving = Math.min(full, Math.sqrt(MOVING_PIXELS / (size.width * size.height)));
    const most = LARGEST / Math.max(size.width, size.height);
    return {
      ...devicePixels(size, Math.min(most, fine ? full : moving)),
      ...(view ? { view } : {}),
      layers: shown,
      theme,
      s,
      line: probe?.line ?? line,
      isoMaterial,
      patterns,
    };
  }

  /** @param {boolean} [force] */
  function update(force = false) {
    const { view, size } = ui.value;
    if (busyElsewhere()) {
      // They have pictures of their own, and the worker to themselves.
      clearTimeout(idle);
      askedFor = null;
      lane.cancel();
      return;
    }
    if (!view || size.width < 1 || size.height < 1) return;
    const next = options(false);
    const document = lookedAt(app);
    if (!force && askedFor === document && asked && same(asked, next)) return;
    const coarse = !answered(document, false);
    asked = next;
    askedFor = document;
    lane.push({ fine: false, coarse });
    clearTimeout(idle);
    if (coarse || !isFine(next)) idle = setTimeout(rest, IDLE);
  }

  /** The picture of a page at rest. */
  function rest() {
    if (!isFine(options(false))) lane.push({ fine: true, coarse: false });
    else refine();
  }

  return { update, retry: () => update(true), cancel: () => lane.cancel() };
}

/**
 * A size in CSS pixels as the kernel takes it.
 * @param {Size} size
 * @param {number} pixelRatio
 */
export function devicePixels(size, pixelRatio) {
  return { width: Math.round(size.width * pixelRatio), height: Math.round(size.height * pixelRatio), pixelRatio };
}

/** @param {PaintOptions} a @param {PaintOptions} b */
function same(a, b) {
  return JSON.stringify(a) === JSON.stringify(b);
}

/** @param {unknown} reason */
function isInterruption(reason) {
  const { name, code } = problem(reason);
  return name === "AbortError" || code === "trap";
}

/**
 * @param {unknown} reason
 * @returns {Problem}
 */
export function problem(reason) {
  if (reason instanceof Error) {
    const { code = "unknown", path, at } = /** @type {Error & Partial<Problem>} */ (reason);
    return {
      name: reason.name,
      code,
      message: reason.message,
      ...(path === undefined ? {} : { path }),
      ...(at === undefined ? {} : { at }),
    };
  }
  return { code: "unknown", message: String(reason) };
}
