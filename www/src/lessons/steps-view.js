/**
 * A figure of the greedy growth: the picture and the controls of the step view, on the curves of the lesson or of the reader.
 *
 * @import { App } from "../state/app.js"
 * @import { CurvesDocument, Point, View } from "../types.js"
 * @import { Figure } from "../../../scripts/lib/lesson.mjs"
 * @import { Steps, VertexSets } from "../../../js/directrix.js"
 * @import { Line, Scene } from "../steps/film.js"
 * @import { Vertex } from "../steps/picture.js"
 * @import { Prediction } from "../steps/prediction.js"
 * @import { FigureView, Host } from "./figure.js"
 * @import { Parts } from "./parts.js"
 */
import { advice } from "../explain.js";
import { attribute, h } from "../dom.js";
import { outline } from "../spline.js";
import { Lane } from "../state/lane.js";
import { phaseAt, sceneAt, totalOf, vertexName } from "../steps/film.js";
import { createPicture } from "../steps/picture.js";
import { answered, begun, isHidden } from "../steps/prediction.js";
import { createPlayer } from "../steps/player.js";
import { spokenScene } from "../steps/spoken.js";
import { createTransport } from "../steps/transport.js";
import { nearestVertex, REACH } from "../steps/vertices.js";
import { words as stepWords } from "../steps/words.js";
import { toScreen } from "../view.js";
import { momentOf } from "./document.js";
import { partsOf } from "./parts.js";
import { words } from "./words.js";

/**
 * @param {App} app
 * @param {Host} host
 * @param {Figure} figure
 * @returns {FigureView}
 */
