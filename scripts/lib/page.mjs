/** The page, built by Vite into `dist`. */
import { join } from "node:path";
import { modulesReady } from "./modules.mjs";
import { writeOffline } from "./offline.mjs";
import { dist, root } from "./paths.mjs";
import { run } from "./run.mjs";
import { inputs, isFresh, mark, unmark } from "./stamp.mjs";
import { thumbnails } from "./thumbnails.mjs";

/** @type {import("./stamp.mjs").Made} */
const made = {
  from: ["www", "js", "vite.config.js", "package.json", "package-lock.json", "CHANGELOG.md", "scripts/lib/offline.mjs"].map((path) => join(root, path)),
  to: [dist],
};
// What turns the texts of lessons into what the page shows.
made.from.push(...["lesson", "lesson-facts", "lesson-plugin", "lesson-text"].map((name) => join(root, `scripts/lib/${name}.mjs`)));

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
    await writeOffline(dist);
    await mark("page", made, before);
  },
};

/** The steps that build the page once the modules are there. */
export const pageSteps = [thumbnails, page];
