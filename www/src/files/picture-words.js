/** What every export of a picture says. */
export const words = {
  heading: "Picture, PNG",
  scale: "Scale",
  download: "Download PNG",
  copy: "Copy",
  copied: "The picture is copied",
  done: (/** @type {string} */ name) => `${name} is written`,
  size: "Size in pixels",
  width: "Width",
  height: "Height",
  theme: "Colours",
  themes: { light: "Light", dark: "Dark" },
  background: "Background",
  transparent: "transparent",
};
