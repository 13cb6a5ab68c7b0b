/** The morph as it plays, and where it is exported. */
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { test } from "node:test";
import { load } from "directrix";
import { unzipSync } from "fflate";
import { PNG } from "pngjs";
import { audit } from "../support/axe.js";
import { between, hex } from "../../../www/src/morph/color.js";
import { fitted } from "../../../www/src/morph/path-data.js";
import { places } from "../../../www/src/morph/motion.js";
import { onOnePage } from "./one-page.js";
import { openPage } from "./open.js";
import { documentOf, eventually, field, pick, uiOf } from "./workbench.js";

/**
 * @import { Page } from "playwright-core"
 */

/** @param {Page} page */
const message = (page) => page.locator("[data-message=morph]");

/** Opens the export of the morph. @param {Page} page @param {string} kind */
async function openMorph(page, kind) {
  if ((await page.locator("[data-panel=export]").count()) === 0) await page.locator("[data-action=export]").click();
  await pick(page, "export-format", "morph");
  await page.locator("[data-select=morph-kind]").selectOption(kind);
}

/** @param {Page} page @param {{[name: string]: number}} values */
async function fill(page, values) {
  for (const [name, value] of Object.entries(values)) {
    await field(page, name).fill(String(value));
    await field(page, name).press("Enter");
  }
}

/** What Download hands out. @param {Page} page @param {string} name of the file */
async function downloaded(page, name) {
  const download = page.waitForEvent("download");
  await page.locator("[data-morph=download]").click();
  const file = await download;
  assert.equal(file.suggestedFilename(), name);
  return readFile(await file.path());
}

/** @param {Page} page */
const shown = async (page) => Number(await page.locator("#morph-controls input").inputValue());

