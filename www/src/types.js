/**
 * Shapes of the data the page passes around. Types only; nothing here runs.
 *
 * @typedef {[number, number]} Point Coordinates in document units, y up.
 *
 * @typedef {object} Material
 * @property {string} name
 * @property {string} color `#rrggbb`
 * @property {boolean} [void]
 *
 * @typedef {object} CompositionKey
 * @property {number} at fraction of the knot domain, in [0, 1)
 * @property {number[]} mix one fraction for each material, summing to 1
 *
 * @typedef {object} Curve
 * @property {string} [name]
 * @property {number} degree
 * @property {"periodic" | "clamped"} form
 * @property {Point[]} points
 * @property {number[]} [knots]
 * @property {number} height
 * @property {CompositionKey[]} composition
 *
 * @typedef {object} Sampling
 * @property {"arc-length" | "parameter"} scheme
 * @property {[number, number]} counts
 *
 * @typedef {object} Matching
 * @property {string} method
 * @property {number} normalWeight
 * @property {number} distanceWeight
 * @property {number} alignmentWeight
 * @property {"signed" | "clamp" | "half"} negative
 * @property {boolean} oneToOne
 *
 * @typedef {object} Blend
 * @property {string} kind
 * @property {number} stages
 *
 * @typedef {object} DocumentView
 * @property {string[]} [layers]
 * @property {Point} [center]
 * @property {number} [span] document units across the picture
 * @property {number} [s]
 *
 * @typedef {object} CurvesDocument
 * @property {1} directrix
 * @property {"curves"} kind
 * @property {string} title
 * @property {string} unit
 * @property {Material[]} materials
 * @property {[Curve, Curve]} curves
 * @property {Sampling} sampling
 * @property {Matching} matching
 * @property {Blend} blend
 * @property {DocumentView} [view]
 *
 * @typedef {object} View The part of the plane that is shown.
 * @property {Point} center
 * @property {number} scale CSS pixels for one document unit
 *
 * @typedef {{width: number, height: number}} Size CSS pixels.
 *
 * @typedef {object} Selection
 * @property {0 | 1} curve
 * @property {number | null} point index of a control point, or null for the whole curve
 *
 * @typedef {object} Diagnostic
 * @property {string} code
 * @property {string} message
 * @property {number} [curve]
 * @property {number[]} [vertices]
 * @property {Point} [at]
 * @property {number[]} [lines]
 *
 * @typedef {{parameters: number[], points: Point[], normals: Point[]}} Samples
 *
 * @typedef {object} Line
 * @property {number} from vertex of the first curve
 * @property {number} to vertex of the second curve
 * @property {number} value
 * @property {boolean} visible
 *
 * @typedef {object} Totals
 * @property {number} count
 * @property {number} sum
 * @property {number | null} mean
 * @property {number | null} integral
 * @property {number | null} eta
 * @property {number} crossings
 * @property {number} blocked
 * @property {[number[], number[]]} uncovered
 *
 * @typedef {object} Match
 * @property {boolean} ok
 * @property {Diagnostic[]} diagnostics
 * @property {[boolean, boolean]} reversed
 * @property {[Samples, Samples]} samples
 * @property {Line[]} lines
 * @property {{lines: Totals | null}} totals
 *
 * @typedef {object} Probe
 * @property {number} line
 * @property {number} s
 * @property {Point} at
 * @property {number[]} fractions
 * @property {number} value
 * @property {number} cosine
 * @property {number} length
 * @property {Point} from
 * @property {Point} to
 *
 * @typedef {object} Picture
 * @property {number} width device pixels
 * @property {number} height device pixels
 * @property {Uint8ClampedArray<ArrayBuffer>} data straight RGBA
 * @property {View} view
 *
 * @typedef {object} PaintOptions
 * @property {number} width device pixels
 * @property {number} height device pixels
 * @property {number} pixelRatio
 * @property {View} [view]
 * @property {string[]} layers
 * @property {"light" | "dark"} theme
 * @property {number | null} s
 * @property {number | null} line ruling line to lift out
 * @property {boolean} [background]
 *
 * @typedef {{code: string, path?: string, message: string, name?: string, at?: Point}} Problem
 *   What is left of a DirectrixError once it is shown.
 *
 * @typedef {object} Call
 * @property {AbortSignal} [signal]
 * @property {(progress: number) => void} [onprogress]
 *
 * @typedef {object} Kernel The asynchronous functions of `connect()` that the page uses.
 * @property {(document: CurvesDocument, call?: Call) => Promise<Match>} match
 * @property {(document: CurvesDocument, options: PaintOptions, call?: Call) => Promise<Picture>} paint
 * @property {(document: CurvesDocument, options: PaintOptions, call?: Call) => Promise<string>} svg
 * @property {(document: CurvesDocument, at: Point, call?: Call) => Promise<Probe | null>} probe
 * @property {(document: CurvesDocument, curve: number, u: number, call?: Call) => Promise<CurvesDocument>} insertPoint
 * @property {(document: unknown, call?: Call) => Promise<CurvesDocument>} defaults
 * @property {(document: CurvesDocument, size: Size & {pixelRatio: number}, call?: Call) => Promise<View>} fit
 * @property {() => void} close
 * @property {(() => void) | null} [onrestart]
 */
export {};
