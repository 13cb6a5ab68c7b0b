/**
 * What tests of lessons share: the lessons themselves, the way to their steps, and what stands in them.
 *
 * @import { Page } from "playwright-core"
 * @import { Lesson } from "../../../scripts/lib/lesson.mjs"
 */
import assert from "node:assert/strict";
import { readFile, readdir } from "node:fs/promises";
import { documentNames, lessonFolder } from "../../../scripts/lib/lesson-plugin.mjs";
import { readLesson } from "../../../scripts/lib/lesson.mjs";
import { eventually } from "./workbench.js";

const documents = await documentNames();
const files = (await readdir(lessonFolder)).filter((file) => file.endsWith(".md"));

/** In the order of the list. */
export const lessons = (await Promise.all(files.map(async (file) => readLesson(file.slice(0, -3), await readFile(`${lessonFolder}/${file}`, "utf8"), documents).lesson)))
  .sort((a, b) => a.order - b.order);

/** @param {string} name */
export const named = (name) => /** @type {Lesson} */ (lessons.find((lesson) => lesson.name === name));

export const [first, , greedy, cell] = /** @type {[Lesson, Lesson, Lesson, Lesson]} */ (lessons);

export const control = (/** @type {Page} */ page, /** @type {string} */ name) => page.locator(`[data-lesson=${name}]`);
export const term = (/** @type {Page} */ page, /** @type {string} */ name) => page.locator(`.lesson [data-term="${name}"]`).first();
/** How many pieces a layer of what is lit has. */
export const lit = (/** @type {Page} */ page, /** @type {string} */ layer) => page.locator(`.lit-${layer}`).getAttribute("d").then((d) => d?.match(/M/g)?.length ?? 0);

/** Waits until a step is shown, with its figure. @param {Page} page @param {Lesson} lesson @param {number} step */
export async function shows(page, lesson, step) {
  await eventually(async () => {
    assert.equal(await page.locator(".lesson h1").innerText(), lesson.steps[step - 1]?.title);
    assert.equal(await page.locator(".lesson-figure").getAttribute("data-drawn"), "true");
  });
  assert.equal(new URL(page.url()).hash, `#lesson=${lesson.name}&step=${step}`);
}

/** @param {Page} page @param {Lesson} lesson @param {number} step */
export async function goTo(page, lesson, step) {
  await page.evaluate((hash) => void (location.hash = hash), `#lesson=${lesson.name}&step=${step}`);
  await shows(page, lesson, step);
}
