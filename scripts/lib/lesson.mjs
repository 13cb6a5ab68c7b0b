/**
 * Reads lessons: texts in a form that is easy to write (docs/lessons.md), checked field by field, into what the page shows. Everything
 * that is wrong is said with the file, the line, the step and the field.
 *
 * @import { Fact } from "./lesson-text.mjs"
 *
 * @typedef {object} Figure
 * @property {string} document name of a preset, or of a document beside the lessons
 * @property {[string, unknown][]} changes of the document: path and value
 * @property {"figure" | "steps" | "body" | "part" | "grid" | "laplace"} view
 * @property {string[] | null} layers of the view `figure`; those of the document when null
 * @property {number | null} s place of the current in-between curve
 * @property {Moment | null} step of the view `steps`
 * @property {[number, number, number] | null} point of the view `body`: u, v and w of the place that is marked
 * @property {[number, number, number] | null} coefficient of the view `body`: the one that is chosen
 * @property {number} cell of the view `body`: the one that the place, the net and the coefficient belong to
 * @property {"cell" | "corner" | "none"} net of the view `body`: the coefficients that are shown
 * @property {number | null} without of the view `body`: a cell that is not painted, so that one sees what lies behind it
 * @property {"block" | "single" | "pair" | null} reach of the view `body`: what moves with a coefficient; a cell alone needs none
 * @property {[number, number, number] | null} by of the view `body`: how far the coefficient has been moved at first
 * @property {number | null} twist of the view `body`: degrees from bottom to top, to be changed
 * @property {"reflect" | "flat" | "natural" | null} rule of the view `body`: for the material of a row of four cells, to be changed
 * @property {number[] | null} shares of the second material before the middle joint of that row and at it
 * @property {typeof READINGS[keyof typeof READINGS][number] | null} reading of the views `body`, `part`, `grid` and `laplace`: what stands below it
 * @property {[number, number] | null} place of the views `part` and `laplace`: x and y of the place that is read
 * @property {[number, number, number, number] | null} line of the view `part`: both ends of the line along which compositions are shown
 * @property {[number, number]} feature of the view `part`: number of the body and of its feature that can be changed
 * @property {[number, number] | null} limit of the view `part`: least and greatest value of the limit of that feature, which a slider moves
 * @property {boolean} courses of the view `part`: whether its course can be chosen
 * @property {"repaired" | "depth" | "printed" | null} overlap of the view `part`: the rule of all bodies, which can then be chosen
 * @property {number} pixels of the view `grid`: along its longer side
 * @property {number | null} at of the view `grid`: the pass that is shown, counted in rows and then in columns
 * @property {number | null} circle of the view `laplace`: radius of a circle round the place, to be changed
 * @property {[number, number] | null} panels of the view `laplace`: fewest and most panels along a side, which a slider changes
 * @property {"full" | "minimal" | "none"} controls
 * @property {string} caption HTML
 * @property {string} alt what the picture shows, in plain words
 *
 * @typedef {{phase: "start" | "growth" | "removal" | "insertion" | "end", index: number | "last"}} Moment
 *   A step of the growth: the index within its phase, from 1. Named so, it stands for something on other curves as well.
 *
 * @typedef {object} Question
 * @property {string} text HTML
 * @property {{text: string, right: boolean}[]} choices HTML; none where the answer is a vertex of the figure
 * @property {string} answer HTML: what is right, and why
 *
 * @typedef {{kind: "text" | "formula", html: string} | {kind: "question", question: Question} | {kind: "figure"}} Block
 *   The figure stands where the text says, else before the first question, else at the end.
 *
 * @typedef {object} Step
 * @property {string} title
 * @property {Figure} figure
 * @property {Block[]} blocks
 *
 * @typedef {object} Lesson
 * @property {string} name
 * @property {string} title
 * @property {string} group heading in the list
 * @property {number} order in the list
 * @property {string} summary one sentence
 * @property {Step[]} steps
 *
 * @typedef {{step: number, facts: Fact[]}[]} Facts for each step from 1
 */
import { escaped, mathematics, prose } from "./lesson-text.mjs";

