/**
 * The sheet of all keys, by topic, from the table of commands.
 */
import { COMMANDS, shownKey } from "../commands.js";
import { h } from "../dom.js";
import { strings } from "../strings.js";
import { MODE_KEYS } from "./mode-keys.js";
import { openPanel } from "./panel.js";
import { TOPICS } from "./shortcut-words.js";

export function openShortcuts() {
  const body = [
    ...Object.entries(TOPICS).map(([topic, heading]) =>
      section(
        heading,
        COMMANDS.filter((command) => command.topic === topic && command.keys).map(({ name, text, sheet, keys = [] }) =>
          entry(sheet ?? (typeof text === "string" ? text : ""), keys, name),
        ),
      ),
    ),
    ...MODE_KEYS.map(({ heading, rows }) =>
      section(
        heading,
        rows.map(({ text, keys }) => entry(text, keys)),
      ),
    ),
  ];
  openPanel({
    name: "shortcuts",
    heading: strings.commands.shortcuts,
    body: [h("div", { class: "keys", tabIndex: 0, role: "group", "aria-label": strings.commands.shortcuts }, ...body)],
    wide: true,
  });
}

/** @param {string} heading @param {HTMLElement[]} entries */
const section = (heading, entries) =>
  h("section", { class: "keys-topic" }, h("h3", {}, heading), h("dl", {}, ...entries));

/** @param {string} text @param {string[]} keys @param {string} [name] of the command */
const entry = (text, keys, name) =>
  h("div", { class: "keys-row", "data-keys": name }, h("dt", {}, text), h("dd", {}, ...keysOf(keys)));

/** @param {string[]} keys */
const keysOf = (keys) => keys.flatMap((key, i) => [...(i > 0 ? [" "] : []), h("kbd", {}, shownKey(key))]);
