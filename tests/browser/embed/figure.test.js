/** What a person and a page can do with a figure. */
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { audit } from "../support/axe.js";
import { launch } from "../support/browser.js";
import { colorAt, colors, eventually, linked, preset, stage, standing, stateOf, visit } from "./host.js";

/** @type {import("playwright-core").Browser} */
let browser;
/** @type {import("./host.js").Stage} */
let host;

before(async () => {
  [browser, host] = await Promise.all([launch(), stage()]);
});
after(() => Promise.all([browser.close(), host.close()]));

/**
 * Collects the events of the first figure in `window.events`.
 *
 * @param {import("playwright-core").Page} page
 */
const listen = (page) =>
  page.evaluate(() => {
    const events = /** @type {any[]} */ ([]);
    Object.assign(window, { events });
    for (const type of ["load", "error", "change", "progress"]) {
      document.querySelector("directrix-figure")?.addEventListener(type, (event) => events.push({ type, ...structuredClone(/** @type {CustomEvent} */ (event).detail) }));
    }
  });

/** @param {import("playwright-core").Page} page @returns {Promise<any[]>} */
const eventsOf = (page) => page.evaluate(() => /** @type {any} */ (window).events);

test("a figure keeps its place: nothing moves when it loads, and a size of the page wins", async () => {
  const figures = `<directrix-figure preset="amoeba">Fallback</directrix-figure><p id="after">After</p>
    <directrix-figure preset="kidney" style="width: 300px; height: 260px"></directrix-figure>
    <directrix-figure preset="petals" controls="none" style="width: 400px; aspect-ratio: 2"></directrix-figure>`;
  const head = `<style>directrix-figure { display: block; aspect-ratio: 16 / 10 }</style><script type="module" src="${host.app}element.js"></script>`;
  await visit(browser, host.page(figures, { head }), { viewport: { width: 800, height: 1200 } }, async (page) => {
    for (const k of [0, 1, 2]) await standing(page, k);
    const sizes = await page.evaluate(() => [...document.querySelectorAll("directrix-figure")].map((each) => [each.clientWidth, each.clientHeight]));
    const shift = await page.evaluate(
      () =>
        new Promise((done) => {
          new PerformanceObserver((list) => done(list.getEntries().reduce((sum, entry) => sum + /** @type {any} */ (entry).value, 0))).observe({
            type: "layout-shift",
            buffered: true,
          });
          setTimeout(() => done(0), 300);
        }),
    );
    assert.equal(shift, 0);
    assert.deepEqual(sizes.slice(1), [
      [300, 260],
      [400, 200],
    ]);
    const [width, height] = sizes[0];
    assert.ok(Math.abs(width / height - 1.6) < 0.02, `${width} x ${height}`);
  });
});

test("the styles of a page do not reach into a figure", async () => {
  const hostile = `* { all: unset !important; color: red !important; font: 40px cursive !important; letter-spacing: 9px !important; }
    button, a, canvas, input { display: none !important; } p { transform: rotate(45deg) !important; }`;
  const head = `<style>${hostile}</style><script type="module" src="${host.app}element.js"></script>`;
  await visit(browser, host.page(`<directrix-figure preset="amoeba" controls="full"></directrix-figure>`, { head }), {}, async (page) => {
    const figure = await standing(page);
    const box = await figure.locator("canvas").boundingBox();
    assert.ok((box?.width ?? 0) > 400 && (box?.height ?? 0) > 200, JSON.stringify(box));
    const looks = await figure.locator(".play, .open, .handle").evaluateAll((elements) =>
      elements.map((element) => {
        const { color, fontSize, letterSpacing, display } = getComputedStyle(element);
        return [color, fontSize, letterSpacing, display].join(" ");
      }),
    );
    for (const look of looks) assert.ok(!look.includes("rgb(255, 0, 0)") && !look.includes("9px") && !look.includes("40px") && !look.includes("none"), look);
  });
});

