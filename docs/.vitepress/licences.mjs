/**
 * The licences of what the pages carry; those of the application stand in `app/licences.json`.
 *
 * @typedef {NonNullable<import("vitepress").UserConfig["vite"]>} Settings of the Vite that VitePress brings along
 * @typedef {Extract<NonNullable<Settings["plugins"]>[number], {name: string}>} Plugin
 */
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { npmPackages } from "../../scripts/lib/licences.mjs";

/** The folder that VitePress names files from. */
const docs = fileURLToPath(new URL("../", import.meta.url));

/**
 * A plugin of Vite that writes `licences.json` beside the pages: a list of packages by name.
 *
 * @returns {Plugin}
 */
export function licences() {
  let isServer = false;
  return {
    name: "licences",
    apply: "build",
    configResolved(config) {
      isServer = Boolean(config.build.ssr);
    },
    async generateBundle(_, bundle) {
      if (isServer) return;
      const files = Object.values(bundle).flatMap((each) =>
        each.type === "chunk" ? each.moduleIds : each.originalFileNames.map((name) => join(docs, name)),
      );
      const parts = await npmPackages(files);
      parts.sort((a, b) => a.name.localeCompare(b.name, "en"));
      this.emitFile({ type: "asset", fileName: "licences.json", source: `${JSON.stringify(parts, null, 1)}\n` });
    },
  };
}
