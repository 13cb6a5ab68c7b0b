/**
 * Fetches a document from an address that a person agreed to. What goes wrong is told in plain words.
 */
import { LARGEST } from "../../../js/link.js";
import { words } from "./words.js";

/** Seconds that an answer may take. */
const PATIENCE = 15;

/**
 * The JSON at an address. Nothing but the request is sent: no cookies, and not where it comes from.
 * @param {string} address
 * @param {AbortSignal} given aborted when the person gives it up
 * @returns {Promise<unknown>} rejects with an `Error` whose message is for the person
 */
export async function fetchDocument(address, given) {
  const { host, protocol, hostname } = new URL(address);
  const w = words.ask;
  if (navigator.onLine === false && hostname !== location.hostname) throw new Error(w.offline);
  const signal = AbortSignal.any([given, AbortSignal.timeout(PATIENCE * 1000)]);
  /** @type {RequestInit} */
  const options = { credentials: "omit", referrerPolicy: "no-referrer", cache: "no-cache", signal };
  let bytes;
  try {
    const response = await fetch(address, options);
    if (!response.ok) throw new Problem(w.status(response.status, host));
    bytes = await read(response);
  } catch (error) {
    if (error instanceof Problem || given.aborted) throw error;
    if (signal.aborted) throw new Error(w.late(PATIENCE), { cause: error });
    if (location.protocol === "https:" && protocol === "http:") throw new Error(w.insecure, { cause: error });
    throw new Error((await answers(address, options)) ? w.refused(host) : w.unreachable(host), { cause: error });
  }
  return parsed(bytes);
}

/** Failures whose reason is known. */
class Problem extends Error {}

/** @param {Response} response */
async function read(response) {
  const reader = response.body?.getReader();
  /** @type {Uint8Array[]} */
  const parts = [];
  let size = 0;
  for (;;) {
    const { done, value } = (await reader?.read()) ?? { done: true, value: undefined };
    if (done || !value) break;
    size += value.length;
    if (size > LARGEST) {
      void reader?.cancel().catch(() => {});
      throw new Problem(words.ask.large);
    }
    parts.push(value);
  }
  return new Uint8Array(await new Blob(/** @type {BlobPart[]} */ (parts)).arrayBuffer());
}

/**
 * Whether there is an answer that the page may not read, which tells a closed door from a missing house.
 * @param {string} address
 * @param {RequestInit} options
 */
async function answers(address, options) {
  return fetch(address, { ...options, mode: "no-cors" }).then(
    (response) => {
      void response.body?.cancel();
      return true;
    },
    () => false,
  );
}

/** @param {Uint8Array} bytes */
function parsed(bytes) {
  let text;
  try {
    text = new TextDecoder("utf-8", { fatal: true }).decode(bytes);
  } catch {
    throw new Error(words.ask.notText);
  }
  let raw;
  try {
    raw = JSON.parse(text);
  } catch {
    throw new Error(words.ask.notJson);
  }
  if (typeof raw !== "object" || raw === null || !("directrix" in raw)) throw new Error(words.ask.notDocument);
  return raw;
}
