/** The package in a browser without a bundler: a worker that hears a cancel while it paints. */
import assert from "node:assert/strict";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { root } from "../../scripts/lib/paths.mjs";
import { presets } from "../../scripts/hyperpatch-presets.mjs";
import { base } from "../node/hostile.js";
import { launch, withPage } from "./support/browser.js";
import { serve } from "./support/server.js";

/** @type {import("playwright-core").Browser} */
let browser;
/** @type {import("../../scripts/lib/serve.mjs").Served} */
let served;

before(async () => {
  [browser, served] = await Promise.all([launch(), serve(join(root, "js"))]);
});
after(() => Promise.all([browser.close(), served.close()]));

test("a large picture is painted in steps, and cancelled between them", async () => {
  await withPage(browser, { allow: /favicon|404/ }, async (page) => {
    await page.goto(`${served.url}index.js`);
    const found = await page.evaluate(
      async ([address, document]) => {
        const { connect } = await import(/** @type {string} */ (address));
        const dx = await connect({ module: "figure" });
        const large = { width: 4096, height: 4096, pixelRatio: 2 };
        await dx.match(document);

        /** @type {number[]} */
        const whole = [];
        const picture = await dx.paint(document, large, { onprogress: (/** @type {number} */ share) => whole.push(share) });

        /** @type {number[]} */
        const shares = [];
        const control = new AbortController();
        const onprogress = (/** @type {number} */ share) => {
          shares.push(share);
          if (share > 0.5) control.abort();
        };
        const outcome = await dx.paint(document, large, { signal: control.signal, onprogress }).catch((/** @type {Error} */ error) => error.name);
        const small = await dx.paint(document, { width: 40, height: 30 });
        dx.close();
        return { bytes: picture.data.length, steps: whole.length, last: whole.at(-1), shares, outcome, small: small.data.length };
      },
      /** @type {const} */ ([`${served.url}index.js`, base]),
    );
    assert.equal(found.bytes, 4096 * 4096 * 4);
    assert.ok(found.steps > 5 && (found.last ?? 1) < 1, `${found.steps} steps`);
    assert.equal(found.outcome, "AbortError");
    assert.ok(found.shares.length > 1 && found.shares.length < found.steps, `${found.shares}`);
    assert.equal(found.small, 40 * 30 * 4);
  });
});

test("a call tells how long it was solved, and that a remembered document is not solved again", async () => {
  await withPage(browser, { allow: /favicon|404/ }, async (page) => {
    await page.goto(`${served.url}index.js`);
    const found = await page.evaluate(
      async ([address, document]) => {
        const { connect } = await import(/** @type {string} */ (address));
        const dx = await connect({ module: "figure" });
        const many = JSON.stringify({ .../** @type {any} */ (document), sampling: { counts: [200, 200] }, matching: { method: "exact" } });
        /** @type {{spent: number, all: number}[]} */
        const calls = [];
        const ask = async (/** @type {string} */ text) => {
          const start = performance.now();
          let spent = -1;
          await dx.match(text, {}, { onsolved: (/** @type {number} */ milliseconds) => (spent = milliseconds) });
          calls.push({ spent, all: performance.now() - start });
        };
        await ask(many);
        await ask(many);
        await ask(`${many} `);
        dx.close();
        return calls;
      },
      /** @type {const} */ ([`${served.url}index.js`, base]),
    );
    const [first, again, other] = found;
    for (const { spent, all } of found) assert.ok(spent >= 0 && spent <= all + 1, `${spent} of ${all} ms`);
    assert.ok(first.spent > 4 * again.spent && other.spent > 4 * again.spent, JSON.stringify(found));
  });
});

test("a body follows its operations over the worker, and a call that is given up loses none of them", async () => {
  await withPage(browser, { allow: /favicon|404/ }, async (page) => {
    await page.goto(`${served.url}index.js`);
    const found = await page.evaluate(
      async ([address, document]) => {
        const { connect, renewSurface } = await import(/** @type {string} */ (address));
        const dx = await connect({ module: "full" });
        const edited = (/** @type {any} */ one, /** @type {any} */ operation) => ({ ...one, operations: [...one.operations, operation] });
        // The first call, which brings all cells, is given up before its turn.
        const control = new AbortController();
        const given = dx.hyperpatch(document, { signal: control.signal }).catch((/** @type {Error} */ error) => error.name);
        control.abort();
        const body = await dx.hyperpatch(document);
        const surface = await body.surface();
        const moved = edited(document, { op: "move", cell: 0, at: [3, 3, 3], by: [0.05, 0, 0] });
        const next = await dx.hyperpatch(moved);
        const ranges = renewSurface(surface, await next.surface({ since: surface.id }));
        const gone = await dx.hyperpatch(edited(moved, { op: "delete", cells: [99] }));
        const merged = await dx.merge(moved, document);
        const verdicts = await next.verdicts({ global: false });
        const refusal = await dx.hyperpatch(edited(moved, { op: "melt" })).catch((/** @type {any} */ error) => `${error.code} ${error.path}`);
        dx.close();
        return {
          given: await given,
          cells: body.cells.length,
          touched: next.operations[1].touched.length,
          ranges: ranges?.vertices.length,
          reason: gone.operations[2].reason,
          merged: merged.operations.length,
          verdicts: verdicts.length,
          refusal,
        };
      },
      /** @type {const} */ ([`${served.url}index.js`, presets().block]),
    );
    const { ranges, reason, ...rest } = found;
    assert.deepEqual(rest, { given: "AbortError", cells: 8, touched: 8, merged: 3, verdicts: 8, refusal: "range operations[2].op" });
    assert.ok(ranges > 0 && /no cell 99/.test(reason));
  });
});
