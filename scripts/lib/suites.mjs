/** Everything that `npm test` checks once the modules and the page are there. */
import { existsSync } from "node:fs";
import { readdir } from "node:fs/promises";
import { join } from "node:path";
import { findBrowser } from "./browser.mjs";
import { documentation, tested } from "./documentation.mjs";
import { modules, modulesReady, wasmLane } from "./modules.mjs";
import { root, target } from "./paths.mjs";
import { CommandError, ask, run } from "./run.mjs";
import { secondChance } from "./second-chance.mjs";
import { compiler, forWasm } from "./rust.mjs";

/** @typedef {import("./steps.mjs").Step} Step */

/** Seconds that one test file may take, the slow start of a browser on a busy machine included. */
const fileLimit = 240;

/** The lane of everything that cargo does in `target/debug`. */
const host = "host";

/**
 * Whether cargo keeps what it needs to compile a part of a crate again: it costs a sixth of the time of a fresh build, and a checkout that is built once
 * has no use for it. Where somebody works with cargo it is there already.
 */
const incremental = existsSync(join(target, "debug", "incremental")) ? {} : { CARGO_INCREMENTAL: "0" };

/**
 * A step that runs cargo.
 *
 * @param {Pick<Step, "name" | "lane" | "needs">} step
 * @param {() => string[] | Promise<string[]>} options
 * @param {Record<string, string>} [env]
 * @returns {Step}
 */
const cargo = (step, options, env) => ({
  ...step,
  async run(log) {
    await compiler();
    await run("cargo", await options(), { log, env: { CARGO_TERM_COLOR: "never", ...incremental, ...env } });
  },
});

/**
 * The runner of Rust tests: nextest where it is installed.
 *
 * @param {string[]} options
 * @param {string} profile
 */
async function rustRunner(options, profile) {
  const nextest = (await ask("cargo", ["nextest", "--version"])) !== null;
  return nextest
    ? ["nextest", "run", "--locked", "--no-fail-fast", "--cargo-profile", profile, ...options]
    : ["test", "--locked", "--no-fail-fast", "--profile", profile, "--bins", "--lib", "--tests", ...options];
}

/**
 * A step that runs test files with Node.
 *
 * @param {Pick<Step, "name" | "lane" | "needs">} step
 * @param {string} folder
 * @param {{ env?: () => Promise<Record<string, string>>, again?: number }} [how] `again`: how many files with failures are run once more
 * @returns {Step}
 */
const node = (step, folder, { env, again = 0 } = {}) => ({
  ...step,
  async run(log) {
    const entries = await readdir(join(root, folder), { recursive: true });
    const files = entries.filter((path) => path.endsWith(".test.js")).map((path) => join(folder, path));
    if (files.length === 0) throw new CommandError(`no test in ${folder}`);
    const added = { NO_COLOR: "1", ...(await env?.()) };
    const options = ["--test-reporter=spec", "--test-force-exit"];
    const runner = (/** @type {string} */ file, /** @type {import("./steps.mjs").Log} */ each) =>
      run(process.execPath, [...options, file], { log: each, env: added, limit: fileLimit });
    await secondChance(log, again, runner, files.sort());
  },
});

/** @type {Step[]} */
export const suites = [
  cargo({ name: "format" }, () => ["fmt", "--all", "--check"]),
  cargo({ name: "clippy", lane: host }, () => [
    ...["clippy", "--locked", "--workspace", "--all-targets", "--all-features", "--", "-D", "warnings"],
  ]),
  cargo({ name: "Rust tests", lane: host }, () => rustRunner(["--all-features"], "test")),
  cargo({ name: "xtask tests", needs: ["xtask"], lane: "tool" }, () => rustRunner(["--package", "xtask"], "tool")),
  // In the release profile, whose build scripts and macros the compilation of the modules has built already.
  ...modules.map(({ name, features }) =>
    cargo({ name: `clippy wasm32 ${name}`, needs: ["wasm32 target"], lane: wasmLane }, () => [
      ...["clippy", "--locked", "--release", "--lib", ...forWasm, "--no-default-features", "--features", features],
      ...["--", "-D", "warnings"],
    ]),
  ),
  cargo({ name: "doc tests", lane: host }, () => ["test", "--locked", "--doc", "--all-features"]),
  cargo({ name: "rustdoc", lane: host }, () => ["doc", "--locked", "--no-deps", "--all-features"], { RUSTDOCFLAGS: "-D warnings" }),
  {
    name: "types",
    needs: ["packages", ...modulesReady],
    run: (log) => run(process.execPath, [join(root, "node_modules/typescript/bin/tsc"), "-p", "jsconfig.json"], { log }),
  },
  node({ name: "Node tests", needs: ["packages", ...modulesReady] }, "tests/node"),
  documentation(tested),
  // After what the host compiles: a page on a machine that is busy otherwise shows things later than its tests look.
  node({ name: "browser tests", lane: host, needs: ["page", documentation(tested).name, "browser"] }, "tests/browser", {
    env: async () => ({ CHROME_PATH: (await findBrowser()) ?? "" }),
    again: 3,
  }),
];
