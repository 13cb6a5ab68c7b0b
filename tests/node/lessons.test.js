/** Lessons: every one is valid and true, and what is wrong with a bad one is said by file, step and field. */
import assert from "node:assert/strict";
import { readFile, readdir } from "node:fs/promises";
import { basename, join } from "node:path";
import { test } from "node:test";
import { load } from "directrix";
import { FACTS, isTrue, numbersOf } from "../../scripts/lib/lesson-facts.mjs";
import { documentNamed, documentNames, lessonFolder } from "../../scripts/lib/lesson-plugin.mjs";
import { readLesson } from "../../scripts/lib/lesson.mjs";
import { firstState, graded, moved, oppositeOf, redone, twisted } from "../../www/src/lessons/body-edits.js";
import { jacobianAt, leastAtCorners, weightsAt } from "../../www/src/lessons/cell-sum.js";
import { jacobianNumbers, pieces } from "../../www/src/lessons/certificate.js";
import { figureDocument, momentOf } from "../../www/src/lessons/document.js";
import { frameOf, influence, inputOf, matrixOf, panelsOf, scaledPanels } from "../../www/src/lessons/laplace-known.js";
import { lengths, phaseAt } from "../../www/src/steps/film.js";

const dx = await load({ module: "full" });
const documents = await documentNames();
const names = (await readdir(lessonFolder)).filter((file) => file.endsWith(".md")).map((file) => basename(file, ".md"));
const sources = new Map(await Promise.all(names.map(async (name) => /** @type {const} */ ([name, await readFile(join(lessonFolder, `${name}.md`), "utf8")]))));

/** @param {string} name */
const lessonNamed = (name) => readLesson(name, sources.get(name) ?? "", documents);

test("there are lessons, each with a place of its own in the list", () => {
  for (const name of ["heterogeneous-object", "why-matching", "greedy", "one-hyperpatch", "cell-validity", "corner-continuity", "material-continuity", "distance-profiles", "distance-transform", "overlaps", "voxel-error", "heat", "boundary-elements", "why-precondition", "harmonic-blend"]) assert.ok(names.includes(name), name);
  const orders = names.map((name) => lessonNamed(name).lesson.order);
  assert.equal(new Set(orders).size, names.length);
});

