/** Terms of the text and what they name in the figure: pointing at one lights up the other. */

/** The terms in a text. @param {HTMLElement} text */
export function termsIn(text) {
  return new Set([...text.querySelectorAll("[data-term]")].map((term) => /** @type {HTMLElement} */ (term).dataset.term ?? ""));
}

/**
 * @param {HTMLElement} text
 * @param {() => {light: (term: string | null) => void}} figure
 * @returns {{pointed: (term: string | null) => void}} to be told what the pointer is on in the figure
 */
export function linkTerms(text, figure) {
  /** The term that stays lit after a press, until another press or Escape. @type {string | null} */
  let held = null;
  const light = (/** @type {string | null} */ term) => {
    figure().light(term);
    for (const each of text.querySelectorAll("[data-term]")) each.classList.toggle("lit", /** @type {HTMLElement} */ (each).dataset.term === term);
  };
  const termOf = (/** @type {Event} */ { target }) =>
    target instanceof Element ? (/** @type {HTMLElement | null} */ (target.closest("[data-term]"))?.dataset.term ?? null) : null;
  text.addEventListener("pointerover", (event) => light(termOf(event) ?? held));
  text.addEventListener("pointerleave", () => light(held));
  text.addEventListener("focusin", (event) => light(termOf(event)));
  text.addEventListener("focusout", () => light(held));
  text.addEventListener("click", (event) => {
    const term = termOf(event);
    if (term === null) return;
    held = held === term ? null : term;
    for (const each of text.querySelectorAll("[data-term]")) each.setAttribute("aria-pressed", String(/** @type {HTMLElement} */ (each).dataset.term === held));
    light(held);
  });
  return { pointed: (term) => light(term ?? held) };
}
