/** Colours of vertices, as figures on other pages have them, and for the shaders of the page. */
export * from "../../../js/space/colors.js";

/** The same for the fragments of a surface. */
export const LAB_SHADER = /* glsl */ `
vec3 lightOf(vec3 lab) {
  float l = lab.x + 0.3963377774 * lab.y + 0.2158037573 * lab.z;
  float m = lab.x - 0.1055613458 * lab.y - 0.0638541728 * lab.z;
  float s = lab.x - 0.0894841775 * lab.y - 1.291485548 * lab.z;
  vec3 lms = vec3(l * l * l, m * m * m, s * s * s);
  return clamp(vec3(
    dot(vec3(4.0767416621, -3.3077115913, 0.2309699292), lms),
    dot(vec3(-1.2684380046, 2.6097574011, -0.3413193965), lms),
    dot(vec3(-0.0041960863, -0.7034186147, 1.707614701), lms)
  ), 0.0, 1.0);
}

vec3 lightOfSrgb(vec3 color) {
  return mix(color / 12.92, pow((color + 0.055) / 1.055, vec3(2.4)), step(0.04045, color));
}

vec3 srgbOf(vec3 light) {
  return mix(light * 12.92, pow(light, vec3(1.0 / 2.4)) * 1.055 - 0.055, step(0.0031308, light));
}
`;
