/**
 * A button that opens a menu below it; the menu itself is fetched with the first press.
 *
 * @import { Item } from "./menu.js"
 */

/**
 * @param {HTMLButtonElement} button
 * @param {() => (Item | "line")[] | Promise<(Item | "line")[]>} items asked for each time the menu opens
 * @param {{wide?: boolean}} [options]
 */
export function attachMenu(button, items, { wide = false } = {}) {
  button.setAttribute("aria-haspopup", "menu");
  button.setAttribute("aria-expanded", "false");
  const label = button.textContent || (button.getAttribute("aria-label") ?? "");
  const isOpen = () => button.getAttribute("aria-expanded") === "true";
  async function toggle() {
    const closing = isOpen();
    const { closeMenu, openMenu } = await import("./menu.js");
    if (closing) closeMenu();
    else openMenu(await items(), { label, box: button.getBoundingClientRect(), button, wide });
  }
  button.addEventListener("click", () => void toggle());
  button.addEventListener("keydown", (event) => {
    if (event.key !== "ArrowDown" || isOpen()) return;
    event.preventDefault();
    void toggle();
  });
}
