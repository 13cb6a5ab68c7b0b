/**
 * Rows as CSV: lines that end in a line feed, numbers with all their digits, and texts in quotes where they need them.
 * @param {readonly (readonly (string | number)[])[]} rows the first one has the names of the columns
 */
export const csvOf = (rows) => rows.map((cells) => `${cells.map(cellOf).join(",")}\n`).join("");

/** @param {string | number} cell */
const cellOf = (cell) => (typeof cell === "string" && /[",\n]/.test(cell) ? `"${cell.replaceAll('"', '""')}"` : String(cell));
