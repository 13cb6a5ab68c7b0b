/**
 * Pages that embed figures, on a server of their own: the application is another origin, as it is for everybody else.
 *
 * @import { Browser, Page } from "playwright-core"
 * @import { PageOptions } from "../support/browser.js"
 */
import { readFile } from "node:fs/promises";
import { createServer } from "node:http";
import { join } from "node:path";
import { decodeDocument } from "../../../js/link.js";
import { dist } from "../../../scripts/lib/paths.mjs";
import { withPage } from "../support/browser.js";
import { serveDist } from "../support/server.js";
import { eventually } from "../page/workbench.js";

export { eventually };

/** What a server of figures sends, so that other pages may use them. */
export const CORS = { "access-control-allow-origin": "*" };

/**
 * @typedef {object} Stage
 * @property {string} app address of the application
 * @property {string} closed address of the same application on a server that does not allow other pages to use it
 * @property {string} home address of the pages
 * @property {(body: string, options?: { headers?: Record<string, string>, head?: string }) => string} page puts a page on the server, and gives its address
 * @property {() => Promise<void>} close
 */

/** @returns {Promise<Stage>} */
export async function stage() {
  /** @type {Map<string, { html: string, headers: Record<string, string> }>} */
  const pages = new Map();
  const [open, closed] = await Promise.all([serveDist({ headers: CORS }), serveDist()]);
  const server = createServer((request, response) => {
    const found = pages.get(request.url ?? "");
    if (!found) response.writeHead(404, { "content-type": "text/plain" }).end("Not found\n");
    else response.writeHead(200, { "content-type": "text/html; charset=utf-8", ...found.headers }).end(found.html);
  });
  await new Promise((done) => server.listen(0, "127.0.0.1", () => done(undefined)));
  const address = /** @type {import("node:net").AddressInfo} */ (server.address());
  const home = `http://127.0.0.1:${address.port}`;
  return {
    app: open.url,
    closed: closed.url,
    home,
    page(body, { headers = {}, head = `<script type="module" src="${open.url}element.js"></script>` } = {}) {
      const path = `/page-${pages.size}`;
      const icon = `<link rel="icon" href="data:,">`;
      pages.set(path, {
        html: `<!doctype html><html lang="en"><head><meta charset="utf-8"><title>A page</title>${icon}${head}</head><body><main><h1>A page</h1>${body}</main></body></html>`,
        headers,
      });
      return home + path;
    },
    async close() {
      server.closeAllConnections();
      await Promise.all([open.close(), closed.close(), new Promise((done) => server.close(done))]);
    },
  };
}

/**
 * Opens a page of the stage and hands it to the test.
 *
 * @template T
 * @param {Browser} browser
 * @param {string} address
 * @param {PageOptions & { allow?: RegExp }} options
 * @param {(page: Page) => Promise<T>} test
 * @returns {Promise<T>}
 */
export const visit = (browser, address, options, test) =>
  withPage(browser, options, async (page) => {
    await page.goto(address);
    return test(page);
  });

/**
 * What a figure shows, once it stands.
 *
 * @param {Page} page
 * @param {number} [index] among the figures of the page
 */
export async function standing(page, index = 0) {
  const figure = page.locator("directrix-figure").nth(index);
  await figure.locator(".frame[data-state=shown]").waitFor({ state: "attached" });
  return figure;
}

/**
 * @param {Page} page
 * @param {number} [index]
 * @returns {Promise<{ runsIn: string | null, result: any, s: number, document: any, href: string, label: string | null, width: number, height: number }>}
 */
export function stateOf(page, index = 0) {
  return page.evaluate((index) => {
    const figure = /** @type {any} */ (document.querySelectorAll("directrix-figure")[index]);
    const { runsIn, result, s, document: shown, shadowRoot } = figure;
    const canvas = shadowRoot.querySelector("canvas");
    const { width, height } = canvas;
    return { runsIn, result, s, document: shown, href: shadowRoot.querySelector(".open").href, label: canvas.getAttribute("aria-label"), width, height };
  }, index);
}

/**
 * The pixels of the canvas of a figure, from a copy: the browser complains about a canvas that is read back again and again.
 *
 * @param {Page} page
 * @param {number} index
 * @returns {Promise<import("playwright-core").JSHandle<ImageData>>}
 */
function pixels(page, index) {
  return page.evaluateHandle((index) => {
    const figure = /** @type {any} */ (document.querySelectorAll("directrix-figure")[index]);
    const canvas = figure.shadowRoot.querySelector("canvas");
    const copy = document.createElement("canvas");
    [copy.width, copy.height] = [canvas.width, canvas.height];
    const context = /** @type {CanvasRenderingContext2D} */ (copy.getContext("2d", { willReadFrequently: true }));
    context.drawImage(canvas, 0, 0);
    return context.getImageData(0, 0, copy.width, copy.height);
  }, index);
}

/**
 * The colour of the canvas of a figure at a place, 0 to 1 across and down.
 *
 * @param {Page} page
 * @param {number} x
 * @param {number} y
 * @param {number} [index]
 */
export async function colorAt(page, x, y, index = 0) {
  return (await pixels(page, index)).evaluate(
    ({ data, width, height }, [x, y]) => {
      const start = 4 * (Math.floor(y * height) * width + Math.floor(x * width));
      return [...data.slice(start, start + 4)];
    },
    [x, y],
  );
}

/** The number of colours on the canvas of a figure. @param {Page} page @param {number} [index] */
export async function colors(page, index = 0) {
  return (await pixels(page, index)).evaluate(({ data }) => new Set(new Uint32Array(data.buffer)).size);
}

/** The document of a preset, as it is served. @param {string} name */
export const preset = async (name) => JSON.parse(await readFile(join(dist, "presets", `${name}.json`), "utf8"));

/** The document in a link to the editor. @param {string | undefined} href */
export const linked = (href) => decodeDocument(new URLSearchParams((href ?? "").split("#")[1]).get("s") ?? "");
