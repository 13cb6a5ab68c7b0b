/**
 * An error with a stable code, the path of the field it concerns, and a place in the plane where it has one.
 *
 * Codes are listed in docs/api.md. The message says what was found and what was expected, without the path.
 */
export class DirectrixError extends Error {
  /**
   * @param {string} code
   * @param {string} path such as `curves[0].points[2][1]`; empty for the whole document
   * @param {string} message
   * @param {[number, number]} [at]
   * @param {number[]} [place]
   */
  constructor(code, path, message, at, place) {
    super(message);
    this.name = "DirectrixError";
    /** @readonly */
    this.code = code;
    /** @readonly */
    this.path = path;
    /** @readonly @type {[number, number] | undefined} */
    this.at = at;
    /** @readonly All coordinates of the place, of problems in the plane or in space. @type {number[] | undefined} */
    this.place = place;
  }
}

/**
 * Turns what the module throws into our error: its own errors carry code and path, a trap is told as such.
 *
 * @param {unknown} error
 * @returns {unknown}
 */
export function fromModule(error) {
  if (error instanceof DirectrixError) return error;
  if (error instanceof WebAssembly.RuntimeError) {
    return new DirectrixError("trap", "", `the module stopped: ${error.message}; load it again`);
  }
  if (error instanceof Error && "code" in error && "path" in error) {
    const { code, path, message, at, place } = /** @type {any} */ (error);
    return new DirectrixError(code, path, message, at, place);
  }
  return error;
}
