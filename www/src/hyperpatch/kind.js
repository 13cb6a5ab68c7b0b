/** Whether a document is a body of hyperpatches, which the workbench of its own shows. @param {{kind: string}} document */
export const isBody = ({ kind }) => kind === "hyperpatch";
