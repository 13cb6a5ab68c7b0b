/**
 * Starts the page: kernel, document, parts, and the loop that draws them from the state.
 *
 * @import { App, Results, Ui } from "./state/app.js"
 * @import { Session } from "./state/session.js"
 * @import { Kernel } from "./types.js"
 */
import { connect } from "../../js/index.js";
import { explain } from "./explain.js";
import { splitView } from "./files/document-view.js";
import { completed } from "./kernel.js";
import { createBar } from "./frame/bar.js";
import { openGallery } from "./frame/gallery.js";
import { createSheet } from "./frame/sheet.js";
import { listenToShortcuts } from "./frame/shortcuts.js";
import { createSpeech } from "./frame/speech.js";
import { createStatus } from "./frame/status.js";
import { currentTheme, followSystem } from "./frame/theme.js";
import { workbenchOf } from "./frame/workbench.js";
import { firstPreset } from "./gallery/first.js";
import { createInspector, FIRST_OPEN } from "./inspector/inspector.js";
import { later } from "./later.js";
import { createPainter, problem } from "./painter.js";
import { createCanvas } from "./stage/canvas.js";
import { listenToKeys } from "./stage/handle-keys.js";
import { createHandles } from "./stage/handles.js";
import { createMorph } from "./stage/morph.js";
import { listenToPointer } from "./stage/pointer.js";
import { createProbe } from "./stage/probe.js";
import { createReading } from "./stage/reading.js";
import { createZoom, fit } from "./stage/zoom.js";
import { NO_RESULTS } from "./state/app.js";
import { find } from "./dom.js";
import { keyWithin } from "./state/composition.js";
import { isCurves } from "./state/kind.js";
import { Record } from "./state/record.js";
import { only, within } from "./state/selection.js";
import { keep, restore, takeHash } from "./state/session.js";
import { originOf, Store } from "./state/store.js";
import { createKeeper } from "./storage/keeper.js";
import { strings } from "./strings.js";

const root = document.documentElement;

/** The workbenches of documents that are not of curves, by their kind. @type {{[kind: string]: () => Promise<(app: App) => import("./later.js").Part>}} */
const BENCHES = {
  hyperpatch: () => import("./hyperpatch/hyperpatch.js").then(({ createHyperpatch }) => createHyperpatch),
  part: () => import("./part/part.js").then(({ createPart }) => createPart),
  laplace: () => import("./laboratory/laboratory.js").then(({ createLaboratory }) => createLaboratory),
};

/** @returns {Promise<void>} */
async function start() {
  const kernel = await connect({ module: "full" });
  const former = await formerSession(kernel);
  const arrival = location.hash ? await sharing().then(({ arrive }) => arrive(kernel, former)).catch(takeHash) : null;
  const { document: first, edited, ui, kept } = former ?? arrival?.session ?? (await firstSession(kernel));
  const store = new Store(first);
  store.open(first, edited, originOf(kept ? origin(kept) : {}));
  const app = assemble(kernel, store, ui, kept);
  run(app);
  arrival?.begin(app);
  for (const type of ["popstate", "hashchange"]) {
    addEventListener(type, () => {
      app.ui.set({ workbench: workbenchOf() });
      // Read at once, before the page writes what is open now.
      const entry = restore();
      void sharing().then(({ follow }) => follow(app, entry)).catch(takeHash);
    });
  }
}

/** Reads links; loaded when the address has one. Without it the page works as if there were none. */
const sharing = () => import("./share/arrive.js");

/**
 * What this entry of the browser's history showed before, when it did: a reload goes on with it.
 * @param {Kernel} kernel
 * @returns {Promise<Session | null>}
 */
async function formerSession(kernel) {
  const session = restore();
  try {
    if (session) await completed(kernel, session.document);
    return session;
  } catch {
    // Kept by another version of the page that wrote what this one does not read.
    return null;
  }
}

/**
 * The first preset.
 * @param {Kernel} kernel
 * @returns {Promise<Session>}
 */
async function firstSession(kernel) {
  const { document, ui } = splitView(await completed(kernel, firstPreset));
  return { document, edited: false, ui, kept: null };
}

/**
 * @param {Kernel} kernel
 * @param {Store} store
 * @param {Partial<Ui>} restored
 * @param {Session["kept"]} kept
 * @returns {App}
 */
function assemble(kernel, store, restored, kept) {
  /** @type {Record<Ui>} */
  const ui = new Record({
    mode: "figure",
    span: 0,
    solid: null,
    step: 1,
    selection: only(1, 2),
    view: null,
    fitted: true,
    fitScale: 1,
    size: { width: 0, height: 0 },
    layers: [],
    isoMaterial: 0,
    patterns: false,
    look: null,
    stageLabels: false,
    composing: false,
    key: null,
    s: 0.4,
    playing: false,
    motion: { seconds: 4, easing: "ease", repeat: "swing" },
    unkept: false,
    theme: currentTheme(),
    probe: null,
    line: null,
    pin: null,
    witness: null,
    note: null,
    open: FIRST_OPEN,
    tab: "matching",
    snap: false,
    drawing: false,
    ...restored,
    workbench: workbenchOf(),
  });
  /** @type {Record<Results>} */
  const results = new Record({ ...NO_RESULTS });
  const parts = { store, ui, results, kernel, say: createSpeech(), retry: () => {}, cancel: () => {}, tool: null };
  const app = /** @type {App} */ (/** @type {unknown} */ (parts));
  app.keeper = createKeeper(app, kept);
  return app;
}

