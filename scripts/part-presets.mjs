/**
 * Writes the presets of parts, `www/presets/part/`: documents whose long lists of points follow from a few numbers.
 *
 *     node scripts/part-presets.mjs
 */
import { mkdir, writeFile } from "node:fs/promises";

/** @typedef {[number, number]} Point */

const RED = { name: "red", color: "#d55e00" };
const GREEN = { name: "green", color: "#009e73" };
const YELLOW = { name: "yellow", color: "#f0e442" };

/** @param {number} value */
const round = (value) => Number(value.toFixed(4));

/** @param {string} name @param {number} left @param {number} bottom @param {number} width @param {number} height */
const box = (name, left, bottom, width, height) => ({
  name,
  kind: "polygon",
  points: [
    [left, bottom],
    [left + width, bottom],
    [left + width, bottom + height],
    [left, bottom + height],
  ],
});

/** @param {string} title @param {object[]} materials @param {object[]} shapes @param {object[]} bodies @param {object[]} [rules] */
const part = (title, materials, shapes, bodies, rules) => ({
  directrix: 1,
  kind: "part",
  title,
  materials,
  shapes,
  bodies,
  ...(rules ? { rules } : {}),
});

/** Two profiles on two edges of a rectangle (Liu and others 2003, Figs. 6 and 7), limits .3 of its width. */
const rectangle = part(
  "Rectangle of two profiles",
  [RED, GREEN, YELLOW],
  [
    box("rectangle", 0, 0, 100, 60),
    { name: "edge A", kind: "segment", from: [0, 0], to: [0, 60] },
    { name: "edge B", kind: "segment", from: [0, 0], to: [100, 0] },
  ],
  [
    {
      name: "rectangle",
      outline: "rectangle",
      default: [0, 0, 1],
      features: [
        { name: "A", reference: "edge A", to: 30, start: [1, 0, 0] },
        { name: "B", reference: "edge B", to: 30, start: [0, 1, 0] },
      ],
    },
  ],
  [{ name: "red changes slowly", material: 0, of: "gradient", most: 0.05 }],
);

/** A base and a cylinder on it in section, the section of Fig. 21: red at the base, green at the cylinder, yellow in between. */
const base = part(
  "Base and cylinder in section",
  [RED, GREEN, YELLOW],
  [
    {
      name: "outline",
      kind: "polygon",
      points: [[0, 0], [120, 0], [120, 30], [85, 30], [85, 90], [35, 90], [35, 30], [0, 30]],
    },
    {
      name: "faces of the base",
      kind: "polyline",
      points: [[35, 30], [0, 30], [0, 0], [120, 0], [120, 30], [85, 30]],
    },
  ],
  [
    {
      name: "part",
      outline: "outline",
      default: [0, 0, 1],
      features: [
        { name: "base", reference: "faces of the base", to: 14, start: [1, 0, 0] },
        {
          name: "cylinder",
          reference: { boundary: "part", except: ["faces of the base"] },
          to: 20,
          start: [0, 1, 0],
        },
      ],
    },
  ],
);

/** Two bars with the same profile, of the distance to an axis and of the distance to the surface (Fig. 5). */
const references = part(
  "Axis and surface as references",
  [{ name: "core", color: "#0072b2" }, { name: "skin", color: "#f0e442" }],
  [
    { name: "upper bar", kind: "polygon", points: [[0, 40], [90, 40], [110, 55], [90, 70], [0, 70], [10, 55]] },
    { name: "axis", kind: "line", through: [0, 55], direction: [1, 0] },
    { name: "lower bar", kind: "polygon", points: [[0, 0], [90, 0], [110, 15], [90, 30], [0, 30], [10, 15]] },
  ],
  [
    {
      name: "by its axis",
      outline: "upper bar",
      default: [0, 1],
      features: [{ name: "axis", reference: "axis", to: 15, start: [1, 0], course: { kind: "smoothstep" } }],
    },
    {
      name: "by its surface",
      outline: "lower bar",
      default: [1, 0],
      features: [
        { name: "surface", reference: { boundary: "by its surface" }, to: 15, start: [0, 1], course: { kind: "smoothstep" } },
      ],
    },
  ],
);

/** The arc of a circle through two points at the same height, from the first to the second. @param {number} half @param {number} sag @param {number} count */
const arc = (half, sag, count) => {
  const radius = (half ** 2 + sag ** 2) / (2 * sag);
  const angle = Math.asin(half / radius);
  return Array.from({ length: count }, (_, n) => {
    const at = angle * (1 - (2 * n) / (count - 1));
    return /** @type {Point} */ ([round(radius * Math.sin(at)), round(radius * Math.cos(at) - radius + sag)]);
  });
};

