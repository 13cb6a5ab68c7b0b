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
 * @param {(error: unknown) => void} [failed] sees to it that the part is no longer needed; it is asked for again when it is
 * @returns {Part}
 */
export function later(app, isNeeded, load, failed) {
  /** @type {Part | null} */
  let part = null;
  let asked = false;
  return {
    render() {
      if (part) part.render();
      else if (!asked && isNeeded(app.ui.value)) {
        asked = true;
        const loading = load().then((create) => {
          part = create(app);
          part.render();
        });
        if (!failed) return;
        loading.catch((error) => {
          asked = false;
          failed(error);
        });
      }
    },
  };
}
