/**
 * Links that carry a document: `#v=1&s=…`, where `s` is the base64url (RFC 4648, section 5, without padding) of the raw deflate
 * (RFC 1951) of its JSON. The keys stand in docs/api.md; an embedded figure has the same ones as attributes.
 *
 * @import { CurvesDocument, DocumentInput, Link } from "./directrix.js"
 */
import { Inflate, deflateSync } from "./pkg/fflate.js";
import { DirectrixError } from "./errors.js";
import { toText } from "./text.js";

/** The version of the links that are written; a reader refuses later ones. */
export const VERSION = 1;

/** Bytes of JSON that a link may hold. */
export const LARGEST = 4 * 1024 * 1024;

/** Compressed bytes that are inflated at once: deflate makes at most 1032 bytes of each, so that a bomb is noticed early. */
const SLICE = 1024;

/** The largest step of a link. */
const LAST_STEP = 1_000_000;

const CUT_OFF = "the text was cut off: its end is missing; copy the whole link";

/** Longest piece of a link that a message quotes. */
const QUOTED = 40;

/**
 * @typedef {object} Key
 * @property {(text: string, key: string) => unknown} read the value, or throws a `DirectrixError` with the code `link`
 * @property {readonly string[]} [values] the words that are allowed, the default first
 */

/**
 * The keys of a link in the order in which they are written; those of a document exclude each other.
 *
 * @type {Readonly<{[key in Exclude<keyof Link, "document">]-?: Key} & {s: Key}>}
 */
export const KEYS = Object.freeze({
  s: { read: decodeDocument },
  preset: { read: presetName },
  url: { read: webAddress },
  view: words("figure", "steps", "compare", "solid"),
  step: { read: stepNumber },
  controls: words("full", "minimal", "none"),
  theme: words("auto", "light", "dark"),
  reveal: words("auto", "interaction"),
});

const SOURCES = /** @type {const} */ (["s", "preset", "url"]);

/**
 * The text of a document in a link.
 *
 * @param {DocumentInput} document
 * @returns {string}
 * @throws {DirectrixError} where JSON cannot hold it, and with the code `limit` above 4 MiB of JSON
 */
export function encodeDocument(document) {
  const text = typeof document === "string" ? JSON.stringify(parsed(document, "")) : toText(document);
  const bytes = new TextEncoder().encode(text);
  if (bytes.length > LARGEST) {
    throw new DirectrixError("limit", "", `${bytes.length} bytes of JSON were found; a link holds at most ${LARGEST}`);
  }
  return toBase64(deflateSync(bytes, { level: 9 }));
}

/**
 * The document in a link. Whether it is a valid one is for `defaults` or `match` to say.
 *
 * @param {string} text
 * @returns {CurvesDocument}
 * @throws {DirectrixError} with the code `link`
 */
export function decodeDocument(text) {
  const document = parsed(inflated(fromBase64(text)), "s");
  if (typeof document !== "object" || document === null || !("directrix" in document)) {
    throw wrong("s", "something else than a document of Directrix was found: it has no field directrix");
  }
  return /** @type {CurvesDocument} */ (document);
}

/**
 * The hash of a link, `#` included. What is undefined is left out.
 *
 * @param {Link} link
 * @returns {string}
 * @throws {DirectrixError} for a value that `readLink` would refuse
 */
export function writeLink({ document, ...rest }) {
  const values = { ...rest, s: document === undefined ? undefined : encodeDocument(document) };
  const pairs = Object.entries(KEYS).flatMap(([key, { read }]) => {
    const value = values[/** @type {keyof typeof values} */ (key)];
    if (value === undefined) return [];
    if (key !== "s") read(String(value), key);
    return [`${key}=${escaped(String(value))}`];
  });
  oneSource(SOURCES.filter((key) => values[key] !== undefined));
  return `#${[`v=${VERSION}`, ...pairs].join("&")}`;
}

/**
 * What a link says. Unknown keys are ignored; an empty hash says nothing.
 *
 * @param {string} hash with or without `#`
 * @returns {Link}
 * @throws {DirectrixError} with the code `link` and the key at fault as path: a later version, a value that is not allowed, a
 *   text that was cut off or changed, or a link of something else
 */
