/**
 * The ruling line that a click means.
 *
 * @import { App } from "../state/app.js"
 * @import { Point } from "../types.js"
 */
import { currentMatch } from "../state/app.js";
import { numbered, shownLines } from "../state/lines.js";
import { lookedAt } from "../state/look.js";
import { toPlane, toScreen } from "../view.js";

/** Pixels from a line at which a click means it. */
const ON_LINE = 8;

/**
 * The ruling line at a place: one that runs there, else the nearest in the band.
 * @param {App} app
 * @param {Point} at CSS pixels
 * @returns {Promise<number | null>}
 */
export async function lineAt(app, at) {
  const { view, size } = app.ui.value;
  if (!view) return null;
  const document = lookedAt(app);
  const aways = shownLines(currentMatch(app)).map(({ from, to }) =>
    away(at, toScreen(view, size, from), toScreen(view, size, to)),
  );
  const nearest = aways.indexOf(Math.min(...aways));
  if (nearest < 0 || aways[nearest] <= ON_LINE) return nearest < 0 ? null : nearest;
  const found = await app.kernel.probe(document, toPlane(view, size, at)).catch(() => null);
  return lookedAt(app) === document ? found && numbered(currentMatch(app), found).line : null;
}

/** Distance of a place from a straight line. @param {Point} at @param {Point} a @param {Point} b */
function away(at, a, b) {
  const [dx, dy] = [b[0] - a[0], b[1] - a[1]];
  const share = ((at[0] - a[0]) * dx + (at[1] - a[1]) * dy) / (dx * dx + dy * dy || 1);
  const t = Math.min(1, Math.max(0, share));
  return Math.hypot(at[0] - a[0] - dx * t, at[1] - a[1] - dy * t);
}
