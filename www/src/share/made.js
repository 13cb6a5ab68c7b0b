/**
 * The links to what is open: to its preset as long as it is as it came, else with the whole document in them.
 *
 * @import { Link } from "../../../js/directrix.js"
 * @import { App } from "../state/app.js"
 */
import { documentWithView, splitView } from "../files/document-view.js";
import { presetDocument, presets } from "../gallery/presets.js";
import { kindOf } from "../kinds/kinds.js";
import { completed } from "../kernel.js";

/** The longest link that is offered, in characters: mail, chat and course systems cut longer ones. */
export const LONGEST = 8192;

/**
 * Where a link to what is open leads, with the mode and the step that are shown.
 * @param {App} app
 * @returns {Promise<Link & {title: string}>}
 */
export async function linkTo(app) {
  const { mode, step } = app.ui.value;
  const shown = {
    ...(mode === "figure" ? {} : { view: mode }),
    ...(mode === "steps" && step > 0 ? { step } : {}),
  };
  const { title } = app.store.document;
  const preset = await presetOf(app);
  return preset ? { preset, ...shown, title } : { document: document(app), ...shown, title };
}

/** The document with its view; one that fits itself to the window does so for the reader as well. @param {App} app */
function document(app) {
  const whole = documentWithView(app);
  if (!app.ui.value.fitted || !whole.view) return whole;
  const { center: _center, span: _span, ...view } = whole.view;
  return { ...whole, view };
}

/** The preset that the document still is, with the view that it came with; null when it is none. @param {App} app */
async function presetOf(app) {
  const { document: open } = app.store;
  const kind = await kindOf(open);
  if (kind) {
    const same = (await kind.presets()).map(async ({ id, document }) => (document.title === open.title && JSON.stringify(await completed(app.kernel, document)) === JSON.stringify(open) ? id : null));
    return (await Promise.all(same)).find((id) => id !== null) ?? null;
  }
  if (!app.ui.value.fitted) return null;
  for (const { id } of presets) {
    const raw = /** @type {{title?: string}} */ (presetDocument(id));
    if (raw.title !== open.title) continue;
    const own = splitView(await completed(app.kernel, raw));
    const same = JSON.stringify(own.document) === JSON.stringify(open) && own.place === null;
    const shown = Object.keys(own.ui).map((key) => [key, app.ui.value[/** @type {keyof typeof own.ui} */ (key)]]);
    if (same && JSON.stringify(own.ui) === JSON.stringify(Object.fromEntries(shown))) return id;
  }
  return null;
}

/** The address of the editor, or of the page that shows a figure alone, without a link. @param {"editor" | "view"} page */
export function addressOf(page) {
  const { origin, pathname } = location;
  return page === "editor" ? `${origin}${pathname}` : new URL("embed.html", `${origin}${pathname}`).href;
}
