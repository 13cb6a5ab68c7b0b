/**
 * How a link makes the page look, for this visit: fewer controls, another theme. Nothing of it is stored.
 *
 * @import { Link } from "../../../js/directrix.js"
 */
import "../../styles/share.css";
import { find, h } from "../dom.js";
import { words } from "./words.js";

const root = document.documentElement;
/** @type {HTMLElement | null} */
let way = null;

/**
 * @param {Link} link
 */
export function look({ controls = "full", theme }) {
  if (theme === "light" || theme === "dark") root.dataset.theme = theme;
  else if (theme === "auto") delete root.dataset.theme;
  if (controls === "full") {
    delete root.dataset.controls;
    way?.remove();
    way = null;
    return;
  }
  root.dataset.controls = controls;
  way ??= h("button", { type: "button", class: "outlined show-controls", "data-show-controls": "" }, words.showControls);
  way.onclick = () => look({});
  find("#bar").append(way);
}