test("nothing of the page is touched: storage, history, address, scroll, globals", async () => {
  await visit(browser, host.page(`<p style="height: 100px">Above</p><directrix-figure preset="amoeba" controls="full" style="height: 300px"></directrix-figure><p style="height: 2000px">Below</p>`), {}, async (page) => {
    await page.evaluate(() => Object.assign(window, { before: Object.keys(window).length, length0: history.length }));
    const figure = await standing(page);
    await figure.locator(".play").click();
    await figure.locator('[data-handle="1 2"]').focus();
    await page.keyboard.press("ArrowRight");
    const found = await page.evaluate(async () => ({
      storage: [localStorage.length, sessionStorage.length, (await indexedDB.databases()).length, (await caches.keys()).length, document.cookie],
      history: [history.length - /** @type {any} */ (window).length0, history.state, location.hash],
      scroll: scrollY,
      restoration: history.scrollRestoration,
    }));
    assert.deepEqual(found, { storage: [0, 0, 0, 0, ""], history: [0, null, ""], scroll: 0, restoration: "auto" });
  });
});

test("the wheel scrolls the page over a figure, and a finger does", async () => {
  const body = `<directrix-figure preset="amoeba" controls="full"></directrix-figure><p style="height: 3000px">Below</p>`;
  await visit(browser, host.page(body), { hasTouch: true, viewport: { width: 390, height: 700 } }, async (page) => {
    const figure = await standing(page);
    const box = await figure.locator("canvas").boundingBox();
    assert.ok(box);
    await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
    await page.mouse.wheel(0, 200);
    await eventually(async () => assert.ok((await page.evaluate(() => scrollY)) > 100));
    const actions = await page.evaluate(() => {
      const root = /** @type {ShadowRoot} */ (document.querySelector("directrix-figure")?.shadowRoot);
      const none = [...root.querySelectorAll("*")].filter((element) => getComputedStyle(element).touchAction === "none");
      return [...new Set(none.map((element) => element.classList[0]))];
    });
    assert.deepEqual(actions, ["handle"], "only handles keep a finger for themselves");
  });
});

test("a control point follows the pointer, and the figure is matched again on the way", async () => {
  await visit(browser, host.page(`<directrix-figure preset="amoeba" controls="full"></directrix-figure>`), {}, async (page) => {
    const figure = await standing(page);
    await listen(page);
    const before = await stateOf(page);
    const handle = figure.locator('[data-handle="1 1"]');
    const from = await handle.boundingBox();
    assert.ok(from);
    await page.mouse.move(from.x + 12, from.y + 12);
    await page.mouse.down();
    for (let k = 1; k <= 5; k++) await page.mouse.move(from.x + 12 + 4 * k, from.y + 12 + 2 * k);
    await eventually(async () => assert.ok((await eventsOf(page)).some(({ reason }) => reason === "document"), "matched while it is held"));
    await page.mouse.up();
    const to = await handle.boundingBox();
    assert.ok(to && Math.abs(to.x - from.x - 20) < 1 && Math.abs(to.y - from.y - 10) < 1, JSON.stringify([from, to]));
    const after = await stateOf(page);
    assert.notDeepEqual(after.document.curves[1].points[1], before.document.curves[1].points[1]);
    await eventually(async () => {
      const { result } = await stateOf(page);
      assert.ok(result.ok && result.integral !== before.result.integral);
    });
    assert.ok((await eventsOf(page)).every(({ type }) => type !== "error"));
  });
});

