/**
 * The gallery: every preset with its picture and one line that says why it matters. Arrow keys go through it as it lies
 * on the screen, Enter opens a preset in place of the open document.
 *
 * @import { App } from "../state/app.js"
 * @import { Preset, Topic } from "./presets.js"
 */
import "../../styles/gallery.css";
import { h } from "../dom.js";
import { openDocument } from "../files/open.js";
import { openPanel } from "../frame/panel.js";
import { kindOf } from "../kinds/kinds.js";
import { presetDocument, presets, thumbnail } from "./presets.js";
import { words } from "./words.js";

const TOPICS = /** @type {const} */ (["shapes", "pockets", "measures", "materials", "stacks"]);
const SIZE = { width: 168, height: 120 };

/**
 * Opens the gallery, or closes it when it is open.
 * @param {App} app
 */
export async function showGallery(app) {
  const kind = await kindOf(app.store.document);
  if (kind) return kind.showGallery(app);
  // As they lie on the screen, so that the keys go from one to the next.
  const shown = TOPICS.flatMap((topic) => presets.filter((preset) => preset.topic === topic));
  const pictures = shown.map(({ id }) => ({ id, element: h("img", { alt: "", loading: "lazy", ...SIZE }) }));
  const paint = () => {
    for (const { id, element } of pictures) element.src = thumbnail(id, app.ui.value.theme);
  };
  paint();

  /** @param {Preset} preset @param {number} index */
  const entry = ({ id, title, matched, line }, index) =>
    h(
      "button",
      { type: "button", class: "preset", "data-preset": id, tabIndex: -1, onclick: () => void open(id, title) },
      pictures[index]?.element,
      h(
        "span",
        { class: "preset-title" },
        title,
        matched === false ? h("span", { class: "preset-tag" }, words.notMatchable) : null,
      ),
      h("span", { class: "preset-line" }, line),
    );
  const entries = shown.map(entry);

  /** @param {Topic} topic */
  const group = (topic) => {
    const heading = h("h3", { id: `gallery-${topic}` }, words.topics[topic]);
    const own = entries.filter((_, index) => shown[index]?.topic === topic);
    return h(
      "section",
      { class: "preset-group", "aria-labelledby": heading.id },
      heading,
      h("ul", { class: "presets" }, ...own.map((each) => h("li", {}, each))),
    );
  };

  const panel = openPanel({
    name: "gallery",
    heading: words.heading,
    body: TOPICS.map(group),
    wide: true,
    tall: true,
    onclose: () => leave(),
  });
  if (!panel) return;
  const { element, close } = panel;
  const leave = app.ui.subscribe((now, before) => {
    if (now.theme !== before.theme) paint();
  });

  /** @param {string} id @param {string} title */
  async function open(id, title) {
    if (await openDocument(app, presetDocument(id), title)) close();
  }

  /** The one entry that Tab reaches; the others are reached from it. @param {HTMLElement | undefined} chosen */
  function rest(chosen) {
    if (!chosen) return;
    for (const each of entries) each.tabIndex = each === chosen ? 0 : -1;
    chosen.focus();
  }

  element.addEventListener("keydown", (event) => {
    const here = entries.findIndex((each) => each === document.activeElement);
    if (here < 0 || event.altKey || event.ctrlKey || event.metaKey) return;
    const target = neighbour(entries, here, event.key);
    if (target === null) return;
    event.preventDefault();
    rest(entries[target]);
  });
  rest(entries[0]);
}

/**
 * The entry that a key leads to, as the entries lie on the screen; null for other keys.
 * @param {HTMLElement[]} entries
 * @param {number} here
 * @param {string} key
 * @returns {number | null}
 */
function neighbour(entries, here, key) {
  const last = entries.length - 1;
  if (key === "ArrowRight") return Math.min(here + 1, last);
  if (key === "ArrowLeft") return Math.max(here - 1, 0);
  if (key === "Home") return 0;
  if (key === "End") return last;
  if (key !== "ArrowDown" && key !== "ArrowUp") return null;
  const places = entries.map((each) => ({ x: each.offsetLeft, y: each.getBoundingClientRect().top }));
  const from = places[here];
  if (!from) return null;
  const beyond = places
    .map(({ x, y }, index) => ({ index, aside: Math.abs(x - from.x), on: key === "ArrowDown" ? y - from.y : from.y - y }))
    .filter(({ on }) => on > 1);
  const next = Math.min(...beyond.map(({ on }) => on));
  const [nearest] = beyond.filter(({ on }) => on < next + 1).sort((a, b) => a.aside - b.aside);
  return nearest?.index ?? here;
}
