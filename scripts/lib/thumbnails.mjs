/** The small pictures of the gallery, painted by the package into `www/thumbnails`: one for each preset and theme. */
import { join } from "node:path";
import { modulesReady } from "./modules.mjs";
import { root } from "./paths.mjs";
import { run } from "./run.mjs";
import { inputs, isFresh, mark, unmark } from "./stamp.mjs";

/** The folder that the page takes them from. */
const thumbnailFolder = join(root, "www/thumbnails");

const script = "scripts/paint-thumbnails.mjs";

/** @type {import("./stamp.mjs").Made} */
const made = {
  from: ["www/presets", "js", "package.json", script, "scripts/lib/thumbnail.mjs"].map((path) => join(root, path)),
  to: [thumbnailFolder],
};

/** @type {import("./steps.mjs").Step} */
export const thumbnails = {
  name: "thumbnails",
  needs: ["packages", ...modulesReady],
  async run(log) {
    if (await isFresh("thumbnails", made)) return "fresh";
    const before = await inputs(made);
    await unmark("thumbnails");
    await run(process.execPath, [script, thumbnailFolder], { log });
    await mark("thumbnails", made, before);
  },
};
