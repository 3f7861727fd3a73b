// SPDX-License-Identifier: GPL-3.0-or-later
// Reports every two seconds what was played; the server decides what counts. Independent of the page.
import { NoConnection } from './api.js';

const kEvery_ms = 2000;

export class ViewingReporter {
  #unreported = []; // not sent yet
  #sent = [];    // under way
  #last_ms = 0;
  #stopped = false;

  /// `post(body, options)`: promise of the server's answer. `onAnswer(answer, unreported)`.
  constructor({ post, onAnswer, now = () => performance.now() }) {
    Object.assign(this, { post, onAnswer, now });
    this.#last_ms = now();
  }
  /// Stretches not yet acknowledged by the server.
  get unreported() {
    return [...this.#sent, ...this.#unreported];
  }
  /// Call as the recording plays; reports when due.
  played(stretch) {
    const last = this.#unreported.at(-1);
    if (last && last.to_us === stretch.from_us && last.speed === stretch.speed) {
      last.to_us = stretch.to_us;
    } else if (stretch.to_us > stretch.from_us) {
      this.#unreported.push({ ...stretch });
    }
    if (this.now() - this.#last_ms >= kEvery_ms) this.report();
  }
  /// Reports now, on pausing or submitting. Never throws; what failed is sent with the next report.
  async report() {
    while (this.underway) await this.underway;
    if (this.#stopped || this.#unreported.length === 0) return;
    this.underway = this.#send();
    await this.underway;
  }
  /// Sends the last stretches without waiting for an answer, when the page is closed.
  close() {
    if (this.#stopped) return;
    this.#stopped = true;
    this.post({ played: this.#unreported, open: false }, { last: true, quiet: true }).catch(() => {});
  }
  /// Stops reporting once the sheet is submitted.
  stop() {
    this.#stopped = true;
  }

  async #send() {
    this.#last_ms = this.now();
    this.#sent = this.#unreported;
    this.#unreported = [];
    try {
      const answer = await this.post({ played: this.#sent, open: true });
      this.#sent = [];
      this.onAnswer(answer, this.unreported);
    } catch (error) {
      const again = error instanceof NoConnection || error.isTransient || error.needsSignIn;
      if (again) this.#unreported = [...this.#sent, ...this.#unreported];
      this.#sent = [];
    } finally {
      this.underway = null;
    }
  }
}
