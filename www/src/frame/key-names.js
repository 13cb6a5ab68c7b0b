/** Whether this is a machine of Apple's, whose keyboards name the keys by signs. */
const apple = /Mac|iPhone|iPad/.test(navigator.platform);

const SIGNS = /** @type {const} */ ([
  ["Ctrl+", "⌘"],
  ["Shift+", "⇧"],
  ["Alt+", "⌥"],
]);

/**
 * A combination of keys as the person's keyboard names it.
 * @param {string} keys such as `Ctrl+Shift+S`
 */
export function keyName(keys) {
  const short = keys.replace("ArrowUp", "↑").replace("ArrowDown", "↓");
  return apple ? SIGNS.reduce((text, [name, sign]) => text.replace(name, sign), short) : short;
}
