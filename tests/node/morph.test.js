/** The matched pair as paths, what is written of them, and the times of the morph. */
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { DirectrixError, load } from "directrix";
import { hex } from "../../www/src/morph/color.js";
import { eased, places, round, shareAt } from "../../www/src/morph/motion.js";
import { commands, moved } from "../../www/src/morph/path-data.js";
import { pathText } from "../../www/src/morph/path-texts.js";
import { webm } from "../../www/src/morph/webm.js";

/** @import { MorphPaths, Point } from "directrix" */
/** @import { Motion } from "../../www/src/morph/motion.js" */

const dx = await load();

/** @type {Motion} */
const swing = { seconds: 3, easing: "ease", repeat: "swing" };

/** @param {string} name */
const preset = (name) => JSON.parse(readFileSync(new URL(`../../www/presets/${name}.json`, import.meta.url), "utf8"));

/** @param {string} path */
const numbersOf = (path) => (path.match(/-?\d+(\.\d+)?/g) ?? []).map(Number);

/** The path with the numbers of two blended evenly. @param {MorphPaths} paths @param {number} s */
function blended({ from, to }, s) {
  const ends = numbersOf(to);
  let k = 0;
  return from.replace(/-?\d+(\.\d+)?/g, (text) => String(Number(text) * (1 - s) + ends[k++] * s));
}

/** The closed polyline that reading an SVG of the path gives. @param {string} path */
function reread(path) {
  const { shapes, skipped } = dx.readShapes(`<svg xmlns="http://www.w3.org/2000/svg"><path d="${path}"/></svg>`);
  assert.deepEqual([shapes.length, skipped.length], [1, 0]);
  return shapes[0].points;
}

/** The largest distance of every third of the points from a closed polyline. @param {Point[]} points @param {Point[]} line */
function off(points, line) {
  let largest = 0;
  for (const [x, y] of points.filter((_, i) => i % 3 === 0)) {
    let nearest = Infinity;
    line.forEach(([ax, ay], i) => {
      const [bx, by] = line[(i + 1) % line.length];
      const [dx, dy] = [bx - ax, by - ay];
      const square = dx * dx + dy * dy;
      const t = square === 0 ? 0 : Math.min(1, Math.max(0, ((x - ax) * dx + (y - ay) * dy) / square));
      nearest = Math.min(nearest, Math.hypot(x - ax - t * dx, y - ay - t * dy));
    });
    largest = Math.max(largest, nearest);
  }
  return largest;
}

test("paths read again, and blended, are the stages within the error that they state", () => {
  for (const name of ["amoeba", "sharp-square", "three-materials", "u-in-oval", "letter-s"]) {
    const document = preset(name);
    const stages = dx.stages(document, { refine: 16 });
    if (stages.length === 0) {
      assert.equal(dx.morphPaths(document), null);
      continue;
    }
    const paths = dx.morphPaths(document);
    assert.ok(paths);
    const [, , wide, high] = paths.viewBox;
    const size = Math.hypot(wide, high);
    assert.ok(paths.error > 0 && paths.error <= 1.01e-4 * size, `${name}: ${paths.error} of ${size}`);
    const letters = [paths.from, paths.to].map((path) => path.replaceAll(/[^A-Za-z]/g, ""));
    assert.deepEqual(letters, Array(2).fill(`M${"C".repeat(paths.commands)}Z`));
    for (const { s, points } of stages) {
      const line = reread(blended(paths, s));
      // Reading turns curves into polylines within 1/50 000 of their size, and stages have chords.
      const slack = size * 6e-5;
      const [there, back] = [off(points, line), off(line, points)];
      assert.ok(there <= paths.error + slack && back <= paths.error + slack, `${name} at ${s}: ${there}, ${back}, ${paths.error}`);
    }
  }
});

test("curves fitted to the paths read again make the same figure", () => {
  const document = preset("amoeba");
  const tolerance = 0.02;
  const paths = dx.morphPaths(document, { tolerance });
  assert.ok(paths && paths.error <= tolerance);
  const curves = [paths.from, paths.to].map((path) => {
    const { curve, error, simple } = dx.fitCurve(reread(path), { tolerance });
    assert.ok(simple && error <= tolerance);
    return curve;
  });
  const again = { ...document, curves: curves.map((curve, k) => ({ ...document.curves[k], ...curve, composition: undefined })) };
  for (const curve of again.curves) delete curve.composition;
  const [first, second] = [dx.stages(document, { refine: 4 }), dx.stages(again, { refine: 4 })];
  assert.equal(second.length, first.length);
  for (const j of [0, first.length - 1]) assert.ok(off(first[j].points, second[j].points) < 3 * tolerance);
});

test("a path keeps to its tolerance, takes fewer commands for a wider one, and has the materials of each", () => {
  const document = preset("three-materials");
  const counts = [1e-6, 0.01, 1].map((tolerance) => {
    const paths = dx.morphPaths(document, { tolerance });
    assert.ok(paths && paths.error <= tolerance);
    for (const all of paths.fractions) {
      assert.equal(all.length, paths.commands);
      for (const fractions of all) assert.ok(Math.abs(fractions.reduce((a, b) => a + b) - 1) < 1e-9);
    }
    return paths.commands;
  });
  assert.ok(counts[0] > counts[1] && counts[1] > counts[2], String(counts));
});

