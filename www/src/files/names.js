/** What a document without letters or digits in its title is called on disk. */
const NAMELESS = "directrix";

/**
 * A title as the name of a file, without its ending: lower case letters, digits and hyphens, which every system takes.
 * @param {string} title
 */
export function fileName(title) {
  const plain = title
    .normalize("NFKD")
    .toLowerCase()
    .replace(/[^a-z0-9]+/g, "-")
    .replace(/^-|-$/g, "");
  return plain || NAMELESS;
}
