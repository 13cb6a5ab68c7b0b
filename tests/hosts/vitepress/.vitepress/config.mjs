export default {
  title: "A site",
  head: [["script", { type: "module", src: "https://directrix.example/element.js" }]],
  vue: { template: { compilerOptions: { isCustomElement: (tag) => tag === "directrix-figure" } } },
};
