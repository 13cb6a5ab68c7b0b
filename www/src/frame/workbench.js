/** Which workbench the address asks for: every step of a lesson has a link of its own, whatever else there is means the curves. */
export const workbenchOf = () => (location.hash.startsWith("#lesson") ? "lessons" : "curves");
