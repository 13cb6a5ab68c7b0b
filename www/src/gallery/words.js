/** Every word of the gallery. */
export const words = {
  heading: "Gallery",
  topics: {
    shapes: "Shapes",
    pockets: "Pockets",
    measures: "Measures and limits",
    materials: "Materials",
    stacks: "Stacks",
  },
  notMatchable: "No matching",
};
