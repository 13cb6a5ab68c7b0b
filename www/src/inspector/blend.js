/**
 * Blend: the group of the inspector. Its fields are loaded when it is open.
 *
 * @import { App } from "../state/app.js"
 * @import { Group } from "./group.js"
 */
import { strings } from "../strings.js";
import { laterGroup } from "./later-group.js";

/** Whether there are more than two curves: two are blended alike either way. @param {App} app */
export const isStack = (app) => app.store.document.curves.length > 2;

/**
 * @param {App} app
 * @returns {Group}
 */
export const blendGroup = (app) =>
  laterGroup(app, {
    name: "blend",
    heading: strings.blend.heading,
    phrase() {
      const { stages, kind } = app.store.document.blend;
      return strings.blend.phrase(stages, kind !== "ruled" && (kind === "harmonic" || isStack(app)) ? kind : "Oklab");
    },
    load: () => import("./blend-fields.js").then(({ createBlendFields }) => createBlendFields),
  });
