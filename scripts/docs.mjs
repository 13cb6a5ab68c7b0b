/**
 * `npm run docs`: builds the documentation into `dist-docs`. `npm run docs -- --base /some/path/` builds it for that path of a web
 * server instead of its root; `npm run docs -- --dev` serves it instead and shows every edit at once.
 */
import { parseArgs } from "node:util";
import { documentation, layApplication, vitepress } from "./lib/documentation.mjs";
import { moduleSteps } from "./lib/modules.mjs";
import { pageSteps } from "./lib/page.mjs";
import { documentationSite } from "./lib/paths.mjs";
import { run } from "./lib/run.mjs";
import { build } from "./lib/steps.mjs";

const { values } = parseArgs({ options: { base: { type: "string", default: "/" }, dev: { type: "boolean", default: false } } });
const { base, dev } = values;
const before = [...moduleSteps(), ...pageSteps];

if (!/^\/([^/\s]+\/)*$/.test(base)) {
  console.error(`--base is ${base}: a path with a slash at both ends is needed, such as /docs/`);
  process.exitCode = 1;
} else if (dev) {
  process.once("SIGINT", () => process.exit(0));
  if (await build(before)) {
    await layApplication();
    await run(process.execPath, [vitepress, "dev", "docs", "--base", base]);
  } else {
    process.exitCode = 1;
  }
} else if (await build([...before, documentation({ base, to: documentationSite })])) {
  console.log("dist-docs is ready");
} else {
  process.exitCode = 1;
}
