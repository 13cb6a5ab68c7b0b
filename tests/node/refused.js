/** Calls that are expected to be refused. */
import assert from "node:assert/strict";
import { DirectrixError } from "directrix";

/**
 * The error of a call.
 * @param {() => unknown} call
 * @returns {DirectrixError}
 */
export function refused(call) {
  try {
    call();
  } catch (error) {
    assert.ok(error instanceof DirectrixError, String(error));
    return error;
  }
  throw new assert.AssertionError({ message: "expected a refusal" });
}

/**
 * What the error of a call says to programs.
 * @param {() => unknown} call
 */
export function refusal(call) {
  const { code, path } = refused(call);
  return { code, path };
}
