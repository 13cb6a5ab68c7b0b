/**
 * The groups beside the body: its cells with their verdicts, the chosen corner, the section, the materials, and what is shown.
 *
 * @import { App } from "../state/app.js"
 * @import { Group } from "../inspector/group.js"
 * @import { StandardView } from "../space/camera.js"
 * @import { CellVerdict } from "../../../js/directrix.js"
 * @import { Known } from "./runner.js"
 * @import { Shown } from "./state.js"
 *
 * @typedef {object} Now
 * @property {Known | null} known the newest that is known
 * @property {boolean} isCurrent whether it belongs to the document as it stands now
 * @property {{position: readonly number[], sides: readonly import("./edits.js").Side[]} | null} corner the chosen one
 * @property {Shown} shown
 * @property {[number, number] | null} extent of the section plane's way, document units
 * @property {import("./joints.js").Joints | null} joints how cells continue each other, where it is shown
 * @property {number | null} area of the face of the cut
 *
 * @typedef {{element: HTMLElement, render: () => void}} Part More rows of a group.
 *
 * @typedef {object} Acts
 * @property {(cell: number, isMore: boolean) => void} chooseCell `isMore`: besides those that are chosen
 * @property {(patch: Partial<Shown>) => void} change
 * @property {(view: StandardView) => void} look
 * @property {(axis: 0 | 1 | 2, value: number, run?: string) => void} moveTo
 * @property {() => void} moved a run of moves is over
 * @property {(run: string) => void} takeBack
 * @property {() => void} nextCorner
 */
import { checkBox, segment } from "../controls/choices.js";
import { numberField } from "../controls/number-field.js";
import { row } from "../controls/row.js";
import { select } from "../controls/select.js";
import { slider } from "../controls/slider.js";
import { attribute, h, write } from "../dom.js";
import { fixed, percent } from "../format.js";
import { fact } from "../space/card.js";
import { measure } from "../space/measure.js";
import { sectionRows } from "../space/section-group.js";
import { viewButtons } from "../space/stand.js";
import { relativeJacobian } from "./colors.js";
import { bodyOf } from "./document.js";
import { boundsOf } from "./state.js";
import { badge, sign, WORST_FIRST } from "./verdict.js";
import { words } from "./words.js";

/** Cells listed at most. */
const LISTED = 60;
/** Largest coordinate of the format. */
const FAR = 1e9;
/** A step of the fields of a corner, as a share of the body. */
const NUDGE = 0.01;

/**
 * @param {App} app
 * @param {() => Now} now
 * @param {Acts} acts
 * @param {{cells: Part, corner: Part & {grid: HTMLElement}, materials: Part}} parts by which the groups are edited
 * @param {Group[]} more groups, of editing
 * @returns {Group[]}
 */
export function createBodyGroups(app, now, acts, parts, more) {
  return [
    cellsGroup(app, now, acts, parts.cells),
    cornerGroup(app, now, acts, parts.corner),
    materialsGroup(app, now, parts.materials),
    ...more,
    sectionGroup(app, now, acts),
    showGroup(app, now, acts),
  ];
}

/** A step of a coordinate: a hundredth of the body, rounded to 1, 2 or 5. @param {Known | null} known */
export function nudgeOf(known) {
  const { min, max } = boundsOf(known?.surface.positions ?? []);
  const wanted = Math.hypot(max[0] - min[0], max[1] - min[1], max[2] - min[2]) * NUDGE;
  const power = 10 ** Math.floor(Math.log10(wanted || 1));
  return power * ([5, 2, 1].find((digit) => digit * power <= wanted) ?? 1);
}

/** Cells from the worst on, and of those with one verdict by their numbers. @param {readonly CellVerdict[]} verdicts */
const worstFirst = (verdicts) =>
  [...verdicts].sort((a, b) => WORST_FIRST.indexOf(a.verdict) - WORST_FIRST.indexOf(b.verdict) || a.cell - b.cell);

