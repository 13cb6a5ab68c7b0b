/**
 * The sheet of a style for the figures of a document, made once for each: no style element, which a policy of the page may forbid.
 *
 * @param {string} css
 * @returns {(owner: Document) => CSSStyleSheet}
 */
export function sheetsOf(css) {
  /** @type {WeakMap<Document, CSSStyleSheet>} */
  const sheets = new WeakMap();
  return (owner) => {
    let sheet = sheets.get(owner);
    if (!sheet) {
      sheet = new (owner.defaultView?.CSSStyleSheet ?? CSSStyleSheet)();
      sheet.replaceSync(css);
      sheets.set(owner, sheet);
    }
    return sheet;
  };
}