const LESSON_FIELDS = ["group", "order", "summary"];
/** Fields of figures of the view `body`. */
const BODY_FIELDS = ["cell", "without", "net", "point", "coefficient", "reach", "by", "twist", "rule", "shares", "reading"];
/** Fields of figures of the views `part`, `grid` and `laplace`. */
const PART_FIELDS = ["place", "line", "feature", "limit", "courses", "overlap"];
const GRID_FIELDS = ["pixels", "at"];
const LAPLACE_FIELDS = ["place", "circle", "panels"];
const VIEW_FIELDS = new Set([...BODY_FIELDS, ...PART_FIELDS, ...GRID_FIELDS, ...LAPLACE_FIELDS]);
const FIGURE_FIELDS = ["figure", "view", "layers", "s", "step", ...VIEW_FIELDS, "controls", "set", "caption", "alt"];
/** The views that a field belongs to. @param {string} name */
function viewsOf(name) {
  const all = { body: BODY_FIELDS, part: PART_FIELDS, grid: GRID_FIELDS, laplace: LAPLACE_FIELDS };
  return Object.entries(all).flatMap(([view, fields]) => (fields.includes(name) ? [view] : []));
}
/** What can stand below figures of a view. */
const READINGS = /** @type {const} */ ({
  body: ["weights", "material", "jacobian", "certificate", "cone", "meeting", "joints", "gap", "row", "amounts"],
  part: ["along", "rules"],
  grid: ["envelope", "scan", "error"],
  laplace: ["mean", "extremes", "fractions", "influence", "matrix", "error", "residuals"],
});
/** Of the views that show documents of another kind than curves: how names of these begin. */
const FOLDERS = /** @type {const} */ ({ body: "hyperpatch-", part: "part-", grid: "part-", laplace: "laplace-" });
const LAYERS = [
  ...["material", "unitCells", "inBetweens", "rulingLines", "samples", "unconnected", "controlPoints", "normals", "grid", "value"],
  ...["isoComposition", "difference"],
];
/** Fields that belong to figures of some views, with these. @type {[string, string[]][]} */
const OWN_FIELDS = [
  ["layers", ["figure"]],
  ["s", ["figure"]],
  ["step", ["steps"]],
  ...[...VIEW_FIELDS].filter((name) => name !== "reading").map((name) => /** @type {[string, string[]]} */ ([name, viewsOf(name)])),
];

/** Paths of a document that `set` may change. */
const PATH = /^(sampling|matching|blend|curves\.[01])\.[a-zA-Z]+$/;

/**
 * @param {string} name of the file, without its ending; part of the link to the lesson
 * @param {string} source
 * @param {string[]} documents names of the documents that figures may show
 * @returns {{lesson: Lesson, facts: Facts}}
 */
export function readLesson(name, source, documents) {
  const lines = source.replace(/\r\n/g, "\n").split("\n");
  let place = `${name}.md`;
  /** @param {number} at @param {string} field @param {string} message @returns {never} */
  const refuse = (at, field, message) => {
    throw new Error(`${place}, line ${at + 1}, ${field}: ${message}`);
  };
  if (!/^[a-z0-9]+(-[a-z0-9]+)*$/.test(name)) refuse(0, "name", `a lesson is named in small letters, digits and hyphens, not "${name}"`);

  const starts = lines.flatMap((line, at) => (line.startsWith("## ") ? [at] : []));
  const head = lines.slice(0, starts[0] ?? lines.length);
  const title = /^# (.+)$/.exec(head[0] ?? "")?.[1]?.trim();
  if (!title) return refuse(0, "title", "a lesson begins with a line such as: # What it is about");
  const { fields, rest } = fieldsOf(head, 1, LESSON_FIELDS, refuse);
  const after = rest.find(({ line }) => line.trim() !== "");
  if (after) refuse(after.at, "text", "text belongs to a step, below a line such as: ## First step");
  const required = (/** @type {string} */ field) => fields.get(field)?.[0]?.value ?? refuse(0, field, "every lesson has one");
  const [group, summary, order] = [required("group"), required("summary"), Number(required("order"))];
  if (!(Number.isInteger(order) && order > 0)) refuse(fields.get("order")?.[0]?.at ?? 0, "order", `a whole number from 1, not "${required("order")}"`);
  if (starts.length === 0) refuse(lines.length - 1, "steps", "a lesson has one step at least, below a line such as: ## First step");

  /** @type {Facts} */
  const facts = [];
  const steps = starts.map((from, k) => {
    const heading = (lines[from] ?? "").slice(3).trim();
    place = `${name}.md, step ${k + 1} "${heading}"`;
    if (heading === "") refuse(from, "title", "a step has a title");
    /** @type {Fact[]} */
    const own = [];
    const step = readStep(lines.slice(from + 1, starts[k + 1]), from + 1, documents, own, refuse);
    facts.push({ step: k + 1, facts: own });
    return { title: heading, ...step };
  });
  return { lesson: { name, title, group, order, summary, steps }, facts };
}

/** @typedef {(at: number, field: string, message: string) => never} RefuseAt */
/** @typedef {Map<string, {value: string, at: number}[]>} Fields */

