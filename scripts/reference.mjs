/** `npm run reference`: writes the tables of `docs/reference-curves.md` from what the package gives for every preset. */
import { writeFile } from "node:fs/promises";
import { moduleSteps } from "./lib/modules.mjs";
import { reference, referencePage } from "./lib/reference.mjs";
import { build } from "./lib/steps.mjs";

if (await build(moduleSteps())) {
  const { load } = await import("../js/node.js");
  await writeFile(referencePage, await reference(await load({ module: "figure" })));
} else {
  process.exitCode = 1;
}
