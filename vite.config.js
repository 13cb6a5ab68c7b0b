import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { defineConfig } from "vite";
import { lessons } from "./scripts/lib/lesson-plugin.mjs";
import { licences } from "./scripts/lib/licences.mjs";

const { version } = JSON.parse(readFileSync(new URL("package.json", import.meta.url), "utf8"));

/** Cameras, colours and cells without the library for three dimensions. */
const SHARED = /\/(js|www\/src)\/(space\/(camera|colors|keys|vector)|hyperpatch\/cell)\.js$/;

export default defineConfig({
  root: "www",
  base: "./",
  worker: { format: "es" },
  define: { __DIRECTRIX_VERSION__: JSON.stringify(version) },
  plugins: [lessons(), licences()],
  build: {
    outDir: "../dist",
    emptyOutDir: true,
    target: "es2022",
    manifest: true,
    // The library for pictures in three dimensions is one piece; `npm run size` bounds it.
    chunkSizeWarningLimit: 650,
    // What the page needs before it can paint comes in one piece, which compresses better, whatever else needs parts of it later.
    // Small parts that several pictures of bodies share are one piece as well: the page names every piece.
    rolldownOptions: { output: { codeSplitting: { groups: [{ name: "page", tags: ["$initial"], priority: 1 }, { name: "bodies", test: SHARED }] } } },
    // A module inside a script could neither be streamed nor shared between the page and its worker.
    assetsInlineLimit: (file) => (file.endsWith(".wasm") ? false : undefined),
  },
  server: { fs: { allow: [fileURLToPath(new URL(".", import.meta.url))] } },
});
