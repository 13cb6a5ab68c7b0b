/**
 * Moments in words: how long ago while that is easy to grasp, else the day.
 */

const MINUTE = 60_000;
const HOUR = 60 * MINUTE;
const DAY = 24 * HOUR;
const WEEK = 7 * DAY;

const ago = new Intl.RelativeTimeFormat("en", { numeric: "auto" });
const day = new Intl.DateTimeFormat("en-GB", { dateStyle: "medium" });
const clock = new Intl.DateTimeFormat("en-GB", { dateStyle: "medium", timeStyle: "short" });

/**
 * @param {number} time in milliseconds of the epoch
 * @param {number} now
 */
export function when(time, now) {
  const passed = now - time;
  if (passed < MINUTE) return "just now";
  if (passed < HOUR) return ago.format(-Math.floor(passed / MINUTE), "minute");
  if (passed < DAY) return ago.format(-Math.floor(passed / HOUR), "hour");
  if (passed < WEEK) return ago.format(-Math.floor(passed / DAY), "day");
  return day.format(time);
}

/** The day and the time of day. @param {number} time in milliseconds of the epoch */
export function moment(time) {
  return clock.format(time);
}
