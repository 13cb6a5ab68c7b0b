/** A web server for a folder of files. */
import { createServer } from "node:http";
import { readFile } from "node:fs/promises";
import { extname, join, normalize } from "node:path";

/** @type {Record<string, string>} */
const types = {
  ".css": "text/css; charset=utf-8",
  ".html": "text/html; charset=utf-8",
  ".ico": "image/x-icon",
  ".js": "text/javascript; charset=utf-8",
  ".json": "application/json; charset=utf-8",
  ".mjs": "text/javascript; charset=utf-8",
  ".png": "image/png",
  ".svg": "image/svg+xml; charset=utf-8",
  ".txt": "text/plain; charset=utf-8",
  ".wasm": "application/wasm",
  ".webmanifest": "application/manifest+json; charset=utf-8",
  ".woff2": "font/woff2",
};

/**
 * @typedef {object} Served
 * @property {string} url the address of the folder, ending with a slash
 * @property {number} port
 * @property {() => Promise<void>} close ends it, open connections too
 */

/**
 * Serves the files of a folder on this machine alone, at `http://localhost:port` and the path `base`; nothing else is there.
 *
 * @param {string} folder
 * @param {object} [options]
 * @param {number} [options.port] 0, the default, takes a free one
 * @param {string} [options.base] a path with a slash at both ends
 * @param {Record<string, string>} [options.headers] sent with every file
 * @returns {Promise<Served>} rejected when the port is taken
 */
export async function serve(folder, { port = 0, base = "/", headers = {} } = {}) {
  /** @type {import("node:http").RequestListener} */
  const answer = async (request, response) => {
    const path = pathOf(request.url ?? "/", base);
    const file = path === null ? null : join(folder, path);
    const body = file === null ? null : await readFile(file).catch(() => null);
    if (file === null || body === null) {
      response.writeHead(404, { "content-type": "text/plain; charset=utf-8" }).end("Not found\n");
      return;
    }
    const type = types[extname(file)] ?? "application/octet-stream";
    response.writeHead(200, { "content-type": type, "cache-control": "no-cache", ...headers }).end(body);
  };

  const first = createServer(answer);
  await listen(first, port, "127.0.0.1");
  const address = first.address();
  if (address === null || typeof address === "string") throw new Error("the server has no port");
  // A browser takes "localhost" for ::1 first: another program listening there would be shown instead of this one.
  const second = createServer(answer);
  try {
    await listen(second, address.port, "::1");
  } catch (error) {
    if (code(error) === "EADDRINUSE") {
      first.close();
      throw error;
    }
  }
  return {
    url: `http://localhost:${address.port}${base}`,
    port: address.port,
    async close() {
      for (const server of [first, second]) {
        server.closeAllConnections();
        if (server.listening) await new Promise((done) => server.close(done));
      }
    },
  };
}

/** @param {unknown} error */
export const code = (error) => (error instanceof Error && "code" in error ? error.code : undefined);

/**
 * The path of a file below the folder, `null` outside it.
 *
 * @param {string} url
 * @param {string} base
 */
function pathOf(url, base) {
  let path;
  try {
    path = decodeURIComponent(new URL(url, "http://localhost").pathname);
  } catch {
    return null;
  }
  if (!path.startsWith(base) || path.includes("\0")) return null;
  const inside = normalize(path.slice(base.length));
  if (inside.startsWith("..") || inside.startsWith("/")) return null;
  return path.endsWith("/") ? join(inside, "index.html") : inside;
}

/**
 * @param {import("node:http").Server} server
 * @param {number} port
 * @param {string} host
 * @returns {Promise<void>}
 */
function listen(server, port, host) {
  return new Promise((done, fail) => {
    server.once("error", fail);
    server.listen(port, host, () => {
      server.removeListener("error", fail);
      done();
    });
  });
}
