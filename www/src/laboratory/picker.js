/**
 * A tap on the boundary: it chooses the group of an element, or while one is picked gives the chosen group the elements round the place.
 *
 * @import { Place } from "./reader.js"
 * @import { Bench } from "./state.js"
 */
import { ANGLE, withGroup } from "./edits.js";
import { grown, normalOf, runsOf } from "./mesh.js";
import { words } from "./words.js";

/** Digits of directions that are written. */
const DIGITS = 6;

/** @param {Bench} bench */
export function createPicker(bench) {
  return {
    /** @param {Place | null} place */
    tap(place) {
      const { known, shown } = bench.now();
      if (!known || !place || place.element === null) return;
      if (shown.picking) pick(place.element);
      else {
        const set = known.boundary.members[place.element];
        const { groups } = bench.now().document;
        bench.change({ group: groups[set] && set !== shown.group ? set : null });
      }
    },
  };

  /** @param {number} element */
  function pick(element) {
    const { document, known, shown } = bench.now();
    const at = shown.group;
    if (!known || at === null || !document.groups[at]) return;
    const { boundary, mesh } = known;
    const { angle = ANGLE } = document.groups[at].where;
    if (shown.picking === "direction") {
      const direction = normalOf(boundary, element).slice(0, boundary.dimension).map((value) => Number(value.toFixed(DIGITS)) + 0);
      bench.commit((now) => withGroup(now, at, { where: { direction, angle } }));
    } else {
      const elements = grown(boundary, mesh.joints, element, angle);
      bench.commit((now) => withGroup(now, at, { where: { elements: runsOf(elements) } }));
      bench.app.say(words.boundary.picked(elements.length));
    }
    bench.change({ picking: null });
  }
}
