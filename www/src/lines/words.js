/** Words of single ruling lines: pins, and why a line is one. */

export const words = {
  pins: {
    heading: "Pins",
    group: "Pins and the ends of the chosen line",
    help:
      "Arrow keys move the end along its curve, with Shift ten times as far, with Alt a tenth. Delete removes the pin, Escape takes " +
      "the move back.",
    pin: (/** @type {number} */ index) => `Pin ${index + 1}`,
    end: (/** @type {string} */ name, /** @type {string} */ curve, /** @type {string} */ at) => `${name} on ${curve}, at ${at}`,
    lineEnd: (/** @type {number} */ line, /** @type {string} */ curve, /** @type {string} */ at) =>
      `End of line ${line + 1} on ${curve}, at ${at}; moving it pins the line`,
    field: (/** @type {number} */ index, /** @type {string} */ curve) => `Pin ${index + 1} on ${curve}`,
    remove: (/** @type {number} */ index) => `Remove pin ${index + 1}`,
    removed: (/** @type {number} */ index) => `Removed pin ${index + 1}`,
    added: (/** @type {number} */ index) => `Pinned as pin ${index + 1}`,
    madeExact: "Pins need an exact method, so the matching is exact now.",
    full: (/** @type {number} */ most) => `A document keeps at most ${most} pins`,
    mend: (/** @type {number} */ count) => `Move an end, or remove ${count > 1 ? "one" : "it"}.`,
  },
  explain: {
    heading: (/** @type {number} */ line) => `Line ${line + 1}`,
    normals: "normals, cos",
    length: "length",
    alignment: "along the normals",
    from: (/** @type {string} */ curve) => `At its end on ${curve}`,
    rank: (/** @type {number} */ rank, /** @type {number} */ of) => `${ordinal(rank)} of ${of} that meet no curve`,
    unseen: (/** @type {number} */ of) => `it meets a curve; ${of} others do not`,
    rivals: "Nearest rivals",
    toLine: (/** @type {number} */ line) => `to line ${line + 1}`,
    toSample: (/** @type {number} */ sample) => `to sample ${sample + 1}`,
    fates: {
      taken: () => "is a line too",
      blocked: () => "meets a curve",
      crosses: (/** @type {number} */ line) => `crosses line ${line + 1}`,
      lower: () => "has the lower f",
      free: () => "lowers the whole",
    },
    gone: "There is no such line any more.",
    pin: "Pin this line",
    pinned: "This line is pinned.",
    previous: "Previous line",
    next: "Next line",
  },
};

/** @param {number} n */
function ordinal(n) {
  const last = n % 10;
  const teen = n % 100 > 10 && n % 100 < 14;
  return `${n}${teen ? "th" : last === 1 ? "st" : last === 2 ? "nd" : last === 3 ? "rd" : "th"}`;
}