test("open curves give open paths, which are stroked and cut nothing out", () => {
  const arc = (/** @type {number} */ radius) => ({
    degree: 3,
    form: "open",
    points: Array.from({ length: 7 }, (_, k) => [radius * Math.cos(0.5 * k), radius * Math.sin(0.5 * k)]),
  });
  const document = /** @type {any} */ ({ directrix: 1, kind: "curves", curves: [arc(10), arc(20)], matching: { method: "exact", oneToOne: true } });
  const stages = dx.stages(document, { refine: 16 });
  const paths = dx.morphPaths(document);
  assert.ok(paths && !paths.closed && stages.length > 0);
  for (const { s, points } of stages) {
    const numbers = numbersOf(blended(paths, s));
    /** @type {Point[]} */
    const line = [];
    for (let k = 0; k < paths.commands; k += 1) {
      for (let i = 0; i <= 32; i += 1) {
        const [t, r] = [i / 32, 1 - i / 32];
        const [x, y] = [0, 1].map((axis) => [r ** 3, 3 * r * r * t, 3 * r * t * t, t ** 3].reduce((sum, w, j) => sum + w * numbers[6 * k + 2 * j + axis], 0));
        line.push([x, -y]);
      }
    }
    // The way back from end to end, which both polylines are given here, is the same.
    const [there, back] = [off(points, line), off(line, points)];
    assert.ok(there < paths.error + 2e-3 && back < paths.error + 2e-3, `${s}: ${there} ${back} ${paths.error}`);
  }
  const texts = { title: "Arcs", materials: /** @type {any} */ (dx.defaults(document).materials), motion: swing };
  assert.doesNotMatch(pathText("css", paths, texts), /clip-path/);
  assert.match(pathText("smil", paths, texts), /<path stroke="#[0-9a-f]{6}" fill="none"/);
  assert.doesNotMatch(paths.from, /Z/);
});

test("what cannot be is refused with its path, or null", async () => {
  const document = preset("amoeba");
  const refused = (/** @type {any} */ options) => {
    try {
      dx.morphPaths(document, options);
    } catch (error) {
      assert.ok(error instanceof DirectrixError);
      return [error.code, error.path];
    }
    throw new assert.AssertionError({ message: `${JSON.stringify(options)} was taken` });
  };
  assert.deepEqual(refused({ tolerance: 0 }), ["range", "options.tolerance"]);
  assert.deepEqual(refused({ tolerance: 1e6 }), ["range", "options.tolerance"]);
  assert.deepEqual(refused({ tolerance: "fine" }), ["type", "options.tolerance"]);
  assert.deepEqual(refused({ tolerance: NaN }), ["non-finite", "options.tolerance"]);
  assert.deepEqual(refused({ digits: 2 }), ["unknown-field", "options.digits"]);
  assert.equal(dx.morphPaths({ ...document, curves: document.curves.slice(0, 1) }), null);
  const figure = await load({ module: "figure" });
  assert.throws(() => figure.morphPaths(document), { code: "not-in-module" });
});

