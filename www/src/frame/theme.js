/**
 * Light and dark: the system decides, the button overrides, and choosing what the system says lifts the override.
 *
 * @import { App } from "../state/app.js"
 */
const KEY = "directrix-theme";
const system = matchMedia("(prefers-color-scheme: dark)");

/** @returns {"light" | "dark"} */
export function currentTheme() {
  const chosen = document.documentElement.dataset.theme;
  if (chosen === "light" || chosen === "dark") return chosen;
  return system.matches ? "dark" : "light";
}

/** @param {App} app */
export function toggleTheme(app) {
  const next = currentTheme() === "dark" ? "light" : "dark";
  const own = (next === "dark") !== system.matches;
  if (own) document.documentElement.dataset.theme = next;
  else delete document.documentElement.dataset.theme;
  try {
    if (own) localStorage.setItem(KEY, next);
    else localStorage.removeItem(KEY);
  } catch {
    // Storage may be closed to the page; the choice then lasts until it is left.
  }
  app.ui.set({ theme: next });
}

/** @param {App} app */
export function followSystem(app) {
  system.addEventListener("change", () => app.ui.set({ theme: currentTheme() }));
}
