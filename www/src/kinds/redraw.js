/**
 * Draws in the next frame of the screen, once, however often it is asked for.
 *
 * @param {() => void} draw
 * @returns {{request: () => void, close: () => void}} nothing is drawn after `close`
 */
export function createRedraw(draw) {
  let frame = 0;
  let isOver = false;
  return {
    request() {
      if (frame !== 0 || isOver) return;
      frame = requestAnimationFrame(() => {
        frame = 0;
        draw();
      });
    },
    close() {
      isOver = true;
      cancelAnimationFrame(frame);
    },
  };
}
