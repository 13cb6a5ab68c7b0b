/** `npm run dev`: builds the modules that are stale and starts Vite's development server, which shows every edit of the page at once. */
import { moduleSteps } from "./lib/modules.mjs";
import { vite } from "./lib/page.mjs";
import { run } from "./lib/run.mjs";
import { build } from "./lib/steps.mjs";

process.once("SIGINT", () => process.exit(0));
if (await build([...moduleSteps()])) await run(process.execPath, [vite]);
else process.exitCode = 1;
