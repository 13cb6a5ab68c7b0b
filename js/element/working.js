/** Says that work runs which takes long: a bar in the frame of a figure, and the event `progress`. */

/** Milliseconds after which work is shown as running, and told. */
const SLOW = 200;

export class Working {
  #bar;
  #tell;
  #isShown = false;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  #timer;

  /** @param {HTMLElement} bar @param {(progress: number) => void} tell from 0 to 1, once the bar is shown */
  constructor(bar, tell) {
    this.#bar = bar;
    this.#tell = tell;
  }

  begin() {
    clearTimeout(this.#timer);
    this.#timer = setTimeout(() => {
      this.#isShown = true;
      this.#bar.classList.add("shown");
      this.#tell(0);
    }, SLOW);
  }

  end() {
    clearTimeout(this.#timer);
    this.#isShown = false;
    this.#bar.classList.remove("shown");
  }

  /** @param {number} progress */
  set(progress) {
    if (progress >= 1) this.end();
    this.#bar.style.transform = `scaleX(${progress})`;
    if (this.#isShown) this.#tell(progress);
  }
}
