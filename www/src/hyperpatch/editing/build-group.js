/**
 * Adding cells and taking them away: copies, mirror images, extrusions, subdivisions, and bodies from files; each followed by its checks.
 *
 * @import { App } from "../../state/app.js"
 * @import { Group } from "../../inspector/group.js"
 * @import { FaceName } from "../../../../js/directrix.js"
 * @import { Known } from "../runner.js"
 * @import { Shown } from "../state.js"
 * @import { Operation } from "../edits.js"
 * @import { Vector } from "../../space/vector.js"
 */
import { checkBox, segment } from "../../controls/choices.js";
import { numberField } from "../../controls/number-field.js";
import { row } from "../../controls/row.js";
import { select } from "../../controls/select.js";
import { attribute, h, write } from "../../dom.js";
import { bodyOf } from "../document.js";
import { idsOf } from "../edits.js";
import { checkLines } from "./check-lines.js";
import { words } from "./words.js";

const said = words.build;
const KINDS = /** @type {const} */ (["copy", "mirror", "extrude", "subdivide", "reorient", "delete", "import"]);
const FACES = /** @type {const} */ (["u0", "u1", "v0", "v1", "w0", "w1"]);
const FAR = 1e9;
const INSIDE = 1e-3;
/** @type {readonly Vector[]} */
const UNITS = [
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
];

/** @typedef {typeof KINDS[number]} Kind */

/** @param {string} text @param {string} unit */
const withUnit = (text, unit) => (unit ? `${text}, ${unit}` : text);

/**
 * @param {App} app
 * @param {object} of
 * @param {() => {known: Known | null, isCurrent: boolean, shown: Shown}} of.now
 * @param {() => number} of.step of lengths, document units
 * @param {(patch: Partial<Shown>) => void} of.change
 * @param {(operation: Operation) => void} of.append
 * @param {ReturnType<typeof import("./add-body.js").addBody>} of.file
 * @param {import("./checks.js").Checks} of.checks
 * @returns {Group}
 */
