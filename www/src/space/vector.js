/** Vectors of three numbers, as figures on other pages have them. */
export * from "../../../js/space/vector.js";
