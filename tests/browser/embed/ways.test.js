/** Where a figure runs, and what it does where it cannot: origins, policies of security, servers that do not allow it. */
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { launch } from "../support/browser.js";
import { colors, eventually, stage, standing, stateOf, visit } from "./host.js";

const FIGURE = `<directrix-figure preset="amoeba">The amoeba, <a href="#x">in words</a>.</directrix-figure>`;

/** More colours than a message has. */
const FEWEST = 50;

/** @type {import("playwright-core").Browser} */
let browser;
/** @type {import("./host.js").Stage} */
let host;

before(async () => {
  [browser, host] = await Promise.all([launch(), stage()]);
});
after(() => Promise.all([browser.close(), host.close()]));

/**
 * The policy that docs/embedding.md names for a way of running.
 *
 * @param {string} app
 * @param {string} more
 */
const policy = (app, more) => ({
  "content-security-policy": `default-src 'none'; img-src data: blob:; script-src ${app} 'wasm-unsafe-eval'; connect-src ${app}; ${more}`,
});

test("on a page of another origin it runs in a worker made there", async () => {
  await visit(browser, host.page(FIGURE), {}, async (page) => {
    await standing(page);
    const { runsIn, result } = await stateOf(page);
    assert.equal(runsIn, "blob worker");
    assert.deepEqual(
      [result.lines, result.crossings, result.blocked, result.uncovered, result.ok, result.verified, result.text],
      [44, 0, 0, 0, true, true, "44 lines, none crossing, η 0.97"],
    );
    assert.ok((await colors(page)) > FEWEST);
    assert.equal(await page.getByText("in words").isVisible(), false, "the fallback is gone");
  });
});

test("on a page of its own origin it runs in a worker of its own", async () => {
  await visit(browser, `${host.app}embed.html#v=1&preset=amoeba`, {}, async (page) => {
    await standing(page);
    assert.equal((await stateOf(page)).runsIn, "worker");
  });
});

test("a stack fetches the whole module, and is shown as any figure", async () => {
  await visit(browser, `${host.app}embed.html#v=1&preset=layered-implant`, {}, async (page) => {
    await standing(page);
    const { runsIn, result } = await stateOf(page);
    assert.deepEqual([runsIn, result.ok, result.verified, result.lines], ["worker", true, true, 120]);
    assert.ok(result.eta > 0.97 && result.eta < 0.99, "that of the worst span");
    // On the same page a harmonic blend, which has lines along its gradient, and stages from the inner curves to the outer one.
    await page.evaluate(() => (location.hash = "#v=1&preset=three-cores&controls=full"));
    await eventually(async () => {
      const { document, result, s } = await stateOf(page);
      assert.deepEqual([document.title, result.ok, result.verified, result.lines, result.crossings, s], ["Three cores", true, true, 60, 0, 0.4]);
      assert.match(result.text, /^60 lines, none crossing/);
    });
    const slider = page.getByRole("slider", { name: "Place between the curves" });
    await eventually(async () => assert.equal(await slider.inputValue(), "0.4"));
    await slider.press("ArrowRight");
    await eventually(async () => assert.equal((await stateOf(page)).s, 0.41));
    const handle = page.locator("[data-handle]").first();
    await handle.focus();
    const before = (await stateOf(page)).document.curves;
    await page.keyboard.press("ArrowUp");
    await eventually(async () => {
      const { document, result } = await stateOf(page);
      assert.notDeepEqual(document.curves, before);
      assert.deepEqual([result.verified, result.lines], [true, 60]);
    });
  });
});

test("so do curves in space, which it shows as they are matched", async () => {
  await visit(browser, `${host.app}embed.html#v=1&preset=pipe-branch`, {}, async (page) => {
    await standing(page);
    const { runsIn, result } = await stateOf(page);
    assert.deepEqual([runsIn, result.ok, result.verified, result.lines], ["worker", true, true, 48]);
  });
});

