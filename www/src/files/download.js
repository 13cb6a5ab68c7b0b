/** Milliseconds after which the browser has surely taken the bytes. */
const TAKEN = 10_000;

/**
 * Hands a file to the browser's own downloads.
 * @param {Blob} blob
 * @param {string} name
 */
export function download(blob, name) {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), TAKEN);
}
