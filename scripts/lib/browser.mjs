/** The browser of the browser tests. */
import { existsSync } from "node:fs";
import { delimiter, join } from "node:path";
import { CommandError, run } from "./run.mjs";
import { root } from "./paths.mjs";

const names = ["chromium", "chromium-browser", "google-chrome", "google-chrome-stable"];

/** Where the systems that have no PATH for it keep Chrome. */
const places = [
  "/Applications/Google Chrome.app/Contents/MacOS/Google Chrome",
  "/Applications/Chromium.app/Contents/MacOS/Chromium",
  ...[process.env.PROGRAMFILES, process.env["PROGRAMFILES(X86)"], process.env.LOCALAPPDATA]
    .filter((folder) => folder !== undefined)
    .map((folder) => join(folder, "Google/Chrome/Application/chrome.exe")),
];

/** Seconds that Playwright may take for its download: behind some proxies it neither fails nor ends. */
const downloadLimit = 300;

/**
 * The program of the browser: the one that CHROME_PATH names, else the system's Chromium or Chrome, else the one that Playwright
 * has downloaded before; `null` when there is none.
 *
 * @returns {Promise<string | null>}
 */
export async function findBrowser() {
  const named = process.env.CHROME_PATH;
  if (named) {
    if (!existsSync(named)) throw new CommandError(`CHROME_PATH names ${named}, which does not exist`);
    return named;
  }
  const folders = (process.env.PATH ?? "").split(delimiter).filter(Boolean);
  const onPath = names.flatMap((name) => folders.map((folder) => join(folder, name)));
  const { chromium } = await import("playwright-core");
  return [...onPath, ...places, chromium.executablePath()].find((path) => existsSync(path)) ?? null;
}

/**
 * Installs a browser when there is none: by Playwright's own download, else, as root on Debian, by its package manager.
 *
 * @type {import("./steps.mjs").Step}
 */
export const browser = {
  name: "browser",
  needs: ["packages"],
  async run(log) {
    if (await findBrowser()) return "fresh";
    const attempts = [download, ...(process.getuid?.() === 0 && existsSync("/usr/bin/apt-get") ? [debian] : [])];
    for (const attempt of attempts) {
      try {
        await attempt(log);
        if (await findBrowser()) return;
      } catch (error) {
        log(String(error));
      }
    }
    throw new CommandError("no browser for the browser tests: install Chromium or Chrome, or set CHROME_PATH to one");
  },
};

/** @param {import("./steps.mjs").Log} log */
async function download(log) {
  const playwright = join(root, "node_modules/playwright-core/cli.js");
  await run(process.execPath, [playwright, "install", "chromium"], { log, limit: downloadLimit });
}

/** @param {import("./steps.mjs").Log} log */
async function debian(log) {
  const env = { DEBIAN_FRONTEND: "noninteractive" };
  await run("apt-get", ["update", "-q"], { log, env });
  await run("apt-get", ["install", "-q", "-y", "--no-install-recommends", "chromium"], { log, env });
}