test("the texts hold the two paths as they are", () => {
  const { title, materials } = dx.defaults(preset("amoeba"));
  assert.ok(title && materials);
  const paths = dx.morphPaths(preset("amoeba"));
  assert.ok(paths);
  const text = (/** @type {"svg" | "json" | "css" | "smil"} */ kind) => pathText(kind, paths, { title: `${title} <&>`, materials: /** @type {any} */ (materials), motion: swing });
  const { from, to, commands: count, error, viewBox } = JSON.parse(text("json"));
  assert.deepEqual({ from, to, count, error, viewBox }, { from: paths.from, to: paths.to, count: paths.commands, error: paths.error, viewBox: paths.viewBox });
  const { shapes } = dx.readShapes(text("svg"));
  assert.deepEqual(shapes.map(({ name, closed }) => [name, closed]), [["from", true], ["to", true]]);
  assert.equal(dx.readShapes(text("smil")).shapes.length, 1);
  assert.match(text("smil"), new RegExp(`values="${paths.from};${paths.to};${paths.from}" dur="6s" repeatCount="indefinite"`));
  const css = text("css");
  assert.ok(css.includes(`d: path("${paths.from}")`) && css.includes(`d: path("${paths.to}")`));
  assert.match(css, /3s cubic-bezier\(0\.333333, 0, 0\.666667, 1\) infinite alternate/);
  const clips = [...css.matchAll(/clip-path: path\("([^"]+)"\)/g)].map(([, path]) => numbersOf(path ?? ""));
  assert.equal(clips.length, 2);
  for (const numbers of clips) assert.ok(Math.min(...numbers) >= -0.01 && Math.max(...numbers) <= 400.01);
});

test("paths are moved number by number, and cut into their commands", () => {
  const path = "M0 -1C1 2 3 4 5 -6C7 8 9 10 0 -1Z";
  assert.equal(moved(path, { scale: 2, x: 10, y: 0.25 }, 1), "M10 -1.8C12 4.3 16 8.3 20 -11.8C24 16.3 28 20.3 10 -1.8Z");
  assert.deepEqual(commands(path), [
    { start: "0 -1", cubic: "C1 2 3 4 5 -6" },
    { start: "5 -6", cubic: "C7 8 9 10 0 -1" },
  ]);
});

test("colours are mixed in Oklab, and come back where nothing is mixed", () => {
  for (const color of ["#f0e442", "#0072b2", "#000000", "#ffffff"]) assert.equal(hex([color], [1]), color);
  // The mean of black and white is the grey of half their lightness.
  assert.match(hex(["#ffffff", "#000000"], [0.5, 0.5]), /^#(63|64)(63|64)(63|64)$/);
});

test("frames are eased, there and back without a pause, and from curve to curve else", () => {
  for (const easing of /** @type {const} */ (["linear", "ease"])) {
    for (const s of [0, 0.1, 0.5, 0.93, 1]) assert.ok(Math.abs(eased(easing, shareAt(easing, s)) - s) < 1e-12);
    const once = places({ easing, repeat: "once" }, 7);
    assert.deepEqual([once[0], once[6]], [0, 1]);
    const back = places({ easing, repeat: "swing" }, 8);
    assert.deepEqual([back[0], back[4]], [0, 1]);
    assert.ok(Math.abs(back[1] - back[7]) < 1e-12 && back[7] > 0);
    for (const all of [once, back.slice(0, 5)]) assert.ok(all.every((s, i) => i === 0 || s > all[i - 1]));
  }
  assert.equal(eased("ease", 0.25), 0.15625);
  assert.deepEqual([round({ seconds: 4, repeat: "swing" }), round({ seconds: 4, repeat: "loop" })], [8, 4]);
});

/**
 * A reader of elements of its own: names, and the bytes of those that hold no others.
 * @param {Uint8Array} bytes
 * @returns {{id: string, at: number, content: any}[]}
 */
function elements(bytes) {
  const nested = ["1a45dfa3", "18538067", "1549a966", "1654ae6b", "ae", "e0", "1f43b675", "1c53bb6b", "bb", "b7"];
  const found = [];
  for (let at = 0; at < bytes.length; ) {
    const idLength = Math.clz32(bytes[at]) - 23;
    const id = [...bytes.subarray(at, at + idLength)].map((byte) => byte.toString(16).padStart(2, "0")).join("");
    assert.equal(bytes[at + idLength], 1, "sizes have eight bytes");
    const start = at + idLength + 8;
    const size = [...bytes.subarray(at + idLength + 1, start)].reduce((sum, byte) => sum * 256 + byte, 0);
    const content = bytes.subarray(start, start + size);
    assert.equal(content.length, size);
    found.push({ id, at, content: nested.includes(id) ? elements(content) : content });
    at = start + size;
  }
  return found;
}

test("a film has its frames at their times, and its list of clusters finds them", async () => {
  const rate = 25;
  const chunks = Array.from({ length: 120 }, (_, i) => ({ time: Math.round((i * 1000) / rate), isKey: i % 48 === 0, data: new Uint8Array([i, 1, 2]) }));
  const blob = webm({ codec: "V_VP9", width: 640, height: 300, rate, seconds: 4.8, color: { matrix: "bt709", fullRange: false } }, chunks);
  assert.equal(blob.type, "video/webm");
  const [head, segment] = elements(new Uint8Array(await blob.arrayBuffer()));
  assert.deepEqual([head.id, segment.id], ["1a45dfa3", "18538067"]);
  const inside = (/** @type {any[]} */ list, /** @type {string} */ id) => list.filter((each) => each.id === id);
  const number = (/** @type {Uint8Array} */ bytes) => [...bytes].reduce((sum, byte) => sum * 256 + byte, 0);
  const [info] = inside(segment.content, "1549a966");
  const [{ content: duration }] = inside(info.content, "4489");
  assert.equal(new DataView(duration.buffer, duration.byteOffset).getFloat64(0), 4800);
  const clusters = inside(segment.content, "1f43b675");
  assert.equal(clusters.length, 3);
  const times = clusters.flatMap(({ content }) => {
    const start = number(inside(content, "e7")[0].content);
    return inside(content, "a3").map(({ content: block }, i) => {
      assert.equal(block[3], i === 0 ? 0x80 : 0);
      return [start + block[1] * 256 + block[2], block[4]];
    });
  });
  assert.deepEqual(times, chunks.map(({ time, data }) => [time, data[0]]));
  const [cues] = inside(segment.content, "1c53bb6b");
  const places = inside(cues.content, "bb").map(({ content }) => number(inside(inside(content, "b7")[0].content, "f1")[0].content));
  assert.deepEqual(places, clusters.map(({ at }) => at));
});
