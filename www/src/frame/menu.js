/**
 * A menu below a button or at a place of the screen: arrows go through it, Escape closes it and gives the focus back.
 */
import { attribute, find, h } from "../dom.js";
import { icon } from "../icons.js";
import { keyName } from "./key-names.js";

/**
 * @typedef {object} Item
 * @property {string} text
 * @property {string} [line] a second line
 * @property {Node} [lead] what stands before the text
 * @property {string} [keys] that do the same, such as `Ctrl+Shift+S`
 * @property {string} name for the data attribute
 * @property {boolean} [checked] for what is switched on and off
 * @property {boolean} [disabled] shown, but not to be had; the second line says why
 * @property {() => void} act
 *
 * @typedef {object} Place
 * @property {string} label
 * @property {{left: number, top: number, bottom: number}} box where the menu goes: below, or above where there is no room
 * @property {HTMLElement | null} [button] that opened it
 * @property {boolean} [wide]
 */

/** @type {(() => void) | null} */
let closeOpen = null;

/** Closes the menu that is open, if one is. */
export const closeMenu = () => closeOpen?.();

/**
 * Opens a menu in place of any other.
 * @param {(Item | "line")[]} items
 * @param {Place} place
 */
export function openMenu(items, { label, box, button = null, wide = false }) {
  closeOpen?.();
  const before = button ?? document.activeElement;
  const menu = h("div", { class: wide ? "menu wide" : "menu", role: "menu", "aria-label": label });
  menu.dataset.furniture = "";
  menu.replaceChildren(...items.map((item) => (item === "line" ? h("div", { role: "separator" }) : entry(item))));
  find("#bar").append(menu);
  settle(menu, box);
  if (button) attribute(button, "aria-expanded", "true");
  closeOpen = close;
  addEventListener("pointerdown", outside, { capture: true });
  addEventListener("resize", close);
  const choices = /** @type {HTMLElement[]} */ ([...menu.querySelectorAll("[role^=menuitem]")]);
  choices[0]?.focus();

  function close() {
    if (!menu.isConnected) return;
    const held = menu.contains(document.activeElement);
    menu.remove();
    if (button) attribute(button, "aria-expanded", "false");
    closeOpen = null;
    removeEventListener("pointerdown", outside, { capture: true });
    removeEventListener("resize", close);
    if (held && before instanceof Element) /** @type {HTMLElement} */ (before).focus({ preventScroll: true });
  }

  /** @param {PointerEvent} event */
  function outside(event) {
    if (event.target instanceof Node && !menu.contains(event.target) && !button?.contains(event.target)) close();
  }

  /** @param {Item} item */
  function entry(item) {
    return h(
      "button",
      {
        type: "button",
        role: item.checked === undefined ? "menuitem" : "menuitemcheckbox",
        tabIndex: -1,
        "data-item": item.name,
        "aria-keyshortcuts": item.keys?.replace("Ctrl", "Control"),
        "aria-checked": item.checked === undefined ? undefined : String(item.checked),
        "aria-disabled": item.disabled ? "true" : undefined,
        onclick: () => {
          if (item.disabled) return;
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
      item.checked ? /** @type {any} */ (icon("check", 14)) : null,
    );
  }

  menu.addEventListener("keydown", (event) => {
    const here = choices.findIndex((item) => item === document.activeElement);
    const target = {
      ArrowDown: (here + 1) % choices.length,
      ArrowUp: (here + choices.length - 1) % choices.length,
      Home: 0,
      End: choices.length - 1,
    }[event.key];
    if (target !== undefined) choices[target]?.focus();
    else if (event.key === "Escape" || event.key === "Tab") close();
    else return;
    event.stopPropagation();
    if (event.key !== "Tab") event.preventDefault();
  });
}

/**
 * @param {HTMLElement} menu
 * @param {Place["box"]} box
 */
function settle(menu, box) {
  const left = Math.min(box.left, innerWidth - menu.offsetWidth - 8);
  const below = box.bottom + 6;
  const fits = below + menu.offsetHeight <= innerHeight - 8;
  const top = fits ? below : Math.max(8, Math.min(box.top - 6, innerHeight - 8) - menu.offsetHeight);
  menu.style.left = `${Math.max(8, left)}px`;
  menu.style.top = `${top}px`;
}
