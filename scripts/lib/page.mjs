/** The page, and what other pages embed, built by Vite into `dist`. */
import { cp } from "node:fs/promises";
import { join } from "node:path";
import { modulesReady } from "./modules.mjs";
import { writeOffline } from "./offline.mjs";
import { dist, root } from "./paths.mjs";
import { run } from "./run.mjs";
import { inputs, isFresh, mark, unmark } from "./stamp.mjs";
import { thumbnails } from "./thumbnails.mjs";

/** @type {import("./stamp.mjs").Made} */
const made = {
  from: [
    ...["www", "js", "vite.config.js", "vite.embed.config.js", "package.json", "package-lock.json"],
    ...["CHANGELOG.md", "scripts/lib/offline.mjs"],
    ...["lesson", "lesson-facts", "lesson-plugin", "lesson-text"].map((name) => `scripts/lib/${name}.mjs`),
  ].map((path) => join(root, path)),
  to: [dist],
};

/** Vite's command line, run with Node. */
export const vite = join(root, "node_modules/vite/bin/vite.js");

/** @type {import("./steps.mjs").Step} */
const page = {
  name: "page",
  needs: ["packages", ...modulesReady, thumbnails.name],
  async run(log) {
    if (await isFresh("page", made)) return "fresh";
    const before = await inputs(made);
    await unmark("page");
    await run(process.execPath, [vite, "build", "--logLevel", "warn"], { log });
    await run(process.execPath, [vite, "build", "--config", "vite.embed.config.js", "--logLevel", "warn"], { log });
    await cp(join(root, "www/presets"), join(dist, "presets"), { recursive: true });
    // Last, as it lists every file.
    await writeOffline(dist);
    await mark("page", made, before);
  },
};

/** The steps that build the page once the modules are there. */
export const pageSteps = [thumbnails, page];
