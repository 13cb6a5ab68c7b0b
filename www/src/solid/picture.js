/**
 * The solid as a picture for elsewhere, at a size of its own: in a space that is made for it and given back.
 *
 * @import { App } from "../state/app.js"
 * @import { Size } from "../types.js"
 * @import { Whole } from "./state.js"
 */
import { axesOf, eyeOf, fitted, STANDARD } from "../space/camera.js";
import { sectionPlane } from "../space/section.js";
import { Space } from "../space/space.js";
import { triples } from "../space/vector.js";
import { Body } from "./body.js";
import { levelsOf, solidUi, stagesAmong, upToPlane } from "./state.js";
import { words } from "./words.js";

/** Background of the page by theme. */
const CANVAS = { light: "#ffffff", dark: "#0e0f12" };
/** CSS pixels of a picture that has no screen to be like. */
const LIKE = 900;

/**
 * PNG of the solid from where it was last seen, with what is shown of it there.
 * @param {App} app
 * @param {Whole} solid
 * @param {Size & {theme: "light" | "dark", transparent: boolean}} wanted in pixels
 * @returns {Promise<Blob>}
 */
export async function solidPicture(app, solid, { width, height, theme, transparent }) {
  const shown = solidUi(app);
  const { document, origin } = app.store;
  const canvas = globalThis.document.createElement("canvas");
  const space = new Space({ canvas });
  const body = new Body(space);
  try {
    // Lines are as wide against the body as on the screen.
    const ratio = Math.max(width, height) / Math.max(1, Math.min(LIKE, Math.max(app.ui.value.size.width, app.ui.value.size.height) || LIKE));
    const frame = { size: { width: width / ratio, height: height / ratio }, top: 0, bottom: 0 };
    space.frame = frame;
    const points = solid.curves.flatMap(triples);
    const { seen } = shown;
    space.camera = seen?.of === origin.name ? seen.camera : fitted(STANDARD.iso, frame, points);
    const isClosed = document.curves.every(({ form }) => form !== "open");
    body.set(solid, isClosed, stagesAmong(document, solid.stages));
    const section = sectionPlane(shown.section, solid.positions, axesOf(space.camera).back)?.plane ?? null;
    const upTo = upToPlane(levelsOf(solid), shown.upTo);
    body.cut({ upTo, section }, shown.layers);
    const { min, max } = solid.bounds;
    const room = Math.max(max[0] - min[0], max[1] - min[1]) * 0.4;
    space.holds({ min: [min[0] - room, min[1] - room, min[2] - room], max: [max[0] + room, max[1] + room, max[2] + room] });
    space.ondraw = () => {
      body.look(shown, theme, space);
      body.stand(eyeOf(space.camera)[2] > min[2], upTo !== null || section !== null);
    };
    // The renderer rounds down what it is given.
    space.resize(frame, ratio * (1 + 1e-9));
    if (space.drawn.width !== width || space.drawn.height !== height) throw new Error(words.exports.tooLarge);
    const flat = new OffscreenCanvas(width, height);
    const context = flat.getContext("2d");
    if (!context) throw new Error(words.exports.noPicture);
    if (!transparent) {
      context.fillStyle = CANVAS[theme];
      context.fillRect(0, 0, width, height);
    }
    context.drawImage(canvas, 0, 0);
    return await flat.convertToBlob({ type: "image/png" });
  } finally {
    body.dispose();
    space.close();
  }
}
