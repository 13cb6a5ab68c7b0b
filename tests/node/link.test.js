/** Links that carry documents: what is written is read, whatever the document, and whatever else is read is refused with a reason. */
import assert from "node:assert/strict";
import { readFileSync, readdirSync } from "node:fs";
import { test } from "node:test";
import { deflateRawSync, inflateRawSync } from "node:zlib";
import { DirectrixError, load } from "directrix";
import { KEYS, LARGEST, VERSION, decodeDocument, encodeDocument, readLink, writeLink } from "directrix/link";
import { base, mutated, numbers } from "./hostile.js";

const seeds = Array.from({ length: 240 }, (_, i) => 20_261_125 + i);
const fixtures = new URL("../fixtures/", import.meta.url);

/** @type {import("directrix").CurvesDocument} */
const small = { ...base, title: "Small" };

/** The text of bytes in a link. @param {Uint8Array} bytes */
const base64url = (bytes) => Buffer.from(bytes).toString("base64url");

/** A link whose document is any text. @param {string | Uint8Array} text */
const linkOf = (text) => `#v=1&s=${base64url(deflateRawSync(text))}`;

/**
 * A document with every kind of field, chosen at random: all forms, schemes, methods, names in many scripts, numbers of all sizes.
 * @param {(below: number) => number} number
 * @returns {any}
 */
function randomDocument(number) {
  const some = (/** @type {any[]} */ list) => list[number(list.length)];
  const maybe = (/** @type {string} */ name, /** @type {() => unknown} */ value) => (number(2) ? { [name]: value() } : {});
  const real = () =>
    some([0, -0.5, 1e-12, 123456.789, -1e300, 5e-324, 0.1 + 0.2, Number.MAX_SAFE_INTEGER, (number(2 ** 31) - 2 ** 30) / (1 + number(2 ** 31))]);
  const text = () =>
    some(["", "Amoeba", "\"quoted\" & <b>bold</b>", "Größe 曲線 \u{1F980}", "\u202etfel", "\ud800 alone", "line\nbreak\u2028", "%41&s=x#", "a".repeat(200)]);
  const list = (/** @type {number} */ most, /** @type {() => unknown} */ item) => Array.from({ length: number(most) }, item);
  const materials = 1 + number(8);
  const curve = () => ({
    ...maybe("name", text),
    degree: 2 + number(31),
    form: some(["periodic", "clamped", "open"]),
    points: list(200, () => [real(), real()]),
    ...maybe("knots", () => list(40, real)),
    ...maybe("height", real),
    ...maybe("composition", () => list(8, () => ({ at: number(1000) / 1000, mix: Array.from({ length: materials }, real) }))),
  });
  return {
    directrix: 1,
    kind: "curves",
    ...maybe("title", text),
    ...maybe("unit", text),
    ...maybe("materials", () =>
      Array.from({ length: materials }, () => ({
        name: text(),
        color: `#${number(2 ** 24).toString(16).padStart(6, "0")}`,
        ...maybe("void", () => number(2) === 1),
      })),
    ),
    curves: list(3, curve),
    ...maybe("sampling", () => ({
      scheme: some(["parameter", "arc-length", "adaptive"]),
      ...maybe("counts", () => [number(2000), number(2000)]),
      ...maybe("tolerance", real),
    })),
    matching: {
      method: some(["exact", "greedy", "one-per-vertex", "shift", "parameter"]),
      ...maybe("objective", () => some(["integral", "sum", "sum-less-price"])),
      ...maybe("linePrice", real),
      ...maybe("shift", () => some(["best", number(100)])),
      ...maybe("pins", () => list(6, () => ({ u: real(), v: real() }))),
      ...maybe("printed", () => list(4, () => some(["normals", "order", "removal"]))),
      ...maybe("oneToOne", () => number(2) === 1),
    },
    ...maybe("blend", () => ({ kind: "ruled", stages: number(100) })),
    ...maybe("view", () => ({ layers: list(5, () => some(["material", "grid", "value"])), center: [real(), real()], span: real(), s: real() })),
  };
}

/** @param {string} hash */
function refusal(hash) {
  try {
    readLink(hash);
  } catch (error) {
    assert.ok(error instanceof DirectrixError, `${error} for ${hash.slice(0, 80)}`);
    assert.equal(error.code, "link");
    return error;
  }
  return assert.fail(`${hash.slice(0, 80)} was read`);
}