/** @param {App} app @param {() => Now} now @param {Acts} acts @param {Part} part @returns {Group} */
function cellsGroup(app, now, { chooseCell }, part) {
  const counts = h("div", { class: "body-counts" });
  const list = h("div", { class: "body-cells", role: "group", "aria-label": words.cells.list });
  const more = h("p", { class: "body-note" });
  const facts = h("div", { class: "body-facts" });
  let drawn = /** @type {unknown} */ (null);
  return {
    name: "cells",
    heading: words.groups.cells,
    body: h("div", {}, counts, list, more, part.element, facts),
    phrase: () => words.cells.phrase(now().known?.cells.length ?? 0),
    render() {
      const { known, isCurrent, shown } = now();
      // Verdicts on what has been edited since are not shown.
      for (const part of [counts, list, facts]) part.classList.toggle("stale", !isCurrent);
      if (drawn !== known?.verdicts) {
        drawn = known?.verdicts;
        const verdicts = known?.verdicts ?? [];
        const present = [...WORST_FIRST].reverse().map((verdict) => ({ verdict, count: verdicts.filter((each) => each.verdict === verdict).length }));
        counts.replaceChildren(
          ...present
            .filter(({ count }) => count > 0)
            .map(({ verdict, count }) =>
              h("span", { class: "body-count", "data-count": verdict }, /** @type {any} */ (sign(verdict)), h("span", { class: "strong number" }, String(count)), ` ${words.verdicts[verdict]}`),
            ),
        );
        const focused = document.activeElement instanceof HTMLElement ? document.activeElement.dataset.cell : undefined;
        list.replaceChildren(
          ...worstFirst(verdicts)
            .slice(0, LISTED)
            .map(({ cell, verdict }) =>
              h(
                "button",
                { type: "button", class: "body-cell", "data-cell": String(cell), onclick: (/** @type {MouseEvent} */ event) => chooseCell(cell, event.shiftKey || event.ctrlKey || event.metaKey) },
                /** @type {any} */ (sign(verdict)),
                h("span", { class: "number" }, String(cell)),
              ),
            ),
        );
        if (focused !== undefined) /** @type {HTMLElement | null} */ (list.querySelector(`[data-cell="${focused}"]`))?.focus();
        write(more, verdicts.length > LISTED ? words.cells.more(verdicts.length - LISTED) : "");
        more.hidden = verdicts.length <= LISTED;
      }
      const listed = worstFirst(known?.verdicts ?? []);
      const chosen = new Set(shown.cells);
      part.render();
      for (const [n, button] of [...list.children].entries()) {
        const { cell, verdict } = listed[n];
        attribute(button, "aria-pressed", String(chosen.has(cell)));
        attribute(button, "title", isCurrent ? words.verdicts[verdict] : null);
        attribute(button, "aria-label", isCurrent ? words.spoken.cell(cell, words.verdicts[verdict]) : words.cells.nth(cell));
      }
      const verdict = known?.verdicts.find(({ cell }) => cell === shown.cell);
      const cell = known?.cells.find(({ id }) => id === shown.cell);
      const next = known && verdict && cell ? cellFacts(app, known, verdict, cell.volume) : [];
      const same = next.length === facts.children.length && next.every((node, i) => facts.children[i].isEqualNode(node));
      if (!same) facts.replaceChildren(...next);
    },
  };
}

/** @param {App} app @param {Known} known @param {CellVerdict} verdict @param {number} volume */
function cellFacts(app, known, verdict, volume) {
  const kind = verdict.witness?.kind;
  const isOpen = !known.summary && verdict.verdict === "locally-valid";
  return [
    h("div", { class: "body-cell-head" }, h("strong", {}, words.cells.nth(verdict.cell)), isOpen ? h("span", {}, words.cells.checking) : badge(verdict.verdict)),
    h("p", { class: "body-note" }, kind === "folded" ? words.folded : kind === "meeting" ? words.meeting : words.means[verdict.verdict]),
    fact(words.cells.margin, fixed(verdict.margin, 2), "margin"),
    fact(words.cells.jacobian, `${fixed(relativeJacobian(verdict, volume), 2)} ${words.cells.ofMean}`, "jacobian"),
    fact(words.cells.volume, measure(Math.abs(volume), bodyOf(app).unit, 3), "volume"),
    ...(verdict.mirrored ? [fact(words.mirrored, "✓", "mirrored")] : []),
  ];
}

