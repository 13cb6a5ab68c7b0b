/**
 * The documentation as a site: the pages of `docs` with live figures, and the application beside them in `app/`, which the figures
 * come from and open in. It asks nobody else for anything.
 */
import { defineConfig } from "vitepress";
import { applicationFolder } from "../../scripts/lib/documentation.mjs";
import { code } from "./code.mjs";
import { licences } from "./licences.mjs";
import { emptyHeads, leadOutside, plainCode, titles } from "./markdown.mjs";
import { sidebar } from "./sidebar.mjs";

export default defineConfig({
  lang: "en",
  title: "Directrix",
  description: "Bodies whose material varies from point to point, in the browser: the guide, the formats and the figures behind them.",
  outDir: "../dist-docs",
  cacheDir: "../.build/vitepress",
  markdown: { theme: code, config: (md) => md.use(leadOutside).use(titles).use(emptyHeads).use(plainCode) },
  vue: { template: { compilerOptions: { isCustomElement: (tag) => tag === "directrix-figure" } } },
  vite: { publicDir: applicationFolder, plugins: [licences()] },
  transformHead: ({ siteData: { base } }) => [
    ["link", { rel: "icon", type: "image/svg+xml", href: `${base}mark.svg` }],
    // As any page does it. The pages follow each other without loading anew; the element is defined once for all.
    ["script", { type: "module", src: `${base}app/element.js` }],
  ],
  themeConfig: {
    logo: "/mark.svg",
    nav: [{ text: "Open Directrix", link: "/app/index.html", target: "_self" }],
    sidebar: sidebar(),
    outline: [2, 3],
    search: { provider: "local" },
    notFound: { title: "No such page", quote: "The address may have changed; the search knows every page.", linkText: "To the start" },
  },
});
