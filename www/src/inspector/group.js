/**
 * What one group of the inspector is to the frame around it.
 *
 * @typedef {object} Group
 * @property {string} name
 * @property {string} heading
 * @property {HTMLElement} body
 * @property {() => string} phrase the content in a few words, shown while the group is closed
 * @property {() => void} render
 * @property {HTMLElement[]} [commands] buttons beside the heading
 */
export {};
