/** The documentation as a site: the pages of `docs`, built by VitePress, with the application beside them. */
import { cp, mkdir, rm } from "node:fs/promises";
import { basename, join, relative } from "node:path";
import { dist, root, work } from "./paths.mjs";
import { run } from "./run.mjs";
import { inputs, isFresh, mark, unmark } from "./stamp.mjs";

/** What VitePress puts beside the pages as it is: the application in `app/`, and the mark. */
export const applicationFolder = join(work, "documentation/beside");

/** VitePress's command line, run with Node. */
export const vitepress = join(root, "node_modules/vitepress/bin/vitepress.js");

/** The site that the tests open, which has a folder of its own on its server. */
export const tested = { base: "/some/docs/", to: join(work, "documentation/site") };

/** Lays the built application beside the pages. */
export async function layApplication() {
  await rm(applicationFolder, { recursive: true, force: true });
  await mkdir(applicationFolder, { recursive: true });
  const filter = (/** @type {string} */ path) => !relative(dist, path).startsWith(".vite");
  await cp(dist, join(applicationFolder, "app"), { recursive: true, filter });
  await cp(join(root, "www/mark.svg"), join(applicationFolder, "mark.svg"));
}

/**
 * The step that builds the site.
 *
 * @param {object} site
 * @param {string} site.base the path that it is served at, with a slash at both ends
 * @param {string} site.to the folder that it is written to
 * @returns {import("./steps.mjs").Step}
 */
export const documentation = ({ base, to }) => ({
  name: "documentation",
  needs: ["page"],
  async run(log) {
    /** @type {import("./stamp.mjs").Made} */
    const made = {
      from: [
        ...["docs", "dist", "tests/golden", "www/mark.svg", "package-lock.json"].map((path) => join(root, path)),
        join(root, "scripts/lib/documentation.mjs"),
      ],
      to: [to],
      with: [base, to],
    };
    const stamp = `documentation-${basename(to)}`;
    if (await isFresh(stamp, made)) return "fresh";
    const before = await inputs(made);
    await unmark(stamp);
    await layApplication();
    await run(process.execPath, [vitepress, "build", "docs", "--base", base, "--outDir", to], { log });
    await mark(stamp, made, before);
  },
});
