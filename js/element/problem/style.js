/** The style sheet that a figure of a boundary value problem has besides that of every figure: as that of a body, without what moves a place. */
import { BODY_CSS } from "../body/style.js";
import { sheetsOf } from "../sheets.js";
import { ZOOMS_CSS } from "../zooms.js";

const CSS = `
.play, .slider, .place { display: none; }
.tools { display: flex; flex: 1; align-items: center; justify-content: space-between; gap: 14px; min-width: 0; }
.key { overflow: hidden; min-width: 0; font-weight: 500; text-overflow: ellipsis; white-space: nowrap; }
`;

/** The sheet for the figures of problems of a document. */
export const problemSheetOf = sheetsOf(`${BODY_CSS}${CSS}${ZOOMS_CSS}`);
