/**
 * A menu below a button: arrows go through it, Escape closes it and gives the focus back.
 */
import { attribute, find, h } from "../dom.js";
import { keyName } from "./key-names.js";

/**
 * @typedef {object} Item
 * @property {string} text
 * @property {string} [line] a second line
 * @property {Node} [lead] what stands before the text
 * @property {string} [keys] that do the same, such as `Ctrl+Shift+S`
 * @property {string} name for the data attribute
 * @property {() => void} act
 */

/** @type {(() => void) | null} */
let closeOpen = null;

/**
 * @param {HTMLButtonElement} button
 * @param {() => (Item | "line")[] | Promise<(Item | "line")[]>} items asked for each time the menu opens
 * @param {{wide?: boolean}} [options]
 */
export function attachMenu(button, items, { wide = false } = {}) {
  const menu = h("div", { class: wide ? "menu wide" : "menu", role: "menu", "aria-label": button.textContent ?? "" });
  menu.dataset.furniture = "";
  button.setAttribute("aria-haspopup", "menu");
  button.setAttribute("aria-expanded", "false");

  async function open() {
    closeOpen?.();
    const list = await items();
    menu.replaceChildren(...list.map((item) => (item === "line" ? h("div", { role: "separator" }) : entry(item))));
    find("#bar").append(menu);
    place(menu, button);
    attribute(button, "aria-expanded", "true");
    closeOpen = close;
    addEventListener("pointerdown", outside, { capture: true });
    addEventListener("resize", close);
    choices()[0]?.focus();
  }

  function close() {
    if (!menu.isConnected) return;
    const held = menu.contains(document.activeElement);
    menu.remove();
    attribute(button, "aria-expanded", "false");
    closeOpen = null;
    removeEventListener("pointerdown", outside, { capture: true });
    removeEventListener("resize", close);
    if (held) button.focus();
  }

  /** @param {PointerEvent} event */
  function outside(event) {
    if (event.target instanceof Node && !menu.contains(event.target) && !button.contains(event.target)) close();
  }

  /** @param {Item} item */
  function entry(item) {
    return h(
      "button",
      {
        type: "button",
        role: "menuitem",
        tabIndex: -1,
        "data-item": item.name,
        "aria-keyshortcuts": item.keys?.replace("Ctrl", "Control"),
        onclick: () => {
          close();
          item.act();
        },
      },
      item.lead,
      h(
        "span",
        { class: "menu-text" },
        h("span", {}, item.text),
        item.line ? h("span", { class: "menu-line" }, item.line) : null,
      ),
      item.keys ? h("span", { class: "menu-keys", "aria-hidden": "true" }, keyName(item.keys)) : null,
    );
  }

  const choices = () => /** @type {HTMLElement[]} */ ([...menu.querySelectorAll("[role=menuitem]")]);

  button.addEventListener("click", () => (menu.isConnected ? close() : void open()));
  button.addEventListener("keydown", (event) => {
    if (event.key !== "ArrowDown" || menu.isConnected) return;
    event.preventDefault();
    void open();
  });
  menu.addEventListener("keydown", (event) => {
    const list = choices();
    const here = list.findIndex((item) => item === document.activeElement);
    const target = {
      ArrowDown: (here + 1) % list.length,
      ArrowUp: (here + list.length - 1) % list.length,
      Home: 0,
      End: list.length - 1,
    }[event.key];
    if (target !== undefined) list[target]?.focus();
    else if (event.key === "Escape" || event.key === "Tab") close();
    else return;
    event.stopPropagation();
    if (event.key !== "Tab") event.preventDefault();
  });
}

/** @param {HTMLElement} menu @param {HTMLElement} button */
function place(menu, button) {
  const box = button.getBoundingClientRect();
  const left = Math.min(box.left, innerWidth - menu.offsetWidth - 8);
  menu.style.left = `${Math.max(8, left)}px`;
  menu.style.top = `${box.bottom + 6}px`;
}
