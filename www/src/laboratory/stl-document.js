/**
 * An STL that is opened as a file: a document of its own, with a first problem on its body.
 *
 * @import { App } from "../state/app.js"
 */
import { openDocument, refuse } from "../files/open.js";
import { problem } from "../painter.js";
import { strings } from "../strings.js";
import { withDefaults } from "./document.js";
import { firstProblem } from "./first-problem.js";
import { boundaryOf, readStl } from "./new-body.js";

/**
 * @param {App} app
 * @param {File} file
 * @returns {Promise<boolean>} whether it was opened
 */
export async function openStlDocument(app, file) {
  try {
    const { model, title, told } = await readStl(app, file);
    const { unit } = app.store.document;
    const bare = withDefaults({ title, unit, model });
    const first = firstProblem(bare, model, await boundaryOf(app, bare, model), title);
    if (!(await openDocument(app, first.document, file.name, { edited: true }))) return false;
    const text = told(first.told);
    app.ui.set({ note: { tone: "plain", text } });
    app.say(text);
    return true;
  } catch (error) {
    const { path = "", message } = problem(error);
    refuse(app, file.name, strings.errors.document(path, message));
    return false;
  }
}
