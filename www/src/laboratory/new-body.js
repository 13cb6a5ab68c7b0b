/**
 * Bodies that share nothing with the one that is open: an STL of the person's own, and a named shape after one. They come with a first problem, in one edit.
 *
 * @import { App } from "../state/app.js"
 * @import { Bench } from "./state.js"
 * @import { LaboratoryDocument, Model } from "./document.js"
 */
import { problem } from "../painter.js";
import { strings } from "../strings.js";
import { fixed } from "../format.js";
import { withModel } from "./edits.js";
import { firstProblem } from "./first-problem.js";
import { words } from "./words.js";

/** Bytes of a file at most: a text of as many triangles as the solver takes stays below. */
const MOST_BYTES = 16 << 20;
/** Letters of a title, as in docs/format.md. */
const MOST_LETTERS = 200;

/**
 * Takes a body with a first problem.
 * @param {Bench} bench
 * @param {Model} model
 * @param {string} title
 * @returns {Promise<string>} what was set, in words
 * @throws {Error} where the kernel cannot read the body at all; then nothing has changed
 */
export async function takeBody(bench, model, title) {
  const boundary = await boundaryOf(bench.app, bench.now().document, model);
  let told = "";
  bench.commit((now) => {
    const first = firstProblem(now, model, boundary, title);
    told = words.first.undo(first.told);
    return first.document;
  });
  bench.seeAnew();
  return told;
}

/**
 * The boundary of a body, without conditions.
 * @param {App} app
 * @param {LaboratoryDocument} document that the body is to come into
 * @param {Model} model
 */
export function boundaryOf(app, document, model) {
  const { section: _section, ...others } = withModel(document, model);
  return app.kernel.boundary(/** @type {any} */ ({ ...others, groups: [] }));
}

/**
 * Reads an STL.
 * @param {App} app
 * @param {File} file
 * @returns {Promise<{model: Model, title: string, told: (first: string) => string}>} its body, a title, and what is said of it with its first problem
 * @throws {Error} where it is too large or no STL
 */
export async function readStl(app, file) {
  const text = words.model;
  if (file.size > MOST_BYTES) throw new Error(text.tooLarge(Math.round(file.size / 2 ** 20), MOST_BYTES >> 20));
  const found = await app.kernel.readMesh(await file.arrayBuffer());
  const model = { kind: "mesh", vertices: threes(found.vertices), triangles: threes(found.triangles) };
  const title = file.name.replace(/\.stl$/i, "").slice(0, MOST_LETTERS);
  return { model, title, told: (first) => text.imported(file.name, fixed(model.triangles.length, 0), first) };
}

/**
 * Takes the body of an STL. Whatever is wrong with it, the problem that was open stays.
 * @param {Bench} bench
 * @param {File} file
 * @returns {Promise<{isOpen: boolean, text: string}>} what is said of it: the problem that it has now, or why it was refused
 */
export async function openStl(bench, file) {
  try {
    const { model, title, told } = await readStl(bench.app, file);
    const text = told(await takeBody(bench, model, title));
    bench.app.say(text);
    return { isOpen: true, text };
  } catch (error) {
    const { path = "", message: reason } = problem(error);
    const message = words.model.refused(file.name, strings.errors.document(path, reason));
    bench.app.say(message);
    return { isOpen: false, text: message };
  }
}

/** Numbers by three. @param {ArrayLike<number>} list @returns {number[][]} */
const threes = (list) => Array.from({ length: list.length / 3 }, (_, n) => [list[3 * n], list[3 * n + 1], list[3 * n + 2]]);