test("under a strict policy with blob workers it runs in one", async () => {
  const headers = policy(host.app, `worker-src blob: ${host.app}`);
  await visit(browser, host.page(FIGURE, { headers }), {}, async (page) => {
    await standing(page);
    assert.equal((await stateOf(page)).runsIn, "blob worker");
  });
});

test("under a policy without workers it runs on the main thread, in short turns", async () => {
  const headers = policy(host.app, "worker-src 'none'");
  await visit(browser, host.page(`${FIGURE}<directrix-figure preset="hyperpatch-pair"></directrix-figure>`, { headers }), { allow: /Content Security Policy|Content-Security-Policy/ }, async (page) => {
    await standing(page);
    const { runsIn, result } = await stateOf(page);
    assert.equal(runsIn, "main thread");
    assert.equal(result.text, "44 lines, none crossing, η 0.97");
    assert.ok((await colors(page)) > FEWEST);
    const body = await standing(page, 1);
    assert.equal((await stateOf(page, 1)).runsIn, "main thread");
    await body.getByRole("slider", { name: "Section" }).fill("0.5");
    await eventually(async () => assert.equal((await stateOf(page, 1)).result.brief, "2 cells, verified"));
    assert.ok((await colors(page, 1)) > FEWEST);
  });
});

test("under a policy that forbids the module it says so, and the fallback stays", async () => {
  const headers = { "content-security-policy": `default-src 'none'; script-src ${host.app}; connect-src ${host.app}; worker-src 'none'` };
  await visit(browser, host.page(FIGURE, { headers }), { allow: /Content Security Policy|wasm|WebAssembly/ }, async (page) => {
    const problem = page.locator("directrix-figure .problem");
    await problem.waitFor();
    assert.match((await problem.textContent()) ?? "", /cannot be computed here/);
    assert.ok(await page.getByText("in words").isVisible());
  });
});

test("the application itself works under a strict policy, in an iframe without any right but scripts", async () => {
  const frame = `<iframe id="f" title="A figure" sandbox="allow-scripts" width="600" height="400" src="${host.app}embed.html#v=1&amp;preset=amoeba"></iframe>`;
  await visit(browser, host.page(frame, { head: "" }), { allow: /sandbox|Blocked script execution/i }, async (page) => {
    const figure = page.frameLocator("#f").locator("directrix-figure");
    await figure.locator(".frame[data-state=shown]").waitFor({ state: "attached" });
    const runsIn = await figure.evaluate((/** @type {any} */ element) => element.runsIn);
    assert.ok(["blob worker", "main thread"].includes(runsIn), runsIn);
    assert.equal(await figure.evaluate(() => window.origin), "null");
  });
});

test("without the leave of its server nothing runs, and the fallback is what is seen", async () => {
  const head = `<script type="module" src="${host.closed}element.js"></script>`;
  await visit(browser, host.page(FIGURE, { head }), { allow: /CORS|ERR_FAILED/ }, async (page) => {
    await page.waitForLoadState("load");
    assert.ok(await page.getByText("in words").isVisible());
    assert.equal(await page.evaluate(() => customElements.get("directrix-figure") === undefined), true);
  });
});

test("without scripts the fallback is what is seen", async () => {
  await visit(browser, host.page(FIGURE), { javaScriptEnabled: false }, async (page) => {
    assert.ok(await page.getByText("in words").isVisible());
  });
});

test("a browser without WebAssembly is told, and keeps the fallback", async () => {
  const head = `<script>delete globalThis.WebAssembly</script><script type="module" src="${host.app}element.js"></script>`;
  await visit(browser, host.page(FIGURE, { head }), {}, async (page) => {
    await page.locator("directrix-figure .problem").waitFor();
    assert.match((await page.locator("directrix-figure .problem").textContent()) ?? "", /needs WebAssembly/);
    assert.ok(await page.getByText("in words").isVisible());
  });
});

