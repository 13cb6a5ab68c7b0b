/**
 * Starts the page: kernel, document, parts, and the loop that draws them from the state.
 *
 * @import { App, Results, Ui } from "./state/app.js"
 * @import { CurvesDocument, Kernel } from "./types.js"
 */
import { connect } from "../../js/index.js";
import { explain } from "./explain.js";
import { splitView } from "./files/document-view.js";
import { completed } from "./kernel.js";
import { createBar } from "./frame/bar.js";
import { listenToDrop } from "./frame/drop.js";
import { presetDocument, presets } from "./frame/gallery.js";
import { createSheet } from "./frame/sheet.js";
import { listenToShortcuts } from "./frame/shortcuts.js";
import { createSpeech } from "./frame/speech.js";
import { createStatus } from "./frame/status.js";
import { currentTheme, followSystem } from "./frame/theme.js";
import { createInspector, FIRST_OPEN } from "./inspector/inspector.js";
import { createPainter, problem } from "./painter.js";
import { createCanvas } from "./stage/canvas.js";
import { listenToKeys } from "./stage/handle-keys.js";
import { createHandles } from "./stage/handles.js";
import { createLegend } from "./stage/legend.js";
import { createMorph } from "./stage/morph.js";
import { listenToPointer } from "./stage/pointer.js";
import { createProbe } from "./stage/probe.js";
import { createWitness } from "./stage/witness-mark.js";
import { createZoom, fit } from "./stage/zoom.js";
import { NO_RESULTS } from "./state/app.js";
import { find } from "./dom.js";
import { handleCount } from "./state/edits.js";
import { Record } from "./state/record.js";
import { keep, restore } from "./state/session.js";
import { Store } from "./state/store.js";
import { strings } from "./strings.js";

/** Layers a phone leaves out at first: at its scale the dots run into each other. */
const CROWDED = "samples";

const root = document.documentElement;

/** @returns {Promise<void>} */
async function start() {
  const kernel = await connect({ module: "figure" });
  const { document: first, edited, ui } = await firstDocument(kernel);
  const store = new Store(first);
  if (edited) store.open(first, true);
  const app = assemble(kernel, store, ui);
  run(app);
}

/**
 * The document of the last visit when there is one, else the first preset.
 * @param {Kernel} kernel
 * @returns {Promise<{document: CurvesDocument, edited: boolean, ui: Partial<Ui>}>}
 */
async function firstDocument(kernel) {
  const session = restore();
  if (session) {
    try {
      await kernel.defaults(session.document);
      return session;
    } catch {
      // Kept by another version of the page that wrote what this one does not read.
    }
  }
  const { document, ui } = splitView(await completed(kernel, presetDocument(presets[0]?.id ?? "")));
  const phone = matchMedia("(width < 600px)").matches;
  const layers = phone ? ui.layers.filter((name) => name !== CROWDED) : ui.layers;
  return { document, edited: false, ui: { ...ui, layers } };
}

/**
 * @param {Kernel} kernel
 * @param {Store} store
 * @param {Partial<Ui>} restored
 * @returns {App}
 */
function assemble(kernel, store, restored) {
  /** @type {Record<Ui>} */
  const ui = new Record({
    selection: { curve: 1, point: 2 },
    view: null,
    fitted: true,
    fitScale: 1,
    size: { width: 0, height: 0 },
    layers: [],
    s: 0.4,
    playing: false,
    theme: currentTheme(),
    probe: null,
    witness: null,
    note: null,
    open: FIRST_OPEN,
    tab: "matching",
    ...restored,
  });
  /** @type {Record<Results>} */
  const results = new Record({ ...NO_RESULTS });
  /** @type {App} */
  const app = { store, ui, results, kernel, say: createSpeech(), retry: () => {}, cancel: () => {} };
  return app;
}

/** Names the regions of the page. */
function nameRegions() {
  const regions = {
    stage: strings.canvas.region,
    "morph-controls": strings.morph.region,
    zoom: strings.canvas.zoom,
    inspector: strings.sheet.region,
    status: strings.status.region,
  };
  for (const [id, name] of Object.entries(regions)) find(`#${id}`).setAttribute("aria-label", name);
}

/** @param {App} app */
function run(app) {
  const { store, ui, results } = app;
  nameRegions();
  const painter = createPainter(app);
  app.retry = () => {
    ui.set({ note: null });
    painter.retry();
  };
  app.cancel = painter.cancel;

  const bar = createBar(app);
  createSheet(bar.panel);
  const handles = createHandles(app);
  const probe = createProbe(app);
  const morph = createMorph(app);
  const parts = [
    createCanvas(app),
    handles,
    probe,
    createWitness(app),
    createLegend(app),
    createZoom(app),
    morph,
    bar,
    createInspector(app),
    createStatus(app),
  ];
  listenToPointer(app, handles, probe);
  listenToKeys(app, handles);
  listenToShortcuts(app, { togglePlay: morph.toggle, choose: bar.choose });
  listenToDrop(app);
  followSystem(app);
  keep(app);

  const progress = find("#progress");
  let frame = 0;
  const draw = () => {
    frame = 0;
    for (const part of parts) part.render();
    painter.update();
  };
  const schedule = () => {
    if (frame === 0) frame = requestAnimationFrame(draw);
  };

  store.subscribe(() => {
    const { selection } = ui.value;
    const last = selection ? handleCount(store.document.curves[selection.curve]) - 1 : 0;
    ui.set({
      probe: null,
      witness: null,
      note: null,
      ...(selection?.point != null && selection.point > last ? { selection: { ...selection, point: last } } : {}),
    });
    schedule();
  });
  ui.subscribe((now, before) => {
    if (now.view === null && before.view !== null) refit();
    schedule();
  });
  results.subscribe((now, before) => {
    if (now.problem && now.problem.code !== before.problem?.code) app.say(explain(store.document, now.problem));
    progress.classList.toggle("shown", now.slow);
    progress.style.transform = `scaleX(${now.slow ? now.progress : 0})`;
    schedule();
  });

  const refit = () => void fit(app).catch((error) => ui.set({ note: { tone: "error", text: problem(error).message } }));
  new ResizeObserver(([entry]) => {
    if (!entry) return;
    const { width, height } = entry.contentRect;
    ui.set({ size: { width: Math.round(width), height: Math.round(height) } });
    if (ui.value.fitted || !ui.value.view) refit();
  }).observe(find("#stage"));
  schedule();
}

if (!root.dataset.plain) {
  start().catch((error) => {
    root.dataset.plain = "blocked";
    find("#plain-reason").textContent = problem(error).message;
  });
}
