/**
 * The step view: the greedy growth, the removal of redundant lines and both passes of insertion, one step after the other, on the curves
 * of the document.
 *
 * @import { App, Tool } from "../state/app.js"
 * @import { CurvesDocument, Point } from "../types.js"
 * @import { Place } from "../modes/modes.js"
 * @import { Steps, VertexSets } from "../../../js/directrix.js"
 * @import { Prediction } from "./prediction.js"
 * @import { Now } from "./groups.js"
 * @import { Vertex } from "./picture.js"
 */
import "../../styles/steps.css";
import { attribute, h, write } from "../dom.js";
import { advice, explain } from "../explain.js";
import { createGroups } from "../inspector/inspector.js";
import { problem } from "../painter.js";
import { fit } from "../stage/zoom.js";
import { Lane } from "../state/lane.js";
import { toScreen } from "../view.js";
import { createAsking } from "./asking.js";
import { CODE, phaseAt, sceneAt, totalOf, vertexName } from "./film.js";
import { createStepGroups } from "./groups.js";
import { createKeyboard } from "./keys.js";
import { createLegend } from "./legend.js";
import { createPicture } from "./picture.js";
import { createPlayer } from "./player.js";
import { answered, begun, isHidden } from "./prediction.js";
import { spokenAnswer, spokenScene, spokenSets } from "./spoken.js";
import { renderStatus } from "./status.js";
import { createTransport } from "./transport.js";
import { nearestVertex, REACH } from "./vertices.js";
import { words } from "./words.js";

/** Groups that are open, and the one on a phone, for as long as the page is open. */
let memory = { open: ["growth", "step", "candidates"], tab: "step" };

/**
 * @param {App} app
 * @param {Place} place
 */
