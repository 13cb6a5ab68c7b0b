/** The small pictures of the gallery. */
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { test } from "node:test";
import { load } from "directrix";
import { PNG } from "pngjs";
import { paintThumbnail } from "../../scripts/lib/thumbnail.mjs";

const dx = await load();
/** @param {string} id */
const preset = async (id) => JSON.parse(await readFile(new URL(`../../www/presets/${id}.json`, import.meta.url), "utf8"));

/** Which columns and rows of a picture hold anything. @param {PNG} png */
function painted({ width, height, data }) {
  const alpha = (/** @type {number} */ x, /** @type {number} */ y) => data[4 * (y * width + x) + 3] > 0;
  const columns = [...Array(width).keys()].filter((x) => [...Array(height).keys()].some((y) => alpha(x, y)));
  const rows = [...Array(height).keys()].filter((y) => [...Array(width).keys()].some((x) => alpha(x, y)));
  return { left: columns[0], right: width - 1 - columns[columns.length - 1], top: rows[0], bottom: height - 1 - rows[rows.length - 1] };
}

for (const id of ["amoeba", "blade", "small-in-large", "closed-pocket"]) {
  test(`the thumbnail of ${id} fills its frame and stands in the middle`, async () => {
    const png = PNG.sync.read(paintThumbnail(dx, await preset(id), "light"));
    assert.deepEqual([png.width, png.height], [336, 240]);
    const { left, right, top, bottom } = painted(png);
    assert.ok(Math.abs(left - right) <= 2 && Math.abs(top - bottom) <= 2, `${[left, right, top, bottom]}`);
    const least = Math.min(left, top);
    assert.ok(least >= 8 && least <= 12, `a margin of ${least} device pixels`);
  });
}

test("the themes differ in the lines and share the materials", async () => {
  const document = await preset("amoeba");
  const [light, dark] = [paintThumbnail(dx, document, "light"), paintThumbnail(dx, document, "dark")].map((png) => PNG.sync.read(png).data);
  const differing = light.filter((level, index) => Math.abs(level - dark[index]) > 8).length / light.length;
  assert.ok(differing > 0.005 && differing < 0.1, `${differing}`);
});

test("a preset that is not matched is painted without a band", async () => {
  const share = async (/** @type {string} */ id) => {
    const { data } = PNG.sync.read(paintThumbnail(dx, await preset(id), "light"));
    return data.filter((level, index) => index % 4 === 3 && level > 250).length / (data.length / 4);
  };
  assert.ok((await share("open-c")) > 0.3);
  assert.ok((await share("closed-pocket")) < 0.1);
});
