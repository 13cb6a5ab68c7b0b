/**
 * The groups of the chosen feature: what it is measured to and its material, and the profile with its plot.
 *
 * @import { PartCourse, PartFeature } from "../../../../js/directrix.js"
 * @import { Group } from "../../inspector/group.js"
 * @import { WholePart } from "../document.js"
 * @import { At } from "../edits/features.js"
 * @import { Bench } from "../state.js"
 * @import { HandleId } from "./plot.js"
 * @import { Profile } from "./course.js"
 */
import "../../../styles/part-profile.css";
import { segment } from "../../controls/choices.js";
import { mixingControl } from "../../controls/mixing.js";
import { numberField } from "../../controls/number-field.js";
import { row } from "../../controls/row.js";
import { textField } from "../../controls/text-field.js";
import { attribute, h, write } from "../../dom.js";
import { fixed, percent } from "../../format.js";
import { icon } from "../../icons.js";
import { withFraction } from "../../state/mix.js";
import { addKey, defaultOf, FAR, featureAt, firstCourse, keysOf, mixesOf, patchFeature, pure, removeKey, renameFeature, setCourse, setEnd, setKey, setLimit } from "../edits/features.js";
import { materialsOf } from "../edits/materials.js";
import { nice, reachOf } from "./axes.js";
import { profileOf, throughMiddle } from "./course.js";
import { expression } from "./expression.js";
import { expressionField, faultIn, faultOf } from "./expression-field.js";
import { picker } from "./picker.js";
import { createPlot, decimalsOf } from "./plot.js";
import { createReference } from "./reference.js";
import { words } from "./words.js";

const MIXTURE = "mixture";
const COURSES = /** @type {PartCourse["kind"][]} */ (Object.keys(words.courses));

/** @param {Bench} bench @returns {At | null} the chosen feature, where there is one */
function chosenFeature(bench) {
  const { document, shown } = bench.now();
  const at = shown.body !== null && shown.feature !== null ? { body: shown.body, feature: shown.feature } : null;
  return at && featureAt(document, at) ? at : null;
}

/** @param {Bench} bench @returns {Group[]} */
export function createProfileGroups(bench) {
  return [featureGroup(bench), profileGroup(bench)];
}

/** @param {Bench} bench */
function editing(bench) {
  /** @param {(document: WholePart, at: At) => WholePart} change @param {string} [run] */
  const commit = (change, run) => {
    const at = chosenFeature(bench);
    if (at) bench.commit((document) => change(document, at), run);
  };
  return { commit, end: bench.endRun, cancel: (/** @type {string} */ run) => void bench.app.store.cancel(run) };
}

/** @param {Bench} bench @returns {Group} */
function featureGroup(bench) {
  const { commit } = editing(bench);
  const none = h("p", { class: "part-note" }, words.none);
  const name = textField({ label: words.name, name: "feature-name" }, (text) => commit((document, at) => renameFeature(document, at, text)));
  const reference = createReference(bench, () => chosenFeature(bench));
  const swatch = h("span", { class: "part-swatch", "aria-hidden": "true" });
  const material = picker({ label: words.material, name: "part-material" }, (value) =>
    commit((document, at) => {
      const mix = pure(Number(value), materialsOf(document).length);
      return keysOf(featureAt(document, at)).length > 0 ? setKey(document, at, 0, { mix }) : setEnd(document, at, "start", mix);
    }),
  );
  material.element.prepend(swatch);
  const reason = h("p", { class: "part-fault", hidden: true, "data-part-fault": "" });
  const rows = h("div", {}, row(words.name, name), reference.element, row(words.material, material), reason);
  return {
    name: "feature",
    heading: words.groups.feature,
    body: h("div", {}, none, rows),
    phrase() {
      const at = chosenFeature(bench);
      return at ? (featureAt(bench.now().document, at)?.name ?? "") : words.noneShort;
    },
    render() {
      const { document, known, isCurrent } = bench.now();
      const at = chosenFeature(bench);
      const feature = at && featureAt(document, at);
      none.hidden = feature !== null;
      rows.hidden = !feature;
      if (!feature || !at) return;
      name.set(feature.name ?? "");
      reference.render(document, at, feature);
      const materials = materialsOf(document);
      const [first = []] = mixesOf(feature);
      const only = first.indexOf(1);
      const choices = materials.map((each, k) => ({ value: String(k), text: each.name }));
      material.set(only >= 0 ? String(only) : MIXTURE, only >= 0 ? choices : [{ value: MIXTURE, text: words.mixture, disabled: true }, ...choices]);
      swatch.style.backgroundColor = materials[only]?.color ?? "transparent";
      swatch.hidden = only < 0;
      if (!isCurrent) return;
      const fault = known?.part.diagnostics.find((each) => each.body === at.body && each.feature === at.feature) ?? null;
      write(reason, fault?.message ?? "");
      reason.hidden = fault === null;
      reason.classList.toggle("remark", fault?.skipped === false);
    },
  };
}

