/** Everything that the page of an embedded figure says by itself. */
export const words = {
  title: (/** @type {string} */ title) => `${title} – Directrix`,
  ask: (/** @type {string} */ address) => `This figure would be loaded from ${address}`,
  load: "Load it",
  refused: "This link does not lead to a figure.",
  empty: "No figure is named here: the address takes #v=1&preset=NAME, or a link from the panel Share.",
};
