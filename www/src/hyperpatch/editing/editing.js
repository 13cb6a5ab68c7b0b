/**
 * Editing a body: what can be chosen, what is done with it, and what the picture shows of that.
 *
 * @import { App } from "../../state/app.js"
 * @import { FaceName } from "../../../../js/directrix.js"
 * @import { BodyReading } from "../card.js"
 * @import { createCorner } from "../corner.js"
 * @import { BodyDocument } from "../document.js"
 * @import { Operation, Place, Side } from "../edits.js"
 * @import { Known } from "../runner.js"
 * @import { Shown } from "../state.js"
 */
import "../../../styles/body-editing.css";
import { faceSegments, edgeSegments, placeOf } from "../cell.js";
import { appended, placeOfCorner } from "../edits.js";
import { isSide, toggled } from "../state.js";
import { addBody } from "./add-body.js";
import { createAround } from "./around.js";
import { buildGroup } from "./build-group.js";
import { cellRows } from "./cell-rows.js";
import { createChecks } from "./checks.js";
import { cornerRows } from "./corner-rows.js";
import { materialRows } from "./material-rows.js";
import { operationsGroup } from "./operations-group.js";
import { createRefusal } from "./refusal.js";

const FACES = /** @type {const} */ (["u0", "u1", "v0", "v1", "w0", "w1"]);

/** The face of a cell that parameters lie nearest to. @param {readonly number[]} uvw @returns {FaceName} */
function nearestFace(uvw) {
  const far = FACES.map((face) => Math.abs(uvw["uvw".indexOf(face[0])] - Number(face[1])));
  return FACES[far.indexOf(Math.min(...far))];
}

/**
 * @param {App} app
 * @param {object} of
 * @param {() => {known: Known | null, isCurrent: boolean, shown: Shown}} of.now
 * @param {(patch: Partial<Shown>) => void} of.change
 * @param {ReturnType<typeof createCorner>} of.corner
 * @param {() => number} of.step of lengths, document units
 * @param {() => void} of.render
 */
export function createEditing(app, { now, change, corner, step, render }) {
  const { store } = app;
  const around = createAround({ now, found: () => change({}) });
  const checks = createChecks(() => (now().isCurrent ? now().known : null), render);
  const refusal = createRefusal(app, () => now().shown.invalid);

  /** @param {Operation} operation @param {string} [run] */
  function append(operation, run) {
    const add = (/** @type {unknown} */ document) => /** @type {any} */ (appended(/** @type {BodyDocument} */ (document), operation, run));
    store.commit({ change: add, ...(run === undefined ? {} : { run }) });
  }

  /** @param {number} cell @param {boolean} isMore besides those that are chosen */
  function chooseCell(cell, isMore) {
    const { cells, picksCells } = now().shown;
    const isOnly = cells.length === 1 && cells[0] === cell;
    const next = isMore || picksCells ? toggled(cells, cell) : isOnly ? [] : [cell];
    change({ cells: next, cell: next.at(-1) ?? null });
  }

  const file = addBody(app);
  const joints = cornerRows(app, { now, around: around.current, corner, change, append });
  return {
    parts: {
      cells: cellRows({ now, change }),
      corner: joints,
      materials: materialRows(app, { now, around: around.current, joint: () => joints.joint, append }),
    },
    groups: [
      buildGroup(app, { now, step, change, append, file, checks }),
      operationsGroup(app, {
        now,
        step,
        checks,
        show({ touched, made }, operation) {
          const ids = new Set(now().known?.cells.map(({ id }) => id));
          const cells = [...new Set([...touched, ...made])].filter((id) => ids.has(id));
          const side = sideOf(operation);
          change({ cells, cell: cells.at(-1) ?? null, ...(side && ids.has(side.cell) ? { corner: side, at: operation.op === "move" ? placeIn(operation) : null, others: [] } : {}) });
        },
      }),
    ],
    refusal: refusal.element,
    chooseCell,

    /** A tap in the picture. @param {BodyReading | null} place @param {boolean} isMore */
    tap(place, isMore) {
      const { known, shown } = now();
      if (!shown.picksFaces) {
        if (place) chooseCell(place.cell, isMore);
        else if (!isMore && !shown.picksCells) change({ cell: null, cells: [], corner: null });
        return;
      }
      if (!place) return;
      const face = { cell: place.cell, face: nearestFace(place.uvw) };
      const isOuter = known?.sharing.faces.some(({ sides: [side, other] }) => !other && side.cell === face.cell && side.face === face.face);
      if (isOuter) change({ faces: toggled(shown.faces, face, (a, b) => a.cell === b.cell && a.face === b.face) });
    },

    /** A corner in the picture. @param {Side} side @param {boolean} isMore */
    tapCorner(side, isMore) {
      const { shown } = now();
      const { corner: first, others } = shown;
      if (!(isMore || shown.picksCorners) || !first) corner.choose(side);
      else if (!isSide(first, side)) change({ others: toggled(others, side, isSide), at: null });
    },

    /** What is chosen and what would move with it, for the picture. @param {Known} known */
    picture(known) {
      const { shown } = now();
      const outline = (/** @type {number} */ id) => {
        const cell = known.cellOf(id);
        return cell ? [{ cell: id, segments: edgeSegments(cell) }] : [];
      };
      const faces = shown.faces.flatMap(({ cell: id, face }) => {
        const cell = known.cellOf(id);
        return cell ? [{ cell: id, segments: faceSegments(cell, face) }] : [];
      });
      const wrong = new Set(refusal.cells);
      return {
        chosen: [...(shown.picksFaces ? [] : shown.cells.filter((cell) => !wrong.has(cell)).flatMap(outline)), ...faces],
        wrong: [...wrong].flatMap(outline),
        ghosts: ghostsOf(known, shown),
      };
    },

    /** What is known of the document as it stands. @param {Known} known */
    know: (known) => refusal.know(known),
    render() {
      around.request();
      refusal.render();
    },
    close() {
      around.close();
      checks.close();
      refusal.close();
    },
  };

  /** @param {Known} known @param {Shown} shown */
  function ghostsOf(known, shown) {
    const found = around.current();
    if (!shown.corner) return [];
    const places = [...(found?.moves ?? []), ...shown.others.map(placeOfCorner)];
    /** @type {Map<string, {cell: number, point: import("../../space/vector.js").Vector}>} */
    const points = new Map();
    for (const { cell, at } of places) {
      const point = known.cellOf(cell)?.coefficients[placeOf(at[0], at[1], at[2])].position;
      if (point) points.set(point.map((value) => value.toPrecision(9)).join(" "), { cell, point });
    }
    return [...points.values()];
  }
}

/** The corner that an operation is about. @param {Operation} operation @returns {Side | null} */
function sideOf(operation) {
  if (operation.op === "move" || (operation.op === "mix" && "at" in operation)) return { cell: operation.cell, corner: operation.at.map((along) => (along > 1 ? 1 : 0)) };
  if ((operation.op === "mix" || operation.op === "slope" || operation.op === "continuity") && "corner" in operation && operation.corner) return { cell: operation.cell, corner: operation.corner };
  return null;
}

/** The neighbour that a move is about; null for the corner itself. @param {Extract<Operation, {op: "move"}>} operation @returns {Place | null} */
const placeIn = ({ cell, at }) => (at.every((along) => along === 0 || along === 3) ? null : { cell, at });
