/**
 * Keeps every file of one build of the page, and answers from it without a network. The build writes the list of its files before this
 * text, so that every build is a worker of its own.
 *
 * A build is kept whole or not at all: each file is checked against its hash as it comes. A page gets all its files from the build that it was
 * opened with, also while a newer one waits or has taken over; a build goes when no open page is of it. What is not on the list is none of
 * the worker's business.
 */
(() => {
  const scope = /** @type {any} */ (globalThis);
  /** Paths below the page, `""` for the page itself, with their integrity. @type {{id: string, files: {[path: string]: string}}} */
  const { id, files } = scope.BUILD;
  /** @type {string} */
  const home = scope.registration.scope;
  /** Names of the caches of this page; another copy of it may live elsewhere on the same host. */
  const prefix = `directrix ${home} `;
  const own = prefix + id;
  /** Holds which build each open page is of, across restarts of the worker. */
  const register = `directrix-pages ${home}`;
  /** Files fetched at once. */
  const LANES = 4;

  /** @param {string} path */
  const address = (path) => new URL(path === "" ? "./" : path, home).href;

  /** @param {string} client */
  const entry = (client) => address(`page-${client}`);

  /** @returns {Promise<string[]>} names of the caches of all builds */
  const builds = async () => (await caches.keys()).filter((name) => name.startsWith(prefix));

  async function keepAll() {
    const cache = await caches.open(own);
    const left = Object.entries(files);
    const lane = async () => {
      for (let next = left.shift(); next; next = left.shift()) {
        const [path, integrity] = next;
        const response = await fetch(address(path), { integrity, cache: "no-cache" });
        if (!response.ok) throw new Error(`${path}: ${response.status}`);
        // A page must not be answered with a response that was redirected, though its content is right.
        await cache.put(address(path), response.redirected ? new Response(response.body, response) : response);
      }
    };
    try {
      await Promise.all(Array.from({ length: LANES }, lane));
    } catch (error) {
      left.length = 0;
      await caches.delete(own);
      throw error;
    }
  }

  /**
   * The build that an open page is of.
   * @param {string} client
   * @returns {Promise<string | null>} the name of its cache
   */
  async function buildOf(client) {
    if (!client) return null;
    const found = await (await caches.open(register)).match(entry(client));
    return found ? found.text() : null;
  }

  /** @param {string} client @param {string} build */
  async function enter(client, build) {
    await (await caches.open(register)).put(entry(client), new Response(build));
  }

  /** Where an address is below the page, or null outside of it. @param {string} url */
  function below(url) {
    const { href, pathname } = new URL(url);
    if (!href.startsWith(home)) return null;
    const rest = pathname.slice(new URL(home).pathname.length);
    return rest === "index.html" ? "" : rest;
  }

  /** Pages that are open here. @returns {Promise<string[]>} */
  async function pages() {
    /** @type {{id: string, url: string}[]} */
    const all = await scope.clients.matchAll({ type: "window", includeUncontrolled: true });
    return all.filter(({ url }) => Object.hasOwn(files, below(url) ?? "other")).map((client) => client.id);
  }

  /** Drops the builds that no open page is of. A page of which nobody knows keeps them all. */
  async function tidy() {
    const open = await pages();
    const used = await Promise.all(open.map(buildOf));
    const entries = await caches.open(register);
    const kept = new Set(open.map(entry));
    for (const { url } of await entries.keys()) if (!kept.has(url)) await entries.delete(url);
    const names = await builds();
    // A newer build that waits is of no page yet.
    const { waiting, installing } = scope.registration;
    if (used.includes(null) || waiting || installing) return;
    for (const name of names) if (name !== own && !used.includes(name)) await caches.delete(name);
  }

  /** @param {any} event @param {string} path */
  async function answer(event, path) {
    const { request, clientId, resultingClientId } = event;
    if (request.mode === "navigate") {
      const page = await (await caches.open(own)).match(address(path));
      if (!page) return fetch(request);
      if (resultingClientId) await enter(resultingClientId, own);
      return page;
    }
    const build = await buildOf(clientId);
    // A worker of a page is no page; names of files with a hash in them tell their build.
    const names = build === null ? [own, ...(await builds())] : [build];
    for (const name of names) {
      const found = await (await caches.open(name)).match(address(path));
      if (found) return found;
    }
    return fetch(request);
  }

  scope.addEventListener("install", (/** @type {any} */ event) => event.waitUntil(keepAll()));

  scope.addEventListener("activate", (/** @type {any} */ event) => {
    const work = async () => {
      // The first worker comes with the page that asks for it.
      if ((await builds()).length === 1) await Promise.all((await pages()).map((page) => enter(page, own)));
      await scope.clients.claim();
      await tidy();
    };
    event.waitUntil(work());
  });

  scope.addEventListener("message", (/** @type {any} */ event) => {
    const { type } = event.data ?? {};
    if (type === "directrix:take-over") scope.skipWaiting();
    if (type === "directrix:tidy") event.waitUntil(tidy());
    if (type === "directrix:changes") {
      const work = async () => {
        const found = await (await caches.open(own)).match(address("changes.json"));
        event.ports[0]?.postMessage(found ? await found.json() : null);
      };
      event.waitUntil(work());
    }
  });

  scope.addEventListener("fetch", (/** @type {any} */ event) => {
    const { request } = event;
    const path = below(request.url);
    if (request.method !== "GET" || path === null) return;
    // Files of an older build are on no list here: whatever a page asks for may be one.
    if (Object.hasOwn(files, path) || request.mode !== "navigate") event.respondWith(answer(event, path));
  });
})();
