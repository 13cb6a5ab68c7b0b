/**
 * The page without a network, and the way from one build to the next: all of the old one until it is reloaded, then all of the new one.
 *
 * @import { Page } from "playwright-core"
 */
import assert from "node:assert/strict";
import { cp, mkdtemp, readFile, readdir, rename, rm, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { writeOffline } from "../../scripts/lib/offline.mjs";
import { dist } from "../../scripts/lib/paths.mjs";
import { choosePoint, documentOf, eventually, field, pick, ready, status } from "./page/workbench.js";
import { launch, watch } from "./support/browser.js";
import { serve } from "./support/server.js";

/** @type {import("playwright-core").Browser} */
let browser;
before(async () => {
  browser = await launch();
});
after(() => browser?.close());

/** A page that cannot reach the server says so in its console; nothing else may be there. */
const OFFLINE = /ERR_INTERNET_DISCONNECTED|ERR_CONNECTION_REFUSED|ERR_FAILED/;

/**
 * A copy of the built page, served below a folder of its own.
 * @param {import("node:test").TestContext} t
 */
async function served(t) {
  const folder = await mkdtemp(join(tmpdir(), "directrix-offline-"));
  await cp(dist, folder, { recursive: true });
  const server = await serve(folder, { base: "/some/where/" });
  t.after(async () => {
    await server.close();
    await rm(folder, { recursive: true });
  });
  return { folder, server };
}

/**
 * @param {import("node:test").TestContext} t
 * @param {string} url
 * @param {RegExp} [allow]
 */
async function visit(t, url, allow) {
  const context = await browser.newContext({ viewport: { width: 1280, height: 800 } });
  t.after(() => context.close());
  context.setDefaultTimeout(20_000);
  const page = await context.newPage();
  const complaints = watch(page, allow);
  t.after(() => assert.deepEqual(complaints, []));
  await page.goto(url);
  await ready(page);
  return { page, context };
}

/** The state of one of the workers. @param {Page} page @param {"active" | "waiting"} which */
const workerState = (page, which) =>
  page.evaluate(async (name) => (await navigator.serviceWorker.getRegistration())?.[name]?.state ?? null, which);

/** Waits until the build is kept, which begins some seconds after the page has loaded. @param {Page} page */
async function kept(page) {
  await page.waitForSelector("link[rel=manifest]", { state: "attached" });
  await eventually(async () => assert.equal(await workerState(page, "active"), "activated"));
}

/** The names of the kept builds. @param {Page} page */
const builds = (page) => page.evaluate(async () => (await caches.keys()).filter((name) => name.startsWith("directrix http")));

/** Types 3.21 for x of the first point. @param {Page} page */
async function moveFirstPoint(page) {
  await choosePoint(page, "A1");
  await field(page, "x").fill("3.21");
  await field(page, "x").press("Enter");
  await eventually(async () => assert.equal((await documentOf(page)).curves[0].points[0][0], 3.21));
}

/** @param {Page} page @param {string} name */
async function openPreset(page, name) {
  await page.locator("[data-action=gallery]").click();
  await page.locator(`[data-preset=${name}]`).click();
  await page.locator("[data-panel=gallery]").waitFor({ state: "detached" });
}

/** @param {Page} page */
async function openAbout(page) {
  await page.locator("[data-action=file]").click();
  await page.locator("[role=menu] [data-item=about], [role=menuitem]:has-text('About')").first().click();
  await page.locator("[data-panel=about]").waitFor();
}

test("after a first visit everything works without a network", async (t) => {
  const { server } = await served(t);
  const { page, context } = await visit(t, server.url, OFFLINE);
  assert.equal(await page.evaluate(async () => (await navigator.serviceWorker.getRegistrations()).length), 0, "nothing is registered with the first paint");
  await kept(page);
  await installable(page, server.url);
  await server.close();
  await context.setOffline(true);

  await page.reload();
  await ready(page);
  assert.equal(await page.evaluate(() => navigator.serviceWorker.controller !== null), true);
  await moveFirstPoint(page);
  await pick(page, "mode", "compare");
  await page.locator("[data-method=exact]").waitFor();
  await pick(page, "mode", "steps");
  await page.locator(".step-picture").waitFor();
  await pick(page, "mode", "figure");
  await openPreset(page, "kidney");
  await eventually(async () => assert.match(await status(page), /Verified/));
  await openAbout(page);
  await page.locator("[data-offline=kept]").waitFor();
  await page.locator("[data-part]").first().waitFor();

  // A page in a new tab is there too.
  const second = await context.newPage();
  await second.goto(`${server.url}index.html#here`);
  await ready(second);
});

/**
 * The manifest leads back to the page, and its icons are images.
 * @param {Page} page
 * @param {string} home
 */
async function installable(page, home) {
  const url = new URL((await page.locator("link[rel=manifest]").getAttribute("href")) ?? "", home);
  const manifest = await (await fetch(url)).json();
  assert.equal(new URL(manifest.start_url, url).href, home);
  assert.equal(new URL(manifest.scope, url).href, home);
  for (const { src } of manifest.icons) {
    const size = await page.evaluate(async (address) => {
      const image = new Image();
      image.src = address;
      await image.decode();
      return image.naturalWidth;
    }, new URL(src, url).href);
    assert.ok(size > 0);
  }
}

/**
 * Makes the copy another build: the chunk of About has another name and other words, and so has the page.
 * @param {string} folder
 */
async function release(folder) {
  const assets = await readdir(join(folder, "assets"));
  const old = assets.find((name) => /^about-.*\.js$/.test(name)) ?? assert.fail("no chunk of About");
  const next = "about-NEXTNEXT.js";
  await rename(join(folder, "assets", old), join(folder, "assets", next));
  let fetching = 0;
  for (const name of (await readdir(join(folder, "assets"))).filter((name) => name.endsWith(".js"))) {
    const file = join(folder, "assets", name);
    const text = await readFile(file, "utf8");
    const changed = text.replaceAll(old, next).replaceAll("Nothing leaves your machine", "Nothing ever leaves your machine");
    if (changed !== text) await writeFile(file, changed);
    if (text.includes(old)) fetching += 1;
  }
  assert.ok(fetching > 0, "something fetches About");
  const page = join(folder, "index.html");
  await writeFile(page, (await readFile(page, "utf8")).replace('<html lang="en"', '<html lang="en" data-release="2"'));
  await writeOffline(folder, `# Changelog\n## [2]\n### Added\n- Something \`new\`, [linked](x.md),\n  in two lines.\n${await changelog()}`);
  return { old, next };
}

const changelog = () => readFile(new URL("../../CHANGELOG.md", import.meta.url), "utf8");

test("an update waits, the old page stays whole, and Reload leads to the new one with the document", async (t) => {
  const { folder, server } = await served(t);
  const { page, context } = await visit(t, server.url);
  await kept(page);
  await page.reload();
  await ready(page);
  await moveFirstPoint(page);
  const other = await context.newPage();
  await other.goto(server.url);
  await ready(other);
  const before = await builds(page);
  assert.equal(before.length, 1);

  const { old, next } = await release(folder);
  // As the page itself does it when it has been open for an hour.
  await page.evaluate(async () => void (await (await navigator.serviceWorker.getRegistration())?.update()));
  await eventually(async () => assert.equal(await workerState(page, "waiting"), "installed"));
  await page.locator("#status [data-command=reload]").waitFor({ timeout: 20_000 });
  assert.match(await status(page), /A new version is ready/);
  assert.equal((await builds(page)).length, 2);

  // The old page goes on wholly from what it has: the server no longer has its part.
  const asked = /** @type {string[]} */ ([]);
  page.on("request", (request) => asked.push(request.url()));
  await openAbout(page);
  await page.locator("[data-offline=kept]").waitFor();
  assert.ok((await page.locator("[data-panel=about]").innerText()).includes("Nothing leaves your machine"));
  assert.deepEqual(await page.locator(".changes li").allInnerTexts(), ["Something new, linked, in two lines."]);
  assert.ok(asked.some((url) => url.endsWith(old)));
  assert.ok(!asked.some((url) => url.endsWith(next)));
  assert.equal((await fetch(`${server.url}assets/${old}`)).status, 404);

  await page.locator("[data-reload]").click();
  await page.waitForSelector("html[data-release='2']", { timeout: 30_000 });
  await ready(page);
  assert.equal((await documentOf(page)).curves[0].points[0][0], 3.21);
  asked.length = 0;
  await openAbout(page);
  await page.locator("[data-offline=kept]").waitFor();
  assert.ok((await page.locator("[data-panel=about]").innerText()).includes("Nothing ever leaves your machine"));
  assert.ok(asked.some((url) => url.endsWith(next)));
  assert.ok(!asked.some((url) => url.endsWith(old)));

  // The other page was opened before and is old through and through, under the new worker; its build stays as long as it does.
  const others = /** @type {string[]} */ ([]);
  other.on("request", (request) => others.push(request.url()));
  await openAbout(other);
  assert.ok((await other.locator("[data-panel=about]").innerText()).includes("Nothing leaves your machine"));
  assert.ok(others.some((url) => url.endsWith(old)));
  await page.evaluate(() => navigator.serviceWorker.controller?.postMessage({ type: "directrix:tidy" }));
  await other.locator("[data-part]").first().waitFor();
  assert.equal((await builds(page)).length, 2);
  await other.close();
  await eventually(async () => {
    await page.evaluate(() => navigator.serviceWorker.controller?.postMessage({ type: "directrix:tidy" }));
    const left = await builds(page);
    assert.equal(left.length, 1);
    assert.notEqual(left[0], before[0]);
  });
});

test("a build that does not come whole is not kept", async (t) => {
  const { folder, server } = await served(t);
  const licences = join(folder, "licences.json");
  await writeFile(licences, `${await readFile(licences, "utf8")} `);
  const { page } = await visit(t, server.url, /integrity|ERR_FAILED|sw\.js/);
  await eventually(async () => {
    if (!(await page.locator("[data-panel=about]").isVisible())) await openAbout(page);
    assert.ok(await page.locator("[data-offline=failed]").isVisible());
  });
  assert.deepEqual(await builds(page), []);
  assert.match(await page.locator("[data-offline]").innerText(), /only with a network/);
});

test("where the browser keeps nothing the page works and About says so", async (t) => {
  const { server } = await served(t);
  const context = await browser.newContext({ viewport: { width: 1280, height: 800 } });
  t.after(() => context.close());
  await context.addInitScript(() =>
    Object.defineProperty(navigator, "serviceWorker", {
      get() {
        throw new DOMException("The operation is insecure.", "SecurityError");
      },
    }),
  );
  const page = await context.newPage();
  const complaints = watch(page);
  await page.goto(server.url);
  await ready(page);
  await eventually(async () => {
    if (!(await page.locator("[data-panel=about]").isVisible())) await openAbout(page);
    assert.ok(await page.locator("[data-offline=failed]").isVisible());
  });
  assert.match(await page.locator("[data-offline]").innerText(), /insecure/);
  assert.deepEqual(complaints, []);
});
