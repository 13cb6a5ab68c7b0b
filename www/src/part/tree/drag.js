/**
 * Dragging a feature to another place of the list: a line shows where it would go; Escape takes it back.
 *
 * @import { At } from "../edits/features.js"
 * @import { Row } from "./rows.js"
 */
import { whileHeld } from "../../controls/held.js";
import { h } from "../../dom.js";

/** CSS pixels before a press is a drag. */
const DEAD = 4;

/**
 * @param {HTMLElement} list
 * @param {object} what
 * @param {() => readonly Row[]} what.rows
 * @param {(key: string) => HTMLElement | null} what.elementOf
 * @param {(from: At, to: At) => void} what.put
 */
export function createDrag(list, { rows, elementOf, put }) {
  const line = h("div", { class: "tree-place", hidden: true, "aria-hidden": "true" });
  list.after(line);
  /** @type {(() => void) | null} */
  let giveUp = null;
  /** Whether the click that comes now ends a drag. */
  let isClick = false;

  /** Where a feature would go that is let go at a height. @param {Row} row @param {number} y */
  function placeAt(row, y) {
    const ends = rows().flatMap((other) => {
      const element = other.kind === "default" || other.kind === "feature" ? elementOf(other.key) : null;
      return element ? [{ other, y: element.getBoundingClientRect().bottom }] : [];
    });
    if (ends.length === 0) return null;
    const best = ends.reduce((a, b) => (Math.abs(b.y - y) < Math.abs(a.y - y) ? b : a));
    const place = best.other.feature + 1;
    const isOwn = best.other.body === row.body;
    return { y: best.y, to: { body: best.other.body, feature: isOwn && place > row.feature ? place - 1 : place } };
  }

  return {
    /** @param {PointerEvent} down @param {Row} row */
    begin(down, row) {
      let isMoving = false;
      let isOff = false;
      /** @type {ReturnType<typeof placeAt>} */
      let place = null;
      const element = elementOf(row.key);
      const show = () => {
        line.hidden = !isMoving || !place;
        element?.classList.toggle("carried", isMoving);
        if (!place) return;
        const frame = /** @type {HTMLElement} */ (line.offsetParent ?? list).getBoundingClientRect();
        line.style.top = `${place.y - frame.top + (line.offsetParent?.scrollTop ?? 0)}px`;
      };
      giveUp = () => {
        isOff = true;
        isMoving = false;
        show();
      };
      whileHeld({
        move(event) {
          if (isOff || event.pointerId !== down.pointerId) return;
          if (!isMoving && Math.abs(event.clientY - down.clientY) < DEAD) return;
          isMoving = true;
          place = placeAt(row, event.clientY);
          show();
        },
        finish(undo) {
          const wasMoving = isMoving && !isOff;
          isMoving = false;
          show();
          giveUp = null;
          if (!wasMoving) return;
          isClick = true;
          setTimeout(() => (isClick = false));
          if (!undo && place) put(row, place.to);
        },
      });
    },
    /** Gives a drag up, if one is under way. */
    cancel: () => giveUp?.(),
    /** Whether a click that comes now ends a drag, and chooses nothing. */
    ends: () => isClick,
  };
}
