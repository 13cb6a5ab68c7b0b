/** Pictures of a page as numbers. */
import { mkdir, writeFile } from "node:fs/promises";
import { join } from "node:path";
import pixelmatch from "pixelmatch";
import { PNG } from "pngjs";
import { work } from "../../../scripts/lib/paths.mjs";

/**
 * @typedef {import("playwright-core").Page} Page
 * @typedef {import("playwright-core").Locator} Locator
 */

/** The colour difference, from 0 to 1, above which two pixels differ: pixelmatch's own 0.1 misses a hue that is 20 degrees off. */
const threshold = 0.02;

/** A picture: straight RGBA, row by row from the top. */
export class Picture {
  /** @param {PNG} png */
  constructor(png) {
    this.width = png.width;
    this.height = png.height;
    this.data = png.data;
  }

  /**
   * The red, green and blue of a pixel, 0 to 255.
   *
   * @param {number} x from the left
   * @param {number} y from the top
   */
  at(x, y) {
    if (x < 0 || y < 0 || x >= this.width || y >= this.height) throw new RangeError(`(${x}, ${y}) is outside the picture`);
    const start = (Math.floor(y) * this.width + Math.floor(x)) * 4;
    return [...this.data.subarray(start, start + 3)];
  }

  /** The number of different colours: a picture of nothing has one. */
  colors() {
    const found = new Set();
    for (let start = 0; start < this.data.length; start += 4) found.add(this.data.readUInt32BE(start));
    return found.size;
  }

  /**
   * The share of the pixels, 0 to 1, that differ from another picture of the same size.
   *
   * @param {Picture} other
   */
  difference(other) {
    if (this.width !== other.width || this.height !== other.height) {
      throw new RangeError(`${this.width} x ${this.height} and ${other.width} x ${other.height} pixels`);
    }
    const count = pixelmatch(this.data, other.data, undefined, this.width, this.height, { threshold });
    return count / (this.width * this.height);
  }
}

/**
 * Takes a picture of what a page or one of its elements shows, and leaves it in `.build/screenshots` for a person to look at.
 *
 * @param {Page | Locator} shown
 * @param {string} name of the file, without its ending
 * @returns {Promise<Picture>}
 */
export async function screenshot(shown, name) {
  const bytes = await shown.screenshot();
  const folder = join(work, "screenshots");
  await mkdir(folder, { recursive: true });
  await writeFile(join(folder, `${name}.png`), bytes);
  return new Picture(PNG.sync.read(bytes));
}
