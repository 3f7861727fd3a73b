// SPDX-License-Identifier: GPL-3.0-or-later
// Detects idleness: no key, no pointer, nothing playing.

const kLook_ms = 1000;
const kLongestWarning_ms = 60_000;
const kPresent_ms = 30_000;
const kWarningShare = 0.2; // of short idle times

export class IdleWatch {
  #last_ms = 0;
  #timer = null;
  #warned = false;
  #said_ms = 0;

  /// `on`: warned(left_s), once before the end; back(), activity after a warning; idle(); present(),
  /// repeatedly during activity, to tell the server; held(), true while the page waits for something and is
  /// not to be locked.
  constructor(on) {
    this.on = on;
    for (const kind of ['keydown', 'pointerdown', 'pointermove', 'wheel', 'touchstart']) {
      window.addEventListener(kind, () => this.note(), { passive: true, capture: true });
    }
    // A closed lid stops timers, but not the clock.
    document.addEventListener('visibilitychange', () => this.#look());
  }
  start(idle_s) {
    this.stop();
    this.idle_ms = 1000 * idle_s;
    this.warn_ms = this.idle_ms - Math.min(kLongestWarning_ms, kWarningShare * this.idle_ms);
    this.#last_ms = Date.now();
    this.#said_ms = this.#last_ms;
    this.#timer = setInterval(() => this.#look(), Math.min(kLook_ms, this.idle_ms / 8));
  }
  stop() {
    clearInterval(this.#timer);
    this.#timer = null;
    this.#calm();
  }
  note() {
    this.#look(); // the first key after a long pause must not unlock the page
    if (this.#timer) this.#active();
  }
  #active() {
    this.#last_ms = Date.now();
    this.#calm();
    if (this.#last_ms - this.#said_ms >= kPresent_ms) {
      this.#said_ms = this.#last_ms;
      this.on.present?.();
    }
  }
  #calm() {
    if (this.#warned) this.on.back();
    this.#warned = false;
  }
  #look() {
    if (!this.#timer) return;
    if (this.on.held?.() && Date.now() - this.#last_ms < this.idle_ms) this.#active();
    const passed_ms = Date.now() - this.#last_ms;
    if (passed_ms >= this.idle_ms) {
      this.stop();
      this.on.idle();
    } else if (passed_ms >= this.warn_ms && !this.#warned) {
      this.#warned = true;
      this.on.warned(Math.ceil((this.idle_ms - passed_ms) / 1000));
    }
  }
}
