/**
 * The cells of another body in this one, as pure functions.
 *
 * @import { HyperpatchDocument, HyperpatchOperation, Material } from "../../../../js/directrix.js"
 * @import { BodyDocument } from "../document.js"
 */
import { appended } from "../edits.js";

/** Materials of a document at most, as in docs/format.md. */
export const MOST_MATERIALS = 16;

/** @param {Pick<Material, "name" | "color" | "void">} a @param {Pick<Material, "name" | "color" | "void">} b */
const isSame = (a, b) => a.name === b.name && a.color.toLowerCase() === b.color.toLowerCase() && Boolean(a.void) === Boolean(b.void);

/**
 * The materials of both, those of the same name and colour once.
 * @param {readonly Material[]} mine
 * @param {readonly Material[]} theirs
 * @returns {{materials: Material[], places: number[]}} `places`: where each of theirs is
 */
export function commonMaterials(mine, theirs) {
  const materials = [...mine];
  const places = theirs.map((material) => {
    const found = mine.findIndex((each) => isSame(each, material));
    return found >= 0 ? found : materials.push(material) - 1;
  });
  return { materials, places };
}

/** A mix with zeros for materials that it did not know. @param {readonly number[]} mix @param {number} count */
const longer = (mix, count) => [...mix, ...Array.from({ length: count - mix.length }, () => 0)];

/**
 * An operation in a document of more materials.
 * @param {HyperpatchOperation} operation
 * @param {number} count
 * @returns {HyperpatchOperation} the same one where it names no mix
 */
function widened(operation, count) {
  if (operation.op === "cells") {
    if (!operation.cells.some(({ coefficients }) => coefficients.some(({ mix }) => mix))) return operation;
    const cells = operation.cells.map((cell) => ({ ...cell, coefficients: cell.coefficients.map((each) => (each.mix ? { ...each, mix: longer(each.mix, count) } : each)) }));
    return { ...operation, cells };
  }
  return "mix" in operation && operation.mix ? { ...operation, mix: longer(operation.mix, count) } : operation;
}

/**
 * A body with the cells of another one, where they lie.
 * @param {BodyDocument} document
 * @param {HyperpatchDocument} other with one operation, which writes its cells out
 * @returns {BodyDocument}
 */
export function merged(document, other) {
  const { materials, places } = commonMaterials(document.materials, other.materials ?? []);
  const count = materials.length;
  const more = count > document.materials.length;
  const mine = more ? document.operations.map((operation) => widened(operation, count)) : document.operations;
  const [operation] = other.operations;
  if (operation?.op !== "cells") return document;
  const cells = operation.cells.map(({ coefficients }) => ({
    coefficients: coefficients.map(({ position, mix = [1] }) => {
      const own = Array.from({ length: count }, () => 0);
      mix.forEach((fraction, i) => (own[places[i]] += fraction));
      return { position, mix: own };
    }),
  }));
  return appended({ ...document, materials, operations: mine }, { op: "cells", cells });
}
