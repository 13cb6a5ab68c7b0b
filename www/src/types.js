/**
 * Shapes of the data the page passes around. Types only; nothing here runs. What the kernel takes and gives is typed by
 * the kernel's own declarations; a document in the page is complete, with every default written out.
 *
 * @typedef {import("../../js/directrix.js").Point} Point
 * @typedef {import("../../js/directrix.js").Material} Material
 * @typedef {import("../../js/directrix.js").CompositionKey} CompositionKey
 * @typedef {import("../../js/directrix.js").LayerName} LayerName
 * @typedef {import("../../js/directrix.js").Match} Match
 * @typedef {import("../../js/directrix.js").Diagnostic} Diagnostic
 * @typedef {import("../../js/directrix.js").LineTotals} Totals
 * @typedef {import("../../js/directrix.js").Probe} Probe
 * @typedef {import("../../js/directrix.js").Explanation} Explanation
 * @typedef {import("../../js/directrix.js").Standing} Standing
 * @typedef {import("../../js/directrix.js").UnitCell} UnitCell
 * @typedef {import("../../js/directrix.js").Amounts} Amounts
 * @typedef {import("../../js/directrix.js").Picture} Picture
 * @typedef {import("../../js/directrix.js").PictureOptions} PaintOptions
 * @typedef {import("../../js/directrix.js").View} View
 * @typedef {import("../../js/directrix.js").Connection} Kernel
 *
 * @typedef {object} Shape A curve without what it is made of.
 * @property {number} degree
 * @property {"periodic" | "clamped" | "open"} form
 * @property {Point[]} points
 * @property {number[]} [knots]
 *
 * @typedef {object} Named
 * @property {string} [name]
 * @property {number} height
 * @property {CompositionKey[]} composition
 *
 * @typedef {Shape & Named} Curve
 *
 * @typedef {"normals" | "negative" | "heights" | "order" | "stop" | "removal" | "stages"} PrintedRule
 *
 * @typedef {object} Sampling
 * @property {"arc-length" | "parameter" | "adaptive"} scheme
 * @property {number[]} counts one for each curve, two while a drawing is in progress
 * @property {number} [tolerance] of adaptive samples, as the two below
 * @property {number} [maxTurn]
 * @property {number} [minCount]
 *
 * @typedef {{u: number, v: number, pair?: number}} Pin Parameters on the two curves of a span as drawn; of a stack `pair` is the span.
 *
 * @typedef {object} Matching
 * @property {"exact" | "greedy" | "one-per-vertex" | "shift" | "parameter"} method
 * @property {"integral" | "sum" | "sum-less-price"} [objective] of the method `exact`, as the two below
 * @property {number} [linePrice]
 * @property {number} [lines] number of one-to-one lines
 * @property {number | "best"} [shift] of the method `shift`
 * @property {"strict" | "repair"} [policy]
 * @property {"tied" | "free"} [ends] of open curves
 * @property {Pin[]} [pins]
 * @property {PrintedRule[]} [printed]
 * @property {number} normalWeight
 * @property {number} distanceWeight
 * @property {number} alignmentWeight
 * @property {"signed" | "clamp" | "half"} negative
 * @property {boolean} oneToOne
 *
 * @typedef {object} Blend
 * @property {"ruled" | "cubic" | "harmonic"} kind
 * @property {number} stages
 * @property {number} [lines] of the kind `harmonic`: lines along the gradient, and segments of each curve
 * @property {number} [segments]
 *
 * @typedef {object} DocumentView
 * @property {LayerName[]} [layers]
 * @property {Point} [center]
 * @property {number} [span] document units across the shorter side of the picture
 * @property {number} [s]
 * @property {number} [isoMaterial]
 * @property {boolean} [patterns]
 *
 * @typedef {object} CurvesDocument
 * @property {1} directrix
 * @property {"curves"} kind
 * @property {string} title
 * @property {string} unit
 * @property {Material[]} materials
 * @property {Curve[]} curves two, a stack of more, or fewer while a drawing is in progress
 * @property {Sampling} sampling
 * @property {Matching} matching
 * @property {Blend} blend
 * @property {DocumentView} [view]
 *
 * @typedef {{width: number, height: number}} Size CSS pixels.
 *
 * @typedef {object} Selection
 * @property {number} curve
 * @property {number[]} points ascending indices of control points; none for the whole curve
 *
 * @typedef {Probe & {boundary?: {curve: number, at: number}}} Reading
 *   What the probe shows; on a curve itself with the place on it, a fraction of its knot domain.
 *
 * @typedef {{code: string, path?: string, message: string, name?: string, at?: Point}} Problem
 *   What is left of a DirectrixError once it is shown.
 */
export {};
