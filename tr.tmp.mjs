import cases from "./bench/hyperpatch.mjs";
import { measure } from "./scripts/lib/bench.mjs";
for (const c of cases) { const {median, p90, runs} = measure(await c.prepare()); console.log(c.name, median.toFixed(2), p90.toFixed(2), c.budget, runs); }
