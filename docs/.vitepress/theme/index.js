/** VitePress's own theme in the colours and the type of the application. */
import theme from "vitepress/theme-without-fonts";
import "./style.css";

export default theme;