test("a control point obeys a finger", async () => {
  await visit(browser, host.page(`<directrix-figure preset="amoeba" controls="full"></directrix-figure>`), { hasTouch: true, viewport: { width: 390, height: 844 } }, async (page) => {
    const figure = await standing(page);
    const handle = figure.locator('[data-handle="1 1"]');
    const from = await handle.boundingBox();
    assert.ok(from && from.width >= 44, "a target for a finger");
    const [x, y] = [from.x + from.width / 2, from.y + from.height / 2];
    const client = await page.context().newCDPSession(page);
    await client.send("Input.dispatchTouchEvent", { type: "touchStart", touchPoints: [{ x, y }] });
    for (let k = 1; k <= 4; k++) await client.send("Input.dispatchTouchEvent", { type: "touchMove", touchPoints: [{ x: x + 5 * k, y: y + 3 * k }] });
    await client.send("Input.dispatchTouchEvent", { type: "touchEnd", touchPoints: [] });
    await eventually(async () => {
      const to = await handle.boundingBox();
      assert.ok(to && Math.abs(to.x - from.x - 20) < 1 && Math.abs(to.y - from.y - 12) < 1, JSON.stringify([from, to]));
    });
  });
});

test("keys move a control point, in three steps, and take it back", async () => {
  await visit(browser, host.page(`<directrix-figure preset="amoeba" controls="full" theme="light"></directrix-figure>`), {}, async (page) => {
    const figure = await standing(page);
    const point = async () => (await stateOf(page)).document.curves[0].points[1];
    const start = await point();
    const handle = figure.locator('[data-handle="0 1"]');
    await figure.locator('[data-handle="0 0"]').focus();
    await page.keyboard.press("PageDown");
    const spoken = figure.locator("[aria-live]");
    await page.keyboard.press("ArrowRight");
    assert.deepEqual(await point(), [start[0] + 1, start[1]]);
    await page.keyboard.press("Shift+ArrowUp");
    assert.deepEqual(await point(), [start[0] + 1, start[1] + 10]);
    await page.keyboard.press("Alt+ArrowDown");
    assert.deepEqual(await point(), [start[0] + 1, start[1] + 9.9]);
    assert.match((await spoken.textContent()) ?? "", /^A2, x 25\.00, y 29\.90$/);
    assert.match((await handle.getAttribute("aria-label")) ?? "", /^A2, x 25\.00/);
    await page.keyboard.press("Escape");
    assert.deepEqual(await point(), start);
    const stops = await figure.locator(".handle[tabindex='0']").count();
    assert.equal(stops, 2, "one stop for each curve");
    assert.deepEqual(await audit(page), []);
  });
});

test("an edit that cannot be is told, the last picture stays, and Escape leads back", async () => {
  await visit(browser, host.page(`<directrix-figure preset="amoeba" controls="full"></directrix-figure>`), {}, async (page) => {
    const figure = await standing(page);
    await listen(page);
    await figure.locator('[data-handle="0 0"]').focus();
    for (let k = 0; k < 8; k++) await page.keyboard.press("Shift+ArrowLeft");
    await figure.locator(".problem").waitFor();
    assert.match((await figure.locator(".problem").textContent()) ?? "", /Not possible here/);
    assert.ok((await colors(page)) > 50);
    assert.equal((await stateOf(page)).result, null);
    const [error] = (await eventsOf(page)).filter(({ type }) => type === "error");
    assert.match(error.code, /self-intersection|contact/);
    await page.keyboard.press("Escape");
    await figure.locator(".problem").waitFor({ state: "hidden" });
    await eventually(async () => assert.equal((await stateOf(page)).result?.ok, true));
  });
});

test("the slider moves the curve in between, play moves it on, and the end of play is the person's", async () => {
  await visit(browser, host.page(`<directrix-figure preset="amoeba"></directrix-figure>`), {}, async (page) => {
    const figure = await standing(page);
    await listen(page);
    const slider = figure.getByRole("slider");
    await slider.fill("0.8");
    assert.equal((await stateOf(page)).s, 0.8);
    assert.equal(await slider.getAttribute("aria-valuetext"), "s 0.80");
    await figure.getByRole("button", { name: "Play" }).click();
    await eventually(async () => assert.ok(Math.abs((await stateOf(page)).s - 0.8) > 0.05));
    await figure.getByRole("button", { name: "Pause" }).click();
    const { s } = await stateOf(page);
    await page.waitForTimeout(120);
    assert.equal((await stateOf(page)).s, s);
    assert.ok((await eventsOf(page)).some((event) => event.reason === "s" && event.s === 0.8));
    await eventually(async () => {
      const { href, s: place } = await stateOf(page);
      assert.equal(linked(href).view?.s, place);
    });
  });
});

