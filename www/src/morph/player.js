/**
 * Plays the morph: moves the place between the curves with the time, as the motion says.
 *
 * @import { App } from "../state/app.js"
 */
import { eased, shareAt } from "./motion.js";

/** Longest step of the time in milliseconds: a page that was in the background goes on where it was. */
const LONGEST_STEP = 100;

let runs = false;

/** Plays until `ui.playing` ends, or ends it where the motion does. @param {App} app */
export function play(app) {
  if (runs) return;
  runs = true;
  let before = performance.now();
  let direction = 1;
  const { s, motion } = app.ui.value;
  if (s >= 1 && motion.repeat !== "swing") app.ui.set({ s: 0 });

  /** @param {number} now */
  function frame(now) {
    const { playing, s: here, motion: { seconds, easing, repeat } } = app.ui.value;
    if (!playing || app.store.document.curves.length < 2) {
      runs = false;
      if (playing) app.ui.set({ playing: false });
      return;
    }
    const elapsed = Math.max(0, Math.min(LONGEST_STEP, now - before)) / 1000;
    before = now;
    if (repeat !== "swing") direction = 1;
    let share = shareAt(easing, here) + (direction * elapsed) / seconds;
    if (share >= 1 && repeat === "once") {
      runs = false;
      app.ui.set({ s: 1, playing: false });
      return;
    }
    if (repeat === "loop") share %= 1;
    else if (share >= 1) [share, direction] = [1, -1];
    else if (share <= 0) [share, direction] = [0, 1];
    app.ui.set({ s: eased(easing, share) });
    requestAnimationFrame(frame);
  }
  requestAnimationFrame(frame);
}
