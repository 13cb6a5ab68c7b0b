/** Words of what works without a network, and of a new version. */
export const words = {
  heading: "Without a network",
  states: {
    waiting: "In a moment this page will be kept by your browser, to work without a network.",
    keeping: "This page is being kept by your browser, to work without a network.",
    kept: "This page is kept by your browser and works without a network.",
    development: "A development server keeps nothing.",
    unsupported: "This browser keeps no pages, or not at this address. Directrix works, but only with a network.",
    failed: "The browser did not keep this page. Directrix works, but only with a network.",
  },
  reason: (/** @type {string} */ reason) => `The reason it gave: ${reason}`,
  ready: "A new version is ready.",
  missing: "A part of this page could not be fetched: there is no network, or a newer version on the server.",
  reload: "Reload",
  reloadNote: "Your document stays.",
  changed: "What changed",
  unlisted: "The changes are not in the list of notable ones.",
};