export function buildGroup(app, { now, step, change, append, file, checks }) {
  /** @type {Kind} */
  let kind = "copy";
  /** @type {Vector} */
  let by = [0, 0, 0];
  let isTouched = false;
  /** @type {0 | 1 | 2} */
  let plane = 0;
  let offset = 0;
  let keeps = true;
  /** Null until one is given: then it is that of a cell. @type {number | null} */
  let length = null;
  /** @type {"C1" | "free"} */
  let start = "C1";
  /** @type {"u" | "v" | "w"} */
  let axis = "u";
  let at = 0.5;

  const choice = select({ label: said.what, name: "build", choices: KINDS.map((value) => ({ value, text: said.kinds[value] })) }, (value) => {
    kind = value;
    change({ picksFaces: false });
  });
  const ways = [0, 1, 2].map((k) => {
    const name = "xyz"[k];
    return numberField(
      { label: `${said.by} ${name}`, name: `build-${name}`, prefix: name, min: -FAR, max: FAR, step, decimals: 2, rounded: true },
      {
        change(value) {
          isTouched = true;
          by = /** @type {Vector} */ (by.map((old, axis) => (axis === k ? value : old)));
          render();
        },
      },
    );
  });
  const planes = segment({ label: said.plane, name: "build-plane", choices: ["x", "y", "z"].map((value) => ({ value, text: value })) }, (value) => {
    plane = /** @type {0 | 1 | 2} */ ("xyz".indexOf(value));
    render();
  });
  const place = numberField({ label: said.place, name: "build-offset", min: -FAR, max: FAR, step, decimals: 2, rounded: true }, { change: (value) => (offset = value) });
  const keep = checkBox({ name: "build-keep", text: [said.keep] }, (on) => (keeps = on));
  const picks = checkBox({ name: "build-picks", text: [said.inPicture] }, (on) => change({ picksFaces: on }));
  const faceButtons = FACES.map((face) => h("button", { type: "button", class: "body-cell", "data-face": face, onclick: () => toggle(face) }, face));
  const facesNote = h("p", { class: "body-note" });
  const far = numberField({ label: said.length, name: "build-length", min: 1e-9, max: FAR, step, decimals: 2, rounded: true }, { change: (value) => (length = value) });
  const starts = segment({ label: said.start, name: "build-start", choices: /** @type {const} */ (["C1", "free"]).map((value) => ({ value, text: said.starts[value] })) }, (value) => {
    start = value;
    render();
  });
  const startNote = h("p", { class: "body-note" });
  const axes = segment({ label: said.axis, name: "build-axis", choices: /** @type {const} */ (["u", "v", "w"]).map((value) => ({ value, text: value })) }, (value) => (axis = value));
  const where = numberField({ label: said.at, name: "build-at", min: INSIDE, max: 1 - INSIDE, step: 0.05, decimals: 2 }, { change: (value) => (at = value) });
  const labels = { by: h("p", { class: "body-label" }), place: h("span", {}), length: h("span", {}) };
  const parts = {
    copy: h("div", {}, labels.by, h("div", { class: "body-fields" }, ...ways.map(({ element }) => element)), ...ways.map(({ error }) => error)),
    mirror: h("div", {}, row(said.plane, planes), row(labels.place, place), keep.element),
    extrude: h(
      "div",
      {},
      picks.element,
      h("div", { class: "body-faces", role: "group", "aria-label": said.faces }, ...faceButtons),
      facesNote,
      row(labels.length, far),
      row(said.start, starts),
      startNote,
    ),
    subdivide: h("div", {}, row(said.axis, axes), row(said.at, where), h("p", { class: "body-note" }, said.sheet)),
    reorient: h("p", { class: "body-note" }, said.reorientNote),
    delete: h("div", {}),
    import: file.element,
  };
  const about = h("p", { class: "body-note", "data-build-about": "" });
  const apply = h("button", { type: "button", class: "push", "data-build-apply": "", onclick: () => act() });
  const made = checkLines();

  /** How far faces go: as far as a cell of the size of the one behind the first face, until a number is given. */
  function lengthNow() {
    const { known, shown } = now();
    const id = shown.faces[0]?.cell ?? shown.cell ?? known?.cells[0]?.id;
    const volume = Math.abs(known?.cells.find((cell) => cell.id === id)?.volume ?? 1);
    return length ?? Number(Math.max(1e-9, Math.cbrt(volume)).toPrecision(2));
  }

  /** What is missing, or null. @returns {string | null} */
  function missing() {
    const { cells, faces } = now().shown;
    if (kind === "import") return null;
    if (kind === "extrude") return faces.length > 0 ? null : said.needsFaces;
    if (kind === "subdivide") return cells.length > 0 ? null : said.needsCell;
    return cells.length > 0 ? null : said.needsCells;
  }

  /** @returns {Operation} */
  function operation() {
    const { shown } = now();
    const cells = [...shown.cells];
    if (kind === "copy") return { op: "copy", cells, by };
    if (kind === "mirror") return { op: "mirror", cells, normal: UNITS[plane], offset, ...(keeps ? {} : { keep: false }) };
    if (kind === "extrude") return { op: "extrude", faces: shown.faces.map(({ cell, face }) => ({ cell, face })), by: lengthNow(), start };
    if (kind === "subdivide") return { op: "subdivide", cell: cells[cells.length - 1], axis, at };
    return { op: kind === "reorient" ? "reorient" : "delete", cells };
  }

  function act() {
    if (kind === "import" || missing() !== null) return;
    const next = operation();
    append(next);
    app.say(words.sentence(next));
    if (kind === "delete" || kind === "extrude") change({ ...(kind === "delete" ? { cell: null, cells: [], corner: null, others: [], at: null } : {}), faces: [], picksFaces: false });
  }

  /** @param {FaceName} face */
  function toggle(face) {
    const { cell, faces } = now().shown;
    if (cell === null) return;
    const is = (/** @type {{cell: number, face: string}} */ each) => each.cell === cell && each.face === face;
    change({ faces: faces.some(is) ? faces.filter((each) => !is(each)) : [...faces, { cell, face }] });
  }

  function render() {
    const { known, shown } = now();
    const { cells, cell, faces } = shown;
    // A copy lies beside its original until another way is given.
    if (!isTouched) by = [Number((step() * 100).toPrecision(2)), 0, 0];
    choice.set(kind);
    for (const name of /** @type {const} */ (["by", "place", "length"])) write(labels[name], withUnit(said[name], bodyOf(app).unit));
    for (const each of KINDS) parts[each].hidden = each !== kind;
    ways.forEach((field, k) => field.set(by[k]));
    planes.set("xyz"[plane]);
    place.set(offset);
    keep.set(keeps);
    picks.set(shown.picksFaces);
    far.set(lengthNow());
    starts.set(start);
    write(startNote, said.startNote[start]);
    axes.set(axis);
    where.set(at);
    const outer = new Set(known?.sharing.faces.filter(({ sides }) => sides.length === 1).map(({ sides: [side] }) => `${side.cell} ${side.face}`));
    for (const [n, button] of faceButtons.entries()) {
      const isOn = faces.some((each) => each.cell === cell && each.face === FACES[n]);
      button.disabled = cell === null || (!isOn && !outer.has(`${cell} ${FACES[n]}`));
      attribute(button, "aria-pressed", String(isOn));
      attribute(button, "aria-label", cell === null ? FACES[n] : said.face(cell, FACES[n]));
    }
    write(facesNote, faces.length > 0 ? said.facesChosen(faces.length) : cell === null ? said.needsFaces : words.cells.chosen(0));
    const why = missing();
    write(about, kind === "import" || kind === "extrude" ? "" : (why ?? said.of(kind === "subdivide" ? cells.slice(-1) : cells)));
    about.hidden = about.textContent === "";
    apply.hidden = kind === "import";
    if (kind !== "import") write(apply, said.apply[kind]);
    attribute(apply, "aria-disabled", why === null ? null : "true");
    attribute(apply, "title", why);
    const { operations } = bodyOf(app);
    const last = now().isCurrent ? known?.operations.find(({ id }) => id === idsOf(operations).at(-1)) : undefined;
    made.render(last && last.made.length > 0 && operations.length > 1 ? checks.of(last.id) : null);
  }

  const body = h("div", {}, row(said.what, choice), ...KINDS.map((each) => parts[each]), about, h("div", { class: "body-buttons" }, apply), made.element);
  file.listen(body);

  return {
    name: "build",
    heading: words.groups.build,
    body,
    phrase: () => said.kinds[kind],
    render,
  };
}
