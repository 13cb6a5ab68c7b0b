/**
 * The groups beside the picture: body, solver, section and display. That of the boundary has a file of its own.
 *
 * @import { Group } from "../inspector/group.js"
 * @import { StandardView } from "../space/camera.js"
 * @import { Bench } from "./state.js"
 *
 * @typedef {object} Acts
 * @property {(view: StandardView) => void} look
 * @property {() => import("../space/vector.js").Vector} back from the body to the eye
 * @property {() => import("./face.js").Face | null} face
 */
import { checkBox, segment } from "../controls/choices.js";
import { numberField } from "../controls/number-field.js";
import { row } from "../controls/row.js";
import { select } from "../controls/select.js";
import { slider } from "../controls/slider.js";
import { attribute, h, write } from "../dom.js";
import { fixed } from "../format.js";
import { problem } from "../painter.js";
import { fact } from "../space/card.js";
import { measure, numberText } from "../space/measure.js";
import { AXES } from "../space/section.js";
import { viewButtons } from "../space/stand.js";
import { middleOf, scaled } from "../space/vector.js";
import { MOST } from "./document.js";
import { solverOf, withModel, withSolver } from "./edits.js";
import { dimensionOf, isNamed, modelOf, MODELS, valueOf } from "./models.js";
import { openStl, takeBody } from "./new-body.js";
import { acrossOf, extentOf, flipped, placed, placeOf, through } from "./section-state.js";
import { words } from "./words.js";

/** Largest coordinate of the format, and steps of the slider of the plane. */
const FAR = 1e9;
const STEPS = 1000;

/**
 * @param {Bench} bench
 * @returns {Group & {open: (file: File) => Promise<{isOpen: boolean, text: string}>}} with opening an STL, which is told of beside its button
 */
