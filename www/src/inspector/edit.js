/**
 * The usual way from a control to the document: change one part, in runs that can be ended and taken back.
 *
 * @import { App } from "../state/app.js"
 * @import { CurvesDocument } from "../types.js"
 */

/**
 * @template T
 * @param {App} app
 * @param {(document: CurvesDocument, value: T) => CurvesDocument} change
 * @returns {import("../controls/run.js").Editing<T>}
 */
export function editing(app, change) {
  return {
    change: (value, run) =>
      app.store.commit({ change: (document) => change(document, value), ...(run === undefined ? {} : { run }) }),
    end: () => app.store.endRun(),
    cancel: (run) => void app.store.cancel(run),
  };
}
