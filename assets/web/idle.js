// SPDX-License-Identifier: GPL-3.0-or-later
// Notices that nobody is there: no key, no pointer, nothing that plays.

export class IdleWatch {
  #last_ms = Date.now();
  #timer = null;

  constructor(onIdle) {
    this.onIdle = onIdle;
    for (const kind of ['keydown', 'pointerdown', 'pointermove', 'wheel', 'touchstart']) {
      window.addEventListener(kind, () => this.note(), { passive: true, capture: true });
    }
    // A lid that was closed: timers stood still, the clock did not.
    document.addEventListener('visibilitychange', () => this.#look());
  }
  start(idle_s) {
    this.idle_ms = 1000 * idle_s;
    this.note();
    clearInterval(this.#timer);
    this.#timer = setInterval(() => this.#look(), Math.min(1000, this.idle_ms / 4));
  }
  stop() {
    clearInterval(this.#timer);
    this.#timer = null;
  }
  note() {
    // The first key after a long pause must not open what should be locked.
    if (this.#timer) this.#look();
    this.#last_ms = Date.now();
  }
  #look() {
    if (this.#timer && Date.now() - this.#last_ms >= this.idle_ms) {
      this.stop();
      this.onIdle();
    }
  }
}
