/** The camera of pictures in three dimensions, which figures on other pages have as well. */
export * from "../../../js/space/camera.js";
