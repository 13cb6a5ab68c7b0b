/** What a page pays once, before the first picture. */
import { readFile } from "node:fs/promises";

/** @type {import("../scripts/lib/bench.mjs").Case[]} */
export default [
  {
    name: "compile the module figure",
    async prepare() {
      const bytes = await readFile(new URL("../js/pkg/directrix_bg.wasm", import.meta.url));
      return () => new WebAssembly.Module(bytes);
    },
  },
];
