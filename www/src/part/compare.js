/**
 * The three rules for overlaps side by side, on the same body: one pointer reads all of them, and a press goes on with one.
 *
 * @import { PartBody } from "../../../js/directrix.js"
 * @import { Point, Size, View } from "../types.js"
 * @import { WholePart } from "./document.js"
 * @import { Bench } from "./state.js"
 *
 * @typedef {NonNullable<PartBody["rule"]>} Rule
 * @typedef {{rule: Rule, raster: import("../../../js/directrix.js").PartRaster}} Result
 * @typedef {{document: WholePart, body: number, isFine: boolean}} Asked
 */
import { ARROWS } from "../controls/arrows.js";
import { checkBox } from "../controls/choices.js";
import { select } from "../controls/select.js";
import { attribute, h, write } from "../dom.js";
import { fixed, percent } from "../format.js";
import { problem } from "../painter.js";
import { entry, fractionBar, NOTHING } from "../space/card.js";
import { Lane } from "../state/lane.js";
import { toPlane, toScreen } from "../view.js";
import { createCanvas } from "./canvas.js";
import { setRule } from "./edits/bodies.js";
import { colorPixels, differencePixels, differencesOf } from "./pixels.js";
import { VOXELS, wholeFrame } from "./raster.js";
import { pixelAt } from "./reading.js";
import { words } from "./words.js";

/** The rules in the order in which they stand. */
const RULES = /** @type {const} */ (["repaired", "depth", "printed"]);
/** Share of a picture that stays free at its edges. */
const MARGIN = 0.03;
/** Width of a picture over its height at most, and at least one over it. */
const WIDEST = 2.4;
/** CSS pixels that the words beside a picture take in a row, those above and below it in a column, and the gap between rules. */
const BESIDE = 240;
const AROUND = 150;
const GAP = 20;
/** Width below which words have no room beside a picture. */
const NARROW = 560;
/** Milliseconds of rest before the pictures get all their pixels. */
const REST = 180;
/** Share of the part that an arrow key with Shift moves the reading by. */
const STEP = 0.02;

