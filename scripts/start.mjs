/**
 * `npm start`: installs and builds what is missing, serves the page on this machine and prints its address. PORT chooses the
 * port; without it the first free one from 5173 on is taken. Ctrl-C ends it.
 */
import { moduleSteps } from "./lib/modules.mjs";
import { pageSteps } from "./lib/page.mjs";
import { dist } from "./lib/paths.mjs";
import { code, serve } from "./lib/serve.mjs";
import { build } from "./lib/steps.mjs";

const firstPort = 5173;
const ports = 100;

/** @returns {Promise<import("./lib/serve.mjs").Served>} */
async function serveOnFreePort() {
  const chosen = process.env.PORT;
  if (chosen) {
    const port = Number(chosen);
    if (!Number.isInteger(port) || port < 0 || port > 65535) throw new Error(`PORT is ${chosen}: a number from 0 to 65535 is needed`);
    return serve(dist, { port }).catch((error) => {
      throw code(error) === "EADDRINUSE" ? new Error(`PORT is ${port}: another program uses this port`) : error;
    });
  }
  for (let port = firstPort; port < firstPort + ports; port++) {
    try {
      return await serve(dist, { port });
    } catch (error) {
      if (code(error) !== "EADDRINUSE") throw error;
    }
  }
  throw new Error(`no free port from ${firstPort} to ${firstPort + ports - 1}: choose one with PORT`);
}

if (await build([...moduleSteps(), ...pageSteps])) {
  try {
    const served = await serveOnFreePort();
    console.log(`Directrix: ${served.url} (Ctrl-C ends it)`);
    for (const signal of ["SIGINT", "SIGTERM"]) process.once(signal, () => served.close().then(() => process.exit(0)));
  } catch (error) {
    console.error(error instanceof Error ? error.message : error);
    process.exitCode = 1;
  }
} else {
  process.exitCode = 1;
}