export function createStepsView(app, host, figure) {
  const { kernel } = app;
  const { surface } = host;
  const still = matchMedia("(prefers-reduced-motion: reduce)");
  const picture = createPicture();
  const reading = h("p", { class: "lesson-status", "data-lesson": "reading" });
  const vertices = h("div", {
    class: "lesson-vertices",
    role: "application",
    tabIndex: 0,
    hidden: true,
    "aria-label": stepWords.keyboard,
  });
  surface.element.prepend(/** @type {any} */ (picture.element), vertices);
  /** @type {CurvesDocument | null} */
  let document = null;
  /** @type {Steps | null} */
  let steps = null;
  /** @type {View | null} */
  let view = null;
  let at = 0;
  let start = 0;
  let over = false;
  let fits = 0;
  /** The question about a vertex, while it is open or has been answered. @type {Prediction | null} */
  let prediction = null;
  /** Told once when a vertex is chosen. @type {((right: boolean, text: string) => void) | null} */
  let ask = null;
  /** @type {Vertex | null} */
  let hovered = null;
  /** @type {Map<string, VertexSets>} */
  const sets = new Map();

  const player = createPlayer(() => {
    goTo(at + 1);
    return at < end();
  }, render);
  const transport = createTransport({
    goTo: (next) => goTo(next),
    goBy: (by) => goTo(at + by),
    toggle,
    setSpeed: (value) => (player.speed = value),
    togglePrediction: () => {},
  });

  /** @type {Lane<CurvesDocument, Steps>} */
  const lane = new Lane({
    work: (job, signal) => kernel.steps(job, { signal }),
    done(found, job) {
      if (over || job !== document) return;
      steps = found;
      sets.clear();
      at = start = momentOf(steps, figure.step);
      host.failed(steps.growth.length === 0 ? new Error(advice(steps) || stepWords.noSteps) : null);
      if (ask) prediction = begun(at - 1);
      void fit();
    },
    failed(error) {
      if (/** @type {Error} */ (error).name !== "AbortError") steps = null;
      host.failed(error);
    },
  });

  /** @type {Lane<{steps: Steps, key: string, step: number, vertex: Vertex}, VertexSets>} */
  const setsLane = new Lane({
    work: ({ step, vertex }, signal) => kernel.sets(/** @type {CurvesDocument} */ (document), { step, ...vertex }, { signal }),
    done(found, job) {
      if (over || job.steps !== steps) return;
      sets.set(job.key, found);
      render();
    },
    // What is wrong with the document is said where the steps are asked for.
    failed: () => {},
  });

  /** Fits the curves into the picture as large as it is now, and draws them. */
  async function fit() {
    const size = surface.size();
    if (!document || size.width < 1) return;
    const turn = (fits += 1);
    try {
      const fitted = await kernel.fit(document, size);
      if (over || turn !== fits) return;
      view = fitted;
      render();
    } catch (error) {
      if (!over && turn === fits) host.failed(error);
    }
  }

  const hidden = () => steps !== null && isHidden(prediction, steps, at);
  const end = () => (steps ? totalOf(steps) : 0);

  /** The vertex whose sets are shown: the start of the line that grows. @returns {{vertex: Vertex, step: number, key: string} | null} */
  function focus() {
    const line = steps?.growth[at - 1];
    if (!steps || !line || hidden() || phaseAt(steps, at).phase !== "growth") return null;
    return { vertex: { curve: 0, vertex: line.from }, step: at - 1, key: `${at - 1} ${line.from}` };
  }

  /** @param {number} next */
  function goTo(next) {
    at = Math.min(end(), Math.max(0, next));
    if (!player.playing) app.say(spoken());
    host.touched();
    render();
  }

  function toggle() {
    if (!steps) return;
    if (player.playing) return pause();
    if (still.matches) return goTo(at === end() ? 0 : at + 1);
    if (at === end()) at = 0;
    host.touched();
    player.play();
    render();
  }

  function pause() {
    player.pause();
    render();
  }

  /** The step in words, with its number. */
  function spoken() {
    if (!steps) return "";
    const scene = sceneAt(steps, at);
    const text = hidden() ? stepWords.askShort(vertexName(0, scene.chosen?.from ?? 0)) : spokenScene(scene, false);
    return `${stepWords.spokenStep(at, end())}: ${text}`;
  }

  function render() {
    if (!document || !steps || !view || steps.growth.length === 0) {
      if (!steps) picture.clear();
      attribute(picture.element, "aria-label", host.alt());
      return;
    }
    const size = surface.size();
    const scene = sceneAt(steps, at);
    const on = focus();
    const found = on ? (sets.get(on.key) ?? null) : null;
    if (on && !found) setsLane.push({ steps, key: on.key, step: on.step, vertex: on.vertex });
    const isSecret = hidden();
    const ownEnd = isSecret && scene.chosen ? { curve: /** @type {const} */ (0), vertex: scene.chosen.from ?? 0 } : null;
    const aim = isSecret && prediction?.aim !== null && prediction ? { curve: /** @type {const} */ (1), vertex: prediction.aim } : hovered;
    const guess = prediction?.told?.at === at && prediction.told.kind !== "right" ? prediction.told.guess : null;
    picture.draw({ view, size, document, steps, scene, hidden: isSecret, focus: on?.vertex ?? ownEnd, sets: found, aim, guess });
    attribute(picture.element, "viewBox", `0 0 ${size.width} ${size.height}`);
    const text = spoken();
    attribute(picture.element, "aria-label", at === start && !isSecret ? `${host.alt()} ${text}` : text);
    reading.replaceChildren(h("span", {}, ...withPowers(text)));
    vertices.hidden = !isSecret;
    surface.element.classList.toggle("asks", isSecret);
    transport.render({ steps, at, total: end(), text, playing: player.playing, still: still.matches, predicting: false });
    surface.name(namedIn(scene, found, on?.vertex ?? null, size));
    if (!on || found) host.element.dataset.drawn = "true";
    host.element.dataset.step = String(at);
  }

  /**
   * What the terms of the text name in this step.
   * @param {Scene} scene
   * @param {VertexSets | null} found
   * @param {Vertex | null} on
   * @param {import("../types.js").Size} size
   * @returns {Parts}
   */
  function namedIn(scene, found, on, size) {
    const place = (/** @type {Point} */ point) => toScreen(/** @type {View} */ (view), size, point);
    const sample = (/** @type {number} */ curve, /** @type {number} */ vertex) => place(steps?.samples[curve]?.points[vertex] ?? [0, 0]);
    const lines = (/** @type {Line[]} */ all) => ({ lines: all.map(({ ends: [p, q] }) => [place(p), place(q)]) });
    const curve = (/** @type {number} */ k) => ({ lines: (document?.curves[k] ? [outline(document.curves[k])] : []).map((chain) => chain.map((each) => place(each.at))) });
    const rays = (/** @type {boolean} */ candidate) => ({
      lines: on ? (found?.visible ?? []).filter((each) => each.candidate === candidate).map(({ vertex }) => [sample(0, on.vertex), sample(1, vertex)]) : [],
    });
    const bare = (steps?.samples ?? []).flatMap(({ points }, k) => points.filter((_, vertex) => scene.degrees[k]?.[vertex] === 0).map(place));
    return partsOf(host.terms, {
      winner: () => lines(scene.chosen && !hidden() ? [scene.chosen] : []),
      moved: () => lines(scene.chosen ? [scene.chosen] : []),
      redundant: () => lines(scene.redundant),
      candidates: () => rays(true),
      visible: () => rays(false),
      accepted: () => lines(scene.lines),
      valid: () => ({ dots: (found?.valid ?? []).map((vertex) => sample(1, vertex)) }),
      bare: () => ({ dots: bare }),
      first: () => curve(0),
      second: () => curve(1),
    });
  }

  /** The vertex of the second curve nearest to a place. @param {Point} place @param {number} reach */
  function under(place, reach) {
    return steps && view ? (nearestVertex(steps, view, surface.size(), place, [1], reach)?.vertex ?? null) : null;
  }

  /** @param {number} guess vertex of the second curve */
  async function answer(guess) {
    const line = steps?.growth[at - 1];
    const [asked, step] = [steps, at];
    if (!document || !steps || !line || !prediction || !hidden()) return;
    try {
      const found = await kernel.sets(document, { step: step - 1, vertex: line.from });
      if (over || steps !== asked || at !== step || !prediction || !hidden()) return;
      sets.set(`${step - 1} ${line.from}`, found);
      prediction = answered(prediction, steps, step, found, guess);
      hovered = null;
      const { kind } = /** @type {NonNullable<Prediction["told"]>} */ (prediction.told);
      ask?.(kind === "right", kind === "right" ? "" : words.vertex[kind](vertexName(1, guess)));
      render();
    } catch (error) {
      host.failed(error);
    }
  }

  surface.element.addEventListener("pointermove", (event) => {
    if (!hidden()) return;
    const vertex = under(surface.placeOf(event), REACH.mouse);
    if (vertex === (hovered?.vertex ?? null)) return;
    hovered = vertex === null ? null : { curve: 1, vertex };
    render();
  });
  surface.element.addEventListener("pointerleave", () => {
    if (!hovered) return;
    hovered = null;
    render();
  });
  surface.element.addEventListener("click", (event) => {
    if (!hidden()) return;
    const isTouch = event instanceof PointerEvent && event.pointerType === "touch";
    const vertex = under(surface.placeOf(event), isTouch ? REACH.touch : REACH.mouse);
    if (vertex !== null) void answer(vertex);
  });
  vertices.addEventListener("keydown", (event) => {
    const by = { ArrowRight: 1, ArrowLeft: -1, ArrowUp: 1, ArrowDown: -1 }[event.key];
    const count = steps?.samples[1]?.points.length ?? 0;
    const line = steps?.growth[at - 1];
    if (!steps || !view || !line || !prediction || count === 0) return;
    const from = toScreen(view, surface.size(), steps.samples[0]?.points[line.from] ?? [0, 0]);
    const aim = prediction.aim ?? under(from, Infinity) ?? 0;
    if (by !== undefined) {
      prediction = { ...prediction, aim: prediction.aim === null ? aim : (aim + by + count) % count };
      app.say(stepWords.aim(vertexName(1, prediction.aim ?? 0)));
      render();
    } else if (event.key === "Enter" || event.key === " ") void answer(aim);
    else return;
    event.preventDefault();
    event.stopPropagation();
  });

  return {
    status: reading,
    controls: figure.controls === "none" ? null : transport.element,
    show(next) {
      player.pause();
      document = next;
      prediction = null;
      hovered = null;
      lane.push(next);
    },
    draw: () => void fit(),
    state: () => (document ? { document, s: null, step: at } : null),
    ask(told) {
      ask = told;
      if (!steps || !told) return;
      at = start;
      prediction = begun(at - 1);
      render();
    },
    focus: () => vertices.focus({ preventScroll: true }),
    close() {
      over = true;
      player.pause();
      lane.cancel();
      setsLane.cancel();
    },
  };
}

/** A sentence in which powers of ten stand raised. @param {string} text @returns {(string | Node)[]} */
const withPowers = (text) => text.split(/\^(\S+?)(?=[,\s]|$)/).map((part, k) => (k % 2 === 1 ? h("sup", {}, part) : part));
