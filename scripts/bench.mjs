/**
 * `npm run bench`: measures the cases of `bench/*.mjs` with the optimised WebAssembly module in Node and prints one table, then
 * those of `bench/tables`, some of which watch the page in a browser. `npm run bench -- TEXT` takes the cases and tables whose name holds the text. A budget that is missed
 * is shown, and fails nothing: timings depend on what else the machine does.
 */
import { readdir } from "node:fs/promises";
import { cpus } from "node:os";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { measure } from "./lib/bench.mjs";
import { moduleSteps } from "./lib/modules.mjs";
import { pageSteps } from "./lib/page.mjs";
import { root } from "./lib/paths.mjs";
import { build } from "./lib/steps.mjs";

/**
 * @typedef {import("./lib/bench.mjs").Case} Case
 *
 * @typedef {object} Table
 * @property {string} name
 * @property {(dx: any) => AsyncIterable<string>} table takes the API of the module `figure` in Node and gives lines of Markdown
 */

/**
 * The default export of a file.
 *
 * @param {string} path below the checkout
 */
const imported = (path) => import(pathToFileURL(join(root, path)).href);

/** @param {string[]} cells */
const row = (cells) => `| ${cells.join(" | ")} |`;

/**
 * The modules of a folder.
 *
 * @param {string} folder
 */
async function modulesIn(folder) {
  const files = (await readdir(join(root, folder))).filter((file) => file.endsWith(".mjs")).sort();
  return Promise.all(files.map((file) => imported(`${folder}/${file}`)));
}

async function bench() {
  const text = process.argv[2] ?? "";
  const isMeant = (/** @type {{name: string}} */ { name }) => name.includes(text);
  const cases = (await modulesIn("bench")).flatMap((module) => /** @type {Case[]} */ (module.default)).filter(isMeant);
  const tables = /** @type {Table[]} */ (await modulesIn("bench/tables")).filter(isMeant);
  const dx = await (await imported("js/node.js")).load({ module: "figure" });

  const [cpu] = cpus();
  console.log(`${new Date().toISOString().slice(0, 10)}, ${cpu.model}, ${cpus().length} cores, Node ${process.versions.node}, wasm32 with SIMD`);
  if (cases.length > 0) {
    console.log(row(["case", "median ms", "p90 ms", "budget ms", "runs", "verdict"]));
    console.log(row(["---", "---:", "---:", "---:", "---:", "---"]));
  }
  for (const { name, budget, prepare } of cases) {
    const { median, p90, runs } = measure(await prepare(dx));
    const verdict = budget === undefined ? "" : median <= budget ? "within" : "OVER";
    console.log(row([name, median.toFixed(2), p90.toFixed(2), `${budget ?? ""}`, `${runs}`, verdict]));
  }
  for (const { name, table } of tables) {
    console.log(`\n${name}:\n`);
    for await (const line of table(dx)) console.log(line);
  }
}

if (await build([...moduleSteps({ optimised: true }), ...pageSteps])) await bench();
else process.exitCode = 1;