export function modelGroup(bench) {
  const text = words.model;
  const kinds = select(
    { label: text.kind, name: "lab-model", choices: [...Object.keys(MODELS), "mesh"].map((value) => ({ value, text: text.kinds[value] })) },
    (kind) => {
      const now = bench.now().document.model;
      // Boxes and planes of a body of one's own are far from a named one.
      if (now.kind === "mesh" && kind !== "mesh") void take(kind);
      else if (kind !== "mesh") bench.commit((document) => (document.model.kind === kind ? document : withModel(document, modelOf(kind))));
      bench.request();
    },
  );
  const fields = h("div", {});
  const facts = h("div", {});
  const error = h("p", { class: "field-error", hidden: true, role: "alert", "data-lab-import-error": "" });
  const file = h("input", { type: "file", accept: ".stl,model/stl", hidden: true, "aria-label": text.import, "data-lab-stl": "" });
  file.addEventListener("change", () => {
    const [chosen] = file.files ?? [];
    if (chosen) void open(chosen);
    file.value = "";
  });
  const told = h("p", { class: "lab-note lab-told", hidden: true, "data-lab-told": "" });
  /** The body that what is told belongs to. @type {import("./document.js").Model | null} */
  let toldOf = null;
  const button = h("button", { type: "button", class: "push", "data-lab-import": "", onclick: () => file.click() }, text.import);
  const note = h("p", { class: "lab-note" }, text.importNote);
  /** @type {{[field: string]: {element: HTMLElement, error?: HTMLElement, set: (value: number) => void}}} */
  let made = {};
  let madeFor = "";

  /** @param {import("./models.js").Field} field @param {number} value as it stands */
  function control({ name, min, max, step, whole, choices }, value) {
    const label = text.fields[name];
    const change = (/** @type {number} */ next, /** @type {string} */ run) => bench.commit((now) => withModel(now, { ...now.model, [name]: next }), run);
    if (!choices) return numberField({ label, name: `lab-${name}`, min, max, step, decimals: whole ? 0 : 2, whole }, { change: /** @type {any} */ (change), end: bench.endRun, cancel: bench.takeBack });
    const all = choices.includes(value) ? choices : [...choices, value].sort((a, b) => b - a);
    const chosen = select({ label, name: `lab-${name}`, choices: all.map((each) => ({ value: String(each), text: each === 0 ? text.none : numberText(each) })) }, (next) => bench.commit((now) => withModel(now, { ...now.model, [name]: Number(next) })));
    return { element: chosen.element, set: (/** @type {number} */ next) => chosen.set(String(next)) };
  }

  /** @param {File} chosen */
  async function open(chosen) {
    const found = await openStl(bench, chosen);
    tell(found.isOpen, found.text);
    return found;
  }

  /** A named shape after one of the person's own. @param {string} kind */
  async function take(kind) {
    try {
      const set = await takeBody(bench, modelOf(kind), text.kinds[kind]);
      bench.app.say(set);
      tell(true, set);
    } catch (reason) {
      tell(false, problem(reason).message);
    }
  }

  /** @param {boolean} isTaken @param {string} message */
  function tell(isTaken, message) {
    error.hidden = isTaken;
    write(error, isTaken ? "" : message);
    if (isTaken) {
      toldOf = bench.now().document.model;
      write(told, message);
    }
    bench.request();
  }

  return {
    name: "model",
    heading: text.heading,
    body: h("div", {}, row(text.kind, kinds), fields, facts, h("div", { class: "lab-acts" }, button, file), error, told, note),
    open,
    phrase() {
      const { document, known } = bench.now();
      const name = text.kinds[document.model.kind] ?? "";
      return known ? text.phrase(name, fixed(known.mesh.count, 0), text.elements(known.mesh.count, known.boundary.dimension)) : name;
    },
    render() {
      const { document, known, isCurrent } = bench.now();
      const { model } = document;
      kinds.set(model.kind);
      for (const option of kinds.element.querySelectorAll("option")) option.hidden = option.value === "mesh" && model.kind !== "mesh";
      const all = isNamed(model) ? MODELS[model.kind].fields : [];
      // Among powers of ten stands the one of the document as well.
      const key = JSON.stringify([model.kind, ...all.flatMap((field) => (field.choices ? [valueOf(model, field)] : []))]);
      if (madeFor !== key) {
        madeFor = key;
        made = Object.fromEntries(all.map((field) => [field.name, control(field, valueOf(model, field))]));
        fields.replaceChildren(...all.map(({ name }) => row(text.fields[name], made[name])));
      }
      for (const field of all) made[field.name].set(valueOf(model, field));
      told.hidden = model !== toldOf;
      note.hidden = !told.hidden;
      facts.classList.toggle("stale", !isCurrent);
      if (!known) return;
      const { count } = known.mesh;
      facts.replaceChildren(
        fact(text.count, `${fixed(count, 0)} ${text.elements(count, known.boundary.dimension)}`, "elements"),
        ...(known.solution ? [fact(text.size(known.boundary.dimension), measure(known.solution.measure, bench.now().document.unit ?? "", known.boundary.dimension), "size")] : []),
      );
    },
  };
}