/** A lens whose index falls with the square of the distance from its axis, with a coating on one face. */
const top = arc(40, 12, 49);
const bottom = arc(40, 9, 49).slice(1, -1).reverse().map(([x, y]) => [x, round(-y)]);
const lens = part(
  "Lens in section",
  [{ name: "crown glass", color: "#56b4e9" }, { name: "flint glass", color: "#0072b2" }, { name: "coating", color: "#e69f00" }],
  [
    { name: "lens", kind: "polygon", points: [...top, ...bottom] },
    { name: "axis", kind: "line", through: [0, 0], direction: [0, 1] },
    { name: "front", kind: "polyline", points: top },
  ],
  [
    {
      name: "lens",
      outline: "lens",
      default: [1, 0, 0],
      features: [
        { name: "index", reference: "axis", to: 40, start: [0, 1, 0], course: { kind: "power", power: 2 } },
        { name: "coating", reference: "front", to: 0.8, start: [0, 0, 1] },
      ],
    },
  ],
);

/** A block with round pores whose walls carry a growth factor, and a rim that is stiff. */
const pores = Array.from({ length: 20 }, (_, n) => {
  const [row, column] = [Math.floor(n / 5), n % 5];
  return { name: `pore ${n + 1}`, kind: "circle", center: [12 + 16 * column + (row % 2) * 8, 12 + 15 * row], radius: 4 + (n % 3) };
});
const scaffold = part(
  "Scaffold",
  [{ name: "polymer", color: "#f0e442" }, { name: "bioactive glass", color: "#cc79a7" }, { name: "hydroxyapatite", color: "#0072b2" }],
  [box("block", 0, 0, 96, 69), ...pores],
  [
    {
      name: "scaffold",
      outline: "block",
      holes: pores.map(({ name }) => name),
      default: [1, 0, 0],
      features: [
        { name: "walls of the pores", reference: { boundary: "scaffold", except: ["block"] }, to: 4, start: [0, 1, 0], course: { kind: "exponential", rate: 2 } },
        { name: "rim", reference: "block", to: 6, start: [0, 0, 1], course: { kind: "smoothstep" } },
      ],
    },
  ],
  [{ name: "enough polymer", material: 0, of: "fraction", least: 0.05 }],
);

/** An injection-moulding tool: hard at the cavity, copper round the cooling channels. */
const channels = [[18, 16], [38, 22], [60, 24], [82, 22], [102, 16]].map((center, n) => ({ name: `channel ${n + 1}`, kind: "circle", center, radius: 4 }));
const cavity = Array.from({ length: 41 }, (_, n) => {
  const x = 10 + 2.5 * n;
  return /** @type {Point} */ ([x, round(46 - 8 * Math.cos(((x - 60) / 50) * (Math.PI / 2)) ** 2)]);
});
const tool = part(
  "Tool with cooling channels",
  [{ name: "tool steel", color: "#c3c9d2" }, { name: "carbide", color: "#0072b2" }, { name: "copper", color: "#d55e00" }],
  [
    { name: "tool", kind: "polygon", points: [[0, 0], [120, 0], [120, 46], ...cavity.toReversed(), [0, 46]] },
    { name: "cavity", kind: "polyline", points: cavity },
    ...channels,
  ],
  [
    {
      name: "tool",
      outline: "tool",
      holes: channels.map(({ name }) => name),
      default: [1, 0, 0],
      features: [
        { name: "hard face", reference: "cavity", to: 9, start: [0, 1, 0], course: { kind: "smoothstep" } },
        { name: "channels", reference: { boundary: "tool", except: ["tool"] }, to: 12, start: [0, 0, 1] },
        {
          name: "from channel to face",
          references: { face: "cavity", pipe: "channel 3" },
          distance: "face + pipe",
          from: 10,
          to: 22,
          start: [0.4, 0, 0.6],
          course: { kind: "piecewise", keys: [{ at: 0, mix: [1, 0, 0] }, { at: 0.5, mix: [0.4, 0, 0.6] }, { at: 1, mix: [1, 0, 0] }] },
        },
      ],
    },
  ],
);

