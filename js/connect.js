import { DirectrixError } from "./errors.js";
import { FUNCTIONS } from "./functions.js";

/** @typedef {(typeof FUNCTIONS)[number]} Name */
/** @typedef {typeof Worker} WorkerClass */
/**
 * @typedef {object} Pending
 * @property {Name} name
 * @property {any[]} args
 * @property {(value: any) => void} resolve
 * @property {(error: unknown) => void} reject
 * @property {((progress: number) => void) | undefined} onprogress
 * @property {((milliseconds: number) => void) | undefined} onsolved
 */

/**
 * Starts a module worker and returns the functions of `load()` as promises. See docs/api.md.
 *
 * @param {import("./directrix.js").ConnectOptions} [options]
 * @returns {Promise<import("./directrix.js").Connection>}
 */
export async function connect(options = {}) {
  const client = await opened(options);
  const functions = FUNCTIONS.map((name) => [name, (/** @type {any[]} */ ...args) => client.call(name, args)]);
  return {
    .../** @type {any} */ (Object.fromEntries(functions)),
    hyperpatch: async (/** @type {any} */ document, /** @type {any} */ control) =>
      (await import("./remote-body.js")).body(client, document, control),
    merge: async (/** @type {any} */ document, /** @type {any} */ other, /** @type {any} */ control) =>
      (await import("./remote-body.js")).merge(client, document, other, control),
    part: async (/** @type {any} */ document, /** @type {any} */ control) => {
      const { remotePart } = await import("./remote-part.js");
      return remotePart((args) => client.call("part", args), document, control);
    },
    solveLaplace: async (/** @type {any} */ input, /** @type {any} */ control) => {
      const { remoteLaplace } = await import("./remote-laplace.js");
      return remoteLaplace((args) => client.call("solveLaplace", args), input, control);
    },
    close: () => client.close(),
    runsIn: client.runsIn,
    set onrestart(/** @type {(() => void) | undefined} */ listener) {
      client.onrestart = listener;
    },
  };
}

/**
 * A client whose worker has started. A browser refuses a worker from another origin than the page's, but not one of the page's own that
 * imports it; a policy of the page may refuse either.
 *
 * @param {import("./directrix.js").ConnectOptions} options
 * @returns {Promise<Client>}
 */
async function opened(options) {
  /** @param {WorkerClass} Worker @param {Client["runsIn"]} runsIn */
  const open = async (Worker, runsIn) => {
    const client = new Client(options, Worker, runsIn);
    await client.opened;
    return client;
  };
  try {
    return await open(Worker, "worker");
  } catch (error) {
    // What went wrong inside a worker would go wrong in another as well.
    if (error instanceof DirectrixError && error.code !== "no-worker") throw error;
    const { BlobWorker } = await import("./blob-worker.js");
    return open(BlobWorker, "blob worker");
  }
}

/** The worker, the calls that wait for it, and its restart after a trap. */
class Client {
  /** @type {(() => void) | undefined} */
  onrestart;
  /** @type {Map<number, Pending>} */
  #pending = new Map();
  #nextId = 1;
  /** @type {Worker} */
  #worker;
  #isClosed = false;
  #options;
  #Worker;

  /**
   * @param {import("./directrix.js").ConnectOptions} options
   * @param {WorkerClass} Worker
   * @param {"worker" | "blob worker"} runsIn
   */
  constructor(options, Worker, runsIn) {
    this.#options = options;
    this.#Worker = Worker;
    this.runsIn = runsIn;
    const { promise, resolve, reject } = withResolvers();
    /** @type {Promise<void>} */
    this.opened = promise;
    this.#worker = this.#start(resolve, reject);
  }