/** @param {Bench} bench */
export function createCompare(bench) {
  const { app } = bench;
  /** @type {Asked | null} */
  let asked = null;
  /** @type {{document: WholePart, results: Result[]} | null} */
  let found = null;
  /** What is read, in document units. @type {Point | null} */
  let at = null;
  let names = "";
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let timer;
  /** @type {WeakMap<object, {key: string, sheet: import("./canvas.js").Sheet}>} */
  const sheets = new WeakMap();
  const cards = RULES.map(createRule);
  const bodyAt = h("div", { class: "part-rule-body" });
  /** @type {ReturnType<typeof select> | null} */
  let body = null;
  const difference = checkBox({ name: "part-compare-difference", text: [words.compare.difference] }, (on) => bench.change({ difference: on }));
  const help = h("p", { id: "part-compare-help", class: "spoken" }, words.compare.help);
  const failure = h("p", { class: "part-note failed", role: "alert", hidden: true });
  const rules = h("div", { class: "part-rules", role: "group", "aria-label": words.compare.group, "aria-describedby": help.id }, ...cards.map((card) => card.element));
  const element = h(
    "div",
    { class: "part-compare", hidden: true, "data-furniture": "", "data-part-compare": "" },
    h("div", { class: "part-compare-head" }, h("p", {}, matchMedia("(pointer: coarse)").matches ? words.compare.hintTouch : words.compare.hint), bodyAt, difference.element),
    help,
    failure,
    rules,
  );

  /** @type {Lane<Asked, Result[]>} */
  const lane = new Lane({
    async work({ document, body: of, isFine }, signal) {
      /** @type {Result[]} */
      const results = [];
      for (const rule of RULES) {
        const part = await app.kernel.part(setRule(document, of, rule), { signal });
        if (!part.box) return [];
        const frame = wholeFrame(part.box, isFine ? VOXELS.fine : VOXELS.coarse);
        results.push({ rule, raster: await part.evaluate({ ...frame, colors: true }, { signal }) });
      }
      return results;
    },
    done(results, { document, isFine }) {
      if (document !== asked?.document) return;
      failure.hidden = true;
      found = { document, results };
      bench.request();
      if (!isFine) rest();
    },
    failed(error, { document }) {
      const { name, message } = problem(error);
      if (name === "AbortError" || document !== asked?.document) return;
      failure.hidden = false;
      write(failure, message);
    },
  });

  function rest() {
    clearTimeout(timer);
    timer = setTimeout(() => {
      if (!asked) return;
      if (app.store.running) rest();
      else lane.push((asked = { ...asked, isFine: true }));
    }, REST);
  }

  /** The body that is compared: the chosen one, or the first. */
  const bodyNow = () => bench.now().shown.body ?? 0;

  /** @param {Rule} rule */
  function adopt(rule) {
    const of = bodyNow();
    bench.commit((document) => setRule(document, of, rule));
    const { document } = bench.now();
    app.say(words.compare.adopted(words.compare.rules[rule], document.bodies[of]?.name ?? ""));
  }

  /** @param {Point | null} place document units */
  function read(place) {
    at = place;
    bench.request();
  }

  /** @param {Rule} rule @param {number} nth */
  function createRule(rule, nth) {
    const { canvas, draw } = createCanvas();
    attribute(canvas, "aria-label", words.compare.rules[rule]);
    const ring = h("span", { class: "part-rule-ring", hidden: true });
    const picture = h("div", { class: "part-rule-picture" }, canvas, ring);
    const title = h("span", { class: "part-rule-title" }, words.compare.rules[rule]);
    const use = h("button", { type: "button", class: "push", "data-rule": rule, onclick: () => adopt(rule) }, words.compare.adopt);
    const differs = h("p", { class: "part-rule-differs" });
    const reading = h("div", { class: "part-rule-reading" });
    const card = h("section", { class: "part-rule", "data-part-rule": rule }, h("div", { class: "part-rule-head" }, title, use), picture, differs, h("p", { class: "part-note" }, words.compare.notes[rule]), reading);
    picture.addEventListener("pointermove", (event) => read(placeIn(event)));
    picture.addEventListener("pointerleave", (event) => {
      if (event.pointerType !== "touch") read(null);
    });
    picture.addEventListener("click", (event) => {
      if (/** @type {PointerEvent} */ (event).pointerType === "touch") read(placeIn(event));
      else adopt(rule);
    });
    use.addEventListener("keydown", (event) => {
      const arrow = ARROWS[event.key];
      if (!arrow) return;
      event.preventDefault();
      event.stopPropagation();
      if (event.shiftKey) step(arrow);
      else cards[(nth + (arrow[0] - arrow[1] > 0 ? 1 : RULES.length - 1)) % RULES.length].focus();
    });

    /** @returns {Size} */
    const sizeOf = () => ({ width: picture.clientWidth, height: picture.clientHeight });
    /** The whole of a raster in the picture. @param {Result["raster"]} raster @returns {View} */
    const viewOf = ({ box: [[left, low], [right, high]] }) => {
      const { width, height } = sizeOf();
      return { center: [(left + right) / 2, (low + high) / 2], scale: (1 - 2 * MARGIN) * Math.min(width / (right - left), height / (high - low)) };
    };
    /** @param {MouseEvent} event */
    function placeIn(event) {
      const result = found?.results[nth];
      if (!result) return null;
      const frame = picture.getBoundingClientRect();
      return toPlane(viewOf(result.raster), sizeOf(), [event.clientX - frame.left, event.clientY - frame.top]);
    }
    let drawn = "";

    return {
      element: card,
      focus: () => use.focus(),
      render() {
        const { document, shown } = bench.now();
        const result = found?.results[nth];
        const first = found?.results[0];
        const inUse = (document.bodies[bodyNow()]?.rule ?? "repaired") === rule;
        card.classList.toggle("chosen", inUse);
        attribute(use, "aria-pressed", String(inUse));
        write(use, inUse ? words.compare.current : words.compare.adopt);
        card.classList.toggle("stale", found?.document !== document);
        if (!result || !first) return;
        const { raster } = result;
        const size = sizeOf();
        const view = viewOf(raster);
        const isDifference = shown.difference && nth > 0;
        const key = isDifference ? "difference" : "colors";
        let made = sheets.get(raster);
        if (made?.key !== key) sheets.set(raster, (made = { key, sheet: { size: raster.size, box: raster.box, pixels: isDifference ? differencePixels(raster, first.raster) : colorPixels(raster) } }));
        picture.style.aspectRatio = String(ratioOf(raster));
        if (size.width > 0) draw({ view, size, theme: app.ui.value.theme, hasGrid: false, sheets: [made.sheet], broken: null });
        const { most } = nth > 0 ? differencesOf(raster, first.raster) : { most: 0 };
        write(differs, nth === 0 ? "" : most < NOTHING ? words.compare.same : words.compare.differs(percent(most)));
        const read = at ? pixelAt(raster, at) : null;
        ring.hidden = !read;
        if (read && at) {
          const [x, y] = toScreen(view, size, at);
          ring.style.transform = `translate(${x.toFixed(1)}px, ${y.toFixed(1)}px)`;
        }
        const fractions = read?.fractions ?? null;
        const text = JSON.stringify([fractions, document.materials]);
        if (text === drawn) return;
        drawn = text;
        const { materials = [] } = document;
        reading.replaceChildren(
          ...(fractions
            ? [fractionBar(fractions, materials), ...fractions.flatMap((fraction, i) => (fraction < NOTHING ? [] : [entry(materials[i]?.name ?? "", percent(fraction))]))]
            : [h("p", { class: "part-rule-none" }, words.compare.nothing)]),
        );
      },
    };
  }

  /** Wide parts stand below each other and others beside each other, whichever makes them larger. */
  function lay() {
    const raster = found?.results[0]?.raster;
    if (!raster) return;
    const { clientWidth: width, clientHeight: height } = rules;
    const ratio = ratioOf(raster);
    const inColumns = Math.min((width - 2 * GAP) / RULES.length, (height - AROUND) * ratio);
    const inRows = Math.min(width - BESIDE, ((height - 2 * GAP) / RULES.length - GAP) * ratio);
    const isInRows = width >= NARROW && inRows > inColumns;
    rules.dataset.lay = isInRows ? "rows" : "columns";
    rules.style.setProperty("--picture", `${Math.max(0, Math.floor(isInRows ? inRows : inColumns))}px`);
  }

  /** Moves what is read, and says it of every rule. @param {Point} by */
  function step(by) {
    const raster = found?.results[0]?.raster;
    if (!raster) return;
    const [[left, low], [right, high]] = raster.box;
    const from = at ?? [(left + right) / 2, (low + high) / 2];
    const way = STEP * Math.max(right - left, high - low);
    const inside = (/** @type {number} */ value, /** @type {number} */ least, /** @type {number} */ most) => Math.min(most, Math.max(least, value));
    const to = /** @type {Point} */ (at ? [inside(from[0] + by[0] * way, left, right), inside(from[1] + by[1] * way, low, high)] : from);
    read(to);
    const { materials = [] } = bench.now().document;
    app.say(
      words.card.spoken([
        words.card.place(fixed(to[0], 2), fixed(to[1], 2)),
        ...(found?.results ?? []).map((result) => {
          const fractions = pixelAt(result.raster, to)?.fractions ?? [];
          const parts = fractions.flatMap((fraction, i) => (fraction < NOTHING ? [] : [`${materials[i]?.name ?? ""} ${percent(fraction)}`]));
          return `${words.compare.rules[result.rule]}: ${parts.join(" ") || words.card.nothing}`;
        }),
      ]),
    );
  }

  return {
    element,
    render() {
      const { document, shown } = bench.now();
      element.hidden = !shown.compare;
      if (!shown.compare) {
        clearTimeout(timer);
        asked = null;
        return;
      }
      const of = bodyNow();
      if (asked?.document !== document || asked.body !== of) lane.push((asked = { document, body: of, isFine: false }));
      const key = JSON.stringify(document.bodies.map(({ name }) => name));
      if (key !== names) {
        names = key;
        body = select({ label: words.compare.body, name: "part-compare-body", choices: document.bodies.map(({ name }, i) => ({ value: String(i), text: name })) }, (value) => bench.change({ body: Number(value), feature: null }));
        bodyAt.replaceChildren(...(document.bodies.length > 1 ? [body.element] : []));
      }
      body?.set(String(of));
      difference.set(shown.difference);
      lay();
      for (const card of cards) card.render();
    },
    close() {
      clearTimeout(timer);
      lane.cancel();
    },
  };
}

/** Width of the picture of a raster over its height. @param {Result["raster"]} raster */
function ratioOf({ box: [[left, low], [right, high]] }) {
  return Math.min(WIDEST, Math.max(1 / WIDEST, (right - left) / (high - low)));
}
