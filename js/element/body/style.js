/** The style sheet that a figure of a body has besides that of every figure. */
import { sheetsOf } from "../sheets.js";
import { ZOOMS_CSS } from "../zooms.js";

/** Its own part, which figures that are turned in the same way have as well. */
export const BODY_CSS = `
.orbit { position: absolute; inset: 0; z-index: 1; outline: 0; cursor: grab; }
.orbit.entered { touch-action: none; }
.orbit.held { cursor: grabbing; }
.orbit:focus-visible:not(.pointed) { outline: 2px solid var(--accent); outline-offset: -3px; border-radius: 6px; }
.hint { position: absolute; left: 16px; bottom: calc(100% + 6px); margin: 0; color: var(--text-2); pointer-events: none; }
.orbit.known ~ .hint, .frame[data-controls="none"] .hint, .frame:not([data-state="shown"]) :is(.hint, .orbit) { display: none; }
.hint .tap { display: none; }
@media (pointer: coarse) { .hint .tap { display: inline; } .hint .drag { display: none; } }
.result .fact { overflow: hidden; text-overflow: ellipsis; }
@container (width < 340px) { .hint { display: none; } }
@media print { .hint, .orbit { display: none; } }
`;

/** The sheet for the figures of bodies of a document. */
export const bodySheetOf = sheetsOf(`${BODY_CSS}${ZOOMS_CSS}`);