test("a figure out of sight does not play, and goes on when it is seen", async () => {
  await visit(browser, host.page(`<directrix-figure preset="amoeba"></directrix-figure><p style="height: 4000px">Below</p>`), {}, async (page) => {
    const figure = await standing(page);
    await figure.getByRole("button", { name: "Play" }).click();
    await page.evaluate(() => scrollTo(0, 3000));
    const place = async () => (await stateOf(page)).s;
    await eventually(async () => {
      const one = await place();
      await page.waitForTimeout(100);
      assert.equal(await place(), one);
    });
    const still = await place();
    await page.evaluate(() => scrollTo(0, 0));
    await eventually(async () => assert.notEqual(await place(), still));
  });
});

test("with reduced motion play is a step", async () => {
  await visit(browser, host.page(`<directrix-figure preset="amoeba"></directrix-figure>`), { reducedMotion: "reduce" }, async (page) => {
    const figure = await standing(page);
    await page.evaluate(() => (/** @type {any} */ (document.querySelector("directrix-figure")).s = 0.4));
    const { stages } = (await preset("amoeba")).blend;
    await figure.getByRole("button", { name: "Next stage" }).click();
    const { s } = await stateOf(page);
    assert.ok(s > 0.4 && Math.abs(s * stages - Math.round(s * stages)) < 1e-9, `${s}`);
    await page.waitForTimeout(120);
    assert.equal((await stateOf(page)).s, s);
  });
});

test("it follows the scheme of its page, and its own attribute before that", async () => {
  const head = `<meta name="color-scheme" content="light dark"><script type="module" src="${host.app}element.js"></script>`;
  await visit(browser, host.page(`<directrix-figure preset="amoeba" controls="none"></directrix-figure>`, { head }), { colorScheme: "dark" }, async (page) => {
    const figure = await standing(page);
    const corner = async () => (await colorAt(page, 0.01, 0.01))[0] < 128 ? "dark" : "light";
    await eventually(async () => assert.equal(await corner(), "dark"));
    await page.emulateMedia({ colorScheme: "light" });
    await eventually(async () => assert.equal(await corner(), "light"));
    await page.evaluate(() => document.documentElement.setAttribute("style", "background: #111"));
    await eventually(async () => assert.equal(await corner(), "dark"));
    await figure.evaluate((element) => element.setAttribute("theme", "light"));
    await eventually(async () => assert.equal(await corner(), "light"));
  });
});

test("on paper it is light and sharp, without controls", async () => {
  await visit(browser, host.page(`<directrix-figure preset="amoeba" theme="dark" controls="full"></directrix-figure>`), {}, async (page) => {
    const figure = await standing(page);
    const paper = figure.locator(".paper[src]");
    await paper.waitFor({ state: "attached" });
    await page.emulateMedia({ media: "print" });
    await paper.waitFor();
    const found = await paper.evaluate((/** @type {HTMLImageElement} */ image) => {
      const canvas = document.createElement("canvas");
      canvas.width = canvas.height = 1;
      canvas.getContext("2d")?.drawImage(image, 0, 0, 1, 1, 0, 0, 1, 1);
      return { ratio: image.naturalWidth / image.clientWidth, corner: [...(canvas.getContext("2d")?.getImageData(0, 0, 1, 1).data ?? [])] };
    });
    assert.ok(found.ratio > 2.5, `${found.ratio} pixels for one`);
    assert.deepEqual(found.corner, [255, 255, 255, 255]);
    assert.equal(await figure.locator(".bar").isVisible(), false);
    assert.equal(await figure.locator(".handle").first().isVisible(), false);
  });
});

