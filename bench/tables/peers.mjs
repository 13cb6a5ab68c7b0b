/** Our methods and those of others on the reference curves, in one process; and our ratios beside those of the papers. */
import { readFile } from "node:fs/promises";
import { compare, isFeasible, methods } from "../support/compare.mjs";

/**
 * @import { Directrix } from "../../js/directrix.js"
 * @import { Rating } from "../support/compare.mjs"
 */

const runs = 5;
const preset = async (/** @type {string} */ file) =>
  JSON.parse(await readFile(new URL(`../../www/presets/${file}.json`, import.meta.url), "utf8"));

/** @param {string[]} cells */
const row = (cells) => `| ${cells.join(" | ")} |`;

/** @param {string[]} head the first column holds words, all others numbers */
const headed = (head) => [row(head), row(head.map((_, k) => (k === 0 ? "---" : "---:")))];

/**
 * η, or in brackets with the number of crossings and of blocked lines where a constraint is broken.
 *
 * @param {Rating} rating
 */
function quality({ places, eta, crossings, blocked }) {
  if (places.length === 0) return "–";
  return crossings + blocked === 0 ? eta.toFixed(4) : `(${eta.toFixed(4)}: ${crossings} + ${blocked})`;
}

/** @param {number[]} values */
const median = (values) => values.sort((a, b) => a - b)[values.length >> 1];

/**
 * The ratios of the papers for 44 lines, by the rows of ours, and their times.
 *
 * @param {Rating[]} ratings of the reference pair
 */
function* papers(ratings) {
  const best = /** @type {Rating} */ (ratings.find(({ method }) => method === "exact")).integral;
  const printed = [
    { method: "parameter", sum: 1.18, seconds: "" },
    { method: "k-shift", sum: 3.01, seconds: "" },
    { method: "greedy", sum: 3.5, seconds: "3.44 s" },
    { method: "exact", sum: 3.63, seconds: "7.94 s" },
  ];
  yield "";
  yield "Reference pair, 44 J, which is the mean of the sum over 44 lines that are evenly spread along the correspondence; beside it the sums that the papers print for 44 lines of their pair:";
  yield "";
  yield* headed(["method", "44 J", "to the best", "papers", "to their best", "ms", "papers"]);
  for (const { method, sum, seconds } of printed) {
    const { integral, milliseconds } = /** @type {Rating} */ (ratings.find((rating) => rating.method === method));
    const ratio = (integral / best).toFixed(3);
    yield row([method, (44 * integral).toFixed(4), ratio, `${sum}`, (sum / 3.63).toFixed(3), milliseconds.toFixed(1), seconds]);
  }
}

/** What `npm run bench -- TEXT` looks for. */
export const name = "peers on the reference curves";

/**
 * The lines of the tables, one after another.
 *
 * @param {Directrix} dx
 */
export async function* table(dx) {
  /** @type {{id: string, title: string}[]} */
  const index = await preset("index");
  /** @type {Map<string, {title: string, ratings: Rating[]}>} */
  const all = new Map();
  yield* headed(["pair, method", "ms", "lines", "J", "η", "crossings", "blocked", "feasible"]);
  for (const { id, title } of index) {
    const document = await preset(id);
    // The others match pairs of closed outlines in the plane alone.
    const isPair = document.curves.length === 2 && document.curves[0].points[0].length === 2;
    if (!isPair || document.curves[0].form === "open") continue;
    const ratings = compare(dx, document, runs);
    all.set(id, { title, ratings });
    for (const rating of ratings) {
      const { method, milliseconds, places, integral, eta, crossings, blocked } = rating;
      const figures = places.length > 0 ? [integral.toPrecision(5), eta.toFixed(4), `${crossings}`, `${blocked}`] : ["–", "–", "–", "–"];
      const verdict = isFeasible(rating) ? "yes" : places.length > 0 ? "INFEASIBLE" : "refused";
      yield row([`${title}, ${method}`, milliseconds.toFixed(1), `${places.length}`, ...figures, verdict]);
    }
  }

  yield "";
  yield "η of every method; in brackets: infeasible, with its crossings + blocked lines; –: refused. Below, the median of the times:";
  yield "";
  yield* headed(["pair", ...methods]);
  for (const { title, ratings } of all.values()) yield row([title, ...ratings.map(quality)]);
  const times = methods.map((_, k) => median([...all.values()].map(({ ratings }) => ratings[k].milliseconds)).toFixed(1));
  yield row(["ms", ...times]);
  yield "";
  const worse = [...all.values()].flatMap(({ title, ratings: [exact, ...others] }) =>
    others
      .filter((other) => isFeasible(other) && !(isFeasible(exact) && exact.integral >= other.integral))
      .map(({ method, integral }) => `${title}: ${method} has J ${integral}, exact ${exact.integral}`),
  );
  yield worse.length === 0 ? "Among the feasible results no J is above that of exact." : `EXACT IS WORSE:\n${worse.join("\n")}`;
  yield* papers(/** @type {{ratings: Rating[]}} */ (all.get("reference-pair")).ratings);
}