/** @param {App} app @param {() => Now} now @param {Acts} acts @param {Part & {grid: HTMLElement}} part @returns {Group} */
function cornerGroup(app, now, { change, moveTo, moved, takeBack, nextCorner }, part) {
  const snapText = h("span", {});
  const fields = /** @type {const} */ ([0, 1, 2]).map((axis) => {
    const name = ["x", "y", "z"][axis];
    const label = `${words.corner.position} ${name}`;
    const field = numberField(
      { label, name: `corner-${name}`, prefix: name, min: -FAR, max: FAR, step: () => nudgeOf(now().known), decimals: 2, rounded: true },
      { change: (value, run) => moveTo(axis, value, run), end: moved, cancel: takeBack },
    );
    field.element.classList.add("short");
    return field;
  });
  const reach = segment(
    { label: words.corner.reach, name: "corner-reach", choices: /** @type {const} */ (["block", "single"]).map((value) => ({ value, text: words.corner.reaches[value] })) },
    (value) => change({ reach: value }),
  );
  const snap = checkBox({ name: "corner-snap", text: [snapText] }, (on) => app.ui.set({ snap: on }));
  const about = h("p", { class: "body-note" });
  const note = h("p", { class: "body-note" });
  const next = h("button", { type: "button", class: "push", "data-corner-next": "", onclick: nextCorner }, words.corner.next);
  const clear = h("button", { type: "button", class: "push", "data-corner-clear": "", onclick: () => change({ corner: null }) }, words.corner.clear);
  const rows = h("div", {}, h("div", { class: "body-fields" }, ...fields.map(({ element }) => element)), ...fields.map(({ error }) => error), part.grid, row(words.corner.reach, reach), note, snap.element);
  return {
    name: "corner",
    heading: words.groups.corner,
    body: h("div", {}, about, rows, part.element, h("div", { class: "body-buttons" }, next, clear)),
    phrase() {
      const { corner } = now();
      return corner ? corner.position.map((value) => fixed(value, 1)).join(", ") : words.corner.none;
    },
    render() {
      const { corner } = now();
      rows.hidden = clear.hidden = !corner;
      write(about, corner ? words.corner.about(new Set(corner.sides.map(({ cell }) => cell)).size, bodyOf(app).unit) : words.corner.hint);
      snap.set(app.ui.value.snap);
      write(snapText, words.corner.snap(`${nudgeOf(now().known)}\u00a0${bodyOf(app).unit}`.trim()));
      reach.set(now().shown.reach);
      write(note, words.corner.reachNote[now().shown.reach]);
      part.render();
      if (corner) fields.forEach((field, axis) => field.set(Number(corner.position[axis].toPrecision(12))));
    },
  };
}

/** @param {App} app @param {() => Now} now @param {Acts} acts @returns {Group} */
function sectionGroup(app, now, { change }) {
  const rows = sectionRows(
    { name: "body", words: words.section, step: () => nudgeOf(now().known), decimals: 2 },
    () => ({ section: now().shown.section, extent: now().extent, unit: bodyOf(app).unit }),
    (section) => change({ section }),
  );
  const area = h("div", {});
  rows.on.append(area, h("p", { class: "body-note" }, words.section.note));
  return {
    name: "section",
    heading: words.groups.section,
    body: rows.element,
    phrase: rows.phrase,
    render() {
      rows.render();
      const { area: cut } = now();
      const next = cut === null ? [] : [fact(words.section.area, measure(cut, bodyOf(app).unit, 2), "area")];
      if (area.textContent !== (next[0]?.textContent ?? "")) area.replaceChildren(...next);
    },
  };
}

