/**
 * Vite's part of lessons: `www/lessons/NAME.md` becomes a module with the lesson and the documents of its figures; with `?head` only what
 * the list of lessons shows. The style of KaTeX comes with the few fonts that lessons use.
 */
import { readFile, readdir } from "node:fs/promises";
import { basename, join } from "node:path";
import { readLesson } from "./lesson.mjs";
import { root } from "./paths.mjs";

export const lessonFolder = join(root, "www/lessons");
const presetFolder = join(root, "www/presets");
/** Folders of presets of other kinds, whose names begin with that of their folder. */
const KINDS = ["hyperpatch", "part", "laplace"];
const STYLE = /\/katex\/dist\/katex\.css$/;
const LESSON = /\/www\/lessons\/([^/?]+)\.md(\?head)?$/;
/** Fonts of what lessons set; a browser fetches those that a formula on the page uses. */
const FONTS = /KaTeX_(Main-Regular|Main-Bold|Main-Italic|Math-Italic|AMS-Regular|Size[1-4]-Regular)\.woff2/;

/** Names of the documents that figures of lessons may show: presets, and documents beside the lessons. */
export async function documentNames() {
  const [presets = [], own = [], ...kinds] = await Promise.all([presetFolder, lessonFolder, ...KINDS.map((kind) => join(presetFolder, kind))].map((folder) => readdir(folder)));
  return [...presets, ...own, ...kinds.flatMap((files, k) => files.map((file) => `${KINDS[k]}-${file}`))]
    .filter((file) => file.endsWith(".json") && file !== "index.json")
    .map((file) => basename(file, ".json"))
    .sort();
}

/** @param {string} name */
export async function documentNamed(name) {
  const kind = KINDS.find((each) => name.startsWith(`${each}-`));
  const paths = [join(lessonFolder, name), join(presetFolder, name), ...(kind ? [join(presetFolder, kind, name.slice(kind.length + 1))] : [])];
  const texts = await Promise.allSettled(paths.map((path) => readFile(`${path}.json`, "utf8")));
  const found = texts.find((each) => each.status === "fulfilled");
  if (!found) throw new Error(`there is no document ${name}`);
  return JSON.parse(found.value);
}

/** The style of KaTeX without the fonts that lessons do not use, and without the formats of old browsers. @param {string} css */
function lean(css) {
  return css.replace(/@font-face\s*{[^}]*}/g, (face) => {
    const font = FONTS.exec(face);
    return font ? face.replace(/src:[^;}]*/, `src: url(fonts/${font[0]}) format("woff2")`) : "";
  });
}

/** @returns {import("vite").Plugin} */
export function lessons() {
  return {
    name: "lessons",
    enforce: "pre",
    async load(id) {
      const [, name, head] = LESSON.exec(id.replaceAll("\\", "/")) ?? [];
      if (name === undefined) return undefined;
      const source = await readFile(join(lessonFolder, `${name}.md`), "utf8");
      const { lesson } = readLesson(name, source, await documentNames());
      const { steps, ...rest } = lesson;
      if (head) return moduleOf({ ...rest, steps: steps.map(({ title }) => title) });
      const used = new Set(steps.map(({ figure }) => figure.document));
      const documents = await Promise.all([...used].map(async (each) => [each, await documentNamed(each)]));
      return moduleOf({ ...lesson, documents: Object.fromEntries(documents) });
    },
    transform: (code, id) => (STYLE.test(id) ? lean(code) : undefined),
  };
}

/** @param {unknown} value */
const moduleOf = (value) => `export default JSON.parse(${JSON.stringify(JSON.stringify(value))});`;