/**
 * The lines `name: value` at the beginning, and what follows.
 * @param {string[]} lines
 * @param {number} skip lines before the first
 * @param {string[]} known
 * @param {RefuseAt} refuse
 * @param {number} [base] number of the first line in the file
 */
function fieldsOf(lines, skip, known, refuse, base = 0) {
  /** @type {Fields} */
  const fields = new Map();
  let at = skip;
  for (; at < lines.length; at += 1) {
    const found = /^([a-z]+):\s*(.*)$/.exec(lines[at] ?? "");
    if (!found) break;
    const [, name = "", value = ""] = found;
    if (!known.includes(name)) refuse(base + at, name, `there is no such field here; there are: ${known.join(", ")}`);
    if (value.trim() === "") refuse(base + at, name, "the field is empty");
    const before = fields.get(name) ?? [];
    if (before.length > 0 && name !== "set") refuse(base + at, name, "the field stands twice");
    fields.set(name, [...before, { value: value.trim(), at: base + at }]);
  }
  return { fields, rest: lines.slice(at).map((line, k) => ({ line, at: base + at + k })) };
}

/**
 * @param {string[]} lines
 * @param {number} base
 * @param {string[]} documents
 * @param {Fact[]} facts grows
 * @param {RefuseAt} refuse
 * @returns {{figure: Figure, blocks: Block[]}}
 */
