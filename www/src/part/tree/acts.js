/**
 * What can be done with the rows of the feature list, by keys, menu and pointer alike.
 *
 * @import { Item } from "../../frame/menu.js"
 * @import { PartFeature } from "../../../../js/directrix.js"
 * @import { At } from "../edits/features.js"
 * @import { WholePart } from "../document.js"
 * @import { Bench } from "../state.js"
 * @import { Row } from "./rows.js"
 */
import { addBody, boundaryUsers, moveBody, removeBody, renameBody } from "../edits/bodies.js";
import {
  addFeature,
  defaultOf,
  duplicateFeature,
  FEATURE_LIMIT,
  featureAt,
  hideFeature,
  moveFeature,
  placeBeside,
  pure,
  queueOf,
  removeFeature,
  renameFeature,
  setReference,
} from "../edits/features.js";
import { deleteShape, renameShape, shapeOf, shapesOf, usesOf, whyNotName } from "../edits/shapes.js";
import { words } from "./words.js";

/** Kinds of shapes that may close. @param {{kind: string, form?: string}} shape */
const isClosed = ({ kind, form }) => kind === "circle" || kind === "polygon" || (kind === "curve" && form !== "open");

/**
 * @param {Bench} bench
 * @param {{rename: (key: string) => void, go: (key: string) => void}} list
 */