test("twenty figures share one worker and one module, and none is fetched before it is near", async () => {
  const presets = ["amoeba", "kidney", "petals", "gear", "blade", "letters", "snail", "void-core", "u-in-oval", "bone-section"];
  const figures = Array.from({ length: 20 }, (_, k) => `<p>Figure ${k}</p><directrix-figure preset="${presets[k % 10]}"></directrix-figure>`).join("");
  await visit(browser, "about:blank", {}, async (page) => {
    /** @type {string[]} */
    const fetched = [];
    page.on("request", (request) => fetched.push(new URL(request.url()).pathname));
    let workers = 0;
    page.on("worker", () => (workers += 1));
    await page.goto(host.page(figures));
    await standing(page, 0);
    await page.waitForTimeout(300);
    const far = await page.locator("directrix-figure .frame[data-state=waiting]").count();
    assert.ok(far >= 12, `${far} figures wait`);
    assert.ok(!fetched.includes("/presets/bone-section.json"), "the last preset is not asked for");

    await page.evaluate(async () => {
      const found = /** @type {number[]} */ ([]);
      const observer = new PerformanceObserver((list) => found.push(...list.getEntries().map((entry) => entry.duration)));
      observer.observe({ type: "longtask" });
      Object.assign(window, { found });
      for (const figure of document.querySelectorAll("directrix-figure")) {
        figure.scrollIntoView({ block: "center" });
        await new Promise((done) => setTimeout(done, 60));
      }
    });
    for (let k = 0; k < 20; k++) await standing(page, k);
    const places = await page.evaluate(() => [...document.querySelectorAll("directrix-figure")].map((figure) => /** @type {any} */ (figure).document.title));
    assert.equal(new Set(places).size, 10, "each shows its own document");
    assert.equal(places[3], places[13]);
    assert.equal(workers, 1);
    assert.equal(fetched.filter((path) => path.endsWith(".wasm")).length, 1);
    assert.deepEqual(fetched.filter((path) => path.includes("full")), []);
    // Nothing of a figure holds the page up, as all of its work is in the worker. On a quiet machine no task takes 50 ms; on one that is busy
    // the clock runs on while others have the processor.
    const tasks = await page.evaluate(() => /** @type {number[]} */ (/** @type {any} */ (window).found).sort((a, b) => a - b));
    const [middle = 0, longest = 0] = [tasks[tasks.length >> 1], tasks.at(-1)];
    assert.ok(middle < 250 && longest < 2000, `tasks took ${tasks} ms`);
  });
});

test("two figures that are changed at once both come to an end", async () => {
  const figures = `<directrix-figure preset="amoeba" style="height: 200px"></directrix-figure><directrix-figure preset="kidney" style="height: 200px"></directrix-figure>`;
  await visit(browser, host.page(figures), {}, async (page) => {
    await Promise.all([standing(page, 0), standing(page, 1)]);
    const changes = await page.evaluate(async () => {
      const [a, b] = /** @type {any[]} */ ([...document.querySelectorAll("directrix-figure")]);
      /** @type {string[]} */
      const loads = [];
      a.addEventListener("load", () => loads.push(`a ${a.document.title}`));
      b.addEventListener("load", () => loads.push(`b ${b.document.title}`));
      for (let k = 1; k <= 6; k++) {
        a.document = { ...a.document, title: `a${k}` };
        b.document = { ...b.document, title: `b${k}` };
      }
      while (!loads.includes("a a6") || !loads.includes("b b6")) await new Promise((done) => setTimeout(done, 20));
      return loads;
    });
    assert.ok(changes.length < 12, `only the newest is solved: ${changes}`);
  });
});

test("a figure that is taken out and put back goes on", async () => {
  await visit(browser, host.page(FIGURE), {}, async (page) => {
    const figure = await standing(page);
    await figure.evaluate((element) => {
      const { parentNode } = element;
      element.remove();
      parentNode?.prepend(element);
    });
    await figure.evaluate((/** @type {any} */ element) => (element.document = { ...element.document, title: "Again" }));
    await eventually(async () => assert.equal((await stateOf(page)).document.title, "Again"));
  });
});

