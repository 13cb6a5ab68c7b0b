/**
 * The names of verdicts, wherever they are said.
 *
 * @type {Record<import("../../../js/directrix.js").VerdictName, string>}
 */
export const verdictNames = {
  regular: "regular",
  valid: "valid",
  "locally-valid": "locally valid",
  degenerate: "degenerate",
  invalid: "invalid",
};
