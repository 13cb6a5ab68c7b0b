import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { load } from "directrix";
import { audit } from "../support/axe.js";
import { SOFTWARE } from "../support/browser.js";
import { onOnePage } from "./one-page.js";
import { offered, share } from "./sharing.js";
import { documentOf, drag, eventually, field, middle, pick, spoken, status } from "./workbench.js";

/** @import { Page } from "playwright-core" */

const dx = await load();

/** Waits until the problem as it stands is solved, and its section has all its pixels. @param {Page} page */
const solved = (page) => page.locator(".lab-stage[data-lab=fine]").waitFor({ state: "attached" });

/** A file that the page has offered. @param {Page} page @param {string} button @returns {Promise<string>} */
async function downloaded(page, button) {
  const [file] = await Promise.all([page.waitForEvent("download"), page.locator(button).click()]);
  return readFile(await file.path(), "utf8");
}

/** Opens a group beside the picture. @param {Page} page @param {string} name */
async function openGroup(page, name) {
  const button = page.locator(`[data-group-button=${name}]`);
  if ((await button.getAttribute("aria-expanded")) !== "true") await button.click();
}

/** Two pyramids on one triangle as a text STL, or with one face missing. */
const pyramids = (isClosed = true) => {
  const [a, b, c, up, down] = ["1 0 0", "-0.5 0.8 0", "-0.5 -0.8 0", "0 0 1", "0 0 -1"];
  const faces = [[a, b, up], [b, c, up], [c, a, up], [b, a, down], [c, b, down], ...(isClosed ? [[a, c, down]] : [])];
  return `solid t\n${faces.map((face) => `facet normal 0 0 0\nouter loop\n${face.map((vertex) => `vertex ${vertex}`).join("\n")}\nendloop\nendfacet`).join("\n")}\nendsolid t\n`;
};

/** Gives the hidden input a file. @param {Page} page @param {string} name @param {string} text */
const giveStl = (page, name, text) => page.locator("[data-lab-stl]").setInputFiles({ name, mimeType: "model/stl", buffer: Buffer.from(text) });

