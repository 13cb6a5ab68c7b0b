/** The values of attributes that have a fixed choice, the default first. */
const CHOICES = {
  controls: ["full", "minimal", "none"],
  theme: ["auto", "light", "dark"],
  reveal: ["auto", "interaction"],
  view: ["figure", "steps", "compare", "solid"],
};

/** What an attribute chooses; the default where it says nothing that can be chosen. @param {Element} element @param {keyof typeof CHOICES} name */
export function choiceOf(element, name) {
  const value = element.getAttribute(name) ?? "";
  return CHOICES[name].includes(value) ? value : CHOICES[name][0];
}
