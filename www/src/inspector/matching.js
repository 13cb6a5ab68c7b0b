/**
 * Matching: the group of the inspector. Its fields are loaded when it is open.
 *
 * @import { App } from "../state/app.js"
 * @import { Group } from "./group.js"
 */
import { editable } from "../format.js";
import { isHarmonic } from "../state/look.js";
import { strings } from "../strings.js";
import { laterGroup } from "./later-group.js";

/**
 * @param {App} app
 * @returns {Group}
 */
export const matchingGroup = (app) =>
  laterGroup(app, {
    name: "matching",
    heading: strings.matching.heading,
    class: "matching",
    phrase() {
      if (isHarmonic(app.store.document)) return strings.blend.unused;
      const { method, normalWeight, distanceWeight } = app.store.document.matching;
      return strings.matching.phrase(method, editable(normalWeight, 1), editable(distanceWeight, 1));
    },
    load: () => import("./matching-fields.js").then(({ createMatchingFields }) => createMatchingFields),
  });
