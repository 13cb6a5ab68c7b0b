/** `npm run dev`: builds what is stale and starts Vite's development server, which shows every edit of the page at once. */
import { moduleSteps } from "./lib/modules.mjs";
import { vite } from "./lib/page.mjs";
import { run } from "./lib/run.mjs";
import { build } from "./lib/steps.mjs";
import { thumbnails } from "./lib/thumbnails.mjs";

process.once("SIGINT", () => process.exit(0));
if (await build([...moduleSteps(), thumbnails])) await run(process.execPath, [vite]);
else process.exitCode = 1;
