/**
 * Triangles of an STL file, binary or text, with corners at one place made one vertex. What the file says of normals is left aside: the order of corners counts.
 *
 * @typedef {{vertices: [number, number, number][], triangles: [number, number, number][], left: number}} Stl `left`: triangles without an area that were left out.
 */

/** Bytes before the triangles of a binary file, and of each of them. */
const HEAD = 84;
const EACH = 50;
/** Most triangles that the solver takes. */
export const MOST_TRIANGLES = 32_000;

/** Why a file was not read: the message is for the person. */
export class StlError extends Error {
  name = "StlError";
}

/** @param {ArrayBuffer} bytes @returns {Stl} @throws {StlError} */
export function readStl(bytes) {
  const view = new DataView(bytes);
  const count = bytes.byteLength >= HEAD ? view.getUint32(80, true) : -1;
  const isBinary = count >= 0 && bytes.byteLength === HEAD + EACH * count;
  return welded(isBinary ? binary(view, count) : text(new TextDecoder().decode(bytes)));
}

/** @param {DataView} view @param {number} count @returns {Float64Array} nine numbers a triangle */
function binary(view, count) {
  atMost(count);
  const found = new Float64Array(9 * count);
  for (let n = 0; n < count; n += 1) for (let k = 0; k < 9; k += 1) found[9 * n + k] = view.getFloat32(HEAD + EACH * n + 12 + 4 * k, true);
  return found;
}

/** @param {string} content @returns {Float64Array} */
function text(content) {
  if (!/^\s*solid\b/i.test(content)) throw new StlError("it is no STL: neither a text that begins with “solid” nor a binary of the length that it states");
  const places = [...content.matchAll(/\bvertex\s+(\S+)\s+(\S+)\s+(\S+)/gi)];
  if (places.length % 3 !== 0) throw new StlError(`${places.length} vertices were found; expected three for each triangle`);
  atMost(places.length / 3);
  return Float64Array.from(places.flatMap(([, ...three], n) => three.map((each) => numberOf(each, n))));
}

/** @param {string} written @param {number} vertex */
function numberOf(written, vertex) {
  const value = Number(written);
  if (!Number.isFinite(value)) throw new StlError(`“${written}” was found in vertex ${vertex + 1}; expected a number`);
  return value;
}

/** @param {number} count */
function atMost(count) {
  if (count === 0) throw new StlError("it has no triangles");
  if (count > MOST_TRIANGLES) throw new StlError(`${count} triangles were found; the solver takes up to ${MOST_TRIANGLES}`);
}

/** @param {Float64Array} soup nine numbers a triangle @returns {Stl} */
function welded(soup) {
  /** @type {Map<string, number>} */
  const known = new Map();
  /** @type {Stl} */
  const found = { vertices: [], triangles: [], left: 0 };
  for (let n = 0; n < soup.length; n += 9) {
    const corners = [0, 3, 6].map((k) => {
      const point = /** @type {[number, number, number]} */ ([soup[n + k] + 0, soup[n + k + 1] + 0, soup[n + k + 2] + 0]);
      if (!point.every(Number.isFinite)) throw new StlError(`triangle ${n / 9 + 1} has a coordinate that is no finite number`);
      const key = point.join(" ");
      const index = known.get(key) ?? found.vertices.length;
      if (index === found.vertices.length) {
        known.set(key, index);
        found.vertices.push(point);
      }
      return index;
    });
    const [a, b, c] = corners;
    if (a === b || b === c || c === a) found.left += 1;
    else found.triangles.push([a, b, c]);
  }
  if (found.triangles.length === 0) throw new StlError("no triangle has an area");
  return found;
}
