/** Whether a person sees an element, or is about to, and the room that it has. */

/** How far from the viewport something is near. */
const NEAR = "600px";

/**
 * @param {Element} element
 * @param {object} listeners
 * @param {(isNear: boolean) => void} listeners.near
 * @param {(isSeen: boolean) => void} listeners.seen
 * @param {() => void} listeners.woken the page is shown again, or hidden
 * @returns {(() => void)[]} what ends it
 */
export function observe(element, { near, seen, woken }) {
  const isIn = (/** @type {IntersectionObserverEntry[]} */ entries) => entries.at(-1)?.isIntersecting ?? false;
  const nearness = new IntersectionObserver((entries) => near(isIn(entries)), { rootMargin: NEAR });
  const sight = new IntersectionObserver((entries) => seen(isIn(entries)));
  nearness.observe(element);
  sight.observe(element);
  document.addEventListener("visibilitychange", woken);
  return [() => nearness.disconnect(), () => sight.disconnect(), () => document.removeEventListener("visibilitychange", woken)];
}

/**
 * @param {Element} element
 * @param {(size: import("./plane.js").Size) => void} change
 * @returns {() => void} ends it
 */
export function observeSize(element, change) {
  const observer = new ResizeObserver(([entry]) => {
    if (!entry) return;
    const { width, height } = entry.contentRect;
    change({ width: Math.round(width), height: Math.round(height) });
  });
  observer.observe(element);
  return () => observer.disconnect();
}
