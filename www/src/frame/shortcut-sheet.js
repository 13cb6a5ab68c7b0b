/**
 * The sheet of all keys, by topic, from the table of commands.
 */
import { COMMANDS, shownKey } from "../commands.js";
import { h } from "../dom.js";
import { strings } from "../strings.js";
import { openPanel } from "./panel.js";

export function openShortcuts() {
  const topics = /** @type {(keyof typeof strings.topics)[]} */ (Object.keys(strings.topics));
  const body = topics.map((topic) =>
    h(
      "section",
      { class: "keys-topic" },
      h("h3", {}, strings.topics[topic]),
      h(
        "dl",
        {},
        ...COMMANDS.filter((command) => command.topic === topic && command.keys).map((command) =>
          h(
            "div",
            { class: "keys-row", "data-keys": command.name },
            h("dt", {}, command.sheet ?? (typeof command.text === "string" ? command.text : "")),
            h("dd", {}, ...keysOf(command.keys ?? [])),
          ),
        ),
      ),
    ),
  );
  openPanel({
    name: "shortcuts",
    heading: strings.commands.shortcuts,
    body: [h("div", { class: "keys", tabIndex: 0, role: "group", "aria-label": strings.commands.shortcuts }, ...body)],
    wide: true,
  });
}

/** @param {string[]} keys */
const keysOf = (keys) => keys.flatMap((key, i) => [...(i > 0 ? [" "] : []), h("kbd", {}, shownKey(key))]);
