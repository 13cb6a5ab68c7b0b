import { DirectrixError } from "../errors.js";
import { toText } from "../text.js";

/**
 * A document that was given to a figure and is not shown yet: until it is found to be one, the last one stays.
 *
 * @template T the document
 */
export class Incoming {
  /** @type {{ text: string, document: T } | null} */
  #given = null;
  #refused;

  /** @param {(error: DirectrixError) => void} refused told what is wrong with a document */
  constructor(refused) {
    this.#refused = refused;
  }

  /** Whether there is one. */
  get waits() {
    return this.#given !== null;
  }

  /**
   * Takes a document in place of one that still waits.
   *
   * @param {import("../directrix.js").DocumentInput} given
   * @throws {DirectrixError} when it is no JSON or holds a number that is not finite
   */
  take(given) {
    const text = toText(given);
    this.#given = { text, document: JSON.parse(text) };
  }

  /**
   * Puts the document in the place of the one that is shown. It goes on waiting when the work is given up or the kernel fails.
   *
   * @param {AbortSignal | undefined} signal
   * @param {(given: { text: string, document: T }, isStillWanted: () => boolean) => Promise<boolean>} put resolves to whether it did
   * @returns {Promise<boolean>} whether another document is shown
   */
  async settle(signal, put) {
    const given = this.#given;
    if (!given) return false;
    let isShown = false;
    try {
      isShown = await put(given, () => this.#given === given);
    } catch (error) {
      const isOfDocument = error instanceof DirectrixError && error.code !== "trap" && error.code !== "closed";
      if (signal?.aborted || !isOfDocument) throw error;
      this.#refused(error);
    }
    if (this.#given === given) this.#given = null;
    return isShown;
  }
}
