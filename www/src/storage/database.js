/**
 * Transactions on the page's own database in the browser. Every one of them may fail, for want of room, in a private window
 * or by a rule of the person's; whoever calls says so and goes on.
 */
import { createStore, promisifyRequest } from "idb-keyval";

const DATABASE = "directrix";
const STORE = "documents";
/** Milliseconds after which the browser is taken not to answer at all. */
const PATIENCE = 5000;

/** @type {ReturnType<typeof createStore> | null} */
let open = null;

/**
 * Runs a transaction to its end. When the work throws, nothing of it is kept.
 * @template T
 * @param {IDBTransactionMode} mode
 * @param {(store: IDBObjectStore) => Promise<T>} work asks the store by `answer` and awaits nothing else
 * @returns {Promise<T>}
 */
export function transact(mode, work) {
  open ??= createStore(DATABASE, STORE);
  const result = open(mode, async (store) => {
    const { transaction } = store;
    const done = end(transaction);
    try {
      const value = await work(store);
      await done;
      return value;
    } catch (error) {
      try {
        transaction.abort();
      } catch {
        // It was over already.
      }
      throw error;
    }
  });
  return within(PATIENCE, result);
}

/**
 * The end of a transaction; rejects with what broke it first.
 * @param {IDBTransaction} transaction
 * @returns {Promise<void>}
 */
function end(transaction) {
  /** @type {unknown} */
  let broken = null;
  transaction.addEventListener("error", ({ target }) => (broken ??= /** @type {IDBRequest} */ (target).error));
  const done = new Promise((resolve, reject) => {
    transaction.addEventListener("complete", () => resolve(undefined));
    transaction.addEventListener("abort", () => reject(broken ?? transaction.error ?? new Error("aborted")));
  });
  done.catch(() => {});
  return done;
}

/**
 * The answer to one request of a transaction.
 * @template T
 * @param {IDBRequest<T>} request
 * @returns {Promise<T>}
 */
export function answer(request) {
  return promisifyRequest(request);
}

/**
 * @template T
 * @param {number} milliseconds
 * @param {Promise<T>} promise
 * @returns {Promise<T>}
 */
function within(milliseconds, promise) {
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let timer;
  const late = new Promise((_, reject) => {
    timer = setTimeout(() => reject(new Error("the browser's storage does not answer")), milliseconds);
  });
  return Promise.race([promise, /** @type {Promise<never>} */ (late)]).finally(() => clearTimeout(timer));
}
