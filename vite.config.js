import { fileURLToPath } from "node:url";
import { defineConfig } from "vite";

export default defineConfig({
  root: "www",
  base: "./",
  worker: { format: "es" },
  build: {
    outDir: "../dist",
    emptyOutDir: true,
    target: "es2022",
    manifest: true,
    // A module inside a script could neither be streamed nor shared between the page and its worker.
    assetsInlineLimit: (file) => (file.endsWith(".wasm") ? false : undefined),
  },
  server: { fs: { allow: [fileURLToPath(new URL(".", import.meta.url))] } },
});
