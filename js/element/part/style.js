/** The style sheet that a figure of a part has besides that of every figure. */
import { sheetsOf } from "../sheets.js";
import { ZOOMS_CSS } from "../zooms.js";

const CSS = `
.play, .slider, .place { display: none; }
.places { position: absolute; inset: 0; z-index: 1; outline: 0; cursor: crosshair; }
.places.moves { cursor: grab; }
.places.held { cursor: grabbing; }
.places:focus-visible:not(.pointed) { outline: 2px solid var(--accent); outline-offset: -3px; border-radius: 6px; }
.frame:not([data-state="shown"]) :is(.places, .card, .mark) { display: none; }
.mark {
  position: absolute; z-index: 2; left: -5px; top: -5px; width: 10px; height: 10px; box-sizing: border-box; border: 2px solid #101216; border-radius: 50%;
  box-shadow: 0 0 0 1.5px #ffffff, inset 0 0 0 1.5px #ffffff; pointer-events: none;
}
.card {
  position: absolute; z-index: 3; left: 0; top: 0; display: grid; gap: 2px; max-width: min(240px, calc(100% - 16px)); box-sizing: border-box; padding: 8px 10px;
  border-radius: 8px; background: var(--field); box-shadow: var(--shadow); pointer-events: none; font-variant-numeric: tabular-nums;
}
.card[hidden], .mark[hidden] { display: none; }
.card div, .key span { display: flex; align-items: center; gap: 8px; }
.card b { margin-left: auto; padding-left: 12px; font-weight: 500; }
.card .far { color: var(--text-2); }
.name { overflow: hidden; text-overflow: ellipsis; white-space: nowrap; }
.swatch { flex: none; width: 12px; height: 12px; border-radius: 4px; box-shadow: inset 0 0 0 1px #00000024; forced-color-adjust: none; }
.tools { display: flex; flex: 1; align-items: center; justify-content: space-between; gap: 14px; min-width: 0; }
.key { display: flex; flex-wrap: wrap; gap: 0 16px; min-width: 0; max-height: 36px; overflow: hidden; color: var(--text-2); }
.result .fact { overflow: hidden; text-overflow: ellipsis; }
@media print { .places, .card, .mark { display: none; } }
`;

/** The sheet for the figures of parts of a document. */
export const partSheetOf = sheetsOf(`${CSS}${ZOOMS_CSS}`);
