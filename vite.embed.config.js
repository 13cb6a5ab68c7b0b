/**
 * What other pages use: `embed.html`, and `element.js` with its chunks, at addresses that stay. The application is built before, into the same
 * folder.
 */
import { fileURLToPath } from "node:url";
import { defineConfig } from "vite";

/** @param {string} path */
const at = (path) => fileURLToPath(new URL(path, import.meta.url));

/** One folder, as the element finds presets and editor beside the file that it stands in. */
const output = {
  entryFileNames: "[name].js",
  chunkFileNames: "element-[name]-[hash].js",
  assetFileNames: (/** @type {{ names: string[] }} */ { names }) => (names[0]?.endsWith(".wasm") ? "[name][extname]" : "element-[name]-[hash][extname]"),
};

export default defineConfig({
  root: "www",
  base: "./",
  publicDir: false,
  worker: { format: "es", rolldownOptions: { output: { ...output, entryFileNames: "element-[name].js" } } },
  build: {
    outDir: "../dist",
    emptyOutDir: false,
    target: "es2022",
    modulePreload: false,
    assetsInlineLimit: 0,
    rolldownOptions: {
      input: { element: at("js/element.js"), embed: at("www/embed.html") },
      preserveEntrySignatures: "strict",
      output,
    },
  },
});
