import { DirectrixError } from "../errors.js";
import { words } from "./words.js";

/** Text shown at most of a message. */
const LONGEST = 400;

/**
 * What a figure tells of an error: its own words, and what the event `error` carries.
 *
 * @param {"document" | "edit" | "kernel"} kind what it is about
 * @param {unknown} error
 */
export function failureOf(kind, error) {
  const { code, path } = error instanceof DirectrixError ? error : { code: "failed", path: "" };
  const message = error instanceof Error ? error.message : String(error);
  const where = words.errors.at(path, message);
  const text = code === "no-wasm" ? message : kind === "kernel" ? words.errors.blocked(where) : words.errors[kind](where);
  return { text: text.length > LONGEST ? `${text.slice(0, LONGEST)}…` : text, detail: { code, path, message } };
}
