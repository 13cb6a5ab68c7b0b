import assert from "node:assert/strict";
import { test } from "node:test";
import { onOnePage } from "./one-page.js";
import { openPage, openRaw } from "./open.js";
import { choosePoint, documentOf, eventually, field, handle, pick, status } from "./workbench.js";

onOnePage("the page as it opens", {
  "the page opens on a finished figure with its certificates": async (page) => {
    const text = await status(page);
    assert.match(text, /Verified/);
    for (const word of ["lines", "mean", "crossings", "blocked", "uncovered", "ms"])
      assert.ok(text.includes(word), `${word} in ${text}`);
    assert.ok(await handle(page, "A1").isVisible());
    const { title } = await documentOf(page);
    assert.ok((await page.title()).startsWith(title));
    assert.equal(await page.locator("[data-state]").textContent(), "");
    const colors = await page.locator("#picture").evaluate((element) => {
      const canvas = /** @type {HTMLCanvasElement} */ (element);
      const { data } = /** @type {CanvasRenderingContext2D} */ (canvas.getContext("2d")).getImageData(
        0,
        0,
        canvas.width,
        canvas.height,
      );
      const seen = new Set();
      for (let i = 0; i < data.length; i += 4)
        seen.add(
          /** @type {number} */ (data[i] << 16) |
            /** @type {number} */ (data[i + 1] << 8) |
            /** @type {number} */ (data[i + 2]),
        );
      return seen.size;
    });
    assert.ok(colors > 1000, `${colors} colours`);
  },

  "no number on the page is NaN, infinite or a negative zero": async (page) => {
    const text = `${await page.locator("body").innerText()} ${await page.locator("input").evaluateAll((all) => all.map((each) => /** @type {HTMLInputElement} */ (each).value).join(" "))}`;
    assert.doesNotMatch(text, /NaN|Infinity|undefined|null|[-\u2212]0(\.0+)?(?![.\d])/);
  },

  "a curve that crosses itself is named with the place, and the document stays": async (page) => {
    const { curves } = await documentOf(page);
    const [x, y] = curves[1].points[Math.floor(curves[1].points.length / 2)];
    await choosePoint(page, "B1");
    await field(page, "x").fill(String(x * 1.6));
    await page.keyboard.press("Enter");
    await field(page, "y").fill(String(y * 1.6));
    await page.keyboard.press("Enter");
    await eventually(async () => assert.match(await status(page), /(crosses itself|touch) near \(.+\)\. Move/));
    assert.deepEqual((await documentOf(page)).curves[1].points[0], [
      Number((x * 1.6).toFixed(12)),
      Number((y * 1.6).toFixed(12)),
    ]);
    await page.keyboard.press("Control+z");
    await page.keyboard.press("Control+z");
    await eventually(async () => assert.match(await status(page), /Verified/));
  },
});

test("without WebAssembly there is a plain message", async (t) => {
  const page = await openRaw(t, { init: "delete globalThis.WebAssembly" });
  await page.getByText("does not offer it").waitFor();
  assert.ok(await page.getByRole("alert").isVisible());
});

test("without SIMD there is a plain message", async (t) => {
  const page = await openRaw(t, { init: "WebAssembly.validate = () => false" });
  await page.getByText("with SIMD").waitFor();
});

test("where a policy blocks the module there is a plain message", async (t) => {
  const headers = { "content-security-policy": "script-src 'self' 'unsafe-inline'" };
  const page = await openRaw(t, { headers });
  await page.getByText("could not start").waitFor();
});

test("without scripts there is a plain message", async (t) => {
  const page = await openRaw(t, { context: { javaScriptEnabled: false } });
  assert.match(await page.content(), /<noscript>[^]*needs JavaScript[^]*<\/noscript>/);
});

test("a failed computation is told, and the work goes on", async (t) => {
  // The module is replaced by one that answers once and then traps, by way of the worker's own messages.
  const page = await openPage(t, {
    init: `{
      const Real = Worker;
      globalThis.Worker = class extends Real {
        postMessage(message, ...rest) {
          if (globalThis.failNext && message.type === "call" && message.name === "match") {
            globalThis.failNext = false;
            const error = { code: "trap", path: "", message: "unreachable" };
            this.onmessage?.({ data: { type: "error", id: message.id, error } });
            return;
          }
          super.postMessage(message, ...rest);
        }
      };
    }`,
  });
  const before = await documentOf(page);
  await page.evaluate("globalThis.failNext = true");
  await handle(page, "A1").focus();
  await page.keyboard.press("ArrowUp");
  await eventually(async () => assert.match(await status(page), /started again/));
  assert.notDeepEqual(await documentOf(page), before);
  await page.locator("[data-command=retry]").click();
  await eventually(async () => {
    assert.match(await status(page), /Verified/);
    assert.doesNotMatch(await status(page), /started again/);
  });
});

test("long work can be cancelled, and the last picture and the document stay", async (t) => {
  // Work takes as long as the test wants: calls that are held back never reach the worker.
  const page = await openPage(t, {
    init: `{
      const Real = Worker;
      globalThis.Worker = class extends Real {
        postMessage(message, ...rest) {
          if (!(globalThis.hold && message.type === "call")) super.postMessage(message, ...rest);
        }
      };
    }`,
  });
  const picture = () =>
    page.locator("#picture").evaluate((canvas) => /** @type {HTMLCanvasElement} */ (canvas).toDataURL());
  // A page that rests is painted once more, finer.
  const before = await eventually(async () => {
    const seen = await picture();
    await page.waitForTimeout(300);
    assert.equal(await picture(), seen);
    return seen;
  });
  await page.evaluate("globalThis.hold = true");
  await page.locator("[data-more] summary").click();
  await pick(page, "negative", "half");
  const cancel = page.locator("[data-command=cancel]");
  await cancel.waitFor();
  assert.ok(await page.locator("#progress").evaluate((line) => line.classList.contains("shown")));
  await cancel.click();
  await eventually(async () => assert.match(await status(page), /Cancelled/));
  assert.equal(await picture(), before);
  assert.equal((await documentOf(page)).matching.negative, "half");
  await page.evaluate("globalThis.hold = false");
  await pick(page, "negative", "clamp");
  await eventually(async () => assert.match(await status(page), /Verified/));
  assert.doesNotMatch(await status(page), /Cancelled/);
});
