// SPDX-License-Identifier: GPL-3.0-or-later
// Brings each change of a sheet to the server: one request at a time, the newest sheet wins, and what it says of
// itself is true. Knows no page and no network: `put` sends, `wait` sleeps.
import { NoConnection } from './api.js';
import { sameMarks } from './sheet_editor.js';

const kFirstWait_ms = 500;
const kLongestWait_ms = 15_000;

/// State: 'idle' (nothing was changed yet), 'saving', 'saved', 'waiting' (tried in vain, will try again),
/// 'signed_out' (waits for resume()), 'conflict' (waits for takeNewer() or keepMine()), 'refused' (`problem` says
/// why; the next change tries again).
export class DraftKeeper {
  state = 'idle';
  problem = null;
  newer = null; // the sheet of the server, in a conflict
  #put;
  #wait;
  #onChange;
  #onSaved;
  #pending = null; // a function that makes the newest sheet
  #running = null;
  #lost = []; // sheets that were sent and never answered for: they may have arrived
  #wake = () => {};

  /// `put(sheet)`: promise of {revision, check}, or throws Refusal, NoConnection. `onSaved(answer)`: before the
  /// state is told. `wait(ms)`: promise.
  constructor({ put, onSaved, onChange, wait = (ms) => new Promise((done) => setTimeout(done, ms)) }) {
    this.#put = put;
    this.#wait = wait;
    this.#onSaved = onSaved;
    this.#onChange = onChange;
  }

  /// Something typed is not at the server yet.
  get unsaved() {
    return this.#pending !== null || this.#running !== null;
  }
  /// For onSaved(): nothing was changed since the sheet that was just saved.
  get newest() {
    return this.#pending === null;
  }
  /// `sheet()`: asked right before each try, so that it carries the newest marks and revision.
  change(sheet) {
    this.#pending = sheet;
    if (this.state === 'conflict' || this.state === 'signed_out') return;
    this.#start();
  }
  /// Somebody signed in again, or the network came back.
  resume() {
    this.#wake();
    if (this.state === 'signed_out') {
      this.#tell(this.#pending ? 'saving' : 'saved');
      this.#start();
    }
  }
  /// Answers a conflict: the sheet of the server stands.
  takeNewer() {
    this.#pending = null;
    this.newer = null;
    this.#tell('saved');
  }
  /// Answers a conflict: the marks here become the next revision.
  keepMine(sheet) {
    this.newer = null;
    this.#tell('saving');
    this.change(sheet);
  }
  /// When nothing is on its way any more; true when the newest sheet is at the server. Does not wait for the
  /// network: a try in vain ends it.
  async settled() {
    while (this.#running && this.state === 'saving') await Promise.race([this.#running, this.#nextState()]);
    return !this.unsaved;
  }
  /// No more tries: another page takes over, or the sheet was sealed. Resolves when nothing is under way.
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
        if (!this.#goesOn(error)) return;
        const pause = new Promise((done) => (this.#wake = done));
        await Promise.race([this.#wait(Math.max(wait_ms, 1000 * (error.wait_s ?? 0))), pause]);
        wait_ms = Math.min(2 * wait_ms, kLongestWait_ms);
      }
    }
  }
  /// The newer sheet of the server says what ours says, or is one of ours whose answer got lost: no conflict, on
  /// with its revision.
  #arrived(error, sheet) {
    const newer = error.status === 409 ? error.body.sheet : null;
    if (!newer || ![sheet, ...this.#lost].some((sent) => sameMarks(sent, newer))) return false;
    this.#lost = [];
    this.#onSaved({ revision: newer.revision, check: null });
    return true;
  }
  /// Whether the same request is tried again after a while.
  #goesOn(error) {
    if (error instanceof NoConnection || error.passes) {
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
