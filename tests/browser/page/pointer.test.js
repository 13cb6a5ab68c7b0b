import assert from "node:assert/strict";
import { idle } from "./idle.js";
import { onOnePage } from "./one-page.js";
import {
  coordinates,
  documentOf,
  drag,
  eventually,
  handle,
  middle,
  onOutline,
  scaleOf,
  status,
  uiOf,
} from "./workbench.js";

onOnePage("the pointer", {
  "the pointer on the band reads the nearest ruling line": async (page) => {
    const [ax, ay] = await onOutline(page, 0);
    const stage = await page.locator("#stage").boundingBox();
    assert.ok(stage);
    const card = page.locator("#probe");
    assert.ok(await card.isHidden());
    // From the inner curve outwards until the band is met.
    await eventually(async () => {
      for (const angle of [0, 1, 2, 3, 4, 5, 6, 7].map((k) => (k * Math.PI) / 4)) {
        await page.mouse.move(ax + 22 * Math.cos(angle), ay + 22 * Math.sin(angle));
        await idle(page);
        if (await card.isVisible()) return;
      }
      assert.fail("no reading");
    });
    const text = await card.innerText();
    assert.match(text, /^Line \d+/);
    assert.match(text, /length/);
    const shares = [...text.matchAll(/(\d+)\s%/g)].map((found) => Number(found[1]));
    assert.ok(Math.abs(shares.reduce((sum, share) => sum + share, 0) - 100) <= 1, `fractions ${shares}`);
    await page.mouse.move(stage.x + stage.width - 10, stage.y + 10);
    await eventually(async () => assert.ok(await card.isHidden()));
  },
  "a dragged point follows the pointer, and the certificates follow the point": async (page) => {
    const before = await status(page);
    const [x, y] = await coordinates(page, "B3");
    const scale = await scaleOf(page);
    await drag(page, await middle(handle(page, "B3")), [-40, 30]);
    await eventually(async () => {
      const [nowX, nowY] = await coordinates(page, "B3");
      assert.ok(Math.abs(nowX - (x - 40 / scale)) < 0.1, `x ${nowX}`);
      assert.ok(Math.abs(nowY - (y - 30 / scale)) < 0.1, `y ${nowY}`);
    });
    await eventually(async () => assert.notEqual(await status(page), before));
    assert.equal(await page.locator("[data-state]").textContent(), "Edited");
  },
  "escape during a drag takes the point back and leaves nothing to undo": async (page) => {
    const before = JSON.stringify(await documentOf(page));
    await drag(page, await middle(handle(page, "A2")), [25, 25], { release: false });
    await eventually(async () => assert.notEqual(JSON.stringify(await documentOf(page)), before));
    await page.keyboard.press("Escape");
    await page.mouse.up();
    assert.equal(JSON.stringify(await documentOf(page)), before);
    assert.ok(await page.locator("[data-action=undo]").isDisabled());
  },
  "a dragged outline moves every point of its curve and no other": async (page) => {
    const before = await documentOf(page);
    await drag(page, await onOutline(page, 0), [14, -7]);
    await eventually(async () => {
      const after = await documentOf(page);
      const [dx, dy] = [0, 1].map((axis) => after.curves[0].points[0][axis] - before.curves[0].points[0][axis]);
      assert.ok((dx ?? 0) > 0 && (dy ?? 0) > 0, `moved by ${dx}, ${dy}`);
      for (const [i, [x, y]] of after.curves[0].points.entries()) {
        assert.ok(Math.abs(x - before.curves[0].points[i][0] - (dx ?? 0)) < 1e-9);
        assert.ok(Math.abs(y - before.curves[0].points[i][1] - (dy ?? 0)) < 1e-9);
      }
      assert.deepEqual(after.curves[1], before.curves[1]);
    });
  },
  "a double click on an outline adds a control point there": async (page) => {
    const before = (await documentOf(page)).curves[1].points.length;
    const [x, y] = await onOutline(page, 1);
    await page.mouse.dblclick(x, y);
    await eventually(async () => assert.equal((await documentOf(page)).curves[1].points.length, before + 1));
    await page.keyboard.press("Control+z");
    await eventually(async () => assert.equal((await documentOf(page)).curves[1].points.length, before));
  },
  "the buttons zoom, and the reading beside them says how far": async (page) => {
    const reading = page.locator("#zoom .zoom-value");
    assert.match((await reading.textContent()) ?? "", /^100\s%$/);
    await page.locator("[data-zoom=plus]").click();
    await eventually(async () => assert.match((await reading.textContent()) ?? "", /^125\s%$/));
    await page.locator("[data-zoom=fit]").click();
    await eventually(async () => assert.match((await reading.textContent()) ?? "", /^100\s%$/));
  },
  "a drag on empty canvas pans, and F shows everything again": async (page) => {
    const before = await middle(handle(page, "B3"));
    const stage = await page.locator("#stage").boundingBox();
    assert.ok(stage);
    await drag(page, [stage.x + stage.width - 12, stage.y + 12], [-90, 60]);
    await eventually(async () => {
      const [x, y] = await middle(handle(page, "B3"));
      assert.ok(Math.abs(x - before[0] + 90) < 1 && Math.abs(y - before[1] - 60) < 1, `${x}, ${y}`);
    });
    assert.equal((await uiOf(page)).fitted, false);
    await page.keyboard.press("f");
    await eventually(async () => {
      const [x, y] = await middle(handle(page, "B3"));
      assert.ok(Math.hypot(x - before[0], y - before[1]) < 1);
    });
  },
  "the wheel zooms about the pointer": async (page) => {
    const fixed = await middle(handle(page, "B3"));
    const far = await middle(handle(page, "B10"));
    await page.mouse.move(fixed[0], fixed[1]);
    await page.mouse.wheel(0, -300);
    await eventually(async () => {
      const now = await middle(handle(page, "B10"));
      assert.ok(
        Math.hypot(now[0] - fixed[0], now[1] - fixed[1]) > 1.3 * Math.hypot(far[0] - fixed[0], far[1] - fixed[1]),
      );
    });
    const [x, y] = await middle(handle(page, "B3"));
    assert.ok(Math.hypot(x - fixed[0], y - fixed[1]) < 0.6, "the place under the pointer moved");
  },
});
