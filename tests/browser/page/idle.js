/**
 * Whether the kernel has answered everything that the page asked: what is seen before may still belong to the document that was open before.
 *
 * @import { BrowserContext, Page } from "playwright-core"
 */
import { drawn } from "./workbench.js";

/** Milliseconds after which a page that keeps asking, such as one that plays a morph, counts as idle. */
const LONGEST = 5000;

/** Counts the calls of a page's workers that wait for an answer; before the page is opened. @param {BrowserContext} context */
export function countCalls(context) {
  return context.addInitScript(() => {
    /** @type {Set<string>} */
    const waiting = new Set();
    let workers = 0;
    Object.assign(globalThis, { callsThatWait: waiting });
    globalThis.Worker = class extends Worker {
      #number = (workers += 1);

      /** @param {string | URL} address @param {WorkerOptions} [options] */
      constructor(address, options) {
        super(address, options);
        this.addEventListener("message", ({ data }) => {
          if (data?.type !== "progress") waiting.delete(`${this.#number} ${data?.id}`);
        });
      }

      /** @param {any} message @param {any} [more] */
      postMessage(message, more) {
        const key = `${this.#number} ${message?.id}`;
        if (message?.type === "call") waiting.add(key);
        if (message?.type === "cancel") waiting.delete(key);
        super.postMessage(message, more);
      }

      terminate() {
        for (const key of waiting) if (key.startsWith(`${this.#number} `)) waiting.delete(key);
        super.terminate();
      }
    };
  });
}

/** Waits until the page has drawn its state, and has asked nothing that is not answered. @param {Page} page */
export async function idle(page) {
  const end = Date.now() + LONGEST;
  let quiet = 0;
  while (quiet < 2 && Date.now() < end) {
    await drawn(page);
    const waiting = await page.evaluate(() => /** @type {any} */ (globalThis).callsThatWait.size);
    quiet = waiting === 0 ? quiet + 1 : 0;
  }
}
