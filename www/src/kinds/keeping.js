/** Keeps what a reload and the way back to a document bring, such as its camera, once it rests. */

/** Milliseconds after the last change. */
const REST = 250;

/**
 * @param {() => void} keep
 * @returns {{later: () => void, close: () => void}} `later`: something has changed; `close` keeps what has not rested yet
 */
export function createKeeping(keep) {
  const over = new AbortController();
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let timer;

  function now() {
    clearTimeout(timer);
    timer = undefined;
    keep();
  }
  // Before the page writes down what a reload brings back.
  for (const type of ["beforeunload", "pagehide"]) addEventListener(type, now, { signal: over.signal, capture: true });

  return {
    later() {
      clearTimeout(timer);
      timer = setTimeout(now, REST);
    },
    close() {
      over.abort();
      if (timer !== undefined) now();
    },
  };
}
