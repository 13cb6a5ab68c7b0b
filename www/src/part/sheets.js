/**
 * What is known of a part as sheets of pixels that lie over each other. Pixels of a page at rest stay over the coarse ones that come while it is panned
 * or zoomed, as long as they are of the same document.
 *
 * @import { PartRaster } from "../../../js/directrix.js"
 * @import { Sheet } from "./canvas.js"
 * @import { Pixels } from "./pixels.js"
 * @import { Known, Shown } from "./state.js"
 */
import { brokenPixels, colorPixels, differencePixels, leafPixels } from "./pixels.js";

/** Pixels of a fine sheet for one of a coarse sheet, from which on the coarse one is the better of both. */
const WORSE = 0.9;

export function createSheets() {
  /** @type {Known | null} */
  let fine = null;
  /** Sheets of rasters, by what is shown of them. @type {WeakMap<object, Map<string, Sheet>>} */
  const made = new WeakMap();

  /** @param {object} of @param {string} look @param {Pick<PartRaster, "size" | "box">} frame @param {() => Pixels} make @returns {Sheet} */
  function sheet(of, look, { size, box }, make) {
    let looks = made.get(of);
    if (!looks) made.set(of, (looks = new Map()));
    let found = looks.get(look);
    if (!found) {
      // One look at a time is shown.
      looks.clear();
      looks.set(look, (found = { pixels: make(), size, box }));
    }
    return found;
  }

  /** @param {Known} known @param {Shown} shown @returns {Sheet} */
  function pictureOf({ raster, reference }, { leaves, leaf, difference }) {
    if (leaves) return sheet(raster, `leaves ${leaf?.body} ${leaf?.leaf}`, raster, () => leafPixels(raster, leaf));
    if (difference && reference) return sheet(raster, "difference", raster, () => differencePixels(raster, reference));
    return sheet(raster, "colors", raster, () => colorPixels(raster));
  }

  return {
    /**
     * @param {Known} known
     * @param {Shown} shown
     * @returns {{sheets: Sheet[], broken: Sheet | null}}
     */
    of(known, shown) {
      if (known.isFine) fine = known;
      else if (fine?.document !== known.document) fine = null;
      const isBehind = fine && fine !== known && density(fine.raster) > WORSE * density(known.raster);
      const sheets = [pictureOf(known, shown), ...(fine && isBehind ? [pictureOf(fine, shown)] : [])];
      const { violations } = known;
      return {
        sheets,
        broken: violations && shown.violations ? sheet(violations, `broken ${shown.rule}`, violations, () => brokenPixels(violations, shown.rule)) : null,
      };
    },
  };
}

/** Pixels for one unit of length. @param {PartRaster} raster */
const density = ({ size, box: [[left], [right]] }) => size[0] / (right - left);