test(`what a link carries is the identical document, seeds ${seeds[0]} to ${seeds.at(-1)}`, () => {
  for (const seed of seeds) {
    const number = numbers(seed);
    const document = seed % 2 ? randomDocument(number) : mutated(small, number);
    if (!Object.hasOwn(document, "directrix")) continue;
    const text = JSON.stringify(document);
    const link = writeLink({ document });
    assert.match(link, /^#v=1&s=[A-Za-z0-9_-]+$/, `seed ${seed}`);
    const read = readLink(link);
    assert.equal(JSON.stringify(read.document), text, `seed ${seed}`);
    assert.deepEqual(Object.keys(read), ["document"]);
    assert.equal(writeLink(read), link, `seed ${seed}: written again it is the same link`);
    assert.equal(encodeDocument(text), encodeDocument(document), `seed ${seed}: its JSON is as good as the object`);
    // The text is plain deflate, which any other program reads.
    const packed = Buffer.from(encodeDocument(document), "base64url");
    assert.equal(inflateRawSync(packed).toString(), text, `seed ${seed}`);
    assert.equal(JSON.stringify(decodeDocument(base64url(deflateRawSync(text)))), text, `seed ${seed}`);
  }
});

test("every combination of keys is read as it was written, in one order", () => {
  const values = /** @type {{[key: string]: any[]}} */ ({
    view: [undefined, ...(KEYS.view.values ?? [])],
    step: [undefined, 1, 44, 1_000_000],
    controls: [undefined, ...(KEYS.controls.values ?? [])],
    theme: [undefined, ...(KEYS.theme.values ?? [])],
    reveal: [undefined, ...(KEYS.reveal.values ?? [])],
  });
  const number = numbers(7);
  const sources = [{}, { preset: "nested-ellipses" }, { url: "https://example.org/a%20b/c.json?x=1&y=2#z" }, { document: small }];
  for (let i = 0; i < 500; i += 1) {
    /** @type {any} */
    const link = { ...sources[number(sources.length)] };
    for (const [key, all] of Object.entries(values)) {
      const value = all[number(all.length)];
      if (value !== undefined) link[key] = value;
    }
    const hash = writeLink(link);
    assert.deepEqual(readLink(hash), link, hash);
    assert.deepEqual(readLink(hash.slice(1)), link, "without #");
  }
  assert.equal(
    writeLink({ reveal: "interaction", theme: "dark", controls: "none", step: 3, view: "steps", preset: "amoeba" }),
    "#v=1&preset=amoeba&view=steps&step=3&controls=none&theme=dark&reveal=interaction",
  );
  assert.deepEqual(readLink(""), {});
  assert.deepEqual(readLink("#"), {});
  assert.deepEqual(readLink("#v=1&preset=amoeba&later=42&another"), { preset: "amoeba" }, "unknown keys are ignored");
  assert.deepEqual(readLink("#preset=amoeba&step=4"), { preset: "amoeba", step: 4 }, "as a person writes it");
});

test("a link that is wrong is refused with the key at fault and what was expected", () => {
  const good = writeLink({ document: small });
  /** @type {[name: string, hash: string, path: string, says: RegExp][]} */
  const cases = [
    ["later version", good.replace("v=1", "v=2"), "v", /version 2 was found.*later release.*reads version 1/],
    ["no number", good.replace("v=1", "v=one"), "v", /"one" was found; expected 1/],
    ["version 0", "#v=0&preset=amoeba", "v", /"0" was found/],
    ["document without a version", good.replace("v=1&", ""), "v", /begins with #v=1/],
    ["Excalidraw", "#json=5729829123,abcdEFGH_x", "v", /"json=5729829123,abcdEFGH_x" was found/],
    ["Compiler Explorer", `#g:!((g:!((${"x".repeat(300)}`, "v", /…" was found/],
    ["anchor", "#section-2", "v", /begins with #v=1/],
    ["empty", "#v=1&s=", "s", /no text/],
    ["cut off", good.slice(0, -20), "s", /cut off.*copy the whole link/],
    ["cut off in the middle of a character", "#v=1&s=abcde", "s", /cut off/],
    ["foreign characters", "#v=1&s=ab+cd/ef", "s", /holds the character "\+"/],
    ["wrapped by a mail program", good.replace("s=", "s=%0A"), "s", /holds the character/],
    ["no deflate", "#v=1&s=_____w", "s", /changed on its way/],
    ["no JSON", linkOf("{"), "s", /no JSON/],
    ["no UTF-8", linkOf(Uint8Array.of(0x22, 0xff, 0xfe, 0x22)), "s", /changed on its way/],
    ["a number", linkOf("42"), "s", /no field directrix/],
    ["null", linkOf("null"), "s", /no field directrix/],
    ["another application's JSON", linkOf('{"type":"excalidraw","elements":[]}'), "s", /no field directrix/],
    ["view", "#v=1&preset=a&view=match", "view", /"match" was found; expected figure, steps, compare, solid/],
    ["step 0", "#v=1&step=0", "step", /whole number from 1/],
    ["step with a fraction", "#v=1&step=1.5", "step", /"1.5" was found/],
    ["step past all", "#v=1&step=1000001", "step", /1000000/],
    ["controls", "#v=1&controls=", "controls", /"" was found; expected full, minimal, none/],
    ["theme", "#v=1&theme=DARK", "theme", /expected auto, light, dark/],
    ["reveal", "#v=1&reveal=click", "reveal", /expected auto, interaction/],
    ["path as preset", "#v=1&preset=../../secret", "preset", /expected the name of a preset/],
    ["markup as preset", "#v=1&preset=%3Cimg%20src%3Dx%3E", "preset", /<img src=x>/],
    ["script as address", "#url=javascript:alert(1)", "url", /https:\/\/ or http:\/\//],
    ["data as address", "#url=data:application/json,{}", "url", /https:\/\//],
    ["file as address", "#url=file:///etc/passwd", "url", /https:\/\//],
    ["relative address", "#url=amoeba.json", "url", /whole address/],
    ["address with a password", "#url=https://me:secret@example.org/a.json", "url", /name or password for example.org/],
    ["two documents", `${good}&preset=amoeba`, "preset", /beside s/],
    ["broken escape", "#v=1&preset=%zz", "preset", /hexadecimal/],
  ];
  for (const [name, hash, path, says] of cases) {
    const error = refusal(hash);
    assert.equal(error.path, path, name);
    assert.match(error.message, says, name);
    assert.ok(error.message.length < 200, `${name}: a message for a person, not the link again`);
    assert.doesNotMatch(error.message, /secret@/, name);
  }
});

test("a link that was cut off anywhere is refused, and one with a changed character never leads to an exception of another kind", () => {
  const good = writeLink({ document: small });
  const start = "#v=1&s=".length;
  for (let end = start; end < good.length; end += 1) {
    // The last character may hold nothing but the padding of the last bits.
    if (end < good.length - 1) refusal(good.slice(0, end));
  }
  const number = numbers(99);
  for (let i = 0; i < 3000; i += 1) {
    const at = start + number(good.length - start);
    const changed = good.slice(0, at) + String.fromCharCode(33 + number(94)) + good.slice(at + 1);
    try {
      readLink(changed);
    } catch (error) {
      assert.ok(error instanceof DirectrixError && error.code === "link", `${error} for ${changed}`);
    }
  }
});

test("a bomb is noticed long before it has grown", () => {
  const bomb = deflateRawSync(Buffer.alloc(1 << 27, 0x20), { level: 9 });
  assert.ok(bomb.length < 150_000);
  const before = process.memoryUsage();
  const error = refusal(`#v=1&s=${base64url(bomb)}`);
  assert.match(error.message, /more than 4 MiB/);
  const { heapUsed, arrayBuffers } = process.memoryUsage();
  const grown = heapUsed + arrayBuffers - before.heapUsed - before.arrayBuffers;
  assert.ok(grown < 64 << 20, `${(grown / 2 ** 20).toFixed(0)} MiB`);
  assert.match(refusal(`#v=1&s=${"A".repeat(LARGEST * 2)}`).message, /8388608 characters/);
});

test("documents up to the limit are carried, those above it and those that JSON cannot hold are refused when written", () => {
  const room = LARGEST - JSON.stringify({ ...small, title: "" }).length;
  const largest = { ...small, title: "x".repeat(room) };
  assert.equal(readLink(writeLink({ document: largest })).document?.title?.length, room);
  const code = (/** @type {string} */ name) => (/** @type {unknown} */ error) => error instanceof DirectrixError && error.code === name;
  assert.throws(() => writeLink({ document: { ...small, title: "x".repeat(room + 1) } }), code("limit"));
  assert.throws(() => encodeDocument(/** @type {any} */ ({ directrix: 1, curves: [{ points: [[0, Infinity]] }] })), {
    code: "non-finite",
    path: "curves[0].points[0][1]",
  });
  assert.throws(() => encodeDocument("{"), code("syntax"));
  for (const [key, value] of Object.entries({ view: "all", step: 0.5, theme: "red", url: "ftp://example.org/", preset: "A B" })) {
    assert.throws(() => writeLink(/** @type {any} */ ({ [key]: value })), { code: "link", path: key });
  }
  assert.throws(() => writeLink({ document: small, preset: "amoeba" }), code("link"));
});

test("links of every released version are read as they were meant", async () => {
  const files = readdirSync(fixtures).filter((name) => /^links-.*\.json$/.test(name));
  assert.ok(files.includes("links-0.1.0.json"));
  const { defaults } = await load();
  for (const file of files) {
    /** @type {{name: string, link: string, gives: import("directrix/link").Link}[]} */
    const cases = JSON.parse(readFileSync(new URL(file, fixtures), "utf8"));
    assert.ok(cases.length > 0);
    for (const { name, link, gives } of cases) {
      const found = readLink(link);
      assert.deepEqual(found, gives, `${file}: ${name}`);
      if (gives.document) {
        assert.equal(JSON.stringify(found.document), JSON.stringify(gives.document), `${file}: ${name}`);
        // Later versions of the format go on reading it.
        assert.equal(defaults(/** @type {any} */ (found.document)).kind, "curves");
      }
    }
  }
  assert.equal(VERSION, 1, "a new version of links keeps these fixtures and adds its own");
});
