/**
 * What follows when the reader changes a figure: it is drawn coarsely while more is about to come, and finely once that rests.
 *
 * @import { Host } from "./figure.js"
 */

/** Milliseconds after a change until the picture is fine again. */
const IDLE = 200;

/** @param {Pick<Host, "element" | "touched">} host @param {() => void} paint */
export function createChanging(host, paint) {
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let timer;
  const changing = {
    isMoving: false,
    /** Something is different. @param {boolean} isDrag whether more of it is about to come */
    touch(isDrag) {
      changing.stop();
      changing.isMoving = isDrag;
      host.touched();
      delete host.element.dataset.drawn;
      if (isDrag) timer = setTimeout(changing.rest, IDLE);
      paint();
    },
    rest() {
      if (!changing.isMoving) return;
      changing.isMoving = false;
      paint();
    },
    stop() {
      changing.isMoving = false;
      clearTimeout(timer);
    },
  };
  return changing;
}
