/**
 * The three axes at the edge of the picture, as they lie to the camera.
 *
 * @import { Camera } from "./camera.js"
 */
import { attribute, svg } from "../dom.js";
import { axesOf } from "./camera.js";

/** CSS pixels: the side of the picture, the length of an axis, and the distance of its name beyond. */
const SIDE = 72;
const LONG = 22;
const NAME = 9;

export function createTriad() {
  const axes = ["x", "y", "z"].map((name) => ({
    line: svg("path", { class: "triad-axis" }),
    text: svg("text", { class: "triad-name", "text-anchor": "middle", "dominant-baseline": "central" }, name),
  }));
  const element = svg(
    "svg",
    { class: "triad", width: SIDE, height: SIDE, viewBox: `${-SIDE / 2} ${-SIDE / 2} ${SIDE} ${SIDE}`, "aria-hidden": "true" },
    ...axes.flatMap(({ line, text }) => [line, text]),
  );
  return {
    element,
    /** @param {Camera} camera */
    render(camera) {
      const { right, up, back } = axesOf(camera);
      axes.forEach(({ line, text }, i) => {
        const [x, y] = [right[i] * LONG, -up[i] * LONG];
        const size = Math.hypot(x, y);
        attribute(line, "d", `M0 0L${x.toFixed(1)} ${y.toFixed(1)}`);
        // An axis that comes straight out of the picture has no room for its name.
        const shown = size > LONG * 0.25;
        attribute(text, "x", (shown ? x + (x / size) * NAME : 0).toFixed(1));
        attribute(text, "y", (shown ? y + (y / size) * NAME : 0).toFixed(1));
        attribute(text, "opacity", shown ? "1" : "0");
        attribute(line, "opacity", back[i] < -0.2 ? "0.55" : "1");
      });
    },
  };
}
