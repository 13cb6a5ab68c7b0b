/** `npm run build`: writes the page into `dist`, ready for any folder of any web server. Fails when the modules cannot be optimised. */
import { moduleSteps } from "./lib/modules.mjs";
import { pageSteps } from "./lib/page.mjs";
import { unmark } from "./lib/stamp.mjs";
import { build } from "./lib/steps.mjs";

await unmark("page");
if (await build([...moduleSteps({ optimised: true }), ...pageSteps])) console.log("dist is ready");
else process.exitCode = 1;