test("a bad document is told in place of the figure, and the last good one stays", async () => {
  await visit(browser, host.page(`<directrix-figure preset="amoeba">Words</directrix-figure>`), {}, async (page) => {
    const figure = await standing(page);
    await listen(page);
    const bad = [
      [{ directrix: 1, kind: "curves", curves: 3 }, "curves"],
      [{ directrix: 1, kind: "curves", curves: [], matching: { method: "greedy" }, extra: 1 }, "extra"],
      ["{", ""],
      [{ directrix: 1, kind: "curves", title: "<img src=x onerror=alert(1)>", curves: [], matching: { method: "<b>" } }, "matching.method"],
    ];
    for (const [document, path] of bad) {
      const count = (await eventsOf(page)).filter(({ type }) => type === "error").length;
      await figure.evaluate((/** @type {any} */ element, given) => (element.document = given), document);
      await eventually(async () => assert.equal((await eventsOf(page)).filter(({ type }) => type === "error").length, count + 1));
      const error = (await eventsOf(page)).filter(({ type }) => type === "error").at(-1);
      assert.equal(error.path, path);
      assert.match((await figure.locator(".problem").textContent()) ?? "", /cannot be shown/);
      assert.equal((await stateOf(page)).document.title, "Amoeba");
      assert.ok((await colors(page)) > 50);
    }
    await figure.evaluate((/** @type {any} */ element) => (element.document = { ...element.document, title: "<i>Good</i>" }));
    await figure.locator(".problem").waitFor({ state: "hidden" });
    await eventually(async () => assert.match((await stateOf(page)).label ?? "", /^<i>Good<\/i>\. 44 lines/));
    const nan = await figure.evaluate((/** @type {any} */ element) => {
      const document = element.document;
      document.curves[0].points[0][0] = NaN;
      return new Promise((done) => {
        element.addEventListener("error", (/** @type {CustomEvent} */ { detail }) => done(detail), { once: true });
        element.document = document;
      });
    });
    assert.deepEqual([nan.code, nan.path], ["non-finite", "curves[0].points[0][0]"]);
  });
});

test("a preset or an address that is not there is told, and the fallback stays", async () => {
  const figures = ["preset='no-such'>One", "preset='../index'>Two", "src='/nothing.json'>Three"].map((rest) => `<directrix-figure style="height: 160px" ${rest}</directrix-figure>`).join("");
  await visit(browser, host.page(figures), { allow: /404|CORS|ERR_FAILED/ }, async (page) => {
    const problems = page.locator("directrix-figure .problem");
    for (const [k, text] of [[0, /preset: the (server answered 404|address cannot be read)/], [1, /name of a preset/], [2, /src: the server answered 404/]]) {
      await eventually(async () => assert.match((await problems.nth(Number(k)).textContent()) ?? "", /** @type {RegExp} */ (text)));
    }
    for (const word of ["One", "Two", "Three"]) assert.ok(await page.getByText(word).isVisible());
  });
});

test("a document at an address is shown, and attributes that change are followed", async () => {
  await visit(browser, host.page(`<directrix-figure src="${host.app}presets/kidney.json" controls="none" alt="A kidney"></directrix-figure>`), {}, async (page) => {
    const figure = await standing(page);
    assert.match((await stateOf(page)).label ?? "", /^A kidney\. \d+ lines, none crossing/);
    assert.equal(await figure.locator(".bar").isVisible(), false);
    assert.deepEqual(await audit(page), []);
    await figure.evaluate((element) => {
      element.removeAttribute("src");
      element.setAttribute("preset", "petals");
      element.setAttribute("controls", "minimal");
      element.removeAttribute("alt");
    });
    await eventually(async () => assert.match((await stateOf(page)).label ?? "", /^Petals/));
    await figure.getByRole("link", { name: "Open in Directrix" }).waitFor();
    assert.deepEqual(await audit(page), []);
  });
});