/** @param {Bench} bench @returns {Group} */
export function solverGroup(bench) {
  const text = words.solver;
  const commit = (/** @type {Partial<import("./document.js").Solver>} */ patch, /** @type {string} */ run) => bench.commit((document) => withSolver(document, patch), run);
  const method = segment(
    { label: text.method, name: "lab-method", choices: /** @type {const} */ (["gmres", "lu"]).map((value) => ({ value, text: text.methods[value] })) },
    (value) => bench.commit((document) => withMethod(document, value)),
  );
  const preconditioner = segment(
    { label: text.preconditioner, name: "lab-preconditioner", choices: /** @type {const} */ (["none", "jacobi", "ssor"]).map((value) => ({ value, text: text.preconditioners[value] })) },
    (value) => bench.commit((document) => withSolver(document, { preconditioner: value })),
  );
  const editing = { change: (/** @type {number} */ omega, /** @type {string} */ run) => commit({ omega }, run), end: bench.endRun, cancel: bench.takeBack };
  const omega = slider({ label: text.omega, name: "lab-omega", min: 0.05, max: 1.95, step: 0.05 }, /** @type {any} */ (editing));
  const omegaField = numberField({ label: text.omega, name: "lab-omega-value", min: 0.01, max: 1.99, step: 0.05, decimals: 2 }, /** @type {any} */ (editing));
  omegaField.element.classList.add("short");
  const tolerances = Object.entries(text.tolerances).map(([value, each]) => ({ value, text: each }));
  const tolerance = select({ label: text.tolerance, name: "lab-tolerance", choices: tolerances }, (value) => bench.commit((document) => withSolver(document, { tolerance: Number(value) })));
  const restart = numberField(
    { label: text.restart, name: "lab-restart", min: 1, max: 1000, step: 5, decimals: 0, whole: true },
    { change: (value, run) => commit({ restart: value }, /** @type {string} */ (run)), end: bench.endRun, cancel: bench.takeBack },
  );
  const rows = { preconditioner: row(text.preconditioner, preconditioner), omega: row(text.omega, omega, omegaField), tolerance: row(text.tolerance, tolerance), restart: row(text.restart, restart) };
  const note = h("p", { class: "lab-note" }, text.mostLu);
  const compare = h("button", { type: "button", class: "push", "data-lab-compare": "", onclick: () => bench.change({ look: "solvers" }) }, text.compare);
  return {
    name: "solver",
    heading: text.heading,
    body: h("div", {}, row(text.method, method), ...Object.values(rows), note, h("div", { class: "lab-acts" }, compare)),
    phrase() {
      const { method: chosen, preconditioner: by } = solverOf(bench.now().document);
      return text.phrase(text.methods[chosen], chosen === "gmres" ? text.preconditioners[by] : "");
    },
    render() {
      const { document, known, shown } = bench.now();
      const solver = solverOf(document);
      method.set(solver.method);
      preconditioner.set(solver.preconditioner);
      omega.set(solver.omega);
      omegaField.set(solver.omega);
      tolerance.set(/** @type {any} */ (tolerances.find(({ value }) => Number(value) === solver.tolerance)?.value ?? ""));
      restart.set(solver.restart);
      const isGmres = solver.method === "gmres";
      for (const each of Object.values(rows)) each.hidden = !isGmres;
      rows.omega.hidden = !isGmres || solver.preconditioner !== "ssor";
      note.hidden = !known || known.mesh.count <= MOST.lu;
      compare.hidden = shown.look === "solvers";
    },
  };
}

/** A document with another method: what belongs to GMRES alone is left out with LU. @param {import("./document.js").LaboratoryDocument} document @param {"gmres" | "lu"} method */
function withMethod(document, method) {
  if (method === "gmres") return withSolver(document, { method });
  const { dense } = document.solver;
  return { ...document, solver: /** @type {import("./document.js").Solver} */ ({ method, ...(dense === undefined ? {} : { dense }) }) };
}

