/** How many tests a runner says it has run. */

/**
 * @typedef {object} Counts
 * @property {number} passed
 * @property {number} failed failed, timed out, or cancelled
 */

/** @type {((line: string) => Counts | null)[]} */
const readers = [
  // cargo-nextest: "Summary [ 0.012s] 3 tests run: 2 passed (1 slow), 1 failed, 0 skipped"
  (line) => {
    const found = line.match(/^\s*Summary \[.*\] (\d+)(?:\/\d+)? tests? run: (\d+) passed/);
    return found && { passed: Number(found[2]), failed: Number(found[1]) - Number(found[2]) };
  },
  // cargo test: "test result: ok. 3 passed; 0 failed; 0 ignored; ..."
  (line) => {
    const found = line.match(/^test result: \S+ (\d+) passed; (\d+) failed;/);
    return found && { passed: Number(found[1]), failed: Number(found[2]) };
  },
  // node --test: "# pass 3", "# fail 0", "# cancelled 0", with another sign at the front from other reporters
  (line) => {
    const found = line.match(/^\S (pass|fail|cancelled) (\d+)$/);
    return found && (found[1] === "pass" ? { passed: Number(found[2]), failed: 0 } : { passed: 0, failed: Number(found[2]) });
  },
];

/**
 * Adds up the closing lines of the runners in an output; `null` when there is none.
 *
 * @param {string[]} output
 * @returns {Counts | null}
 */
export function countTests(output) {
  const found = output.flatMap((line) => readers.map((read) => read(line))).filter((counts) => counts !== null);
  if (found.length === 0) return null;
  return found.reduce((sum, each) => ({ passed: sum.passed + each.passed, failed: sum.failed + each.failed }));
}
