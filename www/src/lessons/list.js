/** The list of lessons, with the steps of the one that is open. */
import { h } from "../dom.js";
import { heads } from "./library.js";
import { linkTo } from "./place.js";
import { words } from "./words.js";

export function createList() {
  const body = h("div", { class: "lesson-groups", id: "lesson-groups" });
  const toggle = h(
    "button",
    { type: "button", class: "bare word lesson-contents", "aria-expanded": "false", "aria-controls": "lesson-groups", onclick: () => open(toggle.getAttribute("aria-expanded") !== "true") },
    words.contents,
  );
  const element = h("nav", { class: "lesson-list", "aria-label": words.list }, toggle, body);

  /** On a phone the list is shown on demand. @param {boolean} isOpen */
  function open(isOpen) {
    toggle.setAttribute("aria-expanded", String(isOpen));
    element.classList.toggle("open", isOpen);
  }

  return {
    element,
    /** @param {string | null} lesson @param {number} step */
    render(lesson, step) {
      open(false);
      const groups = [...new Set(heads.map(({ group }) => group))];
      body.replaceChildren(
        ...groups.flatMap((group) => [
          h("h2", {}, group),
          h(
            "ol",
            {},
            ...heads.flatMap((head, k) => {
              if (head.group !== group) return [];
              const isOpen = head.name === lesson;
              return [
                h(
                  "li",
                  {},
                  h("a", { href: linkTo(head.name, 1), class: isOpen ? "open" : "", title: head.summary }, h("span", { class: "number" }, String(k + 1)), h("span", {}, head.title)),
                  isOpen ? h("ol", { "aria-label": words.steps }, ...head.steps.map((title, i) => stepLink(head.name, title, i + 1, step))) : null,
                ),
              ];
            }),
          ),
        ]),
      );
    },
  };
}

/** @param {string} lesson @param {string} title @param {number} step @param {number} current */
function stepLink(lesson, title, step, current) {
  const link = h("a", { href: linkTo(lesson, step) }, title);
  if (step === current) link.setAttribute("aria-current", "page");
  return h("li", {}, link);
}
