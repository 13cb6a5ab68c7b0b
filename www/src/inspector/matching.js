/**
 * Matching: the group of the inspector. Its fields are loaded when it is open.
 *
 * @import { App } from "../state/app.js"
 * @import { Group } from "./group.js"
 */
import { h } from "../dom.js";
import { editable } from "../format.js";
import { later } from "../later.js";
import { strings } from "../strings.js";

/**
 * @param {App} app
 * @returns {Group}
 */
export function matchingGroup(app) {
  const words = strings.matching;
  const body = h("div", { class: "matching" });
  const fields = later(
    app,
    () => true,
    async () => {
      const { createMatchingFields } = await import("./matching-fields.js");
      return () => {
        const part = createMatchingFields(app);
        body.append(part.element);
        return part;
      };
    },
  );
  return {
    name: "matching",
    heading: words.heading,
    body,
    phrase() {
      const { method, normalWeight, distanceWeight } = app.store.document.matching;
      return words.phrase(method, editable(normalWeight, 1), editable(distanceWeight, 1));
    },
    render: () => fields.render(),
  };
}
