/**
 * The inspector on small screens: over the canvas below 900 px, a sheet with three stops below 600 px.
 */
import { attribute, find, h } from "../dom.js";
import { strings } from "../strings.js";

const STOPS = /** @type {const} */ (["low", "half", "full"]);
/** @typedef {(typeof STOPS)[number]} Stop */

/** Heights of the stops as the style sheets have them: a bar, a part of the window, all but the bar above; of a low window others. */
const HIGH_WINDOW = { low: 88, half: 0.487, top: 60 };
const LOW_WINDOW = { low: 44, half: 0.64, top: 44 };

/** @param {HTMLButtonElement} panelButton */
export function createSheet(panelButton) {
  const root = document.documentElement;
  const inspector = find("#inspector");
  const status = find("#status");
  const narrow = matchMedia("(width < 600px)");
  const flat = matchMedia("(height < 480px)");
  const grip = h(
    "button",
    { type: "button", class: "grip", "aria-label": strings.sheet.resize, "data-grip": "" },
    h("span", {}),
  );
  inspector.prepend(grip);
  /** @type {Stop} */
  let stop = "half";

  /** @param {Stop} next */
  function rest(next) {
    stop = next;
    root.dataset.sheet = next;
    root.style.removeProperty("--sheet");
    attribute(grip, "aria-expanded", String(next !== "low"));
  }
  rest(flat.matches ? "low" : "half");

  const measures = () => (flat.matches ? LOW_WINDOW : HIGH_WINDOW);
  /** @param {Stop} at */
  const height = (at) => {
    const { low, half, top } = measures();
    return { low, half: innerHeight * half, full: innerHeight - top }[at];
  };

  // What has the focus is never below the sheet, nor in the part of it that a low stop cuts off. What a finger focuses is in sight, and must
  // not move from under it.
  find("#stage").addEventListener("focusin", ({ target }) => {
    if (!narrow.matches || !(target instanceof Element) || !target.matches(":focus-visible")) return;
    const { bottom } = target.getBoundingClientRect();
    const clear = [...STOPS].reverse().find((at) => at === "low" || bottom <= innerHeight - height(at));
    if (clear && STOPS.indexOf(clear) < STOPS.indexOf(stop)) rest(clear);
  });
  inspector.addEventListener("focusin", ({ target }) => {
    if (narrow.matches && stop === "low" && target !== grip && target instanceof Element && target.matches(":focus-visible")) rest("half");
  });

  grip.addEventListener("click", () => {
    if (moved) return;
    rest(stop === "low" ? "half" : stop === "half" ? "full" : "low");
  });
  grip.addEventListener("keydown", (event) => {
    const by = { ArrowUp: 1, ArrowDown: -1 }[event.key];
    const next = by === undefined ? undefined : STOPS[STOPS.indexOf(stop) + by];
    if (next) rest(next);
  });

  // A tab that is touched while the sheet is down shows its group.
  find("#groups").addEventListener("click", (event) => {
    if (stop === "low" && event.target instanceof Element && event.target.closest("[role=tab]")) rest("half");
  });

  let moved = false;
  grip.addEventListener("pointerdown", (down) => {
    moved = false;
    const start = inspector.offsetHeight;
    grip.setPointerCapture(down.pointerId);
    const over = new AbortController();
    /** @param {PointerEvent} event */
    const drag = (event) => {
      const by = down.clientY - event.clientY;
      if (!moved && Math.abs(by) < 4) return;
      moved = true;
      const now = Math.min(height("full"), Math.max(height("low"), start + by));
      root.style.setProperty("--sheet", `${now}px`);
    };
    const up = () => {
      over.abort();
      if (!moved) return;
      const now = inspector.offsetHeight;
      const [nearest = "half"] = [...STOPS].sort((a, b) => Math.abs(height(a) - now) - Math.abs(height(b) - now));
      rest(nearest);
    };
    grip.addEventListener("pointermove", drag, { signal: over.signal });
    grip.addEventListener("pointerup", up, { signal: over.signal });
    grip.addEventListener("pointercancel", up, { signal: over.signal });
  });

  /** @param {boolean} open */
  function showPanel(open) {
    root.classList.toggle("panel-open", open);
    attribute(panelButton, "aria-expanded", String(open));
  }
  panelButton.addEventListener("click", () => showPanel(!root.classList.contains("panel-open")));
  inspector.addEventListener("keydown", (event) => {
    if (event.key !== "Escape" || !root.classList.contains("panel-open")) return;
    showPanel(false);
    panelButton.focus();
  });

  /** The status line stands in the sheet on a phone, below everything elsewhere. */
  function settle() {
    if (narrow.matches) grip.after(status);
    else inspector.after(status);
  }
  settle();
  narrow.addEventListener("change", settle);
}