export function createActs(bench, list) {
  const { app } = bench;
  const doc = () => bench.now().document;

  /** @param {Row} row */
  function choose(row) {
    if (row.kind === "shape") bench.change({ shape: row.name, point: null });
    else if (row.kind === "feature") bench.change({ body: row.body, feature: row.feature, shape: null, point: null });
    else if (row.kind !== "shapes") bench.change({ body: row.body, feature: null, shape: null, point: null });
  }

  /** @param {Row} row @param {string} wanted */
  function rename(row, wanted) {
    const name = wanted.trim();
    if (name === "" || name === row.name) return;
    const before = doc();
    if (row.kind === "feature") bench.commit((document) => renameFeature(document, row, name));
    else if (row.kind === "body") bench.commit((document) => renameBody(document, row.body, name));
    else if (row.kind === "shape") {
      if (whyNotName(before, row.name, name) === null) {
        bench.commit((document) => renameShape(document, row.name, name));
        bench.change({ shape: name, point: null });
        list.go(`shape ${name}`);
      }
    }
    app.say(doc() === before ? words.spoken.taken(name) : words.spoken.renamed(name));
  }

  /** @param {Row} row */
  function toggle(row) {
    bench.commit((document) => hideFeature(document, row, !row.hidden));
    app.say((row.hidden ? words.spoken.shown : words.spoken.hidden)(row.name));
  }

  /** Puts a feature at a place of a queue and goes on with it there. @param {At} from @param {At} to */
  function put(from, to) {
    const before = doc();
    const name = featureAt(before, from)?.name ?? "";
    bench.commit((document) => moveFeature(document, from, to));
    if (doc() === before) return;
    const { bodies } = doc();
    bench.change({ body: to.body, feature: to.feature, shape: null, point: null });
    list.go(`feature ${to.body}.${to.feature}`);
    app.say(words.spoken.moved(name, to.feature + 1, queueOf(bodies[to.body]).length, bodies[to.body].name));
  }

  /** @param {Row} row @param {1 | -1} by */
  function move(row, by) {
    if (row.kind === "feature") {
      const to = placeBeside(doc(), row, by);
      if (to) put(row, to);
      else app.say(words.spoken.end);
    } else if (row.kind === "body") {
      const to = row.body + by;
      const { bodies } = doc();
      if (!bodies[to]) return app.say(words.spoken.end);
      bench.commit((document) => moveBody(document, row.body, to));
      bench.change({ body: to, feature: null, shape: null, point: null });
      list.go(`body ${to}`);
      app.say(words.spoken.bodyMoved(row.name, to + 1, bodies.length));
    }
  }

  /** @param {Row} row */
  function duplicate(row) {
    const before = doc();
    bench.commit((document) => duplicateFeature(document, row));
    if (doc() !== before) added({ body: row.body, feature: row.feature + 1 });
  }

  /** @param {At} at */
  function added(at) {
    bench.change({ ...at, shape: null, point: null });
    list.go(`feature ${at.body}.${at.feature}`);
    app.say(words.spoken.added(featureAt(doc(), at)?.name ?? ""));
  }

  /** @param {Row} row */
  function remove(row) {
    const before = doc();
    if (row.kind === "feature") {
      bench.commit((document) => removeFeature(document, row));
      const left = queueOf(doc().bodies[row.body]).length;
      const next = left > 0 ? Math.min(row.feature, left - 1) : null;
      bench.change({ body: row.body, feature: next, shape: null, point: null });
      list.go(next === null ? `default ${row.body}` : `feature ${row.body}.${next}`);
    } else if (row.kind === "body") {
      bench.commit((document) => removeBody(document, row.body));
      if (doc() === before) return app.say(reasonToKeep(row) ?? "");
      bench.change({ body: Math.max(0, row.body - 1), feature: null, shape: null, point: null });
      list.go(`body ${Math.max(0, row.body - 1)}`);
    } else if (row.kind === "shape") {
      bench.commit((document) => deleteShape(document, row.name, { withUses: true }));
      bench.change({ shape: null, point: null });
      list.go("shapes");
    }
    if (doc() !== before) app.say(words.spoken.removed(row.name));
  }

  /** Why a body stays, or null. @param {Row} row */
  function reasonToKeep(row) {
    if (doc().bodies.length < 2) return words.menu.onlyBody;
    const users = boundaryUsers(doc(), row.body);
    return users.length > 0 ? words.menu.measured(users) : null;
  }

  /**
   * A feature measured to a shape, or to the boundary of its body, at the tail of the queue or at a place of it.
   * @param {number} body
   * @param {string | null} shape
   * @param {number} [place]
   */
  function addTo(body, shape, place) {
    const before = doc();
    bench.commit((document) => addFeature(document, body, firstFeature(document, body, shape), place));
    if (doc() !== before) added({ body, feature: place ?? queueOf(doc().bodies[body]).length - 1 });
  }

  /** @param {string} outline */
  function bodyOf(outline) {
    const before = doc();
    bench.commit((document) => addBody(document, outline));
    if (doc() === before) return;
    const body = doc().bodies.length - 1;
    bench.change({ body, feature: null, shape: null, point: null });
    list.go(`body ${body}`);
    app.say(words.spoken.added(doc().bodies[body].name));
  }

  /** What is not to be had says why. @param {number} body */
  const room = (body) => {
    const line = !doc().bodies[body] ? words.menu.noBody : queueOf(doc().bodies[body]).length >= FEATURE_LIMIT ? words.menu.full(FEATURE_LIMIT) : null;
    return line === null ? {} : { disabled: true, line };
  };

  /** The menu of a row. @param {Row} row @returns {(Item | "line")[]} */
  function menuOf(row) {
    const { menu } = words;
    const renaming = { name: "rename", text: menu.rename, keys: "F2", act: () => list.rename(row.key) };
    const deleting = { name: "delete", text: menu.remove, keys: "Delete", act: () => remove(row) };
    const moving = (/** @type {(by: 1 | -1) => boolean} */ can) => [
      { name: "up", text: menu.up, keys: "Alt+ArrowUp", disabled: !can(-1), act: () => move(row, -1) },
      { name: "down", text: menu.down, keys: "Alt+ArrowDown", disabled: !can(1), act: () => move(row, 1) },
    ];
    const document = doc();
    switch (row.kind) {
      case "feature":
        return [
          renaming,
          { name: "hide", text: row.hidden ? menu.show : menu.hide, act: () => toggle(row) },
          { name: "duplicate", text: menu.duplicate, ...room(row.body), act: () => duplicate(row) },
          "line",
          ...moving((by) => placeBeside(document, row, by) !== null),
          "line",
          deleting,
        ];
      case "default":
        return [{ name: "add-feature", text: menu.featureHere, ...room(row.body), act: () => addTo(row.body, null, 0) }];
      case "body": {
        const reason = reasonToKeep(row);
        return [
          renaming,
          { name: "add-feature", text: menu.feature, ...room(row.body), act: () => addTo(row.body, null) },
          "line",
          ...moving((by) => document.bodies[row.body + by] !== undefined),
          "line",
          { ...deleting, ...(reason ? { disabled: true, line: reason } : {}) },
        ];
      }
      case "shape": {
        const shape = shapeOf(document, row.name);
        const { body, feature } = bench.now().shown;
        const at = body !== null && feature !== null ? { body, feature } : null;
        const chosen = at ? featureAt(document, at) : null;
        const uses = usesOf(document, row.name).length;
        return [
          renaming,
          { name: "add-feature", text: menu.featureOn, ...room(body ?? 0), act: () => addTo(body ?? 0, row.name) },
          ...(chosen && at && chosen.reference !== row.name
            ? [{ name: "measure", text: menu.measure(chosen.name ?? ""), act: () => bench.commit((now) => setReference(now, at, row.name)) }]
            : []),
          ...(shape && isClosed(shape) ? [{ name: "add-body", text: menu.body, act: () => bodyOf(row.name) }] : []),
          "line",
          { ...deleting, ...(uses > 0 ? { line: menu.inUse(uses) } : {}) },
        ];
      }
      default:
        return [];
    }
  }

  /** What can be added. @returns {(Item | "line")[]} */
  function additions() {
    const document = doc();
    const { body, shape } = bench.now().shown;
    const target = body ?? 0;
    const outlines = document.bodies.map(({ outline }) => outline);
    const free = shapesOf(document).filter((each) => isClosed(each) && !outlines.includes(each.name));
    return [
      { name: "add-feature", text: words.menu.feature, ...room(target), act: () => addTo(target, shape) },
      ...free.slice(0, 8).map(({ name }) => ({ name: `add-body ${name}`, text: words.menu.bodyOf(name), act: () => bodyOf(name) })),
    ];
  }

  return { choose, rename, toggle, put, move, duplicate, remove, menuOf, additions };
}

