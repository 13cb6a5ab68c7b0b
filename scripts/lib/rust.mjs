/** The Rust toolchain: which one is used, and its standard library for WebAssembly. */
import { existsSync } from "node:fs";
import { readFile } from "node:fs/promises";
import { join } from "node:path";
import { root } from "./paths.mjs";
import { CommandError, ask, run } from "./run.mjs";

const wasmTarget = "wasm32-unknown-unknown";

/** @type {Promise<string> | undefined} */
let found;

/**
 * What `rustc -vV` says of the compiler in use. When rustup does not have the toolchain under the name that
 * `rust-toolchain.toml` asks for and cannot fetch it, but its `stable` is that very version, then `stable` is used.
 *
 * @returns {Promise<string>}
 */
export function compiler() {
  found ??= find();
  return found;
}

async function find() {
  const version = await ask("rustc", ["-vV"]);
  if (version !== null) return version;
  const wanted = (await readFile(join(root, "rust-toolchain.toml"), "utf8")).match(/^channel = "(.*)"$/m)?.[1];
  const stable = await ask("rustc", ["-vV"], { RUSTUP_TOOLCHAIN: "stable" });
  if (stable === null || !stable.includes(`release: ${wanted}\n`)) {
    throw new CommandError(`Rust ${wanted} is missing: install rustup, then run "rustup toolchain install ${wanted}"`);
  }
  process.env.RUSTUP_TOOLCHAIN = "stable";
  return stable;
}

/**
 * The standard library for WebAssembly, added by rustup when it is missing.
 *
 * @type {import("./steps.mjs").Step}
 */
export const wasmLibrary = {
  name: "wasm32 target",
  async run(log) {
    await compiler();
    const folder = await ask("rustc", ["--print", "target-libdir", "--target", wasmTarget]);
    if (folder && existsSync(folder)) return "fresh";
    await run("rustup", ["target", "add", wasmTarget], { log });
  },
};

/** Cargo's options for the WebAssembly target. */
export const forWasm = ["--target", wasmTarget];

/** Cargo's folder of release builds for WebAssembly, below its own folder. */
export const wasmRelease = join(wasmTarget, "release");
