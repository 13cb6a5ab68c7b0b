/**
 * A part of the page whose code is fetched when it is first needed.
 *
 * @import { App, Ui } from "./state/app.js"
 *
 * @typedef {{render: () => void}} Part
 */

/**
 * @param {App} app
 * @param {(ui: Readonly<Ui>) => boolean} isNeeded
 * @param {() => Promise<(app: App) => Part>} load
 * @returns {Part}
 */
export function later(app, isNeeded, load) {
  /** @type {Part | null} */
  let part = null;
  let asked = false;
  return {
    render() {
      if (part) part.render();
      else if (!asked && isNeeded(app.ui.value)) {
        asked = true;
        void load().then((create) => {
          part = create(app);
          part.render();
        });
      }
    },
  };
}
