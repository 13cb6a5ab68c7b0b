/**
 * The checks of what operations made, asked of the module when they are shown and kept as long as the body stands.
 *
 * @import { AdditionChecks } from "../../../../js/directrix.js"
 * @import { Known } from "../runner.js"
 *
 * @typedef {{of: (operation: number) => AdditionChecks | null, close: () => void}} Checks
 */

/**
 * @param {() => Known | null} now the body as it stands, null while it is being found
 * @param {() => void} found
 * @returns {Checks}
 */
export function createChecks(now, found) {
  /** @type {Map<number, AdditionChecks>} */
  let known = new Map();
  /** @type {Set<number>} */
  let asked = new Set();
  let about = /** @type {unknown} */ (null);
  let over = new AbortController();
  return {
    of(operation) {
      const body = now()?.body ?? null;
      if (!body) return null;
      if (body !== about) {
        about = body;
        over.abort();
        over = new AbortController();
        known = new Map();
        asked = new Set();
      }
      if (!asked.has(operation)) {
        asked.add(operation);
        body.checks(operation, { signal: over.signal }).then(
          (checks) => {
            if (body !== about) return;
            known.set(operation, checks);
            found();
          },
          // Given up for another body, which asks again; what else fails is told by the checks of the whole.
          () => undefined,
        );
      }
      return known.get(operation) ?? null;
    },
    close: () => over.abort(),
  };
}
