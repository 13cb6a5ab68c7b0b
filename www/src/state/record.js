/**
 * A record whose changes are told to its listeners. Holds what the page shows besides the document: view, selection,
 * layers, results.
 *
 * @template {object} T
 */
export class Record {
  /** @type {Readonly<T>} */ #value;
  /** @type {Set<(value: Readonly<T>, before: Readonly<T>) => void>} */ #listeners = new Set();

  /** @param {T} value */
  constructor(value) {
    this.#value = Object.freeze({ ...value });
  }

  get value() {
    return this.#value;
  }

  /** @param {Partial<T>} patch */
  set(patch) {
    const before = this.#value;
    const keys = /** @type {(keyof T)[]} */ (Object.keys(patch));
    if (keys.every((key) => Object.is(before[key], patch[key]))) return;
    this.#value = Object.freeze({ ...before, ...patch });
    for (const listener of this.#listeners) listener(this.#value, before);
  }

  /**
   * @param {(value: Readonly<T>, before: Readonly<T>) => void} listener
   * @returns {() => void} ends it
   */
  subscribe(listener) {
    this.#listeners.add(listener);
    return () => void this.#listeners.delete(listener);
  }
}
