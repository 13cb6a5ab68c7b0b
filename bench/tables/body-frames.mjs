/** A body of 400 cells as the page turns it in a browser, on a canvas of 800 x 600: what a picture costs, and how many come in a second. */
import { launch } from "../../tests/browser/support/browser.js";
import { manyCells } from "../../tests/browser/support/many-cells.js";
import { serveDist } from "../../tests/browser/support/server.js";

/** What the frame of the page takes beside the canvas, in CSS pixels. */
const BESIDE = { width: 272, height: 80 };
/** Pictures that are watched. */
const WATCHED = 40;

/** @param {string[]} cells */
const row = (cells) => `| ${cells.join(" | ")} |`;

/** What is shown, and the sliders that show it. @type {[string, Record<string, number>][]} */
const SHOWN = [
  ["as it is", {}],
  ["apart", { "body-apart": 0.4 }],
  ["seen through", { "body-apart": 0, "body-transparency": 0.5 }],
];

export const name = "frames of a body in the page";

/** Lines of Markdown. */
export async function* table() {
  const [browser, served] = await Promise.all([launch(), serveDist()]);
  try {
    yield row(["400 cells", "canvas", "draw calls", "triangles", "pictures a second", "median ms", "p90 ms"]);
    yield row(["---", "---:", "---:", "---:", "---:", "---:", "---:"]);
    const page = await browser.newPage({ viewport: { width: 800 + BESIDE.width, height: 600 + BESIDE.height } });
    await page.goto(`${served.url}#v=1&preset=hyperpatch-cell`);
    await page.locator("[data-body=checked]").waitFor({ state: "attached" });
    const buffer = Buffer.from(JSON.stringify(manyCells(10, 8, 5)));
    await page.locator("input[data-file]").setInputFiles({ name: "many.json", mimeType: "application/json", buffer });
    await page.locator("[data-total=cells]", { hasText: "400" }).waitFor();
    await page.locator("[data-body=checked]").waitFor({ state: "attached", timeout: 120_000 });
    for (const [shown, sliders] of SHOWN) {
      for (const [slider, value] of Object.entries(sliders)) {
        await page.locator(`[data-slider="${slider}"]`).evaluate((input, text) => {
          /** @type {HTMLInputElement} */ (input).value = text;
          input.dispatchEvent(new Event("input", { bubbles: true }));
        }, String(value));
      }
      await page.waitForTimeout(1500);
      const { size, calls, triangles, times } = await page.evaluate(async (count) => {
        const canvas = /** @type {HTMLCanvasElement} */ (globalThis.document.querySelector(".body-stage [data-space]"));
        const keys = /** @type {HTMLElement} */ (globalThis.document.querySelector("[data-body-keys]"));
        keys.focus();
        const gl = /** @type {WebGL2RenderingContext} */ (canvas.getContext("webgl2"));
        const pixel = new Uint8Array(4);
        const times = [];
        for (let n = 0; n < count; n += 1) {
          const start = performance.now();
          keys.dispatchEvent(new KeyboardEvent("keydown", { key: "ArrowRight", bubbles: true }));
          await new Promise(requestAnimationFrame);
          // Until the picture is there and not only ordered.
          gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
          times.push(performance.now() - start);
        }
        return { size: `${canvas.clientWidth} x ${canvas.clientHeight}`, calls: canvas.dataset.calls ?? "", triangles: canvas.dataset.triangles ?? "", times };
      }, WATCHED);
      const sorted = times.sort((a, b) => a - b);
      const at = (/** @type {number} */ share) => sorted[Math.ceil(share * sorted.length) - 1];
      yield row([shown, size, calls, triangles, (1000 / at(0.5)).toFixed(1), at(0.5).toFixed(1), at(0.9).toFixed(1)]);
    }
  } finally {
    await browser.close();
    await served.close();
  }
}
