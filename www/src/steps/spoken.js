/**
 * What the step view says: a step, what a vertex may have, and the answer to a guess. Pure functions.
 *
 * @import { Steps, VertexSets } from "../../../js/directrix.js"
 * @import { Scene } from "./film.js"
 * @import { Vertex } from "./picture.js"
 * @import { Prediction } from "./prediction.js"
 */
import { significantText } from "../format.js";
import { lineName, vertexName } from "./film.js";
import { words } from "./words.js";

/** A step in words. @param {Scene} scene @param {boolean} hidden whether its line is still to be guessed */
export function spokenScene({ phase, chosen, lines }, hidden) {
  if (hidden) return words.ask(vertexName(0, chosen?.from ?? 0));
  const name = chosen ? lineName(chosen) : "";
  const f = chosen ? significantText(chosen.value) : "";
  switch (phase) {
    case "start":
      return words.spoken.start;
    case "growth":
      return words.spoken.growth(name, f, lines.length);
    case "removal":
      return words.spoken.removal(name, f);
    case "end":
      return words.spoken.end(lines.length);
    default: {
      const curve = phase === "first" ? 0 : 1;
      return words.spoken.insert(curve, chosen ? vertexName(1 - curve, curve === 0 ? chosen.to : chosen.from) : "", f);
    }
  }
}

/** What a vertex sees and may have. @param {Vertex} vertex @param {VertexSets} sets */
export function spokenSets({ curve, vertex }, { visible, valid }) {
  const candidates = visible.filter(({ candidate }) => candidate);
  const [best] = candidates;
  const sentence = words.spoken.sets(vertexName(curve, vertex), visible.length, valid.length, candidates.length);
  return best ? `${sentence}, ${words.spoken.best(vertexName(1 - curve, best.vertex), significantText(best.value))}` : sentence;
}

/** The last answer, while its step is shown. @param {Prediction | null} prediction @param {Steps | null} steps @param {number} at the step */
export function spokenAnswer(prediction, steps, at) {
  const line = steps?.growth[at - 1];
  if (!line || prediction?.told?.at !== at) return null;
  const { told, right, tries } = prediction;
  const [guess, q] = [vertexName(1, told.guess), vertexName(1, line.to)];
  const text = told.kind === "right" ? words.right(q) : words.wrong[told.kind](guess, q);
  return `${text} ${words.score(right, tries)}.`;
}
