/**
 * The one kernel of all figures of a page, and whose turn it is.
 *
 * It runs in a worker where that is possible, else on the main thread. One figure at a time has it; figures on the screen go first, and none
 * is passed over more than a few times.
 *
 * @typedef {object} Kernel
 * @property {"worker" | "blob worker" | "main thread"} runsIn
 * @property {(name: import("../connect.js").Name, args: any[], control?: import("../directrix.js").Control) => Promise<any>} call
 * @property {() => void} close
 */
import { connect } from "../connect.js";

/** Milliseconds without a figure after which the worker ends. */
const IDLE = 10_000;
/** How often a lane that waits may see a more urgent one go first. */
const PATIENCE = 4;

/** @type {Promise<Kernel> | null} */
let kernel = null;
/** The module in use: `full` from the first document on that needs it. @type {"figure" | "full"} */
let module = "figure";
/** @type {Lane[]} */
const waiting = [];
let isTaken = false;
let users = 0;
/** @type {ReturnType<typeof setTimeout> | undefined} */
let ending;

/** @returns {Promise<Kernel>} */
function started() {
  if (!kernel) {
    const starting = start();
    kernel = starting;
    starting.catch(() => {
      if (kernel === starting) kernel = null;
    });
  }
  return kernel;
}

/** Starts the kernel while its first document is on its way. */
export function warm() {
  // A failure is told to the lane that asks for a turn.
  started().catch(() => {});
}

/** @returns {Promise<Kernel>} */
async function start() {
  try {
    const connection = await connect({ module });
    return {
      runsIn: connection.runsIn,
      call: (name, args, control) => /** @type {any} */ (connection)[name](...args, ...(control ? [control] : [])),
      close: connection.close,
    };
  } catch (error) {
    if (/** @type {{ code?: string }} */ (error)?.code === "trap") throw error;
    const { mainThread } = await import("./main-thread.js");
    return mainThread(module);
  }
}

/**
 * The kernel with the module `full`, after `figure` said that it does not compute a document.
 *
 * @param {Kernel} old
 */
function fuller(old) {
  module = "full";
  old.close();
  kernel = null;
  return started();
}

/** Whether the kernel has all that the package computes. */
export const isWhole = () => module === "full";

/** A figure is there that may need the kernel. */
export function use() {
  users += 1;
  clearTimeout(ending);
}

/** A figure that said `use` is gone. */
export function release() {
  users -= 1;
  if (users > 0) return;
  ending = setTimeout(() => {
    void kernel?.then(({ close }) => close());
    kernel = null;
  }, IDLE);
}

/** What one figure asks of the kernel: one thing at a time, which reads the newest state when its turn comes. */
export class Lane {
  #work;
  #failed;
  #urgency;
  #passed = 0;
  /** @type {AbortController | null} */
  #flight = null;

  /**
   * @param {object} options
   * @param {(kernel: Kernel, signal: AbortSignal) => Promise<void>} options.work
   * @param {(error: unknown) => void} options.failed not called for what was cancelled
   * @param {() => number} options.urgency 0 for what is on the screen, more for what can wait
   */
  constructor({ work, failed, urgency }) {
    this.#work = work;
    this.#failed = failed;
    this.#urgency = urgency;
  }

  /** Asks for a turn. */
  push() {
    if (waiting.includes(this)) return;
    waiting.push(this);
    void next();
  }

  /** Gives up what runs and what waits. */
  cancel() {
    const index = waiting.indexOf(this);
    if (index >= 0) waiting.splice(index, 1);
    this.#flight?.abort();
  }

  /** Takes the turn. */
  async take() {
    const flight = new AbortController();
    this.#flight = flight;
    this.#passed = 0;
    try {
      const there = await started();
      if (!flight.signal.aborted) await this.#answered(there, flight.signal);
    } catch (error) {
      if (!flight.signal.aborted) this.#failed(error);
    }
    this.#flight = null;
  }

  /**
   * Does the work, with the module `full` where `figure` does not do.
   *
   * @param {Kernel} there
   * @param {AbortSignal} signal
   */
  async #answered(there, signal) {
    try {
      await this.#work(there, signal);
    } catch (error) {
      if (module === "full" || /** @type {{ code?: string }} */ (error)?.code !== "not-in-module") throw error;
      const whole = await fuller(there);
      if (!signal.aborted) await this.#work(whole, signal);
    }
  }

  get urgency() {
    return this.#passed >= PATIENCE ? 0 : this.#urgency();
  }

  /** Another lane goes first. */
  pass() {
    this.#passed += 1;
  }
}

/** Hands the kernel to the lane that waits longest among the most urgent. */
async function next() {
  if (isTaken) return;
  isTaken = true;
  while (waiting.length > 0) {
    const urgencies = waiting.map((lane) => lane.urgency);
    const index = urgencies.indexOf(Math.min(...urgencies));
    const [lane] = waiting.splice(index, 1);
    for (const other of waiting.slice(0, index)) other.pass();
    await lane.take();
  }
  isTaken = false;
}
