/**
 * Sampling: the group of the inspector. Its fields are loaded when it is open.
 *
 * @import { App } from "../state/app.js"
 * @import { Group } from "./group.js"
 */
import { isHarmonic } from "../state/look.js";
import { strings } from "../strings.js";
import { laterGroup } from "./later-group.js";

/**
 * Numbers of samples: as asked for, or as many as the shapes took.
 * @param {App} app
 */
export function numbersTaken(app) {
  const { sampling } = app.store.document;
  const { match } = app.results.value;
  if (sampling.scheme !== "adaptive") return sampling.counts;
  return sampling.counts.map((_, k) => match?.samples[k]?.parameters.length ?? 0);
}

/**
 * @param {App} app
 * @returns {Group}
 */
export const samplingGroup = (app) =>
  laterGroup(app, {
    name: "sampling",
    heading: strings.sampling.heading,
    phrase: () => isHarmonic(app.store.document) ? strings.blend.unused : strings.sampling.phrase(app.store.document.sampling.scheme.replace("-", " "), numbersTaken(app)),
    load: () => import("./sampling-fields.js").then(({ createSamplingFields }) => createSamplingFields),
  });
