export default {
  title: "A site",
  url: "https://site.example",
  baseUrl: "/",
  scripts: [{ src: "https://directrix.example/element.js", type: "module" }],
  presets: [["classic", { docs: { routeBasePath: "/" }, blog: false }]],
};