/** What a reload keeps of where the document lives. @param {NonNullable<Session["kept"]>} kept */
function origin({ name, id, stamp, file, modified }) {
  return { name, id, stamp, file, modified };
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

/** Whether lines of the picture have names. @param {Readonly<Ui>} ui */
const labelled = ({ layers, stageLabels }) =>
  layers.includes("isoComposition") || (stageLabels && layers.includes("inBetweens"));

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
  /** What shows curves, made when the first ones are open. @type {ReturnType<typeof createCurves> | null} */
  let curves = null;
  /** Kinds whose workbench could not be loaded. @type {string[]} */
  const broken = [];
  const after = later(app, () => true, () => import("./after/after.js").then(({ createAfter }) => createAfter));
  /** What belongs to curves and other documents alike. */
  const common = [
    later(
      app,
      ({ workbench }) => workbench === "lessons",
      () => import("./lessons/lessons.js").then(({ createLessons }) => createLessons),
      (error) => {
        location.hash = "#stage";
        delete root.dataset.workbench;
        ui.set({ workbench: "curves", note: { tone: "error", text: problem(error).message } });
      },
    ),
    bar,
    after,
    ...Object.entries(BENCHES).map(([kind, load]) =>
      later(app, () => store.document.kind === kind && !broken.includes(kind), load, (error) => {
        broken.push(kind);
        find("#status").textContent = problem(error).message;
      }),
    ),
  ];
  listenToShortcuts(app, { togglePlay: () => curves?.toggle(), choose: bar.choose });
  followSystem(app);
  keep(app);

  const progress = find("#progress");
  let frame = 0;
  let { document } = store;
  const draw = () => {
    frame = 0;
    const hasCurves = isCurves(store.document);
    if (hasCurves) (curves ??= createCurves(app, bar.choose)).render();
    for (const part of common) part.render();
    if (hasCurves) painter.update();
  };
  const schedule = () => {
    if (frame === 0) frame = requestAnimationFrame(draw);
  };

  store.subscribe(() => {
    if (store.document !== document) app.tool?.close();
    ({ document } = store);
    if (!isCurves(document)) {
      ui.set({ probe: null, line: null, witness: null, note: null, playing: false });
      return schedule();
    }
    if (ui.value.view === null) refit();
    ui.set({
      probe: null,
      line: null,
      witness: null,
      note: null,
      selection: within(ui.value.selection, document),
      key: keyWithin(ui.value.key, document),
      composing: ui.value.composing && document.curves.length > 0,
      isoMaterial: Math.min(ui.value.isoMaterial, document.materials.length - 1),
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

/**
 * The parts of the page that show curves and change them.
 * @param {App} app
 * @param {() => void} choose asks for a file to open
 */
function createCurves(app, choose) {
  const { store } = app;
  const handles = createHandles(app);
  const probe = createProbe(app);
  const morph = createMorph(app);
  const reading = createReading(app);
  const parts = [
    createCanvas(app),
    reading,
    handles,
    frameOf(app),
    { render: () => app.tool?.render() },
    later(
      app,
      () => store.document.curves.length === 0,
      async () => {
        const { createEmpty } = await import("./stage/empty.js");
        return () => createEmpty(app, { gallery: () => void openGallery(app), choose });
      },
    ),
    probe,
    later(app, ({ probe }) => probe !== null, () =>
      import("./stage/probe-card.js").then(({ createProbeCard }) => createProbeCard),
    ),
    later(app, ({ witness }) => witness !== null, () => import("./stage/witness-mark.js").then(({ createWitness }) => createWitness)),
    later(app, () => app.results.value.match?.diagnostics.some(({ code }) => code === "corner") ?? false, () =>
      import("./stage/corners.js").then(({ createCorners }) => createCorners),
    ),
    later(app, ({ line }) => line !== null || (store.document.matching.pins?.length ?? 0) > 0, () =>
      import("./lines/lines.js").then(({ createLines }) => createLines),
    ),
    later(app, ({ layers }) => layers.includes("difference"), () =>
      import("./harmonic/legend.js").then(({ createDifferenceLegend }) => createDifferenceLegend),
    ),
    later(app, ({ composing }) => composing, () => import("./stage/keys.js").then(({ createKeys }) => createKeys)),
    later(app, labelled, () => import("./stage/labels.js").then(({ createLabels }) => createLabels)),
    later(app, () => true, () => import("./stage/legend.js").then(({ createLegend }) => createLegend)),
    createZoom(app),
    morph,
    createInspector(app),
    createStatus(app),
  ];
  listenToPointer(app, handles, probe, reading);
  listenToKeys(app, handles);
  return {
    toggle: morph.toggle,
    render() {
      for (const part of parts) part.render();
    },
  };
}

/**
 * The frame round a selection, loaded when there is one to be framed.
 * @param {App} app
 */
function frameOf(app) {
  /** @type {Promise<{render: () => void}> | null} */
  let coming = null;
  /** @type {{render: () => void} | null} */
  let frame = null;
  return {
    render() {
      const { selection } = app.ui.value;
      if (frame) frame.render();
      else if (!coming && selection && selection.points.length !== 1) {
        coming = import("./stage/frame.js").then(({ createFrame }) => (frame = createFrame(app)));
        void coming.then((part) => part.render());
      }
    },
  };
}

if (!root.dataset.plain) {
  start().catch((error) => {
    root.dataset.plain = "blocked";
    find("#plain-reason").textContent = problem(error).message;
  });
}