export function readLink(hash) {
  const text = hash.replace(/^#/, "");
  if (text === "") return {};
  const given = split(text);
  const known = Object.keys(KEYS).filter((key) => given.has(key));
  const version = given.get("v");
  if (version === undefined && (known.length === 0 || given.has("s"))) {
    throw wrong("v", `"${quoted(text)}" was found; a link of Directrix begins with #v=${VERSION}`);
  }
  if (version !== undefined) checkVersion(version);
  oneSource(SOURCES.filter((key) => given.has(key)));
  const link = /** @type {{[key: string]: unknown}} */ ({});
  for (const key of known) {
    const value = KEYS[/** @type {keyof typeof KEYS} */ (key)].read(given.get(key) ?? "", key);
    link[key === "s" ? "document" : key] = value;
  }
  return /** @type {Link} */ (link);
}

/**
 * The keys of a hash and their texts. Of a key that is given twice the first counts.
 * @param {string} text
 */
function split(text) {
  /** @type {Map<string, string>} */
  const given = new Map();
  for (const pair of text.split("&")) {
    const end = pair.indexOf("=");
    const key = end < 0 ? pair : pair.slice(0, end);
    if (given.has(key)) continue;
    try {
      given.set(key, end < 0 ? "" : decodeURIComponent(pair.slice(end + 1)));
    } catch {
      if (key === "v" || key in KEYS) throw wrong(key, `"${quoted(pair)}" has a % that no two hexadecimal digits follow`);
    }
  }
  return given;
}

/** @param {string} version */
function checkVersion(version) {
  if (version === String(VERSION)) return;
  if (/^[1-9]\d{0,8}$/.test(version)) {
    throw wrong("v", `version ${version} was found, which a later release of Directrix writes; this one reads version ${VERSION}`);
  }
  throw wrong("v", `"${quoted(version)}" was found; expected ${VERSION}`);
}

/** @param {readonly string[]} sources those that are given */
function oneSource(sources) {
  if (sources.length > 1) throw wrong(sources[1] ?? "", `it stands beside ${sources[0]}; a link leads to one document`);
}

/**
 * @param {...string} values the default first
 * @returns {Key}
 */
function words(...values) {
  return {
    values: Object.freeze(values),
    read(text, key) {
      if (!values.includes(text)) throw wrong(key, `"${quoted(text)}" was found; expected ${values.join(", ")}`);
      return text;
    },
  };
}

/**
 * @param {string} text
 * @param {string} key
 */
function presetName(text, key) {
  if (!/^[a-z0-9]+(-[a-z0-9]+)*$/.test(text) || text.length > 64) {
    throw wrong(key, `"${quoted(text)}" was found; expected the name of a preset, such as amoeba`);
  }
  return text;
}

/**
 * @param {string} text
 * @param {string} key
 */
function webAddress(text, key) {
  const address = URL.canParse(text) ? new URL(text) : null;
  if (!address || !["http:", "https:"].includes(address.protocol)) {
    throw wrong(key, `"${quoted(text)}" was found; expected a whole address that begins with https:// or http://`);
  }
  if (address.username || address.password) throw wrong(key, `a name or password for ${quoted(address.host)} was found; expected an address without one`);
  return text;
}

/**
 * @param {string} text
 * @param {string} key
 */
function stepNumber(text, key) {
  const step = /^\d{1,7}$/.test(text) ? Number(text) : 0;
  if (step < 1 || step > LAST_STEP) throw wrong(key, `"${quoted(text)}" was found; expected a whole number from 1 to ${LAST_STEP}`);
  return step;
}

/**
 * @param {string} text
 * @param {string} path
 * @returns {unknown}
 */
function parsed(text, path) {
  try {
    return JSON.parse(text);
  } catch (error) {
    if (path === "s") throw wrong(path, "the text was changed on its way: what it holds is no JSON");
    throw new DirectrixError("syntax", path, error instanceof Error ? error.message : String(error));
  }
}

/**
 * @param {Uint8Array} bytes
 * @returns {string}
 */
function inflated(bytes) {
  const text = new TextDecoder("utf-8", { fatal: true, ignoreBOM: true });
  let size = 0;
  let ended = false;
  let found = "";
  const stream = new Inflate((chunk, last) => {
    size += chunk.length;
    if (size > LARGEST) throw wrong("s", `more than ${LARGEST / 1024 / 1024} MiB of JSON was found, and a link holds at most that`);
    found += text.decode(chunk, { stream: !last });
    ended = last;
  });
  try {
    for (let at = 0; at < bytes.length; at += SLICE) stream.push(bytes.subarray(at, at + SLICE), at + SLICE >= bytes.length);
  } catch (error) {
    if (error instanceof DirectrixError) throw error;
    const cut = error instanceof Error && error.message === "unexpected EOF";
    throw wrong("s", cut ? CUT_OFF : "the text was changed on its way: it cannot be unpacked");
  }
  if (!ended) throw wrong("s", "no text was found; copy the whole link");
  return found;
}

/** @param {Uint8Array} bytes */
function toBase64(bytes) {
  let text = "";
  for (const byte of bytes) text += String.fromCharCode(byte);
  return btoa(text).replaceAll("+", "-").replaceAll("/", "_").replaceAll("=", "");
}

/**
 * @param {string} text
 * @returns {Uint8Array}
 */
function fromBase64(text) {
  // Deflate never makes a text noticeably longer, and base64 makes four characters of three bytes.
  if (text.length > LARGEST * 1.5) throw wrong("s", `${text.length} characters were found, more than any document that a link may hold`);
  const stranger = /[^A-Za-z0-9_-]/u.exec(text);
  if (stranger) throw wrong("s", `the text was changed on its way: it holds the character "${stranger[0]}"`);
  if (text.length % 4 === 1) throw wrong("s", CUT_OFF);
  return Uint8Array.from(atob(text.replaceAll("-", "+").replaceAll("_", "/")), (character) => character.charCodeAt(0));
}

/** Text in a hash, with what addresses are made of left readable. @param {string} text */
function escaped(text) {
  return encodeURIComponent(text).replace(/%(3A|2F|3F|3D|40|2C)/g, decodeURIComponent);
}

/** @param {string} text */
function quoted(text) {
  return text.length > QUOTED ? `${text.slice(0, QUOTED)}…` : text;
}

/**
 * @param {string} key
 * @param {string} message
 */
function wrong(key, message) {
  return new DirectrixError("link", key, message);
}
