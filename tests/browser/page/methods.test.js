/** Methods of matching on the page: the choice, rules, what falls short of the optimum, and repair. */
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { audit } from "../support/axe.js";
import { openAsFile, ring, rings } from "./documents.js";
import { onOnePage } from "./one-page.js";
import { documentOf, drag, eventually, field, handle, middle, pick, status } from "./workbench.js";

/** @typedef {import("playwright-core").Page} Page */

const method = (/** @type {Page} */ page) => page.locator("[data-select=method]");
const gap = (/** @type {Page} */ page) => page.locator("[data-gap]");
const matchingOf = async (/** @type {Page} */ page) => (await documentOf(page)).matching;

onOnePage("methods of matching", {
  "every method reaches the document, and the status line says how far it stays below the optimum": async (page) => {
    await eventually(async () => assert.match(await gap(page).innerText(), /gap to optimum\s*0$/));
    const first = await matchingOf(page);
    assert.deepEqual([first.method, first.objective, first.oneToOne], ["exact", "integral", true]);

    await method(page).selectOption("greedy");
    assert.equal((await matchingOf(page)).method, "greedy");
    await eventually(async () => assert.match(await gap(page).innerText(), /^heuristic, gap \d+(\.\d)?\s%$|^heuristic, gap 0$/));
    assert.ok(await gap(page).evaluate((element) => element.classList.contains("warning")));
    await page.locator("[data-box=one-to-one]").uncheck();
    await eventually(async () => assert.match(await gap(page).innerText(), /^heuristic, gap 0\.5\s%$/));

    await method(page).selectOption("parameter");
    await eventually(async () => assert.match(await status(page), /problem|baseline/));
    await method(page).selectOption("shift");
    await page.locator("[data-segment=shift]").waitFor();
    await pick(page, "shift", "number");
    await field(page, "shift").fill("5");
    await page.keyboard.press("Enter");
    assert.equal((await matchingOf(page)).shift, 5);
    await pick(page, "shift", "best");
    await eventually(async () => assert.match(await gap(page).innerText(), /^baseline, gap \d+(\.\d)?\s%$/));
    await method(page).selectOption("one-per-vertex");
    await method(page).selectOption("sum-less-price");
    await field(page, "line-price").fill("0.001");
    await page.keyboard.press("Enter");
    const priced = await matchingOf(page);
    assert.deepEqual([priced.method, priced.objective, priced.linePrice], ["exact", "sum-less-price", 0.001]);
    await method(page).selectOption("sum");
    await eventually(async () => assert.match(await status(page), /Verified/));
    assert.deepEqual(await audit(page), []);
    await page.locator("#status").click();
    await page.keyboard.press("Control+z");
    await eventually(async () => assert.equal(await method(page).inputValue(), "sum-less-price"));
  },

  "the number of one-to-one lines is the number of samples until it is named": async (page) => {
    await eventually(async () => assert.equal(await field(page, "lines").inputValue(), "44"));
    await field(page, "lines").fill("60");
    await page.keyboard.press("Enter");
    assert.equal((await matchingOf(page)).lines, 60);
    await eventually(async () => assert.match(await status(page), /Verified\s*60\s*lines/));
    await field(page, "lines").fill("44");
    await page.keyboard.press("Enter");
    assert.equal("lines" in (await matchingOf(page)), false);
    await field(page, "lines").fill("2");
    assert.match((await page.locator("#error-lines").textContent()) ?? "", /whole number from 3/);
  },

  "rules are repaired or as printed, all at once or singly": async (page) => {
    await method(page).selectOption("greedy");
    await pick(page, "rules", "printed");
    assert.deepEqual((await matchingOf(page)).printed, ["normals", "negative", "heights", "stages", "order", "removal"]);
    assert.ok(await page.locator("[data-box=printed-order]").isVisible(), "the list opens");
    await eventually(async () => assert.match(await status(page), /mean\s*f\s*\u2212/));
    await page.locator("[data-box=printed-stop]").check();
    await eventually(async () => assert.match(await status(page), /\b1\s*line\b/));
    for (const rule of ["stop", "normals", "negative", "heights", "stages", "order", "removal"]) {
      await page.locator(`[data-box=printed-${rule}]`).uncheck();
    }
    await eventually(async () => assert.ok(await page.locator("[data-segment=rules] input[value=repaired]").isChecked()));
    await method(page).selectOption("integral");
    await eventually(async () => assert.ok(await page.locator("[data-box=printed-order]").isHidden(), "a rule of the growth"));
  },

  "a drag is solved coarsely and refined when it rests": async (page) => {
    await eventually(async () => assert.match(await gap(page).innerText(), /gap to optimum/));
    await drag(page, await middle(handle(page, "B9")), [-30, 20], { release: false });
    await eventually(async () => assert.match(await status(page), /refining|gap to optimum/));
    await page.mouse.up();
    await eventually(async () => assert.match(await gap(page).innerText(), /gap to optimum\s*0$/));
    await eventually(async () => assert.match(await status(page), /Verified\s*44/));
  },

  "what cannot be covered is named and repaired on demand, in one edit": async (page) => {
    await openAsFile(page, JSON.parse(await readFile(new URL("../../../www/presets/closed-pocket.json", import.meta.url), "utf8")));
    await eventually(async () => assert.match(await status(page), /Not covered: \d+ \+ 0 vertices\. Some see nothing/));
    await page.locator("[data-command=repair]").click();
    assert.equal((await matchingOf(page)).policy, "repair");
    await eventually(async () => assert.match(await status(page), /Repaired: \d+ lines pass through a curve/));
    const button = page.locator("[data-certificate=occluded]");
    await button.click();
    await eventually(async () => assert.ok(await page.locator(".witness").first().isVisible()));
    assert.equal(await page.locator("[data-command=repair]").count(), 0);
    assert.deepEqual(await audit(page), []);
    await page.keyboard.press("Control+z");
    await eventually(async () => assert.match(await status(page), /Not covered/));
  },

  "greedy lines that are stuck although a cover exists say which method has one": async (page) => {
    const half = [[20.9, 21.52], [7.43, 29.06], [-8, 28.91], [-21.32, 21.11], [-28.99, 7.72]];
    const inside = [[8.36, -8.61], [1.22, -11.94], [-6.45, -10.12], [-11.33, -3.94]];
    const mirrored = (/** @type {number[][]} */ points) => points.map(([x, y]) => [x, -y]).reverse();
    const c = { degree: 3, form: "periodic", points: [...half, ...mirrored(half), ...inside, ...mirrored(inside)] };
    await openAsFile(page, rings({ method: "greedy" }, { curves: [c, ring(50)], sampling: { counts: [52, 20] } }));
    await eventually(async () => assert.match(await status(page), /Not covered: 1 \+ 0 vertices.*exact method reaches every vertex/s));
    await method(page).selectOption("integral");
    await eventually(async () => assert.match(await status(page), /Verified/));
  },

  "lines between crossing projections keep to the band, and lines that do not are not blended": async (page) => {
    await openAsFile(page, rings({ method: "exact", oneToOne: true }, { title: "Crossing rings", curves: [ring(20), ring(20, 8, 20)] }));
    await eventually(async () => assert.match(await status(page), /Verified\s*44/));
    await method(page).selectOption("shift");
    await eventually(async () => assert.match(await status(page), /problems[\s\S]*Some lines meet a curve or cross another/));
  },

  "a new document is matched by the optimum, one to one": async (page) => {
    await page.locator("[data-action=file]").click();
    await page.locator("[data-item=new]").click();
    await eventually(async () => {
      const { matching, curves } = await documentOf(page);
      assert.deepEqual([curves.length, matching.method, matching.oneToOne], [0, "exact", true]);
    });
  },
});

