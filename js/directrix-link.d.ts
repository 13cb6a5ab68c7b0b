/** Links that carry a document: the entry `directrix/link` of the package, which loads no module. docs/api.md defines the keys. */
import type { CurvesDocument, DocumentInput, Link } from "./directrix.js";

export type { CurvesDocument, DocumentInput, Link };

/** One key of a link. */
export interface Key {
  /** The value that a text stands for; throws `DirectrixError` with the code `link`. */
  read(text: string, key: string): unknown;
  /** The words that are allowed, the default first. */
  values?: readonly string[];
}

/** The keys in the order in which they are written; `s` holds the document. */
export const KEYS: Readonly<{ [key in Exclude<keyof Link, "document"> | "s"]: Key }>;

/** The version of the links that are written; a reader refuses later ones. */
export const VERSION: number;

/** Bytes of JSON that a link may hold. */
export const LARGEST: number;

/** The text of a document in a link: base64url of the raw deflate of its JSON. */
export function encodeDocument(document: DocumentInput): string;

/** The document in such a text; throws `DirectrixError` with the code `link`. It is not checked against the format. */
export function decodeDocument(text: string): CurvesDocument;

/** The hash of a link, `#` included. */
export function writeLink(link: Link): string;

/** What a hash says; throws `DirectrixError` with the code `link` and the key at fault as path. */
export function readLink(hash: string): Link;
