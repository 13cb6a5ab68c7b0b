import type { CurvesDocument, DocumentInput, ErrorCode, HyperpatchDocument, Match, PartDocument } from "./directrix.js";

/**
 * What the matching of a figure is worth, or the body or part of one: then `body` or `part` is there, no line is counted, and what belongs to matchings
 * is null.
 */
export interface FigureResult {
  /** Whether every sample has a line, none cross and none is blocked. */
  ok: boolean;
  /** `ok`, and nothing else is left to say against it. */
  verified: boolean;
  lines: number;
  crossings: number;
  blocked: number;
  /** Samples without a line. */
  uncovered: number;
  /** J over its upper bound; null when it is not known. */
  eta: number | null;
  /** J; null when it is not known. */
  integral: number | null;
  gap: number | null;
  gapKind: Match["gapKind"];
  method: CurvesDocument["matching"]["method"] | null;
  /** Codes of the remarks on the geometry. */
  diagnostics: string[];
  /** The result in words, such as "44 lines, none crossing, η 0.98". */
  text: string;
  /** The same in short, of a body or a part. */
  brief?: string;
  body?: {
    cells: number;
    /** Cells that are invalid, and degenerate. */
    invalid: number;
    degenerate: number;
    /** Pairs of cells that overlap. */
    overlaps: number;
    /** In the unit of the document, cubed. */
    volume: number;
    /** Whether every check has run to its end; before, only certificates of single cells have. */
    checked: boolean;
  };
  part?: {
    bodies: number;
    features: number;
    /** Bodies, features and design rules that have a fault and are left out. */
    skipped: number;
    /** Design rules that are broken. */
    broken: number;
    /** In the unit of the document, squared. */
    area: number;
    /** Of each material, 0 to 1. */
    fractions: number[];
  };
}

interface FigureState {
  document: CurvesDocument;
  /** Place of the current in-between curve, or of the section of a body, 0 to 1. */
  s: number;
  /** null while an edit cannot be matched. */
  result: FigureResult | null;
}

/** A document stands for the first time. */
export type LoadDetail = FigureState & { runsIn: DirectrixFigure["runsIn"] };

/** What the person, or `s` and `play`, has changed: the place, a control point (with its result), the layers, or the step of the growth. */
export type ChangeDetail = FigureState & { reason: "s" | "document" | "layers" | "step"; step?: number };

/** Work that takes longer than 200 ms. */
export interface ProgressDetail {
  /** The share done, 0 to 1. */
  progress: number;
}

/** Why a document, or an edit, cannot be shown; the last good figure stays. */
export interface ErrorDetail {
  code: ErrorCode | "unreachable" | "no-wasm" | (string & {});
  /** The field at fault, or the attribute. */
  path: string;
  message: string;
}

export interface FigureEvents {
  load: CustomEvent<LoadDetail>;
  change: CustomEvent<ChangeDetail>;
  progress: CustomEvent<ProgressDetail>;
  error: CustomEvent<ErrorDetail>;
}

/** The element `<directrix-figure>`; docs/embedding.md lists its attributes. */
export class DirectrixFigure extends HTMLElement {
  /** The folder of the presets, for figures without the attribute `presets`. */
  static presets: string | URL;
  /** The editor, for figures without the attribute `editor`. */
  static editor: string | URL;
  /**
   * A copy of the document that is shown, of a body a `HyperpatchDocument` and of a part a `PartDocument`, which its `kind` tells; null before the first
   * one stands. Setting one shows it once it is found to be valid.
   */
  get document(): CurvesDocument | null;
  set document(document: DocumentInput | HyperpatchDocument | PartDocument | null);
  /** Place of the current in-between curve, 0 to 1; of a body the share of its depth that the section has taken away; of a part 0. */
  s: number;
  readonly result: FigureResult | null;
  /** Where the figure is computed; null before that is known. */
  readonly runsIn: "worker" | "blob worker" | "main thread" | null;
  play(): void;
  pause(): void;
}

declare global {
  interface HTMLElementTagNameMap {
    "directrix-figure": DirectrixFigure;
  }
}
