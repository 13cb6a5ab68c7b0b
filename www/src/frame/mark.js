/**
 * The mark: two curves and the ruling lines between them.
 */
import { svg } from "../dom.js";

export function mark() {
  return svg(
    "svg",
    { viewBox: "0 0 20 20", width: 20, height: 20 },
    svg("path", { d: "M5.6 15.1 2.2 13.4M7.3 11 4.4 7.9M10.6 7.6 8.7 3.9", class: "mark-lines" }),
    svg("path", { d: "M2 17.5C2 8.6 8.6 2 17.5 2M10 17.5c0-5 2.5-7.7 7.5-7.7", class: "mark-curves" }),
  );
}