  /**
   * @param {Name} name
   * @param {any[]} args the last may be `{ signal, onprogress, onsolved }`
   */
  call(name, args) {
    const last = args.at(-1);
    const hasControl = args.length > 1 && last !== null && typeof last === "object" && isControl(last);
    const { signal, onprogress, onsolved } = hasControl ? args.pop() : {};
    if (this.#isClosed) return Promise.reject(new DirectrixError("closed", "", "the connection is closed"));
    if (signal?.aborted) return Promise.reject(signal.reason);
    const id = this.#nextId++;
    return new Promise((resolve, reject) => {
      this.#pending.set(id, { name, args, resolve, reject, onprogress, onsolved });
      signal?.addEventListener("abort", () => this.#cancel(id, signal.reason), { once: true });
      try {
        this.#worker.postMessage({ type: "call", id, name, args });
      } catch (error) {
        this.#settle(id)?.reject(new DirectrixError("type", "", `the document cannot be sent: ${error}`));
      }
    });
  }

  close() {
    this.#isClosed = true;
    this.#worker.terminate();
    for (const id of [...this.#pending.keys()]) {
      this.#settle(id)?.reject(new DirectrixError("closed", "", "the connection was closed"));
    }
  }

  /**
   * @param {() => void} ready
   * @param {(error: unknown) => void} failed
   */
  #start(ready, failed) {
    // Bundlers know this form, and put the worker's address into it whatever the constructor is.
    const Worker = this.#Worker;
    const worker = new Worker(new URL("./worker.js", import.meta.url), { type: "module", name: "directrix" });
    let answers = false;
    const fail = (/** @type {unknown} */ error) => {
      failed(error);
      for (const id of [...this.#pending.keys()]) this.#settle(id)?.reject(error);
    };
    worker.onerror = (event) => {
      event.preventDefault();
      if (!answers) worker.terminate();
      fail(new DirectrixError(answers ? "failed" : "no-worker", "", event.message || "the worker could not be started"));
    };
    worker.onmessage = ({ data }) => {
      answers = true;
      if (data.type === "ready") ready();
      else if (data.type === "failed") fail(revive(data.error));
      else this.#receive(data);
    };
    worker.postMessage({ type: "open", options: this.#options });
    return worker;
  }

  /** @param {any} message */
  #receive({ type, id, value, progress, spent, error }) {
    if (type === "progress") {
      this.#pending.get(id)?.onprogress?.(progress);
    } else if (type === "result") {
      const pending = this.#settle(id);
      pending?.onsolved?.(spent);
      pending?.resolve(value);
    } else {
      this.#settle(id)?.reject(revive(error));
      if (error.code === "trap") this.#restart();
    }
  }

  /** A module that trapped answers nothing more: the calls that wait go to a new worker. */
  #restart() {
    this.#worker.terminate();
    this.#worker = this.#start(
      () => this.onrestart?.(),
      () => {},
    );
    for (const [id, { name, args }] of this.#pending) this.#worker.postMessage({ type: "call", id, name, args });
  }

  /**
   * @param {number} id
   * @param {unknown} reason
   */
  #cancel(id, reason) {
    const pending = this.#settle(id);
    if (!pending) return;
    this.#worker.postMessage({ type: "cancel", id });
    pending.reject(reason);
  }

  /** @param {number} id */
  #settle(id) {
    const pending = this.#pending.get(id);
    this.#pending.delete(id);
    return pending;
  }
}

/** @param {object} value */
export function isControl(value) {
  return "signal" in value || "onprogress" in value || "onsolved" in value;
}

/** @param {{ code: string, path: string, message: string, at?: [number, number], place?: number[] }} error */
function revive({ code, path, message, at, place }) {
  return new DirectrixError(code, path, message, at, place);
}

function withResolvers() {
  /** @type {() => void} */
  let resolve = () => {};
  /** @type {(error: unknown) => void} */
  let reject = () => {};
  const promise = /** @type {Promise<void>} */ (
    new Promise((done, failed) => {
      resolve = () => done(undefined);
      reject = failed;
    })
  );
  return { promise, resolve, reject };
}
