/**
 * One request in flight, and of those that wait only the newest: however fast edits come, the worker is never more
 * than one behind.
 *
 * @template Job, Result
 */
export class Lane {
  /** @type {(job: Job, signal: AbortSignal) => Promise<Result>} */ #work;
  /** @type {(result: Result, job: Job) => void} */ #done;
  /** @type {(error: unknown, job: Job) => void} */ #failed;
  /** @type {Job | null} */ #waiting = null;
  /** @type {AbortController | null} */ #flight = null;
  /** @type {(slow: boolean) => void} */ #slow;

  /** Milliseconds after which work is shown as running. */
  static SLOW = 200;

  /**
   * @param {object} options
   * @param {(job: Job, signal: AbortSignal) => Promise<Result>} options.work
   * @param {(result: Result, job: Job) => void} options.done
   * @param {(error: unknown, job: Job) => void} options.failed
   * @param {(slow: boolean) => void} [options.slow] told when work passes `SLOW`, and when it is over
   */
  constructor({ work, done, failed, slow }) {
    this.#work = work;
    this.#done = done;
    this.#failed = failed;
    this.#slow = slow ?? (() => {});
  }

  get busy() {
    return this.#flight !== null;
  }

  /** Whether a job waits for the one that runs. */
  get waits() {
    return this.#waiting !== null;
  }

  /** @param {Job} job */
  push(job) {
    this.#waiting = job;
    if (!this.#flight) void this.#next();
  }

  /** Gives up what runs and what waits. */
  cancel() {
    this.#waiting = null;
    this.#flight?.abort();
  }

  async #next() {
    const job = this.#waiting;
    if (job === null) return;
    this.#waiting = null;
    const flight = new AbortController();
    this.#flight = flight;
    const timer = setTimeout(() => this.#slow(true), Lane.SLOW);
    try {
      const result = await this.#work(job, flight.signal);
      this.#done(result, job);
    } catch (error) {
      this.#failed(error, job);
    }
    clearTimeout(timer);
    this.#slow(false);
    this.#flight = null;
    void this.#next();
  }
}