onOnePage(
  "a boundary value problem",
  {
    async "is solved, certified, named for what it is, and accessible"(page) {
      await solved(page);
      assert.equal(await page.locator("[data-bench=laplace]").getAttribute("aria-current"), "page");
      // The errors and iterations that stand there are those of the same problem outside of the page.
      const boundary = dx.boundary(await documentOf(page));
      const { dimension, vertices, elements, groups, conditions, composition, solver } = boundary;
      const known = dx.solveLaplace({ dimension, vertices, elements, groups, conditions, composition, solver });
      await eventually(async () => assert.match(await status(page), new RegExp(`^Solved\\s+768\\s+triangles\\s+${known.iterations[0]}\\s+iterations[\\s\\S]*true residual\\s+\\d[\\s\\S]*error\\s+[12]\\.\\d\\d × 10⁻³`)));
      await eventually(async () => assert.match(await page.locator("[data-lab-kind]").innerText(), /^Section of a solution in space/));
      await eventually(async () => assert.match(await page.locator("[data-fact=cut]").innerText(), /≈ (1\.00|0\.99\d)/));
      assert.deepEqual(await audit(page), []);
    },

    async "is read inside with its error, by keyboard"(page) {
      await page.locator("[data-lab-keys]").focus();
      await page.keyboard.press("6");
      await eventually(async () => assert.match(await spoken(page), /Seen from the front/));
      await page.keyboard.press("Enter");
      // The middle of the cube has a quarter of the first material, by the symmetry of its series.
      await eventually(async () => assert.match(await spoken(page), /^x 0\.50, y 0\.50, z 0\.50, \S+ 25 %, \S+ 75 %, error /));
      await page.keyboard.press("Escape");
      await page.locator("[data-plane-handle]").focus();
      await page.keyboard.press("PageUp");
      await eventually(async () => assert.match((await page.locator("[data-plane-handle]").getAttribute("aria-valuetext")) ?? "", /^y = 0\.[46]0$/));
      assert.notEqual((await documentOf(page)).section.origin[1], 0.5);
      await solved(page);
    },

    async "takes groups by a tap and by numbers, and shows where conditions are missing"(page) {
      await pick(page, "lab-axis", "off");
      await page.locator("[data-lab-group='1']").click();
      await page.locator("[data-lab-pick]").click();
      await page.locator("[data-lab-hint]").waitFor();
      await page.locator("[data-lab-keys]").focus();
      await page.keyboard.press("8");
      await page.keyboard.press("Enter");
      // From above the middle of the picture is the top.
      await eventually(async () => assert.deepEqual((await documentOf(page)).groups[1].where, { direction: [0, 0, 1], angle: 10 }));
      // Now the top is in two groups with different conditions.
      await eventually(async () => assert.match(await status(page), /128 elements in two groups/));
      await page.locator("[data-problem=conflict]").click();
      await page.locator("[data-lab-witness]").waitFor();
      await eventually(async () => assert.ok(await page.locator("[data-lab-fault=conflict]").isVisible()));
      await field(page, "lab-direction-z").fill("-1");
      await field(page, "lab-direction-z").press("Enter");
      await solved(page);
      await pick(page, "lab-rest", "none");
      await eventually(async () => assert.match(await status(page), /512 elements have no condition/));
      await pick(page, "lab-condition", "insulated");
      await eventually(async () => assert.deepEqual((await documentOf(page)).groups[1].condition, { flux: [0, 0] }));
      await pick(page, "lab-rest", "insulated");
      // One value and no flow: it is that value everywhere.
      await solved(page);
      await eventually(async () => assert.match(await status(page), /^Solved/));
    },

    async "takes a closed STL, and refuses what is none beside its button"(page) {
      await openGroup(page, "model");
      await giveStl(page, "none.stl", "no solid at all");
      await eventually(async () => assert.match(await page.locator("[data-lab-import-error]").innerText(), /^none\.stl was not opened: \S/));
      await giveStl(page, "open.stl", pyramids(false));
      await page.locator("[data-lab-fault=open]").waitFor();
      await page.locator("[data-problem=open]").click();
      await page.locator("[data-lab-witness]").waitFor();
      await giveStl(page, "closed.stl", pyramids());
      await eventually(async () => assert.equal((await documentOf(page)).model.triangles.length, 6));
      await eventually(async () => assert.match(await status(page), /^Solved\s+6\s+triangles/));
      assert.ok(await page.locator("[data-lab-import-error]").isHidden());
      // It has a problem of its own, which is told, and one step brings back what was there before.
      const { title, groups, rest, materials } = await documentOf(page);
      assert.deepEqual([title, groups.map((/** @type {{name: string}} */ { name }) => name), rest], ["closed", ["lower end", "upper end"], { flux: [0, 0] }]);
      assert.match(await page.locator("[data-lab-told]").innerText(), new RegExp(`^closed\\.stl: 6 triangles\\..*${materials[0].name} at the lower end, ${materials[1].name} at the upper end`));
      await page.locator("[data-action=undo]").click();
      await eventually(async () => assert.equal((await documentOf(page)).title, "open"));
      await page.locator("[data-lab-told]").waitFor({ state: "hidden" });
    },

    async "has boxes that are moved by handles on their sides, by pointer and keys, each in one step"(page) {
      await solved(page);
      await page.locator("[data-lab-group='0']").click();
      await page.locator("[data-select=lab-by]").selectOption("box");
      const box = async () => (await documentOf(page)).groups[0].where.box;
      await eventually(async () => assert.deepEqual(await box(), [[0, 0, 0], [1, 1, 1]]));
      const side = page.locator("[data-box-handle='z min']");
      await side.waitFor();
      await drag(page, await middle(side), [0, -120]);
      await eventually(async () => assert.match(await spoken(page), /^z from 0\.\d\d, \d+ elements/));
      const [low, high] = await box();
      assert.ok(low[2] > 0.2 && low[2] < 0.9, `${low[2]}`);
      assert.deepEqual([low.slice(0, 2), high], [[0, 0], [1, 1, 1]]);
      await side.focus();
      await page.keyboard.press("PageUp");
      await eventually(async () => assert.ok(Math.abs((await box())[0][2] - low[2] - 0.1) < 2e-3));
      await eventually(async () => assert.match((await side.getAttribute("aria-valuetext")) ?? "", /^z from 0\.\d\d$/));
      await page.locator("[data-action=undo]").click();
      await page.locator("[data-action=undo]").click();
      await eventually(async () => assert.deepEqual(await box(), [[0, 0, 0], [1, 1, 1]]));
      assert.deepEqual(await audit(page, [".lab-stage"]), []);
      // With the group its handles go, and the keys stay with the picture.
      await side.focus();
      await page.keyboard.press("Escape");
      await side.waitFor({ state: "hidden" });
      assert.ok(await page.locator("[data-lab-keys]").evaluate((keys) => keys === document.activeElement));
    },

    async "takes more materials while its section is shown, and names the group that a fault is about"(page) {
      await solved(page);
      await openGroup(page, "lab-materials");
      // Until it is solved anew the section has the materials from before.
      await page.locator("[data-lab-material-add]").click();
      await eventually(async () => assert.match(await status(page), /^Solved\s+768\s+triangles\s+\d+ \+ \d+\s+iterations/));
      await page.locator("[data-lab-legend] .legend-triangle").waitFor();
      await page.locator("[data-lab-group='0']").click();
      await page.locator("[data-select=lab-by]").selectOption("positive");
      await field(page, "lab-positive").fill("q");
      await field(page, "lab-positive").press("Enter");
      await eventually(async () => assert.match(await page.locator("[data-lab-fault=expression]").innerText(), /^top: .*`q`/));
    },

    async "compares every solver on it, with residuals as a plot, a table and a file"(page) {
      await solved(page);
      await page.locator("[data-look=solution]").waitFor({ state: "attached" });
      await field(page, "lab-divisions").fill("4");
      await field(page, "lab-divisions").press("Enter");
      await eventually(async () => assert.match(await status(page), /^Solved\s+192\s+triangles/));
      await page.locator("[data-lab-keys]").focus();
      await page.keyboard.press("c");
      await page.locator("[data-solvers-condition]").waitFor();
      // However it is solved, the error is that of the elements.
      const errors = await Promise.all(["lu", "none", "jacobi", "ssor"].map((method) => page.locator(`[data-run=${method}] td`).last().innerText()));
      assert.match(errors[0], /^0\.0[12]\d+$/);
      assert.deepEqual(new Set(errors).size, 1);
      await eventually(async () => assert.match(await page.locator("[data-solvers-condition]").innerText(), /: \d/));
      const chart = page.locator("[data-lab-chart=residuals]");
      await chart.locator("canvas").waitFor();
      await chart.focus();
      await page.keyboard.press("End");
      await eventually(async () => assert.match(await spoken(page), /^iteration \d+ · .*Jacobi .* × 10/));
      const rows = (await downloaded(page, "[data-solvers=csv]")).trim().split("\n");
      assert.match(rows[0], /^iteration,lu,lu preconditioned,none,none preconditioned,jacobi,/);
      // As many iterations as the table states, and the start.
      const iterations = Number(await page.locator("[data-run=jacobi] td").nth(2).innerText());
      assert.ok(rows.length >= iterations + 2);
      assert.ok(Number(rows[iterations + 1].split(",")[5]) < 1e-6);
      assert.deepEqual(await audit(page, [".lab-stage"]), []);
    },

    async "is dark, a problem in the plane, and shared"(page) {
      await pick(page, "lab-look", "solution");
      await page.locator("[data-action=theme]").click();
      await page.locator("[data-select=lab-model]").selectOption("annulus");
      await eventually(async () => assert.match(await page.locator("[data-lab-kind]").innerText(), /^Problem in the plane/));
      await solved(page);
      await page.locator("[data-lab-plane-keys]").focus();
      // The first press shows the crosshair in the middle, which is the hole of the ring.
      await page.keyboard.press("ArrowUp");
      await eventually(async () => assert.match(await spoken(page), /^x \S?0\.0\d, y \S?0\.0\d$/));
      await page.keyboard.press("Shift+ArrowUp");
      for (let k = 0; k < 5; k += 1) await page.keyboard.press("ArrowUp");
      await eventually(async () => assert.match(await spoken(page), /^x \S+, y 0\.\d\d, .*%/));
      assert.deepEqual(await audit(page, [".lab-stage", ".lab-aside"]), []);
      await page.keyboard.press("Escape");
      await page.locator("[data-lab-group='1'][aria-pressed=false]").click();
      await page.locator("[data-lab-group='1'][aria-pressed=true]").waitFor();
      await page.locator("[data-select=lab-by]").selectOption("box");
      const side = page.locator("[data-flat-handle='y min']");
      await side.waitFor();
      await side.focus();
      await page.keyboard.press("PageUp");
      await eventually(async () => assert.match(await spoken(page), /^y from \S?0\.\d\d, \d+ elements/));
      await page.locator("[data-action=undo]").click();
      await page.locator("[data-action=undo]").click();
      await side.waitFor({ state: "hidden" });
      await share(page);
      await offered(page, /#v=1&s=/);
      await page.locator("[data-panel=share] [data-close]").click();
      await page.locator("[data-action=theme]").click();
    },
  },
  { hash: "#v=1&preset=laplace-cube", viewport: { width: 1000, height: 620 }, allow: SOFTWARE },
);
