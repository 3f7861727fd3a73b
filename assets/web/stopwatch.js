// SPDX-License-Identifier: GPL-3.0-or-later
// A timer that a rater starts and stops beside a live sheet.
import { button, h, say } from './dom.js';
import { clockTime } from './numbers.js';
import { t } from './texts.js';

const kTick_ms = 200;

export class Stopwatch {
  #total_ms = 0;
  #since_ms = null;
  #timer = null;

  constructor() {
    this.time = h('span', { class: 'time', role: 'timer' }, clockTime(0));
    this.start = button(t('Start the timer'), () => this.#toggle());
    this.write = button(t('Note the time'), () => this.onWrite?.(t('Time taken: %1', clockTime(1000 * this.ms))));
    this.element = h('span', { class: 'stopwatch' }, this.time, this.start, this.write);
    this.#show();
  }
  get running() {
    return this.#since_ms !== null;
  }
  get ms() {
    return this.#total_ms + (this.running ? performance.now() - this.#since_ms : 0);
  }
  reset() {
    this.#total_ms = 0;
    this.#since_ms = null;
    this.#show();
  }
  setEnabled(enabled) {
    this.start.disabled = !enabled;
    this.enabled = enabled;
    this.#show();
  }
  #toggle() {
    if (this.running) {
      this.#total_ms = this.ms;
      this.#since_ms = null;
    } else {
      this.#since_ms = performance.now();
    }
    this.#show();
  }
  #show() {
    clearInterval(this.#timer);
    if (this.running) this.#timer = setInterval(() => say(this.time, clockTime(1000 * this.ms)), kTick_ms);
    say(this.time, clockTime(1000 * this.ms));
    say(this.start, this.running ? t('Stop the timer') : t('Start the timer'));
    this.write.disabled = this.enabled === false || this.running || this.ms === 0;
  }
}
