// SPDX-License-Identifier: GPL-3.0-or-later
// Tells the server every two seconds what was played. The server decides what of it counts. Knows no page.
import { NoConnection } from './api.js';

const kEvery_ms = 2000;

export class ViewingReporter {
  #unheard = []; // not sent yet
  #sent = [];    // under way
  #last_ms = 0;
  #stopped = false;

  /// `post(body, options)`: promise of the server's answer. `onAnswer(answer, unheard)`.
  constructor({ post, onAnswer, now = () => performance.now() }) {
    Object.assign(this, { post, onAnswer, now });
    this.#last_ms = now();
  }
  /// Stretches that the server has not answered for yet.
  get unheard() {
    return [...this.#sent, ...this.#unheard];
  }
  /// The recording went on; reports where it is time.
  played(stretch) {
    const last = this.#unheard.at(-1);
    if (last && last.to_us === stretch.from_us && last.speed === stretch.speed) {
      last.to_us = stretch.to_us;
    } else if (stretch.to_us > stretch.from_us) {
      this.#unheard.push({ ...stretch });
    }
    if (this.now() - this.#last_ms >= kEvery_ms) this.report();
  }
  /// Now: it was paused, or the sheet is submitted. Never throws; what was not heard is sent with the next one.
  async report() {
    while (this.underway) await this.underway;
    if (this.#stopped || this.#unheard.length === 0) return;
    this.underway = this.#send();
    await this.underway;
  }
  /// The page is left: the last stretches, without waiting for an answer.
  close() {
    if (this.#stopped) return;
    this.#stopped = true;
    this.post({ played: this.#unheard, open: false }, { last: true, quiet: true }).catch(() => {});
  }
  /// The sheet is sealed: nothing counts any more.
  stop() {
    this.#stopped = true;
  }

  async #send() {
    this.#last_ms = this.now();
    this.#sent = this.#unheard;
    this.#unheard = [];
    try {
      const answer = await this.post({ played: this.#sent, open: true });
      this.#sent = [];
      this.onAnswer(answer, this.unheard);
    } catch (error) {
      const again = error instanceof NoConnection || error.passes || error.needsSignIn;
      if (again) this.#unheard = [...this.#sent, ...this.#unheard];
      this.#sent = [];
    } finally {
      this.underway = null;
    }
  }
}
