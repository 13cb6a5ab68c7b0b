/**
 * Starts a module in Node: `node scripts/smoke-module.mjs GLUE.js MODULE.wasm`. An optimiser that is too old ends with code 0
 * and leaves a module that no engine can start; this shows it before the module is used.
 */
import { readFile } from "node:fs/promises";
import { resolve } from "node:path";
import { pathToFileURL } from "node:url";

const [glue, module] = process.argv.slice(2);
if (!glue || !module) throw new Error("usage: node scripts/smoke-module.mjs GLUE.js MODULE.wasm");
const { initSync } = await import(pathToFileURL(resolve(glue)).href);
const { memory } = initSync({ module: await readFile(module) });
if (!(memory instanceof WebAssembly.Memory)) throw new Error(`${module} exports no memory`);
