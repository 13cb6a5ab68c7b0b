/**
 * Rows of an export that is a picture: its size, its colours, its background.
 *
 * @typedef {{width: number, height: number, theme: "light" | "dark", transparent: boolean}} PictureWanted
 */
import { checkBox, segment } from "../controls/choices.js";
import { numberField } from "../controls/number-field.js";
import { row } from "../controls/row.js";
import { words } from "./picture-words.js";

/** Smallest side of a picture in pixels. */
const SMALLEST = 16;

/**
 * @param {object} options
 * @param {string} options.name before the names of the controls
 * @param {number} options.largest side in pixels
 * @param {(patch: Partial<PictureWanted>) => void} change
 */
export function pictureRows({ name, largest }, change) {
  const side = (/** @type {"width" | "height"} */ which) =>
    numberField(
      { label: words[which], name: `${name}-${which}`, prefix: words[which].charAt(0), min: SMALLEST, max: largest, step: 1, decimals: 0, whole: true },
      { change: (value) => change({ [which]: value }) },
    );
  const [width, height] = [side("width"), side("height")];
  const theme = segment(
    { label: words.theme, name: `${name}-theme`, choices: /** @type {const} */ (["light", "dark"]).map((value) => ({ value, text: words.themes[value] })) },
    (value) => change({ theme: value }),
  );
  const transparent = checkBox({ name: `${name}-transparent`, text: [words.transparent] }, (on) => change({ transparent: on }));
  return {
    size: row(words.size, width, height),
    theme: row(words.theme, theme),
    background: row(words.background, transparent),
    /** @param {PictureWanted} wanted */
    set(wanted) {
      width.set(wanted.width);
      height.set(wanted.height);
      theme.set(wanted.theme);
      transparent.set(wanted.transparent);
    },
  };
}
