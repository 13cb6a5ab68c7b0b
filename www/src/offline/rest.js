/** Waiting until the page has nothing better to do. */

/** Milliseconds after loading in which the page is left alone. */
const PAUSE = 1500;

/**
 * Calls once the page has loaded, a moment has passed, and the browser is idle.
 * @param {() => void} call
 */
export function whenAtRest(call) {
  const idle = () => {
    if ("requestIdleCallback" in window) requestIdleCallback(call, { timeout: PAUSE });
    else call();
  };
  const wait = () => setTimeout(idle, PAUSE);
  if (document.readyState === "complete") wait();
  else addEventListener("load", wait, { once: true });
}
