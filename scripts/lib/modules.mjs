/** The two WebAssembly modules: compiled by cargo, bound by xtask, optimised by wasm-opt, tried, and put into `js/pkg`. */
import { copyFile, mkdir, readdir, rm } from "node:fs/promises";
import { homedir } from "node:os";
import { join } from "node:path";
import { copies } from "./copies.mjs";
import { pkg, root, target, work } from "./paths.mjs";
import { packages, versionOf } from "./packages.mjs";
import { CommandError, run } from "./run.mjs";
import { compiler, forWasm, wasmLibrary, wasmRelease } from "./rust.mjs";
import { inputs, isFresh, mark, unmark } from "./stamp.mjs";

/**
 * @typedef {object} Module
 * @property {string} name as `load({ module })` says it
 * @property {string} file the name of its files
 * @property {string} features of the crate
 *
 * @typedef {import("./steps.mjs").Step} Step
 */

/** @type {Module[]} */
export const modules = [
  { name: "figure", file: "directrix", features: "curves" },
  { name: "full", file: "directrix_full", features: "curves,hyperpatch,part,import,edit,explain,paths,stack,amounts,solid,svg,field,laplace,harmonic" },
];

/** The lane of everything that cargo does in its folder for releases. */
export const wasmLane = "wasm release";

/** The oldest major version of binaryen whose output was tried: an older one breaks a module and reports no error. */
const oldestBinaryen = 132;

/**
 * The inputs of each module when its compilation started.
 *
 * @type {Map<string, string>}
 */
const started = new Map();

/**
 * The steps that bring `js/pkg` up to date, and what they need before.
 *
 * @param {{ optimised?: boolean }} [options] `optimised`: fail without binaryen instead of leaving the modules unoptimised
 * @returns {Step[]}
 */
export function moduleSteps({ optimised = false } = {}) {
  return [packages, copies, wasmLibrary, helper, ...modules.map(compile), ...modules.map((module) => bind(module, optimised))];
}

/** The names of the steps after which the modules are ready. */
export const modulesReady = [copies.name, ...modules.map((module) => `bind ${module.name}`)];

/**
 * The build helper.
 *
 * @type {Step}
 */
const helper = {
  name: "xtask",
  needs: ["packages"],
  lane: "tool",
  async run(log) {
    const [version, optimiser] = await Promise.all([compiler(), binaryen()]);
    const current = await Promise.all(modules.map((module) => isFresh(module.file, made(module, version, optimiser))));
    if (current.every(Boolean)) return "fresh";
    await run("cargo", ["build", "--locked", "--profile", "tool", "--package", "xtask"], { log });
  },
};

/**
 * @param {Module} module
 * @returns {Step}
 */
const compile = (module) => ({
  name: `compile ${module.name}`,
  needs: ["packages", "wasm32 target"],
  lane: wasmLane,
  async run(log) {
    const output = made(module, await compiler(), await binaryen());
    if (await isFresh(module.file, output)) return "fresh";
    started.set(module.file, await inputs(output));
    await run("cargo", ["fetch", "--locked", ...forWasm], { log });
    await run(
      "cargo",
      [
        ...["build", "--locked", "--release", "--lib", ...forWasm, "--no-default-features", "--features", module.features],
        ...["--config", `target.wasm32-unknown-unknown.rustflags=${JSON.stringify(await shortPaths())}`],
      ],
      { log, env: { RUSTFLAGS: undefined } },
    );
    await mkdir(join(work, module.file), { recursive: true });
    await copyFile(join(target, wasmRelease, "directrix.wasm"), join(work, module.file, "compiled.wasm"));
  },
});

/**
 * @param {Module} module
 * @param {boolean} optimised
 * @returns {Step}
 */
const bind = (module, optimised) => ({
  name: `bind ${module.name}`,
  needs: ["packages", "xtask", `compile ${module.name}`],
  async run(log) {
    const optimiser = await binaryen();
    if (optimised && optimiser === null) throw new CommandError(`npm package binaryen is missing: run "npm ci"`);
    const output = made(module, await compiler(), optimiser);
    const before = started.get(module.file);
    if (before === undefined) return "fresh";
    const folder = join(work, module.file);
    const wasm = join(folder, `${module.file}_bg.wasm`);
    await run(join(target, "tool", "xtask"), ["bindings", folder, `${module.file}=${join(folder, "compiled.wasm")}`], { log });
    if (optimiser === null) log(`UNOPTIMISED: npm package binaryen is missing, so the module ${module.name} is larger and slower`);
    else await run(process.execPath, [join(root, "node_modules/binaryen/bin/wasm-opt"), "-O3", wasm, "-o", wasm], { log });
    await run(process.execPath, ["scripts/smoke-module.mjs", join(folder, `${module.file}.js`), wasm], { log });
    await unmark(module.file);
    await mkdir(pkg, { recursive: true });
    for (const file of filesOf(module)) await copyFile(join(folder, file), join(pkg, file));
    await rm(folder, { recursive: true });
    await mark(module.file, output, before);
  },
});

/**
 * @param {Module} module
 * @param {string} version of the compiler
 * @param {string | null} optimiser
 * @returns {import("./stamp.mjs").Made}
 */
const made = (module, version, optimiser) => ({
  from: ["src", "Cargo.toml", "Cargo.lock", ".cargo/config.toml", "rust-toolchain.toml", "xtask", "scripts/lib/modules.mjs"].map(
    (path) => join(root, path),
  ),
  to: filesOf(module).map((file) => join(pkg, file)),
  with: [module, version, optimiser],
});

/** @param {Module} module */
const filesOf = ({ file }) => [`${file}.js`, `${file}.d.ts`, `${file}_bg.wasm`, `${file}_bg.wasm.d.ts`];

/** The version of the installed binaryen, `null` when it is missing. */
async function binaryen() {
  const version = await versionOf("binaryen");
  if (version !== null && Number.parseInt(version, 10) < oldestBinaryen) {
    throw new CommandError(`binaryen ${version} is too old: ${oldestBinaryen} or later is needed; run "npm ci"`);
  }
  return version;
}

/**
 * Flags that keep the paths of this machine out of the messages in the module: those of the packages' sources, fetched before.
 *
 * @returns {Promise<string[]>}
 */
async function shortPaths() {
  const sources = join(process.env.CARGO_HOME || join(homedir(), ".cargo"), "registry", "src");
  const folders = await readdir(sources).catch(() => []);
  return folders.map((folder) => `--remap-path-prefix=${join(sources, folder)}=crates`);
}