for (const name of names) {
  test(`${name}: every figure is a document that can be shown, and every number in the text is true`, async () => {
    const { lesson, facts } = lessonNamed(name);
    let count = 0;
    for (const [k, { title, figure }] of lesson.steps.entries()) {
      const source = figureDocument(await documentNamed(figure.document), figure);
      const isOfCurves = figure.view === "figure" || figure.view === "steps";
      const document = isOfCurves ? dx.defaults(source) : source;
      if (figure.view === "part" || figure.view === "grid") {
        const part = dx.part(/** @type {any} */ (document));
        assert.deepEqual(part.diagnostics, [], `${name}, step ${k + 1}`);
        assert.ok(part.bodies[figure.feature[0]]?.features[figure.feature[1]]?.active, `${name}, step ${k + 1}: the part has the feature ${figure.feature}`);
      } else if (figure.view === "laplace") {
        const { diagnostics, exact } = dx.boundary(/** @type {any} */ (document));
        assert.deepEqual(diagnostics, [], `${name}, step ${k + 1}`);
        assert.ok(figure.reading !== "error" || exact, `${name}, step ${k + 1}: errors are measured where the solution is known`);
      } else if (figure.view === "body") assert.ok(dx.hyperpatch(/** @type {any} */ (document)).cells.length > figure.cell, `${name}, step ${k + 1}: the body of the figure has the cell ${figure.cell}`);
      else if (figure.view === "steps") {
        const steps = dx.steps(document);
        const { phase, index = 1 } = figure.step ?? {};
        const own = lengths(steps);
        const most = { start: 1, growth: own.growth, removal: own.removal, insertion: own.first + own.second, end: 1 }[phase ?? "end"];
        assert.ok(index === "last" || index <= most, `${name}, step ${k + 1}: its figure has only ${most} steps of ${phase}`);
      } else {
        const { ok } = dx.match(document);
        const showsFault = figure.layers?.includes("material") === false;
        assert.ok(ok || showsFault, `${name}, step ${k + 1}: a figure with the layer material has a complete matching`);
      }
      for (const { name: fact, arguments: numbers, shown } of facts[k]?.facts ?? []) {
        const value = /** @type {any} */ (FACTS[fact]).of({ dx, document, view: figure.view }, ...numbers);
        assert.ok(isTrue(shown, value), `${name}, step ${k + 1} "${title}": {${fact} ${numbers.join(" ")}: ${shown}} is ${value}`);
        count += 1;
      }
    }
    assert.ok(count >= 5, "the lesson states numbers");
  });

  test(`${name}: links to lessons lead to steps that there are`, () => {
    const { lesson } = lessonNamed(name);
    for (const [, other = "", step] of JSON.stringify(lesson).matchAll(/#lesson=([a-z-]+)&#38;step=(\d+)/g)) {
      assert.ok(names.includes(other), `there is no lesson ${other}`);
      assert.ok(Number(step) <= lessonNamed(other).lesson.steps.length);
    }
  });
}

test("mathematics has MathML beside it", () => {
  const { lesson } = lessonNamed("greedy");
  assert.match(JSON.stringify(lesson.steps[1]), /<math xmlns=/);
  assert.match(JSON.stringify(lesson.steps[1]), /katex-display/);
});

test("a question about a vertex is right about the line of its step", async () => {
  const { lesson } = lessonNamed("greedy");
  const asked = lesson.steps.filter(({ blocks }) => blocks.some((block) => block.kind === "question" && block.question.choices.length === 0));
  assert.ok(asked.length > 0);
  for (const { figure, blocks } of asked) {
    const steps = dx.steps(figureDocument(await documentNamed(figure.document), figure));
    const at = momentOf(steps, figure.step);
    assert.equal(phaseAt(steps, at).phase, "growth");
    const line = steps.growth[at - 1];
    const text = JSON.stringify(blocks.find(({ kind }) => kind === "question")).replace(/<[^>]+>/g, "");
    assert.ok(text.includes(`p_${line?.from}`) && text.includes(`q_${line?.to}`), `names p${line?.from} and q${line?.to}`);
  }
});

test("a moment stands for the nearest step on other curves", () => {
  const small = dx.steps(/** @type {any} */ (ring(5)));
  const { growth, removal, first, second } = lengths(small);
  assert.equal(momentOf(small, { phase: "growth", index: 500 }), growth);
  assert.equal(momentOf(small, { phase: "growth", index: 2 }), 2);
  assert.equal(momentOf(small, { phase: "removal", index: "last" }), growth + removal);
  assert.equal(momentOf(small, { phase: "end", index: 1 }), growth + removal + first + second + 1);
  assert.equal(momentOf(small, { phase: "start", index: 1 }), 0);
});

/** Two circles by a few samples. @param {number} count */
function ring(count) {
  const curve = (/** @type {number} */ r) => ({ degree: 3, form: "periodic", points: [[r, 0], [0, r], [-r, 0], [0, -r]] });
  return { directrix: 1, kind: "curves", curves: [curve(10), curve(30)], sampling: { counts: [count, count] }, matching: { method: "greedy" } };
}

test("what a figure of a cell sums up is what the kernel has", async () => {
  const document = await documentNamed("hyperpatch-twisted");
  const body = dx.hyperpatch(document);
  const [cell] = document.operations[0].cells;
  const question = { dx, document, view: /** @type {const} */ ("body") };
  for (const uvw of /** @type {[number, number, number][]} */ ([[0, 0, 0], [1, 0, 1], [0.2, 0.4, 0.8], [0.5, 0.5, 0.5], [0.93, 0.07, 0.31]])) {
    const weights = weightsAt(uvw);
    assert.ok(Math.abs(weights.reduce((sum, each) => sum + each, 0) - 1) < 1e-14);
    const { position } = body.sample(0, uvw);
    for (const axis of [0, 1, 2]) {
      const sum = weights.reduce((all, weight, n) => all + weight * cell.coefficients[n].position[axis], 0);
      assert.ok(Math.abs(sum - position[axis]) < 1e-12, `${uvw}`);
    }
    const found = jacobianAt(cell, uvw);
    assert.ok(Math.abs(found - /** @type {any} */ (FACTS.jacobian).of(question, ...uvw)) < 1e-10, `${uvw}: ${found}`);
  }
  assert.ok(leastAtCorners(cell) >= body.verdicts()[0].leastJacobianBound);
});

test("numbers in a text are held against the kernel to the digits shown", () => {
  assert.ok(isTrue("44", 44) && !isTrue("44", 44.2) && !isTrue("44", 45));
  assert.ok(isTrue("0.969", 0.96926) && !isTrue("0.969", 0.9696) && !isTrue("0.969", 0.9684));
  assert.ok(isTrue("2.9 %", 0.0288) && !isTrue("2.9 %", 0.0281));
  assert.ok(!isTrue("many", 3) && !isTrue("1", NaN));
});

const GOOD = `# A title
group: Curves
order: 9
summary: A sentence.

## One
figure: amoeba
caption: What it shows.
alt: What is seen.

Text with $x$ and a [term](lines).

? Is it so?
- [x] Yes
- [ ] No
= It is.
`;

test("the 729 numbers of a cell are those that the kernel's positions give, and halving closes in on its least Jacobian", async () => {
  for (const name of ["twisted", "nearly-invalid", "invalid", "crossing"]) {
    const document = await documentNamed(`hyperpatch-${name}`);
    const [cell] = document.operations[0].cells;
    const body = dx.hyperpatch(document);
    const numbers = jacobianNumbers(cell);
    const size = Math.max(...numbers.map(Math.abs));
    // From values back to coefficients, rounding grows by up to 560 along each of three axes.
    numbersOf({ dx, document, view: "body" }).forEach((value, n) => assert.ok(Math.abs(value - numbers[n]) < 1e-7 * size, `${name}, ${n}: ${value} is not ${numbers[n]}`));
    assert.ok(Math.abs(numbers.reduce((sum, each) => sum + each, 0) / 729 - body.volume()) < 1e-12 * size);
    const [{ leastJacobian, verdict }] = body.verdicts();
    let before = -Infinity;
    for (const count of [0, 1, 3, 8, 24]) {
      const all = pieces(cell, count);
      assert.equal(all.length, count + 1);
      assert.ok(all[0].least >= before - 1e-12 * size && all[0].least <= leastJacobian + 1e-9 * size, `${name}, ${count}`);
      before = all[0].least;
    }
    const corner = Math.min(...pieces(cell, 24).map((piece) => piece.corner));
    assert.ok(before <= corner && corner - before < 0.01 * size, `${name}: both bounds meet`);
    assert.equal(before > 0, verdict !== "invalid" || name === "crossing");
  }
});

test("a twist, displacements and rules for the material are what the kernel says of them", async () => {
  const cell = await documentNamed("hyperpatch-cell");
  const half = dx.hyperpatch(twisted(cell, 90)).sample(0, [1, 0.5, 1]).position;
  // The middle of the side x = 1 of the top, a quarter turn on.
  [0, 1, 2].forEach((expected, axis) => assert.ok(Math.abs(half[axis] - expected) < 1e-8));
  const [turned] = dx.hyperpatch(twisted(cell, 150)).verdicts();
  assert.equal(turned.verdict, "valid");
  assert.ok(turned.leastJacobianBound > 4, "as the lesson says");
  const block = await documentNamed("hyperpatch-block");
  const chosen = { cell: 0, at: /** @type {[number, number, number]} */ ([2, 3, 3]) };
  assert.deepEqual(oppositeOf(block, chosen), { cell: 4, at: [1, 3, 3] });
  const smooth = (/** @type {any} */ document) => FACTS["smooth-joints"].of({ dx, document, view: "body" }, 0, 1, 1, 1);
  assert.deepEqual(/** @type {const} */ (["block", "pair", "single"]).map((reach) => smooth(moved(block, chosen, [0.1, -0.1, 0.2], reach))), [12, 4, 4]);
  // One displacement after the other is one operation, and where they differ two.
  const once = moved(moved(block, chosen, [0.1, 0, 0], "pair"), chosen, [0, 0, 0.2], "pair");
  assert.deepEqual(once.operations, moved(block, chosen, [0.1, 0, 0.2], "pair").operations);
  assert.equal(moved(once, chosen, [0, 0, 0.2], "block").operations.length, 4);
  assert.deepEqual(redone(once, chosen, "pair", "block").operations, moved(block, chosen, [0.1, 0, 0.2], "block").operations);
  assert.equal(redone(block, chosen, "pair", "block"), block);

  const row = await documentNamed("hyperpatch-row");
  const at = (/** @type {any} */ document, /** @type {number} */ place) => dx.hyperpatch(document).sample(Math.floor(place), [place % 1, 0.3, 0.6]).mix[1];
  for (const place of [0.2, 0.75, 1.5, 2.1, 3.9]) {
    const t = place % 1;
    const step = 3 * t * t - 2 * t * t * t;
    assert.ok(Math.abs(at(graded(row, { before: 0.5, at: 0.5 }, "natural"), place) - place / 4) < 1e-9, "an even gradient");
    assert.ok(Math.abs(at(graded(row, { before: 0.5, at: 0.5 }, "flat"), place) - (Math.floor(place) + step) / 4) < 1e-9, "a staircase");
  }
  const joint = (/** @type {any} */ document) => dx.hyperpatch(document).neighbourhood(1, [1, 0, 0]).joints.map(({ material }) => material);
  for (const [share, kind] of /** @type {const} */ ([[0.75, "C1"], [0.8, "C0"], [0.25, "C1"], [0.2, "C0"]])) {
    assert.deepEqual(joint(graded(row, { before: 0.5, at: share }, "reflect")), [kind], String(share));
    for (const rule of /** @type {const} */ (["flat", "natural"])) assert.deepEqual(joint(graded(row, { before: 0.5, at: share }, rule)), ["C1"]);
  }
  // As the lesson says of a joint near the end: the step is what there is of the scarcer material.
  const near = FACTS["mix-at"].of({ dx, document: graded(row, { before: 0, at: 0.95 }, "natural"), view: "body" }, 2, 1, 2);
  assert.ok(Math.abs(near - 0.9) < 1e-9);
  const { lesson } = lessonNamed("corner-continuity");
  assert.deepEqual(firstState(block, /** @type {any} */ (lesson.steps[2]?.figure)), block, "a figure without changes shows its document as it is");
});

test("the page on writing lessons has an example that is one, and all facts", async () => {
  const page = await readFile(new URL("../../docs/lessons.md", import.meta.url), "utf8");
  const example = /^```\n(# [^]*?)^```$/m.exec(page)?.[1] ?? "";
  const { lesson, facts } = readLesson("example", example, documents);
  const [step] = lesson.steps;
  assert.ok(step);
  const document = figureDocument(await documentNamed(step.figure.document), step.figure);
  for (const { name, arguments: numbers, shown } of facts[0]?.facts ?? []) {
    assert.ok(isTrue(shown, /** @type {any} */ (FACTS[name]).of({ dx, document, view: "figure" }, ...numbers)), `{${name}: ${shown}}`);
  }
  for (const [name, { arguments: count, meaning }] of Object.entries(FACTS)) assert.ok(page.includes(`| \`${name}\` | ${count} | ${meaning} |`), name);
});

test("the smallest lesson is read", () => {
  const { lesson } = readLesson("small", GOOD, documents);
  assert.equal(lesson.steps.length, 1);
  assert.deepEqual(lesson.steps[0]?.blocks.map(({ kind }) => kind), ["text", "figure", "question"]);
});

/** The same with a figure of a cell. @param {string} text */
const bodied = (text) => text.replace("figure: amoeba", "figure: hyperpatch-cell\nview: body").replace("(lines)", "(net)");

/** @type {[string, (text: string) => string, RegExp][]} */
const BAD = [
  ["no title", (t) => t.replace("# A title\n", "\n"), /^small\.md, line 1, title: a lesson begins with/],
  ["no group", (t) => t.replace("group: Curves\n", ""), /^small\.md, line 1, group: every lesson has one/],
  ["a field that does not exist", (t) => t.replace("order: 9", "oder: 9"), /^small\.md, line 3, oder: there is no such field here; there are: group, order/],
  ["an order that is no number", (t) => t.replace("order: 9", "order: last"), /line 3, order: a whole number from 1, not "last"/],
  ["no step", (t) => t.slice(0, t.indexOf("## One")), /steps: a lesson has one step at least/],
  ["text before the first step", (t) => t.replace("\n## One", "\nHello\n\n## One"), /line 6, text: text belongs to a step/],
  ["an unknown document", (t) => t.replace("amoeba", "amöbe"), /small\.md, step 1 "One", line 7, figure: there is no document "amöbe"; there are: amoeba/],
  ["no caption", (t) => t.replace("caption: What it shows.\n", ""), /step 1 "One", line \d+, caption: every step has one/],
  ["a field twice", (t) => t.replace("figure: amoeba", "figure: amoeba\nfigure: kidney"), /line 8, figure: the field stands twice/],
  ["an empty field", (t) => t.replace("alt: What is seen.", "alt:"), /line 9, alt: the field is empty/],
  ["an unknown layer", (t) => t.replace("caption:", "layers: material, lines\ncaption:"), /layers: there is no layer "lines"; there are: material/],
  ["an s out of range", (t) => t.replace("caption:", "s: 1.5\ncaption:"), /s: a number from 0 to 1, not "1\.5"/],
  ["an unknown view", (t) => t.replace("caption:", "view: film\ncaption:"), /view: one of figure, steps, body, part, grid, laplace, not "film"/],
  ["a body shown as curves", (t) => t.replace("amoeba", "hyperpatch-cell"), /line 7, figure: "hyperpatch-cell" is no document of curves; the view body shows it/],
  ["curves shown as a body", (t) => t.replace("caption:", "view: body\ncaption:").replace("(lines)", "(net)"), /line 7, figure: the view body shows documents whose names begin with hyperpatch-, not "amoeba"/],
  ["a field of parts with curves", (t) => t.replace("caption:", "place: 1 2\ncaption:"), /place: belongs to figures of the view part/],
  ["a circle with a part", (t) => t.replace("figure: amoeba", "figure: part-plate\nview: part\ncircle: 0.2").replace("(lines)", "(place)"), /circle: belongs to figures of the view laplace/],
  ["a place with a grid", (t) => t.replace("figure: amoeba", "figure: part-ring\nview: grid\nplace: 1 2").replace("(lines)", "(features)"), /place: belongs to figures of the view part or laplace/],
  ["panels that are none", (t) => t.replace("figure: amoeba", "figure: laplace-square\nview: laplace\npanels: 0 4").replace("(lines)", "(middles)"), /panels: fewest and most panels along a side, whole numbers/],
  ["a reading of another view", (t) => t.replace("figure: amoeba", "figure: part-plate\nview: part\nreading: scan").replace("(lines)", "(place)"), /reading: one of along, rules, not "scan"/],
  ["too many pixels of a grid", (t) => t.replace("figure: amoeba", "figure: part-ring\nview: grid\npixels: 65").replace("(lines)", "(features)"), /pixels: a whole number from 4 to 64, not "65"/],
  ["a change of a body", (t) => bodied(t).replace("caption:", "set: blend.stages = 3\ncaption:"), /set: changes curves/],
  ["a place outside the cell", (t) => bodied(t).replace("caption:", "point: 0 0.5 1.2\ncaption:"), /point: u, v and w, each from 0 to 1, with a blank between them, not "0 0\.5 1\.2"/],
  ["a coefficient that is not there", (t) => bodied(t).replace("caption:", "coefficient: 1 4 0\ncaption:"), /coefficient: i, j and k, each 0, 1, 2 or 3/],
  ["an unknown reading", (t) => bodied(t).replace("caption:", "reading: volume\ncaption:"), /reading: one of weights, material, jacobian, certificate, cone, meeting, joints, gap, row, amounts, not "volume"/],
  ["a twist out of range", (t) => bodied(t).replace("caption:", "twist: 270\ncaption:"), /twist: degrees from 0 to 180, not "270"/],
  ["a cell that is no number", (t) => bodied(t).replace("caption:", "cell: first\ncaption:"), /cell: the number of a cell, from 0, not "first"/],
  ["fractions that are none", (t) => bodied(t).replace("caption:", "rule: flat\nshares: 0.5 1.5\ncaption:"), /shares: two fractions from 0 to 1, with a blank between them, not "0\.5 1\.5"/],
  ["a field of bodies with curves", (t) => t.replace("caption:", "reach: block\ncaption:"), /reach: belongs to figures of the view body/],
  ["a step of the wrong view", (t) => t.replace("caption:", "step: end\ncaption:"), /step: belongs to figures of the view steps/],
  ["a view without its step", (t) => t.replace("caption:", "view: steps\ncaption:").replace("(lines)", "(winner)"), /step: a figure of the view steps names one/],
  ["an unknown moment", (t) => t.replace("caption:", "view: steps\nstep: growth 0\ncaption:"), /step: start, end, or growth, removal or insertion with a number/],
  ["a change of what is not to be changed", (t) => t.replace("caption:", "set: title = 3\ncaption:"), /set: "title" is no path that a lesson may change/],
  ["a change that is no JSON", (t) => t.replace("caption:", "set: matching.method = greedy\ncaption:"), /set: the value greedy is not JSON/],
  ["a formula that cannot be set", (t) => t.replace("$x$", "$\\frac{x$"), /step 1 "One", line 11, text: the formula \\frac\{x cannot be set/],
  ["a term that names nothing", (t) => t.replace("(lines)", "(rulings)"), /text: the term rulings names nothing in a figure of the view figure; there are: first/],
  ["a line without its number", (t) => t.replace("(lines)", "(line)"), /text: the term line names nothing/],
  ["an unknown fact", (t) => t.replace("Text", "{lnes: 4} Text"), /text: there is no fact "lnes"; there are: samples/],
  ["a fact without its number", (t) => t.replace("Text", "{f: 4} Text"), /text: the fact f has 1 numbers behind its name, not 0/],
  ["a mark left open", (t) => t.replace("Text", "*Text"), /text: the sign \* in/],
  ["a form that lessons do not have", (t) => t.replace("Text", "> Text"), /text: "> Text/],
  ["two places for its figure", (t) => t.replace("\n? Is", "\n[figure]\n\n[figure]\n\n? Is"), /text: a step has one figure, whose place is given once/],
  ["no text", (t) => t.replace(/Text.*\n/, ""), /text: a step has text/],
  ["a question without its answer", (t) => t.replace("= It is.\n", ""), /line 13, question: its last line is the answer/],
  ["a question with two right answers", (t) => t.replace("[ ] No", "[x] No"), /question: has two choices at least, one of them right: there are 2 with 2 right/],
  ["a choice that is badly written", (t) => t.replace("[ ] No", "[o] No"), /question: a choice is written/],
  ["a question about a vertex without steps", (t) => t.replace(/- \[.*\n/g, ""), /question: a question without choices asks where the line of a growing step ends/],
];

for (const [fault, change, message] of BAD) {
  test(`a lesson with ${fault} is refused`, () => {
    const text = change(GOOD);
    assert.notEqual(text, GOOD);
    assert.throws(() => readLesson("small", text, documents), (error) => {
      assert.match(/** @type {Error} */ (error).message, message);
      return true;
    });
  });
}

test("a lesson is named so that it fits into a link, and markup in its text stays text", () => {
  assert.throws(() => readLesson("My lesson", GOOD, documents), /name: a lesson is named in small letters/);
  const { lesson } = readLesson("small", GOOD.replace("Text", "Text <img src=x onerror=alert(1)>"), documents);
  assert.ok(!JSON.stringify(lesson).includes("<img"));
});

/** Solves with a matrix, by Gauss and Jordan with the largest pivots. @param {number[][]} rows each with its right-hand side last */
function solvedBy(rows) {
  const count = rows.length;
  for (let k = 0; k < count; k += 1) {
    const pivot = rows.reduce((best, row, n) => (n >= k && Math.abs(row[k]) > Math.abs(rows[best][k]) ? n : best), k);
    [rows[k], rows[pivot]] = [rows[pivot], rows[k]];
    rows.forEach((row, n) => {
      if (n === k) return;
      const factor = row[k] / rows[k][k];
      rows[n] = row.map((x, m) => x - factor * rows[k][m]);
    });
  }
  return rows.map((row, k) => row[count] / row[k]);
}

test("the matrix that a figure shows is the one that the kernel solves with", async () => {
  const boundary = dx.boundary(await documentNamed("laplace-few"));
  const { matrix, count, values } = matrixOf(boundary);
  const { panels, scale } = scaledPanels(boundary);
  assert.ok(values.every(Boolean) && count === 16);
  // Values less their middle, as the kernel has them, because constants cost accuracy where the sum of the fluxes is not 0.
  const given = panels.map((_, n) => /** @type {{value: number[]}} */ (boundary.conditions[boundary.groups[n]]).value[0] - 0.5);
  const doubled = panels.map(({ middle }) => panels.reduce((sum, panel, n) => sum + influence(panel, middle).double * given[n], 0));
  const rows = panels.map((_, n) => [...matrix.subarray(n * count, (n + 1) * count), given[n] / 2 - doubled[n]]);
  const { fluxes } = dx.solveLaplace(inputOf(boundary, { tolerance: 1e-10 }));
  solvedBy(rows).forEach((flux, n) => assert.ok(Math.abs(flux * scale - fluxes[0][n]) < 1e-3, `${flux * scale}, not ${fluxes[0][n]}`));
});

test("a panel does what its integrals say, by many points in place of closed forms", async () => {
  const [panel] = panelsOf(dx.boundary(await documentNamed("laplace-few")));
  for (const point of /** @type {[number, number][]} */ ([[0.5, 0.5], [0.1, 0.01], [-0.3, 0.2]])) {
    const { single, double } = influence(panel, point);
    let [own, angle] = [0, 0];
    const pieces = 4000;
    for (let n = 0; n < pieces; n += 1) {
      const y = [0, 1].map((axis) => panel.from[axis] + ((panel.to[axis] - panel.from[axis]) * (n + 0.5)) / pieces);
      const [dx_, dy] = [y[0] - point[0], y[1] - point[1]];
      const square = dx_ * dx_ + dy * dy;
      own -= (Math.log(square) / 2) * (panel.length / pieces);
      angle += ((dx_ * panel.normal[0] + dy * panel.normal[1]) / square) * (panel.length / pieces);
    }
    assert.ok(Math.abs(single - own / (2 * Math.PI)) < 1e-6 && Math.abs(double - angle / (2 * Math.PI)) < 1e-6);
  }
  assert.equal(influence(panel, panel.middle).double, 0);
});

test("pictures of bodies in space are their sections, seen the right way round", async () => {
  const document = await documentNamed("laplace-cube");
  const boundary = dx.boundary(document);
  const { frame, box } = frameOf(document, boundary, 50);
  assert.deepEqual(frame.size, [50, 50]);
  const { values } = dx.solveLaplace(inputOf(boundary)).section(frame);
  const column = 25;
  assert.ok(values[0][45 * 50 + column] > 0.8 && values[0][25 * 50 + column] < 0.35, "rows run upwards, to the face that is 1");
  assert.ok(Math.abs(box[0][0] + 0.03) < 1e-12 && Math.abs(box[1][1] - 1.03) < 1e-12);
});