/** A coating of 1 under a gradient of 50: the rule `depth` loses it, and Eq. 2 as printed as well. */
const coating = part(
  "Thin coating under a deep gradient",
  [{ name: "coating", color: "#d55e00" }, { name: "gradient", color: "#0072b2" }, { name: "core", color: "#f0e442" }],
  [
    box("plate", 0, 0, 80, 50),
    { name: "top", kind: "segment", from: [0, 50], to: [80, 50] },
    { name: "left", kind: "segment", from: [0, 0], to: [0, 50] },
  ],
  [
    {
      name: "plate",
      outline: "plate",
      default: [0, 0, 1],
      features: [
        { name: "gradient", reference: "left", to: 50, start: [0, 1, 0] },
        { name: "coating", reference: "top", to: 1, start: [1, 0, 0] },
      ],
    },
  ],
);

/** A plate with two pipes and a foot, insulated elsewhere: what heat would do between them, material does. */
const heatPlate = part(
  "Plate between two pipes",
  [{ name: "copper", color: "#d55e00" }, { name: "steel", color: "#0072b2" }, { name: "ceramic", color: "#f0e442" }],
  [
    box("plate", 0, 0, 120, 70),
    { name: "copper pipe", kind: "circle", center: [34, 42], radius: 11 },
    { name: "steel pipe", kind: "circle", center: [88, 46], radius: 8 },
    { name: "foot", kind: "segment", from: [25, 0], to: [95, 0] },
  ],
  [
    {
      name: "plate",
      outline: "plate",
      holes: ["copper pipe", "steel pipe"],
      blend: {
        kind: "laplace",
        boundaries: [
          { on: "plate" },
          { on: "copper pipe", value: [1, 0, 0] },
          { on: "steel pipe", value: [0, 1, 0] },
          { on: "foot", value: [0, 0, 1] },
        ],
      },
    },
  ],
);

/** A material fillet between adjacent components, as that of Fig. 23: what lies between two bodies takes its boundary from both. */
const fillet = part(
  "Material fillet between shaft and hub",
  [{ name: "steel", color: "#0072b2" }, { name: "bronze", color: "#d55e00" }, { name: "aluminium", color: "#f0e442" }],
  [
    box("hub", -60, -42, 120, 84),
    {
      name: "seam",
      kind: "curve",
      degree: 3,
      form: "periodic",
      points: Array.from({ length: 12 }, (_, k) => {
        const [angle, radius] = [(k * Math.PI) / 6, k % 2 === 0 ? 37 : 29];
        return [round(radius * Math.cos(angle)), round(radius * Math.sin(angle))];
      }),
    },
    { name: "shaft", kind: "circle", center: [0, 0], radius: 15 },
    { name: "left side", kind: "segment", from: [-60, -42], to: [-60, 42] },
  ],
  [
    {
      name: "hub",
      outline: "hub",
      holes: ["seam"],
      default: [0, 0, 1],
      features: [{ name: "from the left", reference: "left side", to: 120, start: [0, 1, 0] }],
    },
    {
      name: "fillet",
      outline: "seam",
      holes: ["shaft"],
      default: [0, 0, 1],
      blend: {
        kind: "laplace",
        boundaries: [
          { on: "seam", from: { body: "hub" } },
          { on: "shaft", from: { body: "shaft" } },
        ],
      },
    },
    { name: "shaft", outline: "shaft", default: [1, 0, 0] },
  ],
);

/** JSON with lists of numbers, and small objects, on a line each. @param {object} document */
function textOf(document) {
  const short = (/** @type {unknown} */ value) => JSON.stringify(value).replace(/([,:])(?=\S)/g, "$1 ");
  /** @param {unknown} value @param {string} indent @returns {string} */
  const written = (value, indent) => {
    if (typeof value !== "object" || value === null || short(value).length + indent.length <= 130) return short(value);
    const inner = `${indent} `;
    const isList = Array.isArray(value);
    const items = isList
      ? value.map((item) => written(item, inner))
      : Object.entries(value).map(([key, item]) => `${JSON.stringify(key)}: ${written(item, inner)}`);
    const [open, close] = isList ? "[]" : "{}";
    return `${open}\n${inner}${items.join(`,\n${inner}`)}\n${indent}${close}`;
  };
  return `${written(document, "")}\n`;
}

const presets = { rectangle, base, references, lens, scaffold, tool, coating, "heat-plate": heatPlate, fillet };
const folder = new URL("../www/presets/part/", import.meta.url);
await mkdir(folder, { recursive: true });
for (const [name, document] of Object.entries(presets)) await writeFile(new URL(`${name}.json`, folder), textOf(document));
