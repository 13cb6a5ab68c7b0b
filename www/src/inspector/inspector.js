/**
 * The inspector: groups one below the other that open and close, or tabs on a phone.
 *
 * @import { App } from "../state/app.js"
 * @import { Group } from "./group.js"
 */
import { attribute, find, h, write } from "../dom.js";
import { icon } from "../icons.js";
import { strings } from "../strings.js";
import { blendGroup } from "./blend.js";
import { curvesGroup } from "./curves.js";
import { layersGroup } from "./layers.js";
import { matchingGroup } from "./matching.js";
import { materialsGroup } from "./materials.js";
import { samplingGroup } from "./sampling.js";

/** Groups that are open at first. */
export const FIRST_OPEN = ["curves", "matching", "materials", "layers"];

/** @param {App} app */
export function createInspector(app) {
  const narrow = matchMedia("(width < 600px)");
  const sections = [
    curvesGroup(app),
    samplingGroup(app),
    matchingGroup(app),
    blendGroup(app),
    materialsGroup(app),
    layersGroup(app),
  ].map((group) => createSection(app, group));
  const tabs = h(
    "div",
    { class: "tabs", role: "tablist", "aria-label": strings.sheet.tabs },
    ...sections.map(({ tab }) => tab),
  );
  tabs.addEventListener("keydown", (event) => {
    const by = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
    if (by === undefined) return;
    const here = sections.findIndex(({ name }) => name === app.ui.value.tab);
    const next = sections[(here + by + sections.length) % sections.length];
    if (!next) return;
    app.ui.set({ tab: next.name });
    next.tab.focus();
  });
  find("#groups").append(tabs, ...sections.map(({ element }) => element));

  return {
    render() {
      const { open, tab } = app.ui.value;
      for (const section of sections) section.render(narrow.matches, open, tab);
    },
  };
}

/**
 * @param {App} app
 * @param {Group} group
 */
function createSection(app, group) {
  const { name, heading, body, phrase, render, commands = [] } = group;
  const down = icon("down");
  const aside = h("span", { class: "aside number" });
  const button = h(
    "button",
    { type: "button", "aria-controls": `group-${name}`, "data-group-button": name },
    /** @type {any} */ (down),
    h("span", {}, heading),
    aside,
  );
  button.addEventListener("click", () => {
    const { open } = app.ui.value;
    app.ui.set({ open: open.includes(name) ? open.filter((other) => other !== name) : [...open, name] });
  });
  body.id = `group-${name}`;
  body.classList.add("group-body");
  const element = h(
    "section",
    { class: "group", "data-group": name },
    h("div", { class: "group-head" }, h("h2", {}, button), ...commands),
    body,
  );
  const tab = h(
    "button",
    { type: "button", role: "tab", id: `tab-${name}`, "aria-controls": `group-${name}`, "data-tab": name },
    heading,
  );
  tab.addEventListener("click", () => app.ui.set({ tab: name }));

  return {
    name,
    element,
    tab,
    /** @param {boolean} narrow @param {string[]} open @param {string} chosen */
    render(narrow, open, chosen) {
      const shown = narrow ? chosen === name : open.includes(name);
      attribute(button, "aria-expanded", String(open.includes(name)));
      attribute(tab, "aria-selected", String(chosen === name));
      tab.tabIndex = chosen === name ? 0 : -1;
      attribute(body, "role", narrow ? "tabpanel" : null);
      attribute(body, "aria-labelledby", narrow ? tab.id : null);
      element.hidden = narrow && !shown;
      body.hidden = !shown;
      element.classList.toggle("closed", !shown);
      for (const command of commands) command.hidden = !shown;
      write(aside, shown ? "" : phrase());
      if (shown) render();
    },
  };
}
