/**
 * Reading a part at a place: by the pointer, by a tap, and by a crosshair that the arrow keys move.
 *
 * @import { Point } from "../types.js"
 * @import { PartReading } from "./reading.js"
 * @import { Bench } from "./state.js"
 */
import { ARROWS, stride } from "../controls/arrows.js";
import { h } from "../dom.js";
import { Lane } from "../state/lane.js";
import { toPlane, toScreen } from "../view.js";
import { createCard, spokenReading } from "./card.js";
import { readingOf } from "./reading.js";
import { words } from "./words.js";

/** Milliseconds that the pointer rests before its reading is spoken. */
const REST = 600;
/** CSS pixels of one arrow key; Shift and Alt make it ten times as much and a tenth. */
const STEP = 10;

/** @param {Bench} bench */
export function createProbe(bench) {
  const { app } = bench;
  const { marks, card, ...cardOf } = createCard();
  const help = h("p", { id: "part-reader-help", class: "spoken" }, words.reader.help);
  const keyboard = h("div", { class: "part-keys", tabIndex: 0, role: "application", "aria-label": words.reader.name, "aria-describedby": help.id, "data-part-keys": "" });
  /** Where something is read, in document units. @type {Point | null} */
  let at = null;
  /** @type {PartReading | null} */
  let reading = null;
  let isKeyed = false;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let timer;

  /** @type {Lane<Point, PartReading | null>} */
  const lane = new Lane({
    async work(place, signal) {
      const { known, isCurrent } = bench.now();
      return known && isCurrent ? readingOf(await known.part.probe(place, { signal }), known.raster, place) : null;
    },
    done(found, place) {
      if (place !== at) return;
      reading = found;
      clearTimeout(timer);
      if (isKeyed) speak(place);
      else if (found) timer = setTimeout(() => speak(place), REST);
      bench.request();
    },
    failed: () => hide(),
  });

  /** @param {Point} place */
  const speak = (place) => app.say(spokenReading(bench.now().document, reading, place));

  /** @param {Point} place document units @param {boolean} byKeys */
  function read(place, byKeys) {
    [at, isKeyed] = [place, byKeys];
    lane.push(place);
    bench.request();
  }

  function hide() {
    clearTimeout(timer);
    if (!at) return;
    [at, reading, isKeyed] = [null, null, false];
    bench.request();
  }

  keyboard.addEventListener("keydown", (event) => {
    const { view, size } = bench.now();
    if (!view || event.ctrlKey || event.metaKey) return;
    const arrow = ARROWS[event.key];
    if (event.key === "Escape" && at) hide();
    else if (arrow) {
      const from = at && isKeyed ? toScreen(view, size, at) : null;
      const by = STEP * stride(event);
      const to = from ? [from[0] + arrow[0] * by, from[1] - arrow[1] * by] : [size.width / 2, size.height / 2];
      read(toPlane(view, size, [Math.min(size.width, Math.max(0, to[0])), Math.min(size.height, Math.max(0, to[1]))]), true);
    } else if (event.key === "Enter" && at && isKeyed) speak(at);
    else return;
    event.preventDefault();
    event.stopPropagation();
  });
  keyboard.addEventListener("blur", () => {
    if (isKeyed) hide();
  });

  return {
    nodes: [keyboard, help, /** @type {any} */ (marks), card],
    /** The reading by pointer. @param {Point | null} screen CSS pixels */
    hover(screen) {
      const { view, size } = bench.now();
      if (screen && view) read(toPlane(view, size, screen), false);
      else if (!isKeyed) hide();
    },
    /** What was read belongs to another document. */
    again() {
      if (at) lane.push(at);
    },
    render() {
      const { document, view, size, shown } = bench.now();
      cardOf.render(document, reading, at && view ? toScreen(view, size, at) : null, size, isKeyed);
      cardOf.witness(shown.witness && view ? toScreen(view, size, shown.witness) : null);
    },
    close() {
      clearTimeout(timer);
      lane.cancel();
    },
  };
}
