/** The morph as the page plays it in a browser, on a canvas of 800 x 600: how many pictures a second it shows. */
import { readFile } from "node:fs/promises";
import { launch } from "../../tests/browser/support/browser.js";
import { serveDist } from "../../tests/browser/support/server.js";
import { writeLink } from "../../js/link.js";

/** What the frame of the page takes beside the canvas, in CSS pixels. */
const BESIDE = { width: 272, height: 80 };
/** Seconds that are watched, after one in which the worker's code gets its full speed. */
const WATCHED = 4;

/** @param {string[]} cells */
const row = (cells) => `| ${cells.join(" | ")} |`;

/** Counts in the page: every picture that it puts on the canvas, and every frame of the screen. */
const counter = () => {
  const { putImageData } = CanvasRenderingContext2D.prototype;
  const seen = { pictures: /** @type {number[]} */ ([]), frames: /** @type {number[]} */ ([]) };
  Object.assign(window, { seen });
  CanvasRenderingContext2D.prototype.putImageData = function (/** @type {any[]} */ ...given) {
    seen.pictures.push(performance.now());
    return putImageData.apply(this, /** @type {any} */ (given));
  };
  const tick = (/** @type {number} */ time) => {
    seen.frames.push(time);
    requestAnimationFrame(tick);
  };
  requestAnimationFrame(tick);
};

/** Steps between neighbours. @param {number[]} times */
const steps = (times) => times.slice(1).map((time, k) => time - times[k]).sort((a, b) => a - b);

export const name = "frames of the morph in the page";

/** Lines of Markdown. */
export async function* table() {
  const amoeba = JSON.parse(await readFile(new URL("../../www/presets/amoeba.json", import.meta.url), "utf8"));
  const [browser, served] = await Promise.all([launch(), serveDist()]);
  try {
    yield row(["lines", "canvas", "pictures a second", "median ms", "p90 ms", "frames of the screen a second"]);
    yield row(["---:", "---:", "---:", "---:", "---:", "---:"]);
    for (const lines of [44, 200]) {
      const document = { ...amoeba, sampling: { scheme: "arc-length", counts: [lines, lines] }, matching: { ...amoeba.matching, lines } };
      const context = await browser.newContext({ viewport: { width: 800 + BESIDE.width, height: 600 + BESIDE.height } });
      const page = await context.newPage();
      await page.addInitScript(counter);
      await page.goto(`${served.url}${writeLink({ document })}`);
      await page.waitForSelector("#status[data-verdict=verified]");
      await page.locator("[data-play]").click();
      await page.waitForTimeout(1000);
      const { size, pictures, frames } = await page.evaluate(async (seconds) => {
        const { seen } = /** @type {any} */ (window);
        seen.pictures.length = seen.frames.length = 0;
        await new Promise((done) => setTimeout(done, seconds * 1000));
        const { clientWidth, clientHeight } = /** @type {HTMLElement} */ (globalThis.document.querySelector("#picture"));
        return { size: `${clientWidth} x ${clientHeight}`, pictures: [...seen.pictures], frames: [...seen.frames] };
      }, WATCHED);
      const between = steps(pictures);
      const at = (/** @type {number} */ share) => between[Math.ceil(share * between.length) - 1].toFixed(1);
      const rate = (/** @type {number[]} */ times) => ((times.length - 1) / ((times[times.length - 1] - times[0]) / 1000)).toFixed(1);
      yield row([`${lines}`, size, rate(pictures), at(0.5), at(0.9), rate(frames)]);
      await context.close();
    }
  } finally {
    await browser.close();
    await served.close();
  }
}