/** @param {App} app @param {() => Now} now @param {Part} part @returns {Group} */
function materialsGroup(app, now, part) {
  const list = h("div", { class: "body-materials", role: "list", "aria-label": words.materials.amount });
  let drawn = "";
  return {
    name: "materials",
    heading: words.groups.materials,
    body: h("div", {}, list, part.element),
    phrase: () => words.materials.phrase(bodyOf(app).materials.length),
    render() {
      const { known } = now();
      const { materials, unit } = bodyOf(app);
      part.render();
      const key = JSON.stringify([materials, known?.amounts, unit]);
      if (key === drawn) return;
      drawn = key;
      const whole = known?.amounts.reduce((sum, amount) => sum + amount, 0) ?? 0;
      list.replaceChildren(
        ...materials.map(({ name, color }, i) => {
          const swatch = h("span", { class: "body-swatch" });
          swatch.style.backgroundColor = color;
          const amount = known?.amounts[i];
          const value = amount === undefined ? words.materials.unknown : measure(amount, unit, 3);
          const share = amount === undefined || whole === 0 ? "" : percent(amount / whole);
          return h("div", { class: "body-material", role: "listitem" }, swatch, h("span", {}, name), h("span", { class: "strong number" }, value), h("span", { class: "number" }, share));
        }),
      );
    },
  };
}

/** @param {App} app @param {() => Now} now @param {Acts} acts @returns {Group} */
function showGroup(app, now, { change, look }) {
  const color = segment(
    { label: words.show.color, name: "body-color", choices: /** @type {const} */ (["material", "fraction", "jacobian"]).map((value) => ({ value, text: words.show.colors[value] })) },
    (value) => change({ color: value }),
  );
  const boxes = /** @type {const} */ (["edges", "corners", "light"]).map((name) => ({ name, ...checkBox({ name: `body-${name}`, text: [words.show[name]] }, (on) => change({ [name]: on })) }));
  const share = (/** @type {"apart" | "transparency"} */ name) => slider({ label: words.show[name], name: `body-${name}`, min: 0, max: 1, step: 0.01 }, { change: (value) => change({ [name]: value }) });
  const [apart, transparency] = [share("apart"), share("transparency")];
  const continuity = segment(
    { label: words.show.continuity, name: "body-continuity", choices: /** @type {const} */ (["off", "shape", "material"]).map((value) => ({ value, text: words.show.continuities[value] })) },
    (value) => change({ continuity: value }),
  );
  continuity.element.classList.add("wide");
  const meetings = h("p", { class: "body-note", "data-meetings": "" });
  const material = h("div", {});
  let names = "";
  /** @type {ReturnType<typeof select> | null} */
  let choice = null;
  return {
    name: "show",
    heading: words.groups.show,
    body: h(
      "div",
      {},
      h("div", { class: "body-color" }, color.element),
      material,
      h("div", { class: "layers body-layers" }, ...boxes.map(({ element }) => element)),
      row(words.show.apart, apart),
      row(words.show.transparency, transparency),
      h("p", { class: "body-label" }, words.show.continuity),
      continuity.element,
      meetings,
      viewButtons("body", words.show, look),
    ),
    phrase: () => words.show.colors[now().shown.color],
    render() {
      const { shown } = now();
      const { materials } = bodyOf(app);
      color.set(shown.color);
      apart.set(shown.apart);
      transparency.set(shown.transparency);
      for (const { input } of [apart, transparency]) attribute(input, "aria-valuetext", percent(Number(input.value)));
      continuity.set(shown.continuity);
      const { joints } = now();
      write(meetings, joints && shown.continuity !== "off" ? words.show.meetings(shown.continuity, joints.counts) : "");
      meetings.hidden = meetings.textContent === "";
      for (const { name, set } of boxes) set(shown[name]);
      const key = JSON.stringify(materials.map(({ name }) => name));
      if (key !== names) {
        names = key;
        choice = select({ label: words.show.fraction, name: "body-material", choices: materials.map(({ name }, i) => ({ value: String(i), text: name })) }, (value) => change({ material: Number(value) }));
        material.replaceChildren(row(words.show.fraction, choice));
      }
      material.hidden = shown.color !== "fraction";
      choice?.set(String(Math.min(shown.material, materials.length - 1)));
    },
  };
}