onOnePage("the morph", {
  "with reduced motion the morph goes from stage to stage": async (page) => {
    await page.emulateMedia({ reducedMotion: "reduce" });
    const { blend } = await documentOf(page);
    await page.locator("[data-play]").click();
    await eventually(async () => assert.ok(Math.abs((await shown(page)) * blend.stages - 3) < 1e-6));
    await page.emulateMedia({ reducedMotion: "no-preference" });
  },

  "an animated figure is the figure with its in-between in motion, and frames are the kernel's pictures": async (page) => {
    await openMorph(page, "svg");
    const text = (await downloaded(page, "amoeba-morph.svg")).toString("utf8");
    assert.match(text, /id="layer-ruling-lines"/);
    assert.doesNotMatch(text, /id="layer-current"/);
    assert.match(text, /<g id="morph"[^>]*>\n<path [^>]*><animate attributeName="d"/);
    assert.match(text, /dur="8s" repeatCount="indefinite" calcMode="spline"/);
    await page.locator("[data-select=morph-kind]").selectOption("png");
    await pick(page, "export-repeat", "once");
    await fill(page, { "morph-frames": 3 });
    const files = unzipSync(await downloaded(page, "amoeba-frames.zip"));
    assert.deepEqual(Object.keys(files), ["amoeba-1.png", "amoeba-2.png", "amoeba-3.png"]);
    await eventually(async () => assert.equal(await message(page).innerText(), "Downloaded amoeba-frames.zip"));
    const [document, ui] = [await documentOf(page), await uiOf(page)];
    const dx = await load({ module: "figure" });
    for (const [i, s] of places({ easing: "ease", repeat: "once" }, 3).entries()) {
      const { width, height, data } = PNG.sync.read(Buffer.from(files[`amoeba-${i + 1}.png`]));
      const { layers, view, isoMaterial } = ui;
      const same = dx.paint(document, { width, height, layers, s, view, isoMaterial, theme: "light", line: null });
      assert.equal(Buffer.compare(Buffer.from(data), Buffer.from(same.data)), 0, `frame ${i}`);
    }
  },

  "the morph plays once, eased, in the seconds that are set, and stops on the second curve": async (page) => {
    await page.keyboard.press("Escape");
    await page.locator("[data-group-button=blend]").click();
    await pick(page, "blend-repeat", "once");
    await fill(page, { "blend-seconds": 0.6 });
    await page.locator("[data-play]").click();
    await eventually(async () => assert.equal(await shown(page), 1));
    await eventually(async () => assert.equal(await page.locator("[data-play]").getAttribute("aria-label"), "Play"));
    // From the second curve it starts again.
    await fill(page, { "blend-seconds": 20 });
    await page.locator("[data-play]").click();
    await eventually(async () => {
      const s = await shown(page);
      assert.ok(s > 0 && s < 0.5, String(s));
    });
    await page.locator("[data-play]").click();
    assert.deepEqual((await uiOf(page)).motion, { seconds: 20, easing: "ease", repeat: "once" });
  },

  "the two paths are those of the kernel, follow the tolerance, and go to the clipboard": async (page) => {
    await openMorph(page, "paths");
    await pick(page, "morph-text", "json");
    const dx = await load();
    const document = await documentOf(page);
    const code = page.locator("[data-code]");
    const same = async (/** @type {number | undefined} */ tolerance) => {
      const paths = dx.morphPaths(document, tolerance ? { tolerance } : {});
      assert.ok(paths);
      await eventually(async () => {
        const { from, to, commands, error } = JSON.parse(await code.inputValue());
        assert.deepEqual({ from, to, commands, error }, { from: paths.from, to: paths.to, commands: paths.commands, error: paths.error });
      });
      assert.match(await page.locator("[data-certificate]").innerText(), new RegExp(`^${paths.commands} cubics each, error at most`));
      return paths.commands;
    };
    const fine = await same(undefined);
    await fill(page, { "morph-tolerance": 0.5 });
    assert.ok((await same(0.5)) < fine);
    for (const [text, looks] of /** @type {const} */ ([["svg", /^<svg.*<path id="from"/s], ["css", /^\/\*.*@keyframes/s], ["smil", /<animate attributeName="d"/], ["json", /^{\n {2}"from"/]])) {
      await pick(page, "morph-text", text);
      await page.locator("[data-morph=copy]").click();
      await eventually(async () => assert.equal(await message(page).innerText(), "Copied to the clipboard"));
      assert.match(await page.evaluate(() => navigator.clipboard.readText()), looks);
    }
    assert.match((await downloaded(page, "amoeba-paths.json")).toString("utf8"), /"commands"/);
  },

  "an animated SVG shows the kernel's in-between in its materials at every time, and plays as an image": async (page) => {
    await openMorph(page, "svg");
    await pick(page, "morph-shows", "shape");
    await pick(page, "export-easing", "linear");
    await pick(page, "export-repeat", "once");
    await fill(page, { "export-seconds": 2 });
    const text = (await downloaded(page, "amoeba-morph.svg")).toString("utf8");
    const document = await documentOf(page);
    const { size } = await uiSize(page);
    const dx = await load();
    const paths = dx.morphPaths(document);
    assert.ok(paths);
    const place = fitted(paths.viewBox, size, 24);
    const other = await page.context().newPage();
    await other.setViewportSize(size);
    await other.setContent(`<style>body { margin: 0 } svg { display: block }</style>${text}`);
    const colors = document.materials.map((/** @type {{color: string}} */ { color }) => color);
    const pictures = [];
    for (const s of [0, 0.5, 1]) {
      await other.evaluate((time) => {
        const svg = /** @type {SVGSVGElement} */ (globalThis.document.querySelector("svg"));
        svg.pauseAnimations();
        svg.setCurrentTime(time);
      }, 2 * s);
      const picture = PNG.sync.read(await other.screenshot());
      pictures.push(picture);
      const found = middles(paths, s).filter(([x, y], k) => {
        const [px, py] = [Math.round(place.scale * x + place.x - 0.5), Math.round(place.scale * y + place.y - 0.5)];
        const wanted = hex(colors, between(paths.fractions[0][k], paths.fractions[1][k], s));
        const channels = [1, 3, 5].map((i) => Number.parseInt(wanted.slice(i, i + 2), 16));
        const at = (py * picture.width + px) * 4;
        return channels.every((channel, i) => Math.abs(channel - picture.data[at + i]) <= 8);
      });
      assert.ok(found.length >= 0.97 * paths.commands, `${found.length} of ${paths.commands} at ${s}`);
    }
    assert.ok(differing(pictures[0], pictures[2]) > 5000);
    // As an image nobody steers it.
    await other.setContent(`<img width="600" src="data:image/svg+xml;base64,${Buffer.from(text).toString("base64")}">`);
    const image = other.locator("img");
    await image.evaluate((element) => /** @type {HTMLImageElement} */ (element).decode());
    const first = PNG.sync.read(await image.screenshot());
    await eventually(async () => assert.ok(differing(first, PNG.sync.read(await image.screenshot())) > 1000));
    await other.close();
  },

  "a film has its size, its duration and its frames": async (page) => {
    await openMorph(page, "webm");
    await page.locator("[data-select=morph-rate]").selectOption("12");
    await pick(page, "export-repeat", "swing");
    await fill(page, { "morph-width": 321, "morph-height": 240, "export-seconds": 0.5 });
    const bytes = await downloaded(page, "amoeba.webm");
    const result = await page.evaluate(async (base64) => {
      const blob = await (await fetch(`data:video/webm;base64,${base64}`)).blob();
      const video = document.createElement("video");
      video.muted = true;
      video.src = URL.createObjectURL(blob);
      await new Promise((done, failed) => {
        video.onloadeddata = done;
        video.onerror = () => failed(new Error(video.error?.message));
      });
      const canvas = new OffscreenCanvas(video.videoWidth, video.videoHeight);
      const context = /** @type {OffscreenCanvasRenderingContext2D} */ (canvas.getContext("2d", { willReadFrequently: true }));
      const frameAt = async (/** @type {number} */ time) => {
        const seeked = new Promise((done) => (video.onseeked = done));
        video.currentTime = time;
        await seeked;
      };
      const pixels = () => {
        context.clearRect(0, 0, canvas.width, canvas.height);
        context.drawImage(video, 0, 0);
        return context.getImageData(0, 0, canvas.width, canvas.height).data;
      };
      // A frame is shown some time after it was found.
      const shown = async (/** @type {(data: Uint8ClampedArray) => boolean} */ isThere) => {
        for (let tries = 0; tries < 200; tries += 1) {
          const data = pixels();
          if (isThere(data)) return data;
          await new Promise((done) => setTimeout(done, 50));
        }
        throw new Error("the frame is not shown");
      };
      await frameAt(0.01);
      const first = await shown((data) => data[3] === 255 && data[0] !== 0);
      const corner = [...first.subarray(0, 3)];
      await frameAt(0.51);
      let differ = 0;
      await shown((data) => {
        differ = 0;
        for (let i = 0; i < first.length; i += 4) if (Math.abs((first[i] ?? 0) - (data[i] ?? 0)) > 40) differ += 1;
        return differ > 0;
      });
      return { duration: video.duration, width: video.videoWidth, height: video.videoHeight, corner, differ };
    }, bytes.toString("base64"));
    assert.deepEqual([result.duration, result.width, result.height], [1, 320, 240]);
    assert.ok(result.corner.every((channel) => channel > 240), String(result.corner));
    assert.ok(result.differ > 200, String(result.differ));
  },

  "what is too much is refused with its limit, and work can be cancelled": async (page) => {
    await openMorph(page, "png");
    await fill(page, { "morph-width": 1920, "morph-height": 1080, "morph-frames": 600 });
    await page.locator("[data-morph=download]").click();
    await eventually(async () => assert.match(await message(page).innerText(), /1\s245\smillion pixels were asked for; expected at most 600\smillion pixels/));
    await fill(page, { "morph-width": 640, "morph-height": 480 });
    await page.locator("[data-morph=download]").click();
    await eventually(async () => assert.match(await message(page).innerText(), /Frame \d+ of 600/));
    await page.locator("[data-morph=cancel]").click();
    await eventually(async () => assert.equal(await message(page).innerText(), "Cancelled"));
    assert.ok(await page.locator("[data-morph=cancel]").isHidden());
    await page.locator("[data-select=morph-kind]").selectOption("webm");
    await page.locator("[data-select=morph-rate]").selectOption("60");
    await fill(page, { "export-seconds": 60 });
    await page.locator("[data-morph=download]").click();
    await eventually(async () => assert.match(await message(page).innerText(), /7200 frames were asked for; expected at most 1800/));
  },

  "without a complete matching the panel says why there is no morph": async (page) => {
    await page.locator("[data-action=gallery]").click();
    await page.locator("[data-preset=closed-pocket]").click();
    await eventually(async () => assert.equal((await documentOf(page)).title, "Pocket that closes"));
    await openMorph(page, "paths");
    await eventually(async () => assert.match(await message(page).innerText(), /there is no morph, because the matching is not complete/));
  },
}, { permissions: ["clipboard-read", "clipboard-write"] });

test("a browser without an encoder says so, and offers nothing that fails", async (t) => {
  const page = await openPage(t, { init: "delete globalThis.VideoEncoder" });
  await openMorph(page, "webm");
  await eventually(async () => assert.match(await page.locator(".morph-export [data-note]").innerText(), /cannot write WebM/));
  assert.equal(await page.locator("[data-morph=download]").getAttribute("aria-disabled"), "true");
});

test("the export of the morph is clean to axe, light and dark, large and small", async (t) => {
  for (const [colorScheme, width] of /** @type {const} */ ([["light", 1440], ["dark", 390]])) {
    const page = await openPage(t, { colorScheme, viewport: { width, height: 844 }, hasTouch: width < 600 });
    if (width < 600) {
      await page.locator("[data-action=menu]").click();
      await page.locator("[data-item=export]").click();
      await page.locator("[data-panel=export]").waitFor();
    }
    await openMorph(page, "paths");
    await page.locator("[data-code]").waitFor();
    assert.deepEqual(await audit(page), []);
    if (width > 600) continue;
    const heights = await page.locator("[data-morph]:visible").evaluateAll((all) => all.map((each) => each.getBoundingClientRect().height));
    assert.deepEqual(heights, [44, 44]);
  }
});

/** The size of the canvas. @param {Page} page */
const uiSize = (page) =>
  page.locator("#stage").evaluate((element) => ({ size: { width: element.clientWidth, height: element.clientHeight } }));

/**
 * The middles of all commands at a place between the paths.
 * @param {{from: string, to: string, commands: number}} paths
 * @param {number} s
 */
function middles({ from, to, commands }, s) {
  const [a, b] = [from, to].map((path) => (path.match(/-?\d+(\.\d+)?/g) ?? []).map(Number));
  return Array.from({ length: commands }, (_, k) =>
    [0, 1].map((axis) => {
      const [p, q, r, t] = [0, 2, 4, 6].map((i) => a[6 * k + i + axis] * (1 - s) + b[6 * k + i + axis] * s);
      return (p + 3 * q + 3 * r + t) / 8;
    }),
  );
}

/** How many pixels differ clearly. @param {PNG} a @param {PNG} b */
function differing(a, b) {
  let count = 0;
  for (let i = 0; i < a.data.length; i += 4) if ([0, 1, 2].some((k) => Math.abs(a.data[i + k] - b.data[i + k]) > 40)) count += 1;
  return count;
}
