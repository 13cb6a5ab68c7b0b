/** The style sheet of a figure, kept from that of its page. */
import { sheetsOf } from "./sheets.js";

const CSS = `
:host { display: block; }
:host([hidden]) { display: none; }

.whole { position: relative; height: 100%; }

.frame {
  --canvas: #ffffff; --hover: #ebecee; --press: #e0e1e5; --field: #ffffff; --line: #e2e3e7; --line-strong: #c9ccd2; --control: #8b909b;
  --text: #17191d; --text-2: #585d68; --accent: #4a45c8; --on-accent: #ffffff; --error: #b3261e; --handle: #4a45c8;
  --shadow: 0 1px 2px #14161c0f, 0 8px 24px #14161c1a;
  --height: 28px; --play: 36px; --thumb: 18px;
  all: initial;
  display: block;
  box-sizing: border-box;
  height: 100%;
  container-type: inline-size;
  direction: ltr;
  color-scheme: light;
  color: var(--text);
  font: 400 12px/18px system-ui, sans-serif;
  text-align: start;
}
.frame[data-theme="dark"] {
  --canvas: #0e0f12; --hover: #24272d; --press: #2d3038; --field: #1e2025; --line: #282b31; --line-strong: #3d414a; --control: #6a707c;
  --text: #eceef2; --text-2: #a3a8b4; --accent: #a8a4ff; --on-accent: #14122e; --error: #ff8d85;
  --shadow: 0 1px 2px #00000080, 0 8px 24px #00000080;
  color-scheme: dark;
}
@media (pointer: coarse) { .frame { --height: 44px; --play: 44px; --thumb: 24px; } }

.body {
  position: relative;
  display: flex;
  flex-direction: column;
  box-sizing: border-box;
  width: 100%;
  aspect-ratio: 16 / 10;
  height: 100%;
  min-height: 120px;
  overflow: hidden;
  border: 1px solid var(--line);
  border-radius: 8px;
  background: var(--canvas);
}
@container (width < 480px) { .body { aspect-ratio: 1; } }
.frame[data-controls="none"] .body { border: 0; border-radius: 0; }

.head, .bar { display: flex; flex: none; align-items: center; box-sizing: border-box; padding: 0 16px; white-space: nowrap; }
.head { justify-content: flex-end; gap: 8px; min-height: 36px; padding-top: 6px; }
.bar { gap: 14px; min-height: calc(var(--play) + 20px); padding: 4px 16px 8px 12px; }
.frame[data-controls="none"] :is(.head, .bar) { display: none; }
.frame:not([data-state="shown"]) :is(.head, .bar) { visibility: hidden; }

.picture { position: relative; flex: 1 1 0; min-height: 0; }
canvas, .poster, .paper { position: absolute; inset: 0; display: block; width: 100%; height: 100%; }
.poster { object-fit: contain; }
.frame:not([data-state="shown"]) canvas, .frame[data-state="shown"] .poster, .paper, [hidden] { display: none; }

/* Tells light from dark, see theme.js. */
.ground { display: none; background-color: Canvas; }

.fallback { position: absolute; inset: 0; z-index: 1; overflow: auto; box-sizing: border-box; padding: 12px 16px; }
.fallback[hidden] { display: none; }

.reveal { position: absolute; inset: 0; z-index: 2; display: grid; place-items: end center; padding: 12px; pointer-events: none; }
.reveal[hidden] { display: none; }
.reveal button { pointer-events: auto; height: max(36px, var(--height)); padding: 0 16px; background: var(--accent); color: var(--on-accent); }
.reveal button:hover { background: var(--accent); filter: brightness(1.1); }

.working { position: absolute; inset: 0 0 auto; z-index: 3; height: 2px; background: var(--accent); transform: scaleX(0); transform-origin: left; opacity: 0; }
.working.shown { opacity: 1; }

.problem {
  position: absolute; z-index: 4; inset: auto 12px 12px; max-height: 60%; overflow: auto; margin: 0; padding: 6px 10px;
  border: 1px solid var(--error); border-radius: 6px; background: var(--canvas); color: var(--error); overflow-wrap: anywhere;
}

button, .open {
  all: unset;
  box-sizing: border-box; display: inline-flex; align-items: center; justify-content: center; border-radius: 6px;
  color: inherit; font: 500 13px/20px system-ui, sans-serif; cursor: pointer; white-space: nowrap;
}
button:focus-visible, .open:focus-visible { outline: 2px solid var(--accent); outline-offset: 2px; }

.play { flex: none; width: var(--play); height: var(--play); border-radius: 50%; background: var(--text); color: var(--canvas); }
.play:hover { background: var(--text-2); }
.icon { display: block; fill: currentColor; }
.icon-check { fill: none; stroke: var(--accent); stroke-width: 1.75; stroke-linecap: round; stroke-linejoin: round; }

.slider { position: relative; display: flex; flex: 1; align-items: center; min-width: 40px; height: var(--play); margin: 0 calc(var(--thumb) / 2); }
.slider::before {
  content: ""; position: absolute; inset: calc(50% - 1px) 0 auto; height: 2px; border-radius: 1px;
  background: linear-gradient(to right, var(--accent) calc(var(--fill, 0) * 100%), var(--control) calc(var(--fill, 0) * 100%));
}
input {
  all: unset; appearance: none; position: absolute; left: calc(var(--thumb) / -2); width: calc(100% + var(--thumb)); height: 100%;
  cursor: pointer; touch-action: pan-y;
}
input::-webkit-slider-runnable-track { height: var(--thumb); }
input::-webkit-slider-thumb {
  appearance: none; width: var(--thumb); height: var(--thumb); border: 0; border-radius: 50%; background: var(--field);
  box-shadow: 0 0 0 1.5px var(--accent);
}
input::-moz-range-thumb {
  width: var(--thumb); height: var(--thumb); border: 0; border-radius: 50%; background: var(--field); box-shadow: 0 0 0 1.5px var(--accent);
}
input:hover::-webkit-slider-thumb { background: var(--hover); }
input:focus-visible::-webkit-slider-thumb { outline: 2px solid var(--accent); outline-offset: 3.5px; }
input:focus-visible::-moz-range-thumb { outline: 2px solid var(--accent); outline-offset: 3.5px; }

.place { min-width: 44px; font-variant-numeric: tabular-nums; }
.place i, .result i { font: italic 1.12em/1 "KaTeX_Math", "Cambria Math", Georgia, serif; color: var(--text-2); }
.place b, .result b { font-weight: 500; }
.rule { flex: none; width: 1px; height: 20px; background: var(--line-strong); }
.open { min-height: var(--height); text-decoration: none; }
.open:hover { text-decoration: underline; }

.result { display: flex; align-items: center; gap: 14px; overflow: hidden; color: var(--text-2); font-variant-numeric: tabular-nums; }
.result b { color: var(--text); }
.result .failed, .result .failed b { color: var(--error); }

.layers { margin-right: auto; position: relative; }
.layers summary {
  box-sizing: border-box; display: flex; align-items: center; height: var(--height); padding: 0 8px; margin-left: -8px; border-radius: 6px;
  font-weight: 500; cursor: pointer; list-style: none;
}
.layers summary::-webkit-details-marker { display: none; }
.layers summary:hover { background: var(--hover); }
.layers summary:focus-visible { outline: 2px solid var(--accent); outline-offset: -2px; }
.layers div {
  position: absolute; z-index: 5; left: 0; top: 100%; padding: 6px; border: 1px solid var(--line); border-radius: 8px;
  background: var(--field); box-shadow: var(--shadow);
}
.layers label { display: flex; align-items: center; gap: 8px; min-height: var(--height); padding: 0 8px; border-radius: 6px; cursor: pointer; }
.layers label:hover { background: var(--hover); }
.layers input {
  all: revert; position: static; width: 14px; height: 14px; margin: 0; accent-color: var(--accent); cursor: pointer;
}
.layers input:focus-visible { outline: 2px solid var(--accent); outline-offset: 2px; }

.growth { position: absolute; inset: 0; width: 100%; height: 100%; pointer-events: none; }
.growth path { fill: none; stroke-linecap: round; }
.growth .accepted { stroke: var(--text); stroke-width: 1.25; }
.growth .halo { stroke: var(--canvas); stroke-width: 6; }
.growth .winner { stroke: var(--accent); stroke-width: 3; }

.handles { position: absolute; inset: 0; overflow: hidden; pointer-events: none; }
.handle {
  --hit: 24px;
  position: absolute; top: calc(var(--hit) / -2); left: calc(var(--hit) / -2); width: var(--hit); height: var(--hit); border-radius: 50%;
  cursor: move; pointer-events: auto; touch-action: none;
}
@media (pointer: coarse) { .handle { --hit: 44px; } }
.handle::before {
  content: ""; position: absolute; inset: calc(50% - 5px); border-radius: 50%; background: #ffffff; box-shadow: inset 0 0 0 1.5px var(--handle);
}
.handle.square::before { border-radius: 2.5px; }
.handle:hover::before { background: #eceafa; }
.handle:is(:focus, .held) { z-index: 1; }
.handle:is(:focus, .held)::before { background: var(--handle); box-shadow: 0 0 0 1.5px #ffffff; }
.handle.held::after {
  content: ""; position: absolute; inset: calc(50% - 12.5px); border-radius: 50%; background: var(--accent); opacity: 0.16;
}
.handle.touched::after { inset: calc(50% - 22px); }

.spoken { position: absolute; width: 1px; height: 1px; margin: -1px; overflow: hidden; clip-path: inset(50%); white-space: nowrap; }

@container (width < 620px) { .result .crossings:not(.failed) { display: none; } }
@container (width < 440px) {
  .bar { gap: 10px; }
  .rule, .place { display: none; }
  .open { font-size: 12px; }
  .result { gap: 10px; }
}
@container (width < 300px) { .open { display: none; } }

@media (forced-colors: active) {
  .body, .problem { border: 1px solid CanvasText; }
  .play { border: 1px solid ButtonText; background: ButtonFace; color: ButtonText; }
  .slider::before { background: CanvasText; }
  input::-webkit-slider-thumb { background: ButtonFace; border: 2px solid ButtonText; }
  .handle::before { forced-color-adjust: none; }
  .open { color: LinkText; }
  .rule { background: CanvasText; }
}

@media print {
  .bar, .layers, .handles, .working, .reveal { display: none; }
  .body { break-inside: avoid; }
  .growth { z-index: 2; }
  .frame .paper[src] { display: block; z-index: 1; }
  .frame .paper[src] ~ canvas { visibility: hidden; }
  .frame[data-theme] { --canvas: #ffffff; --line: #e2e3e7; --text: #17191d; --text-2: #585d68; --accent: #4a45c8; --error: #b3261e; color-scheme: light; }
}
`;

/** The sheet for the figures of a document. */
export const sheetOf = sheetsOf(CSS);
