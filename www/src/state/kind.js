/** Whether a document is of a kind. @param {{kind: string}} document @param {"curves" | "hyperpatch" | "part" | "laplace"} kind */
export const isOf = (document, kind) => document.kind === kind;

/** Whether it is one of curves, which the page shows from the start; what shows others is fetched. @param {{kind: string}} document */
export const isCurves = (document) => isOf(document, "curves");
