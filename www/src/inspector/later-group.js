/**
 * A group of the inspector whose fields are loaded when it is first open.
 *
 * @import { App } from "../state/app.js"
 * @import { Group } from "./group.js"
 */
import { h } from "../dom.js";
import { later } from "../later.js";

/**
 * @param {App} app
 * @param {Pick<Group, "name" | "heading" | "phrase"> & { load: () => Promise<(app: App) => {element: HTMLElement, render: () => void}>, class?: string }} group
 * @returns {Group}
 */
export function laterGroup(app, { name, heading, phrase, load, class: kind = "" }) {
  const body = h("div", { class: kind });
  const fields = later(app, () => true, async () => {
    const create = await load();
    return () => {
      const part = create(app);
      body.append(part.element);
      return part;
    };
  });
  return { name, heading, body, phrase, render: () => fields.render() };
}