test("with reveal it waits for the person, and loads nothing before", async () => {
  await visit(browser, host.page(`<directrix-figure preset="amoeba" reveal="interaction">What do you expect?</directrix-figure>`), {}, async (page) => {
    let modules = 0;
    page.on("request", (request) => (modules += Number(request.url().endsWith(".wasm"))));
    const show = page.getByRole("button", { name: "Show the figure" });
    await show.waitFor();
    await page.waitForTimeout(200);
    assert.equal(modules, 0);
    assert.ok(await page.getByText("What do you expect?").isVisible());
    assert.deepEqual(await audit(page), []);
    await show.press("Enter");
    const figure = await standing(page);
    await eventually(async () => assert.equal(await figure.getByRole("button", { name: "Play" }).evaluate((each) => each.matches(":focus")), true));
  });
});

test("properties set before the element is defined count", async () => {
  const body = `<directrix-figure id="f"></directrix-figure><script>document.getElementById("f").document = ${JSON.stringify(await preset("kidney"))};</script>`;
  await visit(browser, host.page(body), {}, async (page) => {
    await standing(page);
    assert.equal((await stateOf(page)).document.title, (await preset("kidney")).title);
  });
});

test("layers can be switched, and the link carries them", async () => {
  await visit(browser, host.page(`<directrix-figure preset="kidney" controls="full"></directrix-figure>`), {}, async (page) => {
    const figure = await standing(page);
    const before = await colors(page);
    await figure.locator("summary").click();
    await figure.getByLabel("Material").uncheck();
    await eventually(async () => assert.ok((await colors(page)) < before / 2));
    await eventually(async () => assert.ok(!linked((await stateOf(page)).href).view?.layers?.includes("material")));
    await page.keyboard.press("Escape");
    assert.equal(await figure.getByLabel("Material").isVisible(), false);
  });
});

test("Open in Directrix leads to the same document at the same place", async () => {
  await visit(browser, host.page(`<directrix-figure preset="amoeba" controls="full"></directrix-figure>`), {}, async (page) => {
    const figure = await standing(page);
    await figure.locator('[data-handle="1 3"]').focus();
    await page.keyboard.press("ArrowRight");
    await figure.getByRole("slider").fill("0.65");
    await eventually(async () => {
      const { href, document } = await stateOf(page);
      assert.deepEqual(linked(href), document);
      assert.equal(linked(href).view?.s, 0.65);
      assert.ok(href.startsWith(`${host.app}index.html#v=1&s=`), href);
    });
  });
});

test("with the view of steps it shows the greedy growth up to a step, which keys and the link follow", async () => {
  await visit(browser, host.page(`<directrix-figure preset="amoeba" view="steps" step="5" controls="minimal"></directrix-figure>`), {}, async (page) => {
    const figure = await standing(page);
    await listen(page);
    const label = async () => (await stateOf(page)).label ?? "";
    await eventually(async () => assert.match(await label(), /^Amoeba\. Step 5 of \d+ of the greedy growth$/));
    const lines = () => figure.locator(".growth .accepted").evaluate((path) => (path.getAttribute("d") ?? "").split("M").length - 1);
    assert.equal(await lines(), 4, "and the one that is accepted");
    const steps = Number(/of (\d+)/.exec(await label())?.[1]);
    const slider = figure.getByRole("slider", { name: "Steps of the greedy growth" });
    await slider.press("ArrowRight");
    await eventually(async () => assert.match(await label(), /Step 6 of/));
    assert.equal(await slider.getAttribute("aria-valuetext"), `Step 6 of ${steps} of the greedy growth`);
    assert.equal(await lines(), 5);
    await eventually(async () => assert.match((await stateOf(page)).href, /&view=steps&step=6$/));
    assert.ok((await eventsOf(page)).some(({ reason, step }) => reason === "step" && step === 6));
    await figure.evaluate((element) => element.setAttribute("step", "100000"));
    await eventually(async () => assert.equal(await lines(), steps - 1));
    assert.deepEqual(await audit(page), []);
    await figure.evaluate((element) => element.setAttribute("view", "figure"));
    await eventually(async () => assert.match(await label(), /44 lines/));
    assert.equal(await lines(), 0);
  });
});
