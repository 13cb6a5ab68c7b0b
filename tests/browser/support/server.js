/** The built page on a web server of its own, and pages made for a test. */
import { dist } from "../../../scripts/lib/paths.mjs";
import { serve } from "../../../scripts/lib/serve.mjs";

export { serve };

/**
 * Serves the built page at a free port.
 *
 * @param {object} [options]
 * @param {string} [options.base] the path that the page lives at, with a slash at both ends
 * @param {Record<string, string>} [options.headers] sent with every file, a Content-Security-Policy for example
 */
export function serveDist(options) {
  return serve(dist, options);
}
