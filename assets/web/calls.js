// SPDX-License-Identifier: GPL-3.0-or-later
// Follows the calls to the real arm: each request waits on the server until something changes.
import { api } from './api.js';

const kPatience_ms = 40_000; // the server answers after half a minute at the latest
const kFirstPause_ms = 500;
const kLongestPause_ms = 4000;

/// The rater's live sheets, newest state: `live` as /api/live returns it; null until known.
export class CallWatch {
  live = null;
  #run = 0;
  #away = false;
  #wake = () => {};

  /// `onChange(live)`: called for the first state, for each change, and when the server answers again. `onAway(since_ms)`:
  /// it has stopped answering; null: it answers again.
  constructor(onChange, onAway) {
    Object.assign(this, { onChange, onAway });
  }
  get goesOn() {
    return Boolean(this.live?.calls_go_on);
  }
  async start() {
    this.#run += 1;
    this.live = null;
    const run = this.#run;
    let pause_ms = kFirstPause_ms;
    while (run === this.#run) {
      try {
        const path = this.live && !this.#away ? `/api/live/${this.live.stamp}` : '/api/live';
        const live = await api.get(path, { patience_ms: kPatience_ms });
        if (run !== this.#run) return;
        pause_ms = kFirstPause_ms;
        if (this.#away) this.onAway(null);
        this.#away = false;
        if (live) {
          this.live = live;
          await this.onChange(live);
        }
      } catch (error) {
        if (error.needsSignIn || error.status === 403) return; // start() is called again after signing in
        if (run !== this.#run) return;
        if (!this.#away) this.onAway(Date.now());
        this.#away = true;
        await new Promise((done) => {
          this.#wake = done;
          setTimeout(done, pause_ms);
        });
        pause_ms = Math.min(2 * pause_ms, kLongestPause_ms);
      }
    }
  }
  stop() {
    this.#run += 1;
    this.live = null;
  }
  /// Call when the network is back.
  resume() {
    this.#wake();
  }
}