/** Share of the shorter side of what is drawn that a new band takes. */
const BAND = 0.25;

/**
 * A feature as it is added: from a pure material that is not the default, to the default.
 * @param {WholePart} document
 * @param {number} body
 * @param {string | null} shape what it is measured to; null for the boundary of its body
 * @returns {PartFeature}
 */
function firstFeature(document, body, shape) {
  const standard = defaultOf(document, body);
  const most = standard.indexOf(Math.max(...standard));
  const count = standard.length;
  const used = queueOf(document.bodies[body]).map(({ start = [] }) => start.indexOf(1));
  const others = standard.map((_, k) => k).filter((k) => k !== most);
  const material = others.find((k) => !used.includes(k)) ?? others[0] ?? most;
  return {
    name: words.unnamed,
    hidden: false,
    reference: shape ?? { boundary: document.bodies[body].name, except: [] },
    from: 0,
    to: bandOf(document),
    start: pure(material, count),
    end: [...standard],
    course: { kind: "smoothstep" },
  };
}

/** A width for a band: a quarter of the shorter side of all shapes, rounded to 1, 2 or 5. @param {WholePart} document */
function bandOf(document) {
  const numbers = shapesOf(document).flatMap((shape) =>
    shape.kind === "circle"
      ? [[shape.center[0] - shape.radius, shape.center[1] - shape.radius], [shape.center[0] + shape.radius, shape.center[1] + shape.radius]]
      : "points" in shape
        ? shape.points
        : [],
  );
  const spread = [0, 1].map((axis) => {
    const along = numbers.map((point) => point[axis]);
    return along.length > 0 ? Math.max(...along) - Math.min(...along) : 0;
  });
  const wanted = BAND * (Math.min(...spread) || Math.max(...spread) || 40);
  const power = 10 ** Math.floor(Math.log10(wanted));
  return Number((power * ([5, 2, 1].find((digit) => digit * power <= wanted) ?? 1)).toPrecision(6));
}
