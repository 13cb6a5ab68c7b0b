/**
 * Lets the page work without a network, and offers a new version when there is one. Nothing is exchanged under an open page: it goes on
 * with the files it was opened with, until the person reloads it. See service-worker.js.
 *
 * @import { App } from "../state/app.js"
 *
 * @typedef {"waiting" | "keeping" | "kept" | "development" | "unsupported" | "failed"} State
 *
 * @typedef {object} Offline
 * @property {State} state
 * @property {string | null} reason why it failed, in the browser's words
 * @property {boolean} ready a new version waits
 * @property {string[]} changes what it changes
 */
import { Record } from "../state/record.js";
import { words } from "./words.js";

/** Milliseconds between two looks for a new version while the page is open. */
const HOUR = 3_600_000;

/** What About tells. @type {Record<Offline>} */
export const offline = new Record(/** @type {Offline} */ ({ state: "waiting", reason: null, ready: false, changes: [] }));

/** @type {ServiceWorkerRegistration | null} */
let registration = null;
let leaving = false;

/** @param {App} app */
export async function startOffline(app) {
  // Where nothing is kept, a part may be gone from the server before it is fetched. What asked for it has its say first.
  addEventListener("vite:preloadError", () => setTimeout(() => offer(app, words.missing)));
  if (import.meta.env.DEV) {
    offline.set({ state: "development" });
    return;
  }
  try {
    if (!window.isSecureContext || !navigator.serviceWorker) {
      offline.set({ state: "unsupported" });
      return;
    }
    offline.set({ state: "keeping" });
    registration = await navigator.serviceWorker.register("./sw.js", { updateViaCache: "none" });
  } catch (error) {
    offline.set({ state: "failed", reason: error instanceof Error ? error.message : String(error) });
    return;
  }
  addManifest();
  follow(app, registration);
}

/** Lets the page be installed as an application. */
function addManifest() {
  const link = document.createElement("link");
  link.rel = "manifest";
  link.href = "./manifest.webmanifest";
  document.head.append(link);
}

/** @param {App} app @param {ServiceWorkerRegistration} registration */
function follow(app, registration) {
  /** A worker on its way, which becomes the one that keeps this page or a newer one that waits. @param {ServiceWorker | null} worker */
  const watch = (worker) => {
    if (!worker) return;
    const look = () => {
      if (worker.state === "installed" && registration.active) void announce(app, worker);
      else if (worker.state === "activated") offline.set({ state: "kept" });
      else if (worker.state === "redundant" && !registration.active) offline.set({ state: "failed" });
    };
    worker.addEventListener("statechange", look);
    look();
  };
  registration.addEventListener("updatefound", () => watch(registration.installing));
  for (const worker of [registration.active, registration.waiting, registration.installing]) watch(worker);
  registration.active?.postMessage({ type: "directrix:tidy" });
  navigator.serviceWorker.addEventListener("controllerchange", () => {
    if (leaving) location.reload();
  });
  setInterval(() => {
    if (!document.hidden) registration.update().catch(() => {});
  }, HOUR);
}

/** @param {App} app @param {ServiceWorker} worker */
async function announce(app, worker) {
  const [now, next] = await Promise.all([ownChanges(), changesOf(worker)]);
  offline.set({ ready: true, changes: next.filter((change) => !now.includes(change)) });
  offer(app, words.ready);
}

/** @param {App} app @param {string} text */
function offer(app, text) {
  app.ui.set({ note: { tone: "plain", text, command: { name: "reload", text: words.reload, act: () => void reload(app) } } });
  app.say(text);
}

/** Changes up to the build of this page. @returns {Promise<string[]>} */
async function ownChanges() {
  try {
    return (await (await fetch("./changes.json")).json()).changes;
  } catch {
    return [];
  }
}

/** Changes up to the build of a worker. @param {ServiceWorker} worker @returns {Promise<string[]>} */
function changesOf(worker) {
  const { port1, port2 } = new MessageChannel();
  return new Promise((resolve) => {
    port1.onmessage = ({ data }) => {
      port1.close();
      resolve(data?.changes ?? []);
    };
    worker.postMessage({ type: "directrix:changes" }, [port2]);
  });
}

/** Goes over to the new version, with the document as it is. @param {App} app */
export async function reload(app) {
  await app.keeper.flush();
  const waiting = registration?.waiting;
  if (!waiting) {
    location.reload();
    return;
  }
  leaving = true;
  waiting.postMessage({ type: "directrix:take-over" });
}
