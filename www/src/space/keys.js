/** The camera by keys, as figures on other pages have it. */
export * from "../../../js/space/keys.js";
