// SPDX-License-Identifier: GPL-3.0-or-later
// Saves the changes of a sheet to the server, one request at a time, always the newest version, with a
// truthful state. Independent of page and network: `put` sends, `wait` sleeps.
import { NoConnection } from './api.js';
import { sameMarks } from './sheet_editor.js';

const kFirstWait_ms = 500;
const kLongestWait_ms = 15_000;

/// State: 'idle' (no change yet), 'saving', 'saved', 'waiting' (failed, will retry), 'signed_out' (until
/// resume()), 'conflict' (until takeNewer() or keepMine()), 'refused' (see `problem`; the next change tries
/// again).
export class DraftKeeper {
  state = 'idle';
  problem = null;
  newer = null; // the server's sheet during a conflict
  #put;
  #wait;
  #onChange;
  #onSaved;
  #pending = null; // returns the newest sheet
  #running = null;
  #lost = []; // sheets sent without an answer: they may have arrived
  #wake = () => {};

  /// `put(sheet)`: promise of {revision, check}, or throws Refusal, NoConnection. `onSaved(answer)`: called
  /// before the state changes. `wait(ms)`: promise.
  constructor({ put, onSaved, onChange, wait = (ms) => new Promise((done) => setTimeout(done, ms)) }) {
    this.#put = put;
    this.#wait = wait;
    this.#onSaved = onSaved;
    this.#onChange = onChange;
  }

  /// True if there are changes that the server does not have.
  get unsaved() {
    return this.#pending !== null || this.#running !== null;
  }
  /// For onSaved(): true if nothing changed since the sheet just saved.
  get newest() {
    return this.#pending === null;
  }
  /// `sheet()`: called right before each attempt, so that it returns the newest marks and revision.
  change(sheet) {
    this.#pending = sheet;
    if (this.state === 'conflict' || this.state === 'signed_out') return;
    this.#start();
  }
  /// Call after signing in again or when the network is back.
  resume() {
    this.#wake();
    if (this.state === 'signed_out') {
      this.#tell(this.#pending ? 'saving' : 'saved');
      this.#start();
    }
  }
  /// Resolves a conflict with the server's sheet.
  takeNewer() {
    this.#pending = null;
    this.newer = null;
    this.#tell('saved');
  }
  /// Resolves a conflict with the local marks as next revision.
  keepMine(sheet) {
    this.newer = null;
    this.#tell('saving');
    this.change(sheet);
  }
  /// Resolves when no request is pending; true if the server has the newest sheet. A failed attempt ends the
  /// wait.
  async settled() {
    while (this.#running && this.state === 'saving') await Promise.race([this.#running, this.#nextState()]);
    return !this.unsaved;
  }
  /// Stops saving, as another page takes over or the sheet was submitted. Resolves when no request is
  /// pending.
  async stop() {
    this.#pending = null;
    this.#wake();
    await this.#running;
  }

  #watchers = [];
  #nextState() {
    return new Promise((done) => this.#watchers.push(done));
  }
  #tell(state, problem = null) {
    this.state = state;
    this.problem = problem;
    this.#watchers.splice(0).forEach((done) => done());
    this.#onChange(this);
  }
  #start() {
    if (this.#running || !this.#pending) return;
    this.#running = this.#run().finally(() => {
      this.#running = null;
      if (this.#pending && this.state === 'saved') this.#start();
    });
  }
  async #run() {
    let wait_ms = kFirstWait_ms;
    while (this.#pending) {
      const taken = this.#pending;
      this.#tell(this.state === 'waiting' ? 'waiting' : 'saving');
      const sheet = taken();
      try {
        const answer = await this.#put(sheet);
        if (this.#pending === taken) this.#pending = null;
        wait_ms = kFirstWait_ms;
        this.#lost = [];
        this.#onSaved(answer);
        this.#tell(this.#pending ? 'saving' : 'saved');
      } catch (error) {
        if (this.#arrived(error, sheet)) continue;
        if (error instanceof NoConnection) this.#lost.push(sheet);
        if (!this.#willRetry(error)) return;
        const pause = new Promise((done) => (this.#wake = done));
        await Promise.race([this.#wait(Math.max(wait_ms, 1000 * (error.wait_s ?? 0))), pause]);
        wait_ms = Math.min(2 * wait_ms, kLongestWait_ms);
      }
    }
  }
  /// True if the server's newer sheet equals ours, or one of ours whose answer was lost: no conflict; adopts
  /// its revision.
  #arrived(error, sheet) {
    const newer = error.status === 409 ? error.body.sheet : null;
    if (!newer || ![sheet, ...this.#lost].some((sent) => sameMarks(sent, newer))) return false;
    this.#lost = [];
    this.#onSaved({ revision: newer.revision, check: null });
    return true;
  }
  /// True if the same request is to be retried.
  #willRetry(error) {
    if (error instanceof NoConnection || error.isTransient) {
      this.#tell('waiting', error);
      return true;
    }
    if (error.status === 409 && error.body.sheet) {
      this.newer = error.body.sheet;
      this.#tell('conflict', error);
    } else if (error.needsSignIn) {
      this.#tell('signed_out', error);
    } else {
      this.#tell('refused', error);
    }
    return false;
  }
}
