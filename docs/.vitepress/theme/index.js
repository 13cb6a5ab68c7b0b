/** VitePress's own theme in the colours and the type of the application. */
import { withBase } from "vitepress";
import theme from "vitepress/theme-without-fonts";
import "./style.css";

/** @type {import("vitepress").Theme} */
export default {
  extends: theme,
  enhanceApp() {
    // Built pages have it in their heads, to which the development server adds nothing.
    if (!import.meta.env.DEV || import.meta.env.SSR) return;
    const script = document.createElement("script");
    script.type = "module";
    script.src = withBase("/app/element.js");
    document.head.append(script);
  },
};
