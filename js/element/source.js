/** Documents from elsewhere: a preset by name, or any address. */
import { DirectrixError } from "../errors.js";
import { presetKind } from "./kind.js";
import { words } from "./words.js";

/** Bytes that a document may have. */
const LARGEST = 4 * 1024 * 1024;

/**
 * The address of a preset.
 *
 * @param {string} name
 * @param {string | URL} folder
 */
export function presetAddress(name, folder) {
  if (!/^[a-z0-9]+(-[a-z0-9]+)*$/.test(name)) throw new DirectrixError("range", "preset", words.errors.preset(name));
  return new URL(`${presetKind(name) === "curves" ? name : name.replace("-", "/")}.json`, folder);
}

/**
 * The text of the document that attributes name.
 *
 * @param {{ src: string | null, preset: string | null, presets: string | URL }} source `src` goes before `preset`
 * @param {AbortSignal} signal
 * @returns {Promise<string>}
 * @throws {DirectrixError}
 */
export async function readSource({ src, preset, presets }, signal) {
  const { baseURI } = document;
  if (src === null) return fetchText(presetAddress(preset ?? "", new URL(presets, baseURI)), "preset", signal);
  if (!URL.canParse(src, baseURI)) throw new DirectrixError("range", "src", words.errors.address(src));
  return fetchText(new URL(src, baseURI), "src", signal);
}

/**
 * The text at an address.
 *
 * @param {URL} address
 * @param {string} path what names the address: `preset` or `src`
 * @param {AbortSignal} signal
 * @returns {Promise<string>}
 * @throws {DirectrixError} with the code `unreachable` or `limit`
 */
async function fetchText(address, path, signal) {
  const response = await fetch(address, { signal }).catch((error) => {
    if (signal.aborted) throw error;
    throw new DirectrixError("unreachable", path, words.errors.unreachable);
  });
  if (!response.ok) throw new DirectrixError("unreachable", path, words.errors.status(response.status));
  const reader = response.body?.pipeThrough(new TextDecoderStream()).getReader();
  let text = "";
  for (let part = await reader?.read(); part && !part.done; part = await reader?.read()) {
    text += part.value;
    if (text.length <= LARGEST) continue;
    await reader?.cancel();
    throw new DirectrixError("limit", path, words.errors.tooLarge);
  }
  return text;
}