/** @param {Bench} bench @param {Acts} acts @returns {Group} */
export function sectionGroup(bench, { back, face }) {
  const text = words.section;
  const axis = segment(
    { label: text.axis, name: "lab-axis", choices: /** @type {const} */ (["off", "x", "y", "z", "own"]).map((value) => ({ value, text: text.axes[value] })) },
    (value) => {
      const { known } = bench.now();
      if (!known) return;
      const middle = middleOf(known.mesh.bounds);
      bench.commit(({ section, ...rest }) => {
        if (value === "off") return rest;
        // What is towards the eye of the first view is taken away, across the view what is towards the eye as it stands.
        const normal = value === "own" ? scaled(back(), -1) : value === "y" ? AXES.y : scaled(AXES[value], -1);
        return { ...rest, section: through(normal, middle) };
      });
    },
  );
  const move = (/** @type {number} */ place, /** @type {string | undefined} */ run) => {
    const { known } = bench.now();
    bench.commit((document) => (document.section && known?.mesh.soup ? { ...document, section: placed(document.section, place, extentOf(document.section, known.mesh.soup.positions)) } : document), run);
  };
  const place = slider({ label: text.field, name: "lab-at", min: 0, max: STEPS, step: 1 }, { change: (at, run) => move(fromShare(at / STEPS), run), end: bench.endRun, cancel: bench.takeBack });
  const field = numberField(
    { label: text.field, name: "lab-place", min: -FAR, max: FAR, step: () => stepOf(), decimals: 2, rounded: true },
    { change: (value, run) => move(value, run), end: bench.endRun, cancel: bench.takeBack },
  );
  field.element.classList.add("lab-place");
  const other = h("button", { type: "button", class: "push", "data-lab-flip": "", onclick: () => bench.commit((document) => (document.section ? { ...document, section: flipped(document.section) } : document)) }, text.other);
  const facts = h("div", {});
  const on = h("div", {}, row(text.at, place, field), h("div", { class: "lab-acts" }, other), facts, h("p", { class: "lab-note" }, text.note));

  const axisRow = row(text.axis, axis);
  const none = h("p", { class: "lab-note" }, text.none);

  /** @returns {[number, number]} */
  function extent() {
    const { document, known } = bench.now();
    return document.section && known?.mesh.soup ? extentOf(document.section, known.mesh.soup.positions) : [0, 1];
  }
  const fromShare = (/** @type {number} */ share) => extent()[0] + share * (extent()[1] - extent()[0]);
  const stepOf = () => (extent()[1] - extent()[0]) / 100;

  return {
    name: "section",
    heading: text.heading,
    body: h("div", {}, axisRow, on, none),
    phrase() {
      const { section } = bench.now().document;
      return section ? text.value(acrossOf(section), fixed(placeOf(section), 2)) : text.off;
    },
    render() {
      const { section, model, unit = "" } = bench.now().document;
      const found = face();
      const isSpace = dimensionOf(model) === 3;
      axisRow.hidden = !isSpace;
      none.hidden = isSpace;
      axis.set(acrossOf(section));
      on.hidden = !section;
      if (!section) return;
      const [low, high] = extent();
      const now = placeOf(section);
      place.set(high > low ? (STEPS * (now - low)) / (high - low) : 0);
      field.set(Number(now.toPrecision(9)));
      attribute(place.input, "aria-valuetext", text.value(acrossOf(section), fixed(now, 2)));
      const [wide, tall] = found?.size ?? [0, 0];
      const area = found ? (found.inside * Math.hypot(...found.frame.sides[0]) * Math.hypot(...found.frame.sides[1])) / (wide * tall) : null;
      facts.replaceChildren(...(found && area !== null ? [fact(text.area, `≈ ${measure(area, unit, 2)}`, "cut"), fact(text.pixels, `${wide} × ${tall}`, "pixels")] : []));
    },
  };
}

/** @param {Bench} bench @param {Acts} acts @returns {Group} */
export function displayGroup(bench, { look }) {
  const text = words.display;
  const color = segment({ label: text.color, name: "lab-color", choices: /** @type {const} */ (["given", "solved"]).map((value) => ({ value, text: text.colors[value] })) }, (value) => bench.change({ color: value }));
  const boxes = /** @type {const} */ (["edges", "light"]).map((name) => ({ name, ...checkBox({ name: `lab-${name}`, text: [text[name]] }, (on) => bench.change({ [name]: on })) }));
  const place = h("div", {});
  const note = h("p", { class: "lab-note" });
  const views = viewButtons("lab", words.show, look);
  let names = "";
  /** @type {ReturnType<typeof select> | null} */
  let lines = null;
  return {
    name: "display",
    heading: text.heading,
    body: h("div", {}, row(text.color, color), note, place, h("div", { class: "layers lab-layers" }, ...boxes.map(({ element }) => element)), views),
    phrase() {
      const { document, shown } = bench.now();
      return shown.isolines === null ? text.noLines : text.linesOf(document.materials[shown.isolines]?.name ?? "");
    },
    render() {
      const { document, known, shown } = bench.now();
      const key = JSON.stringify(document.materials.map(({ name }) => name));
      if (key !== names) {
        names = key;
        const choices = [{ value: "", text: text.off }, ...document.materials.map(({ name }, i) => ({ value: String(i), text: name }))];
        lines = select({ label: text.lines, name: "lab-isolines", choices }, (value) => bench.change({ isolines: value === "" ? null : Number(value) }));
        place.replaceChildren(row(text.lines, lines));
      }
      lines?.set(shown.isolines === null ? "" : String(shown.isolines));
      color.set(shown.color);
      write(note, text[shown.color]);
      const isSpace = known?.boundary.dimension !== 2;
      for (const { name, element, set } of boxes) {
        set(shown[name]);
        element.hidden = name === "light" && !isSpace;
      }
      views.hidden = !isSpace;
    },
  };
}
