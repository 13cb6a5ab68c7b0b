/**
 * Defines `<directrix-figure>`: a figure for any page, from one module script. See docs/embedding.md.
 */
import { DirectrixFigure } from "./element/figure.js";

export { DirectrixFigure };

/** Not written out as `new URL("./presets/", import.meta.url)`, which bundlers take for a file of the bundle. */
const home = import.meta.url;

DirectrixFigure.presets = new URL("./presets/", home);
DirectrixFigure.editor = new URL("./index.html", home);

if (globalThis.customElements && !customElements.get("directrix-figure")) customElements.define("directrix-figure", DirectrixFigure);
