/**
 * Puts things on the clipboard. Must be called while the browser still counts the person's press; what is to be copied may
 * still be on its way then. Rejects when the browser does not allow it.
 */

/** @param {Promise<string>} text */
export function copyText(text) {
  return copy("text/plain", text.then((content) => new Blob([content], { type: "text/plain" })));
}

/** @param {Promise<Blob>} png */
export function copyPng(png) {
  return copy("image/png", png);
}

/** @param {string} type @param {Promise<Blob>} content */
async function copy(type, content) {
  // Whatever becomes of the clipboard, a failure of the content itself is the one to tell.
  const [written] = await Promise.allSettled([write(type, content)]);
  await content;
  if (written.status === "rejected") throw written.reason;
}

/** @param {string} type @param {Promise<Blob>} content */
async function write(type, content) {
  await navigator.clipboard.write([new ClipboardItem({ [type]: content })]);
}
