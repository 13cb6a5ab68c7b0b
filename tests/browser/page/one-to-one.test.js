/** One-to-one lines and adaptive samples on the page. */
import assert from "node:assert/strict";
import { test } from "node:test";
import { audit } from "../support/axe.js";
import { openPage } from "./open.js";
import { documentOf, eventually, field, middle, pick, status } from "./workbench.js";

/** A C in a ring, sampled so that inserted lines fail in its mouth. */
const mouth = {
  directrix: 1,
  kind: "curves",
  title: "Mouth",
  sampling: { counts: [65, 16] },
  matching: { method: "greedy", oneToOne: true },
  curves: [
    {
      degree: 3,
      form: "periodic",
      points: [
        ...[[10.1, 11.3], [-2.9, 14.9], [-13.6, 6.7], [-13.6, -6.7], [-2.9, -14.9], [10.1, -11.3]],
        ...[[4.4, -4.9], [-1.3, -6.5], [-5.9, -2.9], [-5.9, 2.9], [-1.3, 6.5], [4.4, 4.9]],
      ],
    },
    {
      degree: 3,
      form: "periodic",
      points: [[54.1, 0], [38.2, 38.2], [0, 54.1], [-38.2, 38.2], [-54.1, 0], [-38.2, -38.2], [0, -54.1], [38.2, -38.2]],
    },
  ],
};

const plot = (/** @type {import("playwright-core").Page} */ page) => page.locator(".correspondence");

test("lines become one to one, the plot, the probe and the status line follow, and undo takes it back", async (t) => {
  const page = await openPage(t);
  await page.locator("[data-select=method]").selectOption("greedy");
  await page.locator("[data-box=one-to-one]").uncheck();
  await page.locator("[data-plot] summary").click();
  await eventually(async () => assert.match((await plot(page).getAttribute("aria-label")) ?? "", /\d+ lines/));
  await page.locator("[data-box=one-to-one]").check();
  assert.equal((await documentOf(page)).matching.oneToOne, true);
  const count = await eventually(async () => {
    const found = /for (\d+) one-to-one lines/.exec((await plot(page).getAttribute("aria-label")) ?? "");
    assert.ok(found);
    return Number(found[1]);
  });
  await eventually(async () => assert.match(await status(page), new RegExp(`Verified\\s*${count}\\s*lines`)));
  assert.equal(await page.locator("#probe-keys").getAttribute("aria-valuemax"), String(count));

  const box = await page.locator(".correspondence-frame").boundingBox();
  assert.ok(box);
  const read = async () => (await page.locator("#probe .probe-head strong").textContent()) ?? "";
  await page.mouse.move(box.x + box.width * 0.2, box.y + 20);
  const first = await eventually(async () => {
    assert.ok(await page.locator("#probe").isVisible());
    return read();
  });
  await page.mouse.move(box.x + box.width * 0.6, box.y + 20);
  await eventually(async () => assert.notEqual(await read(), first));
  await page.mouse.move(...(await middle(page.locator("[data-group-button=matching]"))));
  await eventually(async () => assert.ok(await page.locator("#probe").isHidden()));

  await page.locator("#probe-keys").focus();
  await page.keyboard.press("ArrowRight");
  await eventually(async () => assert.equal(await read(), "Line 1"));
  await page.keyboard.press("ArrowLeft");
  await eventually(async () => assert.equal(await read(), `Line ${count}`));
  await page.keyboard.press("Control+z");
  await eventually(async () => assert.ok(!(await page.locator("[data-box=one-to-one]").isChecked())));
  await eventually(async () => assert.doesNotMatch((await plot(page).getAttribute("aria-label")) ?? "", /one-to-one/));
});

test("gaps that keep their lines are problems with a place", async (t) => {
  const page = await openPage(t);
  const buffer = Buffer.from(JSON.stringify(mouth));
  await page.locator("input[data-file]").setInputFiles({ name: "mouth.json", mimeType: "application/json", buffer });
  await eventually(async () => assert.match(await status(page), /problem/));
  const button = page.locator("[data-certificate=gaps]");
  await eventually(async () => assert.ok(await button.isVisible()));
  assert.match(await page.locator("[data-reason]").innerText(), /one to one/);
  await button.click();
  await eventually(async () => assert.ok(await page.locator(".witness").first().isVisible()));
  await page.locator("[data-plot] summary").click();
  await eventually(async () => assert.match((await plot(page).getAttribute("aria-label")) ?? "", /gaps? keeps? lines/));
  assert.ok((await page.locator(".correspondence .kept").getAttribute("d"))?.includes("L"));
  assert.deepEqual(await audit(page), []);

  await page.locator("[data-box=one-to-one]").uncheck();
  await eventually(async () => assert.match(await status(page), /Verified/));
  assert.ok(await button.isHidden());
});

test("adaptive samples have fields of their own and say how many they are", async (t) => {
  const page = await openPage(t);
  await page.locator("[data-group-button=sampling]").click();
  await pick(page, "scheme", "adaptive");
  const { sampling } = await documentOf(page);
  assert.deepEqual([sampling.scheme, sampling.maxTurn, sampling.minCount], ["adaptive", 15, 12]);
  assert.ok(sampling.tolerance > 0 && String(sampling.tolerance).length <= 5, "two figures");
  await eventually(async () => assert.ok(await field(page, "count-0").isHidden()));
  const taken = async () => {
    const counts = ((await page.locator("[data-taken]").textContent()) ?? "").split(" : ").map(Number);
    assert.ok(counts.length === 2 && counts.every((count) => count >= 12), String(counts));
    return counts;
  };
  const before = await eventually(async () => {
    const counts = await taken();
    assert.notDeepEqual(counts, [44, 44], "those of the scheme before");
    return counts;
  });
  await field(page, "maxTurn").fill("40");
  await page.keyboard.press("Enter");
  await eventually(async () => assert.ok((await taken())[0] < before[0]));
  await field(page, "tolerance").fill("0");
  assert.match((await page.locator("#error-tolerance").textContent()) ?? "", /number from/);
  await page.keyboard.press("Escape");
  await field(page, "tolerance").fill("0.00001");
  await page.keyboard.press("Enter");
  await eventually(async () => assert.match(await page.locator("[data-reason]").innerText(), /1000 samples/));
  assert.deepEqual(await audit(page), []);
  await pick(page, "scheme", "arc-length");
  await eventually(async () => assert.ok(await field(page, "count-0").isVisible()));
});
