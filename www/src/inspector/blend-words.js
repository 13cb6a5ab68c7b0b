/** Words of the fields of the blend. */

export const words = {
  kind: "Across",
  ruled: "Linear",
  cubic: "Cubic",
  stages: "Stages",
  names: "Names of stages",
};