export function createSteps(app, { stage, aside, status }) {
  const { store, ui, kernel } = app;
  const still = matchMedia("(prefers-reduced-motion: reduce)");
  /** @type {Steps | null} */
  let steps = null;
  /** @type {CurvesDocument | null} */
  let asked = null;
  /** @type {CurvesDocument | null} */
  let shown = null;
  /** Why there are no steps. */
  let failure = "";
  let ms = 0;
  let at = ui.value.step;
  /** The vertex that the person chose, in place of the one of the step. @type {Vertex | null} */
  let chosen = null;
  /** @type {Vertex | null} */
  let hovered = null;
  /** @type {Prediction | null} */
  let prediction = null;
  /** @type {Map<string, VertexSets>} */
  const sets = new Map();
  /** What is said once the sets are there. @type {string | null} */
  let toSay = null;

  const picture = createPicture();
  const legend = createLegend();
  const message = h("p", { class: "steps-message", hidden: true });
  const asking = createAsking(() => goBy(1));
  const keyboard = createKeyboard(aside, {
    isReady: () => steps !== null,
    isHidden: hidden,
    moveAlong,
    changeCurve,
    goTo,
    goBy,
    toggle,
    settle() {
      if (!prediction) return false;
      if (hidden()) void answer(aimed().vertex);
      else goBy(1);
      return true;
    },
    leave() {
      if (!chosen && !prediction) return false;
      if (chosen) follow();
      else togglePrediction();
      return true;
    },
  });
  const player = createPlayer(
    () => {
      goTo(at + 1);
      return at < end();
    },
    () => {
      say();
      render();
    },
  );
  const transport = createTransport({
    goTo: (next) => {
      player.pause();
      goTo(next);
    },
    goBy,
    toggle,
    setSpeed: (value) => (player.speed = value),
    togglePrediction,
  });
  const foot = h("div", { class: "steps-foot" }, h("div", { class: "steps-head" }, legend.element, transport.predict), transport.element);
  stage.append(/** @type {any} */ (picture.element), ...keyboard.elements, message, asking.element, foot);
  const groupsAt = h("div", { class: "steps-groups" });
  aside.append(groupsAt);
  const groups = createGroups(groupsAt, words.groups.region, createStepGroups(app, now, { goTo, follow }), {
    read: () => memory,
    write: (patch) => {
      memory = { ...memory, ...patch };
      render();
    },
  });

  /** @type {Lane<CurvesDocument, {steps: Steps, ms: number}>} */
  const lane = new Lane({
    async work(document, signal) {
      let spent = 0;
      const onsolved = (/** @type {number} */ milliseconds) => (spent = milliseconds);
      return { steps: await kernel.steps(document, { signal, onsolved }), ms: spent };
    },
    done(result, document) {
      steps = result.steps;
      ms = result.ms;
      failure = "";
      begin(document);
    },
    failed(error, document) {
      const { name } = problem(error);
      if (name === "AbortError") return;
      steps = null;
      failure = explain(store.document, problem(error));
      begin(document);
    },
  });

  /** @type {Lane<{steps: Steps, key: string, step: number, vertex: Vertex}, VertexSets>} */
  const setsLane = new Lane({
    work: ({ step, vertex }, signal) => kernel.sets(/** @type {CurvesDocument} */ (shown), { step, ...vertex }, { signal }),
    done(found, job) {
      if (job.steps !== steps) return;
      sets.set(job.key, found);
      render();
    },
    // The step view says what is wrong with the document when it asks for the steps.
    failed: () => {},
  });

  /** Shows the steps of a document from where it stood. @param {CurvesDocument} document */
  function begin(document) {
    shown = document;
    sets.clear();
    if (!steps || steps.growth.length === 0) player.pause();
    prediction = prediction && steps ? begun(Math.min(at, steps.growth.length)) : null;
    const counts = steps?.samples.map(({ points }) => points.length) ?? [];
    if (chosen && chosen.vertex >= (counts[chosen.curve] ?? 0)) chosen = null;
    at = Math.min(ui.value.step, end());
    render();
  }

  function hidden() {
    return steps !== null && isHidden(prediction, steps, at);
  }

  /** Asks for what the next step will show, so that playing does not blink. */
  function fetchNext() {
    const next = steps?.growth[at];
    if (!steps || !next || hidden()) return;
    const vertex = chosen ?? { curve: /** @type {const} */ (0), vertex: next.from };
    const key = `${at} ${vertex.curve} ${vertex.vertex}`;
    if (!sets.has(key)) setsLane.push({ steps, key, step: at, vertex });
  }

  const end = () => (steps ? totalOf(steps) : 0);

  /** The vertex whose sets are shown, and after how many lines. @returns {{vertex: Vertex, step: number, key: string} | null} */
  function focus() {
    if (!steps || hidden()) return null;
    const { phase } = phaseAt(steps, at);
    const own = phase === "growth" ? steps.growth[at - 1] : undefined;
    const vertex = chosen ?? (own ? { curve: /** @type {const} */ (0), vertex: own.from } : null);
    if (!vertex || (phase !== "growth" && phase !== "start")) return null;
    const step = Math.max(0, at - 1);
    return { vertex, step, key: `${step} ${vertex.curve} ${vertex.vertex}` };
  }

  /** @returns {Now | null} */
  function now() {
    if (!steps || steps.growth.length === 0) return null;
    const on = focus();
    const scene = sceneAt(steps, at);
    if (hidden()) scene.code = CODE.ask;
    else if (prediction?.told?.at === at) scene.code = CODE.accept;
    return {
      steps,
      at,
      scene,
      hidden: hidden(),
      focus: on?.vertex ?? null,
      pinned: chosen !== null && on !== null,
      sets: (on && sets.get(on.key)) ?? null,
      prediction,
    };
  }

  /** @param {number} next */
  function goTo(next) {
    if (!steps) return;
    at = Math.min(end(), Math.max(0, next));
    ui.set({ step: at, note: null });
    if (prediction) prediction = { ...prediction, aim: null, told: prediction.told?.at === at ? prediction.told : null };
    hovered = null;
    if (!player.playing) say();
    render();
  }

  /** @param {number} by */
  function goBy(by) {
    player.pause();
    goTo(at + by);
  }

  function toggle() {
    if (!steps || steps.growth.length === 0) return;
    if (player.playing) {
      player.pause();
      say();
      render();
    } else if (still.matches || prediction) {
      goTo(at === end() ? 0 : at + 1);
    } else {
      if (at === end()) goTo(0);
      app.say(words.playing);
      player.play();
      render();
    }
  }

  function follow() {
    chosen = null;
    say();
    render();
  }

  /** @param {Vertex | null} vertex */
  function choose(vertex) {
    chosen = vertex;
    const on = focus();
    toSay = on ? on.key : null;
    render();
  }

  function togglePrediction() {
    player.pause();
    if (!steps) return;
    if (prediction) {
      prediction = null;
      app.say(words.spokenStep(at, end()));
    } else if (at >= steps.growth.length) {
      app.say(words.predictOver);
      ui.set({ note: { tone: "plain", text: words.predictOver } });
      return;
    } else {
      chosen = null;
      prediction = begun(at);
      at += 1;
      ui.set({ step: at });
      keyboard.focus();
      say();
    }
    render();
  }

  /** Takes a guess, and tells what it is worth. @param {number} guess vertex of the second curve */
  async function answer(guess) {
    const line = steps?.growth[at - 1];
    if (!steps || !line || !prediction || !hidden()) return;
    const [growing, step] = [steps, at];
    try {
      const found = await kernel.sets(/** @type {CurvesDocument} */ (shown), { step: step - 1, vertex: line.from });
      if (steps !== growing || at !== step || !prediction || !hidden()) return;
      sets.set(`${step - 1} 0 ${line.from}`, found);
      prediction = answered(prediction, steps, step, found, guess);
      hovered = null;
      app.say(spokenAnswer(prediction, steps, step) ?? "");
      render();
    } catch (error) {
      ui.set({ note: { tone: "error", text: problem(error).message } });
    }
  }

  function say() {
    toSay = null;
    app.say(spoken());
  }

  /** The step in words, with its number. */
  function spoken() {
    const state = now();
    return `${words.spokenStep(at, end())}: ${state ? spokenScene(state.scene, state.hidden) : words.noSteps}`;
  }

  /** Says what the chosen vertex sees and may have, once that is known. @param {string} key @param {VertexSets} found */
  function saySets(key, found) {
    if (toSay !== key || !chosen) return;
    toSay = null;
    app.say(spokenSets(chosen, found));
  }

  /** The vertex that is meant by a place on the screen. @param {Point} place @param {number} reach */
  function under(place, reach) {
    const { view, size } = ui.value;
    return view && steps ? nearestVertex(steps, view, size, place, hidden() ? [1] : [0, 1], reach) : null;
  }

  /** Chooses the next vertex along a curve, or aims at it. @param {number} by */
  function moveAlong(by) {
    const line = steps?.growth[at - 1];
    const from = hidden() ? aimed() : (focus()?.vertex ?? { curve: /** @type {const} */ (0), vertex: line?.from ?? 0 });
    const count = steps?.samples[from.curve]?.points.length ?? 0;
    if (count === 0) return;
    const vertex = (from.vertex + by + count) % count;
    if (!hidden() || !prediction) return choose({ curve: from.curve, vertex });
    prediction = { ...prediction, aim: vertex };
    app.say(words.aim(vertexName(1, vertex)));
    render();
  }

  /** The vertex aimed at; at first the nearest to the start of the line. @returns {Vertex} */
  function aimed() {
    const { view, size } = ui.value;
    const start = steps?.growth[at - 1]?.from;
    const point = start === undefined ? undefined : steps?.samples[0]?.points[start];
    const near = prediction?.aim ?? (steps && view && point ? nearestVertex(steps, view, size, toScreen(view, size, point), [1])?.vertex : null);
    return { curve: 1, vertex: near ?? 0 };
  }

  /** Chooses the end on the other curve of the line of the step, or the vertex nearest to the chosen one. */
  function changeCurve() {
    const { view, size } = ui.value;
    const from = focus()?.vertex;
    const line = steps?.growth[Math.max(0, at - 1)];
    if (!steps || !view || !from || hidden()) return;
    const curve = from.curve === 0 ? 1 : 0;
    const isOwn = line && (from.curve === 0 ? line.from : line.to) === from.vertex;
    if (line && isOwn) return choose({ curve, vertex: curve === 0 ? line.from : line.to });
    const place = toScreen(view, size, steps.samples[from.curve]?.points[from.vertex] ?? [0, 0]);
    choose(nearestVertex(steps, view, size, place, [curve]));
  }

  /** @type {Tool} */
  const tool = {
    hover(place) {
      const vertex = place ? under(place, REACH.mouse) : null;
      if (vertex?.curve === hovered?.curve && vertex?.vertex === hovered?.vertex) return;
      hovered = vertex;
      render();
    },
    tap(place, event) {
      const vertex = under(place, event.pointerType === "touch" ? REACH.touch : REACH.mouse);
      keyboard.take();
      if (hidden()) {
        if (vertex) void answer(vertex.vertex);
        return;
      }
      const isSame = vertex && chosen && vertex.curve === chosen.curve && vertex.vertex === chosen.vertex;
      if (!vertex || isSame) follow();
      else choose(vertex);
    },
    stroke: () => null,
    render() {},
    close() {
      if (app.tool === tool) app.tool = null;
    },
  };

  // The lower edge is this view's own from now on.
  requestAnimationFrame(() => {
    if (ui.value.fitted) void fit(app).catch(() => {});
  });

  function render() {
    const { document } = store;
    if (asked !== document) {
      asked = document;
      lane.push(document);
    }
    if (app.tool !== tool) {
      app.tool?.close();
      app.tool = tool;
    }
    const { view, size } = ui.value;
    const on = focus();
    const found = on ? sets.get(on.key) : undefined;
    if (on && found) {
      saySets(on.key, found);
      fetchNext();
    } else if (on && steps) setsLane.push({ steps, key: on.key, step: on.step, vertex: on.vertex });

    const state = now();
    const isEmpty = !steps || steps.growth.length === 0;
    message.hidden = !isEmpty;
    write(message, isEmpty ? why() : "");
    foot.hidden = isEmpty;
    message.classList.toggle("below", document.curves.length > 1);
    if (!shown || shown.curves.length !== document.curves.length) picture.clear();
    else if (!state && view) {
      picture.outlines(shown, view, size);
      attribute(picture.element, "aria-label", words.picture(document.title, why()));
    } else if (state && view) {
      const aim = hidden() && !hovered && prediction?.aim !== null ? aimed() : hovered;
      const guess = prediction?.told?.at === at && prediction.told.kind !== "right" ? prediction.told.guess : null;
      const ownEnd = hidden() && state.scene.chosen ? { curve: /** @type {const} */ (0), vertex: state.scene.chosen.from ?? 0 } : null;
      picture.draw({ view, size, document: shown, steps: state.steps, scene: state.scene, hidden: state.hidden, focus: state.focus ?? ownEnd, sets: state.sets, aim, guess });
      const text = spoken();
      attribute(picture.element, "aria-label", words.picture(document.title, text));
      transport.render({ steps: state.steps, at, total: end(), text, playing: player.playing, still: still.matches, predicting: prediction !== null });
      legend.render(state);
    }
    stage.dataset.step = String(at);
    stage.dataset.phase = state?.scene.phase ?? "";
    stage.dataset.hidden = String(hidden());
    stage.parentElement?.classList.toggle("steps-hover", hovered !== null);
    asking.render(prediction, steps, at);
    groups.render();
    renderStatus(status, { now: state, why: why(), isFailure: failure !== "", note: ui.value.note, ms });
  }

  /** Why there is nothing to show. */
  function why() {
    if (failure) return failure;
    if (store.document.curves.length < 2) return words.needsTwo;
    if (!steps) return "";
    return advice(steps) || words.noSteps;
  }

  return {
    render,
    close() {
      player.pause();
      keyboard.close();
      lane.cancel();
      setsLane.cancel();
      tool.close();
      stage.parentElement?.classList.remove("steps-hover");
      for (const name of ["step", "phase", "hidden"]) delete stage.dataset[name];
      requestAnimationFrame(() => {
        if (ui.value.fitted) void fit(app).catch(() => {});
      });
    },
  };
}
