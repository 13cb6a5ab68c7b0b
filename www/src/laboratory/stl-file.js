/**
 * Opening an STL of the person's own as the body of the problem: by a button or by dropping it. Whatever is wrong with it, the problem stays.
 *
 * @import { Bench } from "./state.js"
 */
import { problem } from "../painter.js";
import { AXES } from "../space/section.js";
import { middleOf } from "../space/vector.js";
import { strings } from "../strings.js";
import { withModel } from "./edits.js";
import { boundsOf } from "./mesh.js";
import { through } from "./section-state.js";
import { words } from "./words.js";

/** Bytes of a file at most: a text of as many triangles as the solver takes stays below. */
const MOST_BYTES = 16 << 20;

/**
 * @param {Bench} bench
 * @param {File} file
 * @param {(message: string | null) => void} tell why it was refused; null when it was taken
 */
export async function openStl(bench, file, tell) {
  const text = words.model;
  try {
    if (file.size > MOST_BYTES) throw new Error(`it has ${Math.round(file.size / 2 ** 20)} MiB; expected at most 16`);
    const found = await bench.app.kernel.readMesh(await file.arrayBuffer());
    const triangles = threes(found.triangles);
    const model = { kind: "mesh", vertices: threes(found.vertices), triangles };
    // A boundary that the kernel cannot read at all is refused before it takes the place of the body.
    const { section: _section, ...document } = withModel(bench.now().document, model);
    const boundary = await bench.app.kernel.boundary(/** @type {any} */ (document));
    // A plane through its middle shows the solution at once.
    const section = through(AXES.y, middleOf(boundsOf(boundary)));
    bench.commit((now) => ({ ...withModel(now, model), section }));
    tell(null);
    bench.app.say(text.imported(file.name, triangles.length));
  } catch (error) {
    const { path = "", message: reason } = problem(error);
    const message = text.refused(file.name, strings.errors.document(path, reason));
    tell(message);
    bench.app.say(message);
  }
}

/** Numbers by three. @param {ArrayLike<number>} list @returns {number[][]} */
const threes = (list) => Array.from({ length: list.length / 3 }, (_, n) => [list[3 * n], list[3 * n + 1], list[3 * n + 2]]);

/** Whether a file is meant to be an STL. @param {{name: string}} file */
export const isStl = ({ name }) => /\.stl$/i.test(name);
