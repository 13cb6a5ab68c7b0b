/** The data of paths as the kernel writes them: one `M`, cubics `C`, and `Z`, all with plain numbers. */

const NUMBER = /-?\d+(?:\.\d+)?/g;

/**
 * The path magnified and then moved.
 * @param {string} path
 * @param {{scale: number, x: number, y: number}} place
 * @param {number} decimals
 */
export function moved(path, { scale, x, y }, decimals) {
  let count = 0;
  return path.replace(NUMBER, (text) => {
    const value = Number(text) * scale + (count++ % 2 === 0 ? x : y);
    return String(Number(value.toFixed(decimals)));
  });
}

/**
 * The path of each command by itself, open.
 * @param {string} path
 */
export function commands(path) {
  const numbers = path.match(NUMBER) ?? [];
  const point = (/** @type {number} */ k) => `${numbers[2 * k]} ${numbers[2 * k + 1]}`;
  return Array.from({ length: (numbers.length - 2) / 6 }, (_, k) => ({
    start: point(3 * k),
    cubic: `C${[1, 2, 3].map((i) => point(3 * k + i)).join(" ")}`,
  }));
}

/**
 * The place of a box in a frame, in the middle and as large as the margin lets it be.
 * @param {[number, number, number, number]} box x, y, width and height
 * @param {{width: number, height: number}} frame
 * @param {number} margin
 */
export function fitted([left, top, wide, high], { width, height }, margin) {
  const scale = Math.min((width - 2 * margin) / wide, (height - 2 * margin) / high);
  return { scale, x: width / 2 - scale * (left + wide / 2), y: height / 2 - scale * (top + high / 2) };
}
