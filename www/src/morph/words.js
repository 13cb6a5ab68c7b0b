/** What the morph says where it is set and where it goes elsewhere. */
const NARROW = "\u00a0";

export const words = {
  seconds: "Seconds",
  secondsLabel: "Seconds from one curve to the other",
  easing: "Motion",
  easings: { linear: "Even", ease: "Eased" },
  repeat: "Repeat",
  repeatLabel: "Repeat: once, from the start again, or there and back",
  repeats: { once: "Once", loop: "Loop", swing: "Swing" },

  kind: "As",
  kinds: { svg: "Animated SVG", png: "PNG sequence", webm: "WebM film", paths: "Two paths" },
  shows: "Shows",
  showns: { figure: "Figure", shape: "Shape" },
  size: "Size in pixels",
  width: "Width",
  height: "Height",
  frames: "Frames",
  rate: "Frames a second",
  theme: "Colours",
  themes: { light: "Light", dark: "Dark" },
  background: "Background",
  transparent: "transparent",
  tolerance: "Tolerance",
  toleranceLabel: (/** @type {string} */ unit) => `Largest distance of a path from its curve, in ${unit}`,
  text: "Text",
  texts: { svg: "SVG", json: "JSON", css: "CSS", smil: "SMIL" },
  code: (/** @type {string} */ text) => `${text} of the two paths`,

  notes: {
    svg: {
      figure: "The figure as on screen stands still, its in-between moves. Plays as an image too.",
      shape: "The in-between alone, in its materials: one colour for each piece of it, so finer along the curve with more lines.",
    },
    png: (/** @type {string} */ size) => `The figure as on screen, one picture a frame, in a zip. Up to 600 frames; at most ${size} in all.`,
    webm: "The figure as on screen, every frame at its exact time. VP9 or VP8, up to 60 s and 1800 frames.",
    paths: {
      svg: "Both curves with the same commands, matched point by point.",
      json: "from, to, number of commands, error and viewBox.",
      css: "Keyframes of d for an SVG path, and of clip-path for any element. Not every browser animates d; all animate clip-path.",
      smil: "An SVG that plays by itself, also as an image.",
    },
  },
  certificate: (/** @type {number} */ commands, /** @type {string} */ error) => `${commands} cubics each, error at most ${error}`,
  noVideo: "This browser cannot write WebM: it has no encoder for VP9 or VP8. An animated SVG or a PNG sequence plays anywhere.",
  unmatched: "there is no morph, because the matching is not complete",
  tooMany: (/** @type {string} */ found, /** @type {string} */ most) =>
    `${found} were asked for; expected at most ${most}: take fewer frames or a smaller size`,
  megapixels: (/** @type {number} */ count) => `${count.toLocaleString("en").replaceAll(",", NARROW)}${NARROW}million pixels`,
  tooLong: (/** @type {number} */ frames, /** @type {number} */ most) =>
    `${frames} frames were asked for; expected at most ${most}: take fewer seconds or frames a second`,

  download: "Download",
  downloaded: (/** @type {string} */ file) => `Downloaded ${file}`,
  copy: "Copy",
  copied: "Copied to the clipboard",
  cancel: "Cancel",
  cancelled: "Cancelled",
  frame: (/** @type {number} */ frame, /** @type {number} */ of) => `Frame ${frame} of ${of}`,
  progress: "Export",
  failed: (/** @type {string} */ reason) => `That did not work: ${reason}.`,
};
