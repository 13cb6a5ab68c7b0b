/**
 * A shape that was found, as a row with its picture, a box that takes it, and room for what becomes of it.
 *
 * @import { Shape } from "../../../js/directrix.js"
 */
import { checkBox } from "../controls/choices.js";
import { h } from "../dom.js";
import { thumbnail } from "./picture.js";

/** CSS pixels of a picture. */
const SIZE = { width: 40, height: 32 };

/**
 * @param {Shape} shape
 * @param {number} index
 * @param {(on: boolean) => void} take
 */
export function shapeRow(shape, index, take) {
  const result = h("span", { class: "import-result", id: `import-result-${index}` });
  const box = checkBox({ name: `import-${index}`, text: [shape.name] }, take);
  box.element.querySelector("input")?.setAttribute("aria-describedby", result.id);
  const element = h(
    "li",
    { class: "import-shape", "data-shape": String(index) },
    /** @type {any} */ (thumbnail(shape.points, SIZE.width, SIZE.height)),
    h("span", { class: "import-names" }, box.element, result),
  );
  return { element, result, box };
}
