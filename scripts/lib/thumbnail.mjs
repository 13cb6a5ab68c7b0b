/** One small picture of a document as the gallery shows it. */
import { PNG } from "pngjs";

/** The themes that a picture is painted for. */
export const themes = /** @type {const} */ (["light", "dark"]);

/** Size of a picture in CSS pixels, and device pixels for one of them. */
const width = 168;
const height = 120;
const ratio = 2;
/** CSS pixels left free on each side at least. */
const margin = 6;
/** Strokes are this much of their width in the figure. */
const thin = 0.75;

/**
 * The bytes of a PNG file with a transparent background: both curves with the band between them, as large as the frame allows.
 * Where there is no band, the lines that were found stand for it.
 *
 * @param {import("../../js/directrix.js").Directrix} dx
 * @param {import("../../js/directrix.js").CurvesDocument} document
 * @param {(typeof themes)[number]} theme
 * @returns {Buffer}
 */
export function paintThumbnail(dx, document, theme) {
  const { ok, samples } = dx.match(document);
  const points = samples.flatMap((each) => each.points);
  const [left, right] = extent(points.map(([x]) => x));
  const [bottom, top] = extent(points.map(([, y]) => y));
  const scale = Math.min((width - 2 * margin) / (right - left), (height - 2 * margin) / (top - bottom));
  const { data } = dx.paint(document, {
    width: width * ratio,
    height: height * ratio,
    pixelRatio: ratio * thin,
    view: { center: [(left + right) / 2, (bottom + top) / 2], scale: scale / thin },
    layers: [ok ? "material" : "rulingLines"],
    theme,
    background: false,
    s: null,
  });
  const png = new PNG({ width: width * ratio, height: height * ratio });
  png.data = Buffer.from(data.buffer, data.byteOffset, data.byteLength);
  return PNG.sync.write(png, { deflateLevel: 9 });
}

/**
 * @param {number[]} numbers
 * @returns {[number, number]}
 */
const extent = (numbers) => [Math.min(...numbers), Math.max(...numbers)];
