/** What every export of a picture says. */
export const words = {
  size: "Size in pixels",
  width: "Width",
  height: "Height",
  theme: "Colours",
  themes: { light: "Light", dark: "Dark" },
  background: "Background",
  transparent: "transparent",
};
