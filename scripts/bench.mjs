/**
 * `npm run bench`: measures the cases of `bench/*.mjs` with the optimised WebAssembly module in Node and prints one table.
 * `npm run bench -- TEXT` measures the cases whose name holds the text. A budget that is missed is shown, and fails nothing:
 * timings depend on what else the machine does.
 */
import { readdir } from "node:fs/promises";
import { cpus } from "node:os";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { measure } from "./lib/bench.mjs";
import { moduleSteps } from "./lib/modules.mjs";
import { root } from "./lib/paths.mjs";
import { build } from "./lib/steps.mjs";

/** @typedef {import("./lib/bench.mjs").Case} Case */

/**
 * The default export of a file.
 *
 * @param {string} path below the checkout
 */
const imported = (path) => import(pathToFileURL(join(root, path)).href);

/** @param {string[]} cells */
const row = (cells) => `| ${cells.join(" | ")} |`;

async function bench() {
  const files = (await readdir(join(root, "bench"))).filter((file) => file.endsWith(".mjs")).sort();
  const all = await Promise.all(files.map(async (file) => /** @type {Case[]} */ ((await imported(`bench/${file}`)).default)));
  const text = process.argv[2] ?? "";
  const cases = all.flat().filter((each) => each.name.includes(text));
  const dx = await (await imported("js/node.js")).load({ module: "figure" });

  const [cpu] = cpus();
  console.log(`${new Date().toISOString().slice(0, 10)}, ${cpu.model}, ${cpus().length} cores, Node ${process.versions.node}, wasm32 with SIMD`);
  console.log(row(["case", "median ms", "p90 ms", "budget ms", "runs", "verdict"]));
  console.log(row(["---", "---:", "---:", "---:", "---:", "---"]));
  for (const { name, budget, prepare } of cases) {
    const { median, p90, runs } = measure(await prepare(dx));
    const verdict = budget === undefined ? "" : median <= budget ? "within" : "OVER";
    console.log(row([name, median.toFixed(2), p90.toFixed(2), `${budget ?? ""}`, `${runs}`, verdict]));
  }
}

if (await build(moduleSteps({ optimised: true }))) await bench();
else process.exitCode = 1;
