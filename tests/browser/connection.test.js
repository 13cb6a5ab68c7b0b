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

/** A ring between two circles of so many segments each, with the values 0 outside and 1 inside. @param {number} count */
function ring(count) {
  const points = [1, 0.4].flatMap((radius, k) =>
    Array.from({ length: count }, (_, n) => [radius * Math.cos((2 * Math.PI * n) / count), (k ? -radius : radius) * Math.sin((2 * Math.PI * n) / count)]),
  );
  return {
    dimension: 2,
    vertices: points.flat(),
    elements: points.flatMap((_, n) => [n, n - (n % count) + ((n + 1) % count)]),
    conditions: [{ value: 0 }, { value: 1 }],
    groups: points.map((_, n) => Number(n >= count)),
  };
}

test("boundary elements are solved by the worker, given up, and solved again after it was restarted", async () => {
  await withPage(browser, { allow: /favicon|404/ }, async (page) => {
    await page.goto(`${served.url}index.js`);
    const found = await page.evaluate(
      async ([address, small, large]) => {
        // The module is replaced by one that traps at a call, by way of the worker's own messages.
        let traps = false;
        const Real = Worker;
        globalThis.Worker = class extends Real {
          /** @param {any} message @param {any} rest */
          postMessage(message, rest = []) {
            if (!traps || message.type !== "call") return super.postMessage(message, rest);
            traps = false;
            const error = { code: "trap", path: "", message: "unreachable" };
            this.onmessage?.(new MessageEvent("message", { data: { type: "error", id: message.id, error } }));
          }
        };
        const { connect } = await import(/** @type {string} */ (address));
        const dx = await connect({ module: "full" });
        const solution = await dx.solveLaplace(small);
        const first = await solution.at([0.7, 0]);
        const section = await solution.section({ longest: 64 });

        /** @type {number[]} */
        const shares = [];
        const control = new AbortController();
        const onprogress = (/** @type {number} */ share) => {
          shares.push(share);
          control.abort();
        };
        const outcome = await dx.solveLaplace(large, { signal: control.signal, onprogress }).catch((/** @type {Error} */ error) => error.name);
        const after = await solution.at([0.7, 0]);

        const restarted = new Promise((resolve) => (dx.onrestart = () => resolve(true)));
        traps = true;
        const stopped = await solution.at([0.7, 0]).catch((/** @type {any} */ error) => error.code);
        const again = await solution.at([0.7, 0]);
        const outside = await solution.at([0, 0]).catch((/** @type {any} */ error) => error.code);
        const values = [first, after, again].map((answer) => answer.values[0]);
        const hole = Number.isNaN(section.values[0][32 * 64 + 32]);
        const found = { elements: solution.elements, values, size: section.size, inside: section.inside, hole, outcome, shares, stopped, outside };
        const isRestarted = await restarted;
        dx.close();
        return { ...found, isRestarted };
      },
      /** @type {const} */ ([`${served.url}index.js`, ring(120), ring(2000)]),
    );
    const { values, inside, shares, ...rest } = found;
    const expected = { elements: 240, size: [64, 64], hole: true, outcome: "AbortError", stopped: "trap", outside: "outside", isRestarted: true };
    assert.deepEqual(rest, expected);
    for (const value of values) assert.ok(Math.abs(value - Math.log(0.7) / Math.log(0.4)) < 1e-3, `${values}`);
    // The ring fills this share of its box.
    assert.ok(Math.abs(inside / 64 ** 2 - (Math.PI / 4) * (1 - 0.4 ** 2)) < 0.01, `${inside} pixels`);
    assert.ok(shares.length > 0 && (shares.at(-1) ?? 1) < 1, `${shares}`);
  });
});