/** @param {Bench} bench @returns {Group} */
function profileGroup(bench) {
  const { app } = bench;
  const { commit, end, cancel } = editing(bench);
  /** What is chosen in the plot, and of which feature. */
  let seen = { of: "", handle: /** @type {HandleId} */ ("start"), material: /** @type {number | null} */ (null) };
  /** @type {{at: At, feature: PartFeature, profile: Profile, standard: number[], involved: number[]} | null} */
  let now = null;

  /** @param {Partial<typeof seen>} patch */
  function see(patch) {
    seen = { ...seen, ...patch };
    render();
  }

  const plot = createPlot({
    choose(handle) {
      if (seen.handle !== handle) see({ handle });
    },
    move: (handle, to, run) => moveHandle(handle, to, run),
    end,
    cancel,
    insert,
    remove: (handle) => removeAt(Number(handle.split(" ")[1])),
  });

  /** @param {HandleId} handle @param {{distance: number, fraction: number}} to @param {string} run */
  function moveHandle(handle, to, run) {
    if (!now) return;
    const { feature, involved } = now;
    const [material] = involved;
    const mixWith = (/** @type {number[]} */ mix) => withFraction(mix, material, to.fraction, involved);
    const { start = [], end: last = [], course = { kind: "linear" } } = feature;
    commit((document, at) => {
      switch (handle) {
        case "from":
        case "to":
          return setLimit(document, at, handle, to.distance);
        case "start":
          return setEnd(document, at, "start", mixWith(start));
        case "end":
          return setEnd(document, at, "end", mixWith(last));
        case "middle": {
          const next = throughMiddle(course, (to.fraction - start[material]) / (last[material] - start[material]));
          return next ? setCourse(document, at, next) : document;
        }
        default: {
          const index = Number(handle.split(" ")[1]);
          const key = keysOf(feature)[index];
          const { from = 0 } = feature;
          if (!key) return document;
          const isLevel = Math.abs(key.mix[material] - to.fraction) < 1e-9;
          return setKey(document, at, index, { at: (to.distance - from) / (feature.to - from), ...(isLevel ? {} : { mix: mixWith(key.mix) }) });
        }
      }
    }, run);
    tell(handle);
  }

  /** Says where a handle is. @param {HandleId} handle */
  function tell(handle) {
    const at = chosenFeature(bench);
    const feature = at && featureAt(bench.now().document, at);
    if (!feature || !now) return;
    const { unit = "" } = bench.now().document;
    const length = (/** @type {number} */ value) => `${fixed(value, decimalsOf(stepOf(feature.to)))}\u00a0${unit}`.trim();
    const [material] = now.involved;
    const share = (/** @type {number} */ value) => words.plot.share(materialsOf(bench.now().document)[material].name, percent(value));
    if (handle === "from") return app.say(length(feature.from ?? 0));
    if (handle === "to") return app.say(length(feature.to));
    if (handle === "start" || handle === "end") return app.say(share(feature[handle]?.[material] ?? 0));
    if (handle === "middle") return app.say(share(profileOf(feature, now.standard).plain(0.5)[material]));
    const key = keysOf(feature)[Number(handle.split(" ")[1])];
    const { from = 0 } = feature;
    if (key) app.say(`${share(key.mix[material])}, ${words.plot.at(length(from + key.at * (feature.to - from)))}`);
  }

  /** @param {number} distance */
  function insert(distance) {
    if (!now || now.feature.course?.kind !== "piecewise") return;
    const { feature, profile } = now;
    const share = (distance - profile.from) / (feature.to - profile.from);
    /** @type {number | null} */
    let index = null;
    commit((document, at) => {
      const made = addKey(document, at, share, profile.plain(Math.min(1, Math.max(0, share))));
      index = made.index;
      return made.document;
    });
    app.say(index === null ? words.noRoom : words.keyAdded);
    if (index === null) return;
    see({ handle: `key ${index}` });
    plot.focus(`key ${index}`);
  }

  /** @param {number} index */
  function removeAt(index) {
    if (!now || keysOf(now.feature).length < 2) return;
    const hadFocus = document.activeElement instanceof HTMLElement && document.activeElement.dataset.plotHandle !== undefined;
    commit((doc, at) => removeKey(doc, at, index));
    app.say(words.keyRemoved);
    /** @type {HandleId} */
    const handle = `key ${Math.max(0, index - 1)}`;
    see({ handle });
    if (hadFocus) plot.focus(handle);
  }

  const chips = h("div", { class: "plot-chips", role: "group", "aria-label": words.plot.curves });
  let chipped = "";
  const course = picker({ label: words.course, name: "part-course" }, (value) => {
    const kind = /** @type {PartCourse["kind"]} */ (value);
    if (now && now.feature.course?.kind !== kind) {
      const first = firstCourse(kind, now.feature, now.profile.plain);
      commit((document, at) => setCourse(document, at, first));
    }
  });
  const step = () => (now ? stepOf(now.feature.to) : 1);
  const limit = (/** @type {"from" | "to"} */ which) => {
    const field = numberField(
      { label: which === "from" ? words.fromLabel : words.toLabel, name: `part-${which}`, prefix: words[which], min: 0, max: FAR, step, decimals: 1 },
      { change: (value, run) => commit((document, at) => setLimit(document, at, which, value), run), end, cancel },
    );
    return field;
  };
  const [from, to] = [limit("from"), limit("to")];
  const limitsLabel = h("span", {});
  /** @param {string} label @param {string} name @param {number} min @param {number} max @param {number} by @param {(value: number) => PartCourse} make @param {boolean} [whole] */
  const numberRow = (label, name, min, max, by, make, whole = false) => {
    const field = numberField(
      { label, name, min, max, step: by, decimals: whole ? 0 : 2, whole },
      { change: (value, run) => commit((document, at) => setCourse(document, at, make(value)), run), end, cancel },
    );
    return { field, element: row(label, field) };
  };
  const power = numberRow(words.power, "part-power", 0.01, 100, 0.1, (value) => ({ kind: "power", power: value }));
  // A rate of 0 would be no exponential function.
  const rate = numberRow(words.rate, "part-rate", -100, 100, 0.1, (value) => ({ kind: "exponential", rate: Math.abs(value) < 0.005 ? 0.005 : value }));
  const waves = numberRow(words.waves, "part-waves", 1, 1000, 1, (value) => ({ kind: "periodic", waves: value }), true);
  const text = expressionField({
    label: words.textLabel,
    name: "part-expression",
    help: words.textHelp,
    check: async (typed) => {
      const at = chosenFeature(bench);
      return at ? faultOf(bench, at, "course.text", (document) => setCourse(document, at, { kind: "expression", text: typed }), expression(typed, ["d", "t"]) !== null) : null;
    },
    change: (typed, run) => commit((document, at) => setCourse(document, at, { kind: "expression", text: typed }), run),
    end,
    cancel,
  });
  const textRow = h("div", { class: "expression-rows" }, h("p", { class: "part-label" }, words.text), text.element);

  const whichEnd = segment(
    { label: words.mixAt, name: "part-end", choices: /** @type {const} */ (["start", "end"]).map((value) => ({ value, text: words.ends[value] })) },
    (handle) => see({ handle }),
  );
  const endRow = row(words.mixAt, whichEnd);
  const keyName = h("span", { class: "part-key-name number" });
  const stepKey = (/** @type {1 | -1} */ by, /** @type {string} */ label) => {
    const button = h("button", { type: "button", class: "bare icon-only", "aria-label": label, title: label }, /** @type {any} */ (icon("right")));
    if (by < 0) button.classList.add("turned");
    button.addEventListener("click", () => {
      const count = keysOf(now?.feature ?? null).length;
      see({ handle: `key ${(keyIndex() + by + count) % count}` });
    });
    return button;
  };
  const keyAt = numberField(
    { label: words.keyAtLabel, name: "part-key-at", prefix: words.plot.at("").trim(), min: 0, max: FAR, step, decimals: 1 },
    {
      change: (value, run) =>
        commit((document, at) => {
          const feature = featureAt(document, at);
          const { from: low = 0, to: high = 1 } = feature ?? {};
          return setKey(document, at, keyIndex(), { at: (value - low) / (high - low) });
        }, run),
      end,
      cancel,
    },
  );
  const addOne = h("button", { type: "button", class: "command-word", "data-action": "add-key" }, words.addKey);
  addOne.addEventListener("click", () => {
    const keys = keysOf(now?.feature ?? null);
    if (!now || keys.length === 0) return;
    const index = keyIndex();
    const [low, high] = index + 1 < keys.length ? [keys[index].at, keys[index + 1].at] : keys[index].at < 1 ? [keys[index].at, 1] : [keys[index - 1]?.at ?? 0, keys[index].at];
    insert(now.profile.from + ((low + high) / 2) * (now.feature.to - now.profile.from));
  });
  const removeOne = h("button", { type: "button", class: "command-word", "data-action": "remove-key" }, words.removeKey);
  removeOne.addEventListener("click", () => removeAt(keyIndex()));
  const keyRows = h(
    "div",
    {},
    h("div", { class: "row" }, keyName, h("span", { class: "row-controls" }, stepKey(-1, words.previousKey), stepKey(1, words.nextKey), keyAt.element), keyAt.error),
    h("div", { class: "part-commands" }, addOne, removeOne),
  );
  const mixing = mixingControl({
    change: (mix, run) =>
      commit((document, at) => (isKeyed() ? setKey(document, at, keyIndex(), { mix }) : setEnd(document, at, seen.handle === "end" ? "end" : "start", mix)), run),
    end,
    cancel,
  });
  const tick = h("span", {}, /** @type {any} */ (icon("check")));
  const remark = h("span", {});
  const meet = h("button", { type: "button", class: "command-word", "data-action": "meet-default" }, words.meet);
  meet.addEventListener("click", () => {
    if (!now) return;
    const { standard, feature, profile } = now;
    commit((document, at) => {
      const keys = keysOf(feature);
      if (keys.length > 0) return patchFeature(document, at, { course: { kind: "piecewise", keys: keys.map((key, k) => ((k === 0 && !profile.meets[0]) || (k === keys.length - 1 && !profile.meets[1]) ? { ...key, mix: standard } : key)) } });
      return patchFeature(document, at, { ...(profile.meets[1] ? {} : { end: standard }), ...(profile.meets[0] ? {} : { start: standard }) });
    });
  });
  const verdict = h("div", { class: "part-meets", "data-part-meets": "" }, tick, remark, meet);
  const none = h("p", { class: "part-note" }, words.none);
  const rows = h(
    "div",
    {},
    plot.element,
    chips,
    row(words.course, course),
    h("div", { class: "row" }, h("span", { class: "row-label" }, limitsLabel), h("span", { class: "row-controls" }, from.element, to.element), from.error, to.error),
    power.element,
    rate.element,
    waves.element,
    textRow,
    verdict,
    endRow,
    keyRows,
    mixing.element,
  );

  const isKeyed = () => now?.feature.course?.kind === "piecewise";
  /** The chosen key; the first where none is. */
  function keyIndex() {
    const count = keysOf(now?.feature ?? null).length;
    const wanted = seen.handle.startsWith("key") ? Number(seen.handle.split(" ")[1]) : 0;
    return Math.min(wanted, Math.max(0, count - 1));
  }

  function render() {
    const { document, known, isCurrent } = bench.now();
    const at = chosenFeature(bench);
    const feature = at && featureAt(document, at);
    none.hidden = feature !== null;
    rows.hidden = !feature;
    if (!at || !feature) {
      now = null;
      return;
    }
    const of = `${app.store.origin.name} ${at.body}.${at.feature}`;
    if (seen.of !== of) seen = { of, handle: "start", material: null };
    const materials = materialsOf(document);
    const standard = defaultOf(document, at.body);
    const profile = profileOf(feature, standard);
    const involved = involvedOf(feature, standard, seen.material);
    now = { at, feature, profile, standard, involved };
    const { unit = "" } = document;
    const isPrinted = document.bodies[at.body].rule === "printed";
    const kind = feature.course?.kind ?? "linear";
    const isPieces = kind === "piecewise";
    const chosen = isPieces && !["from", "to"].includes(seen.handle) ? /** @type {HandleId} */ (`key ${keyIndex()}`) : seen.handle;
    plot.render({ feature, profile, standard, isPrinted, materials, involved, unit, chosen });
    renderChips(materials, involved);
    course.set(kind, COURSES.map((value) => ({ value, text: words.courses[value] })));
    write(limitsLabel, words.limits(unit));
    from.set(feature.from ?? 0);
    to.set(feature.to);
    power.element.hidden = kind !== "power";
    rate.element.hidden = kind !== "exponential";
    waves.element.hidden = kind !== "periodic";
    textRow.hidden = kind !== "expression";
    if (feature.course?.kind === "power") power.field.set(feature.course.power);
    if (feature.course?.kind === "exponential") rate.field.set(feature.course.rate);
    if (feature.course?.kind === "periodic") waves.field.set(feature.course.waves);
    if (feature.course?.kind === "expression") text.set(feature.course.text, isCurrent && known ? faultIn(known.part.diagnostics, at, "course.text") : null);
    endRow.hidden = isPieces;
    keyRows.hidden = !isPieces;
    const keys = keysOf(feature);
    const key = keys[keyIndex()];
    if (key) {
      write(keyName, words.plot.key(keyIndex(), keys.length));
      keyAt.set(Number((profile.from + key.at * (feature.to - profile.from)).toPrecision(9)));
      removeOne.disabled = keys.length < 2;
    }
    const isEnd = seen.handle === "end";
    whichEnd.set(isEnd ? "end" : "start");
    const mix = key?.mix ?? (isEnd ? feature.end : feature.start) ?? standard;
    mixing.render({ materials: /** @type {any} */ (materials), mix, used: involved, three: null });
    renderVerdict(profile, isPrinted, unit);
  }

  /** @param {Profile} profile @param {boolean} isPrinted @param {string} unit */
  function renderVerdict({ from: low, to, meets, taper }, isPrinted, unit) {
    verdict.hidden = to <= low;
    const isMet = meets[0] && meets[1];
    tick.hidden = !isMet;
    meet.hidden = isMet;
    verdict.classList.toggle("warned", !isMet);
    const width = `${fixed(taper, 1 + decimalsOf(nice(taper)))}\u00a0${unit}`.trim();
    const which = !meets[0] && !meets[1] ? "both" : meets[1] ? "from" : "to";
    write(remark, isMet ? (low > 0 ? words.meetsBoth : words.meets) : isPrinted ? words.led.printed : words.led[which](width));
  }

  /** @param {readonly {name: string, color: string}[]} materials @param {readonly number[]} involved */
  function renderChips(materials, involved) {
    const shown = [...involved].sort((a, b) => a - b);
    chips.hidden = shown.length < 3;
    const next = JSON.stringify(shown.map((k) => [k, materials[k].name, materials[k].color]));
    if (next !== chipped) {
      chipped = next;
      chips.replaceChildren(
        ...shown.map((k) => {
          const swatch = h("span", { class: "part-swatch" });
          swatch.style.backgroundColor = materials[k].color;
          return h("button", { type: "button", class: "plot-chip", "data-plot-material": k, onclick: () => see({ material: k }) }, swatch, materials[k].name);
        }),
      );
    }
    [...chips.children].forEach((chip, n) => attribute(chip, "aria-pressed", String(shown[n] === involved[0])));
  }

  return {
    name: "profile",
    heading: words.groups.profile,
    body: h("div", {}, none, rows),
    phrase() {
      const at = chosenFeature(bench);
      const feature = at && featureAt(bench.now().document, at);
      return feature ? words.courses[feature.course?.kind ?? "linear"].toLowerCase() : words.noneShort;
    },
    render,
  };
}

/** A step of a distance within a band. @param {number} to */
const stepOf = (to) => nice(reachOf(to).most / 200);

/**
 * The materials that a profile has some of, the one first whose fraction changes most, or the one that is wanted.
 * @param {PartFeature} feature
 * @param {readonly number[]} standard
 * @param {number | null} wanted
 */
function involvedOf(feature, standard, wanted) {
  const mixes = [...mixesOf(feature), standard];
  const some = standard.map((_, k) => k).filter((k) => mixes.some((mix) => mix[k] > 0));
  const [first] = mixes;
  const change = (/** @type {number} */ k) => first[k] - standard[k] + 0.001 * first[k];
  const [most] = [...some].sort((a, b) => change(b) - change(a));
  const own = wanted !== null && some.includes(wanted) ? wanted : most;
  return [own, ...some.filter((k) => k !== own)];
}
