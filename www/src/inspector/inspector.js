/**
 * The inspector: groups one below the other that open and close, or tabs on a phone.
 *
 * @import { App } from "../state/app.js"
 * @import { Group } from "./group.js"
 *
 * @typedef {object} Memory Which groups are open, and which is shown on a phone.
 * @property {() => {open: string[], tab: string}} read
 * @property {(patch: {open?: string[], tab?: string}) => void} write
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
  const groups = [
    curvesGroup(app),
    samplingGroup(app),
    matchingGroup(app),
    blendGroup(app),
    materialsGroup(app),
    layersGroup(app),
  ];
  return createGroups(find("#groups"), strings.sheet.tabs, groups, {
    read: () => app.ui.value,
    write: (patch) => app.ui.set(patch),
  });
}

/**
 * Groups one below the other that open and close, or tabs on a phone.
 * @param {HTMLElement} place
 * @param {string} label of the tabs
 * @param {Group[]} groups
 * @param {Memory} memory
 */
export function createGroups(place, label, groups, memory) {
  const narrow = matchMedia("(width < 600px)");
  const sections = groups.map((group) => createSection(memory, group));
  const tabs = h(
    "div",
    { class: "tabs", role: "tablist", "aria-label": label },
    ...sections.map(({ tab }) => tab),
  );
  tabs.addEventListener("keydown", (event) => {
    const by = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
    if (by === undefined) return;
    const here = sections.findIndex(({ name }) => name === memory.read().tab);
    const next = sections[(here + by + sections.length) % sections.length];
    if (!next) return;
    memory.write({ tab: next.name });
    next.tab.focus();
  });
  place.append(tabs, ...sections.map(({ element }) => element));

  return {
    render() {
      const { open, tab } = memory.read();
      for (const section of sections) section.render(narrow.matches, open, tab);
    },
  };
}

/**
 * @param {Memory} memory
 * @param {Group} group
 */
function createSection(memory, group) {
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
    const { open } = memory.read();
    memory.write({ open: open.includes(name) ? open.filter((other) => other !== name) : [...open, name] });
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
  tab.addEventListener("click", () => memory.write({ tab: name }));

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
