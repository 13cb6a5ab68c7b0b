/**
 * A press that is held: moves are heard on the whole page until it is let go, or Escape takes it back.
 *
 * @param {object} what
 * @param {(event: PointerEvent) => void} what.move
 * @param {(undo: boolean) => void} what.finish called once; `undo` when the browser took the pointer away or Escape was pressed
 */
export function whileHeld({ move, finish }) {
  const over = new AbortController();
  const { signal } = over;
  /** @param {boolean} undo */
  const end = (undo) => {
    over.abort();
    finish(undo);
  };
  addEventListener("pointermove", move, { signal });
  addEventListener("pointerup", () => end(false), { signal });
  addEventListener("pointercancel", () => end(true), { signal });
  addEventListener(
    "keydown",
    (event) => {
      if (event.key !== "Escape") return;
      event.stopPropagation();
      end(true);
    },
    { signal, capture: true },
  );
}
