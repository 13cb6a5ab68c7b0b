/** How npm is started, from `npm run` and without it. */

/**
 * The program and the options that stand before those of npm.
 *
 * @returns {[string, ...string[]]}
 */
export function npm() {
  const path = process.env.npm_execpath;
  if (path?.endsWith("js")) return [process.execPath, path];
  return [process.platform === "win32" ? "npm.cmd" : "npm"];
}