function readStep(lines, base, documents, facts, refuse) {
  const { fields, rest } = fieldsOf(lines, 0, FIGURE_FIELDS, refuse, base);
  const figure = readFigure(fields, base, documents, facts, refuse);
  /** @param {string} text @param {number} at @param {string} field */
  const html = (text, at, field) => {
    const read = prose(text, figure.view, (message) => refuse(at, field, message));
    facts.push(...read.facts);
    return read.html;
  };
  /** @type {Block[]} */
  const blocks = [];
  for (const { text, at } of paragraphs(rest)) {
    if (text.startsWith("$$")) {
      if (!/^\$\$[^$]+\$\$$/.test(text)) refuse(at, "formula", "a formula stands between two lines $$, with no empty line in it");
      blocks.push({ kind: "formula", html: mathematics(text.slice(2, -2), true, (message) => refuse(at, "formula", message)) });
    } else if (text === "[figure]") {
      if (blocks.some(({ kind }) => kind === "figure")) refuse(at, "text", "a step has one figure, whose place is given once");
      blocks.push({ kind: "figure" });
    } else if (text.startsWith("? ")) blocks.push({ kind: "question", question: readQuestion(text, at, figure, html, refuse) });
    else if (text.startsWith("- ")) {
      const items = text.split(/\n(?=- )/).map((item) => `<li>${html(joined(item.slice(2)), at, "text")}</li>`);
      blocks.push({ kind: "text", html: `<ul>${items.join("")}</ul>` });
    } else if (/^(#|>|\||\d+\. |<|---)/.test(text)) refuse(at, "text", `"${text.slice(0, 20)}" is not part of the form of lessons; see docs/lessons.md`);
    else blocks.push({ kind: "text", html: `<p>${html(joined(text), at, "text")}</p>` });
  }
  if (!blocks.some(({ kind }) => kind === "text")) refuse(base, "text", "a step has text");
  const question = blocks.findIndex(({ kind }) => kind === "question");
  if (!blocks.some(({ kind }) => kind === "figure")) blocks.splice(question < 0 ? blocks.length : question, 0, { kind: "figure" });
  return { figure, blocks };
}

/** @param {{line: string, at: number}[]} lines */
function paragraphs(lines) {
  /** @type {{text: string, at: number}[]} */
  const found = [];
  let open = false;
  for (const { line, at } of lines) {
    if (line.trim() === "") open = false;
    else if (open) /** @type {{text: string}} */ (found.at(-1)).text += `\n${line.trimEnd()}`;
    else {
      found.push({ text: line.trimEnd(), at });
      open = true;
    }
  }
  return found;
}

/** Lines of one paragraph as one. @param {string} text */
const joined = (text) => text.replace(/\s*\n\s*/g, " ").trim();

/**
 * @param {string} text
 * @param {number} at
 * @param {Figure} figure
 * @param {(text: string, at: number, field: string) => string} html
 * @param {RefuseAt} refuse
 * @returns {Question}
 */
function readQuestion(text, at, { step }, html, refuse) {
  const parts = text.split(/\n(?=- \[|= )/);
  const answers = parts.filter((part) => part.startsWith("= "));
  const choices = parts.slice(1).filter((part) => part.startsWith("- ["));
  const [answer] = answers;
  if (!answer || answers.length > 1 || parts.at(-1) !== answer) return refuse(at, "question", "its last line is the answer with the reason, such as: = Because …");
  if (choices.some((choice) => !/^- \[[ x]\] \S/.test(choice))) refuse(at, "question", "a choice is written: - [ ] wrong, or: - [x] right");
  if (choices.length === 0 && step?.phase !== "growth") {
    refuse(at, "question", "a question without choices asks where the line of a growing step ends, so its figure has the view steps and such a step");
  }
  const right = choices.filter((choice) => choice.startsWith("- [x]")).length;
  if (choices.length > 0 && (choices.length < 2 || right !== 1)) refuse(at, "question", `has two choices at least, one of them right: there are ${choices.length} with ${right} right`);
  return {
    text: html(joined((parts[0] ?? "").slice(2)), at, "question"),
    choices: choices.map((choice) => ({ text: html(joined(choice.slice(6)), at, "question"), right: choice.startsWith("- [x]") })),
    answer: html(joined(answer.slice(2)), at, "question"),
  };
}

/**
 * @param {Fields} fields
 * @param {number} base
 * @param {string[]} documents
 * @param {Fact[]} facts grows
 * @param {RefuseAt} refuse
 * @returns {Figure}
 */
function readFigure(fields, base, documents, facts, refuse) {
  const of = (/** @type {string} */ name) => fields.get(name)?.[0];
  const required = (/** @type {string} */ name) => of(name) ?? refuse(base, name, "every step has one");
  /** @template {string | null} T @param {string} name @param {readonly T[]} values @param {T} other @returns {T} */
  const oneOf = (name, values, other) => {
    const given = of(name);
    if (!given) return other;
    const value = values.find((each) => each === given.value);
    return value ?? refuse(given.at, name, `one of ${values.join(", ")}, not "${given.value}"`);
  };
  const document = required("figure");
  if (!documents.includes(document.value)) refuse(document.at, "figure", `there is no document "${document.value}"; there are: ${documents.join(", ")}`);
  const view = oneOf("view", /** @type {const} */ (["figure", "steps", "body", "part", "grid", "laplace"]), "figure");
  for (const [name, needed] of OWN_FIELDS) {
    const given = of(name);
    if (given && !needed.includes(view)) refuse(given.at, name, `belongs to figures of the view ${needed.join(" or ")}`);
  }
  const folder = view === "figure" || view === "steps" ? null : FOLDERS[view];
  if (folder !== null) {
    if (!document.value.startsWith(folder)) refuse(document.at, "figure", `the view ${view} shows documents whose names begin with ${folder}, not "${document.value}"`);
    const change = of("set");
    if (change) refuse(change.at, "set", `changes curves; a figure of the view ${view} shows its document as it is`);
  } else {
    const other = Object.entries(FOLDERS).find(([, start]) => document.value.startsWith(start));
    if (other) refuse(document.at, "figure", `"${document.value}" is no document of curves; the view ${other[0]} shows it`);
  }
  const reading = of("reading");
  if (reading && folder === null) refuse(reading.at, "reading", `belongs to figures of the views ${Object.keys(READINGS).join(", ")}`);
  /** @param {string} name @param {number} count @param {(value: number) => boolean} fits @param {string} expected @returns {number[] | null} */
  const numbers = (name, count, fits, expected) => {
    const given = of(name);
    if (!given) return null;
    const found = given.value.split(" ").map(Number);
    if (found.length !== count || !found.every(fits)) refuse(given.at, name, `${expected}, not "${given.value}"`);
    return found;
  };
  /** @param {string} name @param {(value: number) => boolean} fits @param {string} expected */
  const three = (name, fits, expected) => /** @type {[number, number, number] | null} */ (numbers(name, 3, fits, expected));
  const isShare = (/** @type {number} */ value) => value >= 0 && value <= 1;
  const layers = of("layers")?.value.split(/\s*,\s*/) ?? null;
  const unknown = layers?.find((layer) => !LAYERS.includes(layer));
  if (unknown !== undefined) refuse(of("layers")?.at ?? base, "layers", `there is no layer "${unknown}"; there are: ${LAYERS.join(", ")}`);
  const s = of("s");
  if (s && !(Number(s.value) >= 0 && Number(s.value) <= 1)) refuse(s.at, "s", `a number from 0 to 1, not "${s.value}"`);
  const step = of("step");
  if (view === "steps" && !step) refuse(base, "step", "a figure of the view steps names one");
  const caption = required("caption");
  const told = prose(caption.value, view, (message) => refuse(caption.at, "caption", message));
  facts.push(...told.facts);
  const alt = required("alt").value;
  return {
    document: document.value,
    changes: (fields.get("set") ?? []).map(({ value, at }) => readChange(value, at, refuse)),
    view,
    layers,
    s: s ? Number(s.value) : null,
    step: step ? readMoment(step.value, step.at, refuse) : null,
    cell: numbers("cell", 1, (value) => Number.isInteger(value) && value >= 0, "the number of a cell, from 0")?.[0] ?? 0,
    without: numbers("without", 1, (value) => Number.isInteger(value) && value >= 0, "the number of a cell, from 0")?.[0] ?? null,
    net: oneOf("net", /** @type {const} */ (["cell", "corner", "none"]), "cell"),
    reach: oneOf("reach", /** @type {const} */ (["block", "single", "pair"]), null),
    by: three("by", Number.isFinite, "x, y and z with a blank between them"),
    twist: numbers("twist", 1, (value) => value >= 0 && value <= 180, "degrees from 0 to 180")?.[0] ?? null,
    rule: oneOf("rule", /** @type {const} */ (["reflect", "flat", "natural"]), null),
    shares: numbers("shares", 2, isShare, "two fractions from 0 to 1, with a blank between them"),
    point: three("point", isShare, "u, v and w, each from 0 to 1, with a blank between them"),
    coefficient: three("coefficient", (value) => Number.isInteger(value) && value >= 0 && value <= 3, "i, j and k, each 0, 1, 2 or 3, with a blank between them"),
    reading: oneOf("reading", view === "figure" || view === "steps" ? [] : READINGS[view], null),
    place: /** @type {[number, number] | null} */ (numbers("place", 2, Number.isFinite, "x and y with a blank between them")),
    line: /** @type {[number, number, number, number] | null} */ (numbers("line", 4, Number.isFinite, "x and y of both ends with blanks between them")),
    feature: /** @type {[number, number]} */ (numbers("feature", 2, (value) => Number.isInteger(value) && value >= 0, "numbers of a body and of its feature, from 0") ?? [0, 0]),
    limit: /** @type {[number, number] | null} */ (numbers("limit", 2, (value) => value > 0, "least and greatest value, above 0, with a blank between them")),
    courses: oneOf("courses", /** @type {const} */ (["choose"]), null) !== null,
    overlap: oneOf("overlap", /** @type {const} */ (["repaired", "depth", "printed"]), null),
    pixels: numbers("pixels", 1, (value) => Number.isInteger(value) && value >= 4 && value <= 64, "a whole number from 4 to 64")?.[0] ?? 16,
    at: numbers("at", 1, (value) => Number.isInteger(value) && value >= 0, "a number of rows, and then of columns")?.[0] ?? null,
    circle: numbers("circle", 1, (value) => value > 0, "a radius above 0")?.[0] ?? null,
    panels: /** @type {[number, number] | null} */ (numbers("panels", 2, (value) => Number.isInteger(value) && value > 0, "fewest and most panels along a side, whole numbers with a blank between them")),
    controls: oneOf("controls", /** @type {const} */ (["full", "minimal", "none"]), "minimal"),
    caption: told.html,
    alt: escaped(alt) === alt ? alt : refuse(of("alt")?.at ?? base, "alt", "is plain text, without < > & and quotation marks"),
  };
}

/** @param {string} text such as `growth 3` @param {number} at @param {RefuseAt} refuse @returns {Moment} */
function readMoment(text, at, refuse) {
  const [, end, phase, index] = /^(?:(start|end)|(growth|removal|insertion) ([1-9]\d{0,4}|last))$/.exec(text) ?? [];
  if (end) return { phase: end === "start" ? "start" : "end", index: 1 };
  if (!phase) refuse(at, "step", `start, end, or growth, removal or insertion with a number from 1 or with last, not "${text}"`);
  return { phase: /** @type {Moment["phase"]} */ (phase), index: index === "last" ? "last" : Number(index) };
}

/**
 * @param {string} text such as `matching.method = "greedy"`
 * @param {number} at
 * @param {RefuseAt} refuse
 * @returns {[string, unknown]}
 */
function readChange(text, at, refuse) {
  const [, path = "", value = ""] = /^(\S+)\s*=\s*(.+)$/.exec(text) ?? refuse(at, "set", 'is written as a path and a value, such as: matching.method = "greedy"');
  if (!PATH.test(path)) refuse(at, "set", `"${path}" is no path that a lesson may change: sampling., matching., blend., curves.0. or curves.1. and a field`);
  try {
    return [path, JSON.parse(value)];
  } catch {
    return refuse(at, "set", `the value ${value} is not JSON: numbers as they are, text in quotation marks`);
  }
}
