// SPDX-License-Identifier: GPL-3.0-or-later
// One case: recording on the left, sheet on the right; every change is saved to the server.
import { api, NoConnection, Refusal } from './api.js';
import { pressKey } from './case_keys.js';
import { stepName, versionsText } from './case_labels.js';
import { rememberAdvancing, remembersAdvancing } from './habits.js';
import { askConflict } from './dialogs.js';
import { DraftKeeper } from './draft_keeper.js';
import { button, h } from './dom.js';
import { letGoOn, stopDraft } from './drafts_underway.js';
import { keysHelp } from './keys_help.js';
import { clockTenths, joinedSentences } from './numbers.js';
import { Player } from './player.js';
import { problemText } from './problem.js';
import { remarkStore } from './remark_store.js';
import { RemarksView } from './remarks_view.js';
import { SaveStatus } from './save_status.js';
import { shownPassword } from './signing.js';
import { SheetEditor } from './sheet_editor.js';
import { SheetView } from './sheet_view.js';
import { SubmitBar } from './submit_bar.js';
import { t } from './texts.js';
import { dropUnsaved, keepUnsaved, unsavedSheet } from './unsaved.js';
import { ViewingReporter } from './viewing_reporter.js';

export class CasePage {
  element = h('div', { class: 'case-page' });
  status = new SaveStatus();

  /// `watch`: the timer of a live sheet on its page; without it, the case has the whole window.
  constructor(frame, handle, { watch = null } = {}) {
    this.frame = frame;
    this.watch = watch;
    this.#useHandle(handle);
  }
  #useHandle(handle) {
    this.handle = handle;
    this.path = `/api/cases/${encodeURIComponent(handle)}`;
  }
  get title() {
    return this.opened ? t('Case %1', this.opened.label) : t('Case');
  }
  get sealed() {
    return this.opened.state === 'submitted';
  }
  get unsaved() {
    return Boolean(this.keeper) && (this.keeper.unsaved || Boolean(this.remarks?.unsaved) || this.bar.amending);
  }

  async load() {
    await stopDraft(this.path);
    this.opened = await this.#open();
    this.check = this.opened.check;
    const kept = this.sealed ? null : unsavedSheet(this.frame.login, this.opened.label);
    this.editor = new SheetEditor(this.opened.rubric, kept ?? this.opened.sheet);
    this.#build();
    if (kept) this.#save();
    this.view.takeFocus();
    if (this.player) this.#openRecording(); // takes a while; the sheet is usable meanwhile
  }

  /// A new session uses other handles: find the case in the queue by its label.
  async #open() {
    try {
      const opened = await api.get(this.path);
      if (!this.watch) window.history.replaceState({ label: opened.label }, '');
      return opened;
    } catch (error) {
      const label = this.watch ? null : window.history.state?.label;
      if (!label || ![403, 404].includes(error.status) || !(await this.#follow(label))) throw error;
      return api.get(this.path);
    }
  }
  /// Adopts the current handle of the case with this label. False: not in the queue.
  async #follow(label) {
    const { lines } = await api.get(this.watch ? '/api/live' : '/api/queue');
    const line = lines.find((one) => one.label === label);
    if (!line) return false;
    this.#useHandle(line.case);
    if (this.player) this.player.path = this.path;
    if (!this.watch) window.history.replaceState({ label }, '', `#case/${encodeURIComponent(line.case)}`);
    return true;
  }

  #build() {
    const { opened } = this;
    this.keeper = new DraftKeeper({
      put: (sheet) => api.put(`${this.path}/sheet`, sheet),
      onSaved: (answer) => this.#saved(answer),
      onChange: (keeper) => {
        this.status.show(keeper);
        if (keeper.state === 'conflict') this.#askConflict();
      },
    });
    this.reporter = new ViewingReporter({
      post: (body, options) => api.post(`${this.path}/viewing`, body, options),
      onAnswer: (answer, unreported) => this.#viewed(answer, unreported),
    });
    this.view = new SheetView(opened.rubric, opened.reasons ?? [], {
      edited: () => this.#edited(),
      out: () => this.bar.cancel() || this.bar.takeFocus(),
    });
    this.view.setEditor(this.editor);
    this.view.setReadOnly(this.sealed);
    if (this.sealed) this.reporter.stop();
    this.bar = new SubmitBar(this);
    const right = h('div', { class: 'right' }, this.view.element, this.bar.element);
    if (opened.live) {
      this.#useWatch();
      this.element.replaceChildren(this.#head(), right);
    } else {
      this.player = new Player(this.path, opened, {
        played: (stretch) => this.#played(stretch),
        paused: () => this.reporter.report(),
      });
      this.remarks = new RemarksView(opened.remarks, remarkStore(() => this.path), this.player, () => this.view.takeFocus());
      const left = h('div', { class: 'left' }, this.player.element, this.remarks.element);
      this.keys = keysHelp();
      this.element.replaceChildren(this.#head(), h('div', { class: 'halves' }, left, right), this.keys);
    }
    this.#showHistory();
    if (opened.state === 'draft') this.status.say(t('Draft found and opened'));
  }
  #useWatch() {
    if (!this.watch) return;
    this.watch.setEnabled(!this.sealed);
    this.watch.onWrite = (text) => {
      const { comment } = this.editor;
      this.view.setComment(comment === '' || comment.endsWith('\n') ? comment + text : `${comment}\n${text}`);
    };
  }
  #head() {
    const { opened } = this;
    const facts = opened.live ? [] : [t('%1 long', clockTenths(opened.length_us))];
    if (this.sealed) facts.push(t('submitted and sealed'));
    if (opened.versions.length > 1) facts.push(t('version %1', opened.versions.at(-1).version));
    this.undoButton = button(t('Undo'), () => this.view.undo(), { class: 'undo' });
    this.redoButton = button(t('Redo'), () => this.view.redo(), { class: 'redo' });
    this.clearButton = button(t('Clear'), () => this.view.clearAll(), {
      title: t('Removes every mark, reason and comment; Undo brings them back'),
    });
    const advance = h('input', {
      type: 'checkbox', checked: remembersAdvancing(),
      onchange: () => {
        this.view.keys.setAdvancing(advance.checked);
        rememberAdvancing(advance.checked);
      },
    });
    this.view.keys.setAdvancing(advance.checked);
    return h('div', { class: 'case-head' },
      h('h1', {}, t('Case %1', opened.label)),
      h('span', { class: 'quiet facts', title: versionsText(opened.versions) }, facts.join('  \u00b7  ')),
      this.status.element,
      this.watch?.element ?? null,
      h('div', { class: 'actions' },
        h('label', { class: 'check-label', title: t('After each mark the next row is selected automatically') }, advance, t('Auto-advance')),
        this.undoButton, this.redoButton, this.clearButton));
  }
  async #openRecording() {
    try {
      await this.player.load();
      this.player.setWatched(this.opened.watched, []);
      this.player.setBookmarks(this.remarks.remarks.map((one) => one.time_us));
    } catch (error) {
      const again = button(t('Try again'), () => this.#openRecording());
      const why = error instanceof NoConnection || error instanceof Refusal ? problemText(error) : '';
      this.player.sentence.replaceChildren(`${joinedSentences([t('The recording could not be opened.'), why])} `, again);
    }
  }

  // The draft.
  #edited() {
    this.awaitsTouch = false;
    if (!this.bar.amending) this.#save();
    this.bar.edited();
    this.#showHistory();
  }
  #save() {
    keepUnsaved(this.frame.login, this.opened.label, this.editor.sheet);
    this.keeper.change(() => this.editor.sheet);
  }
  #saved({ revision, check }) {
    this.editor.revision = revision;
    this.opened.state = 'draft';
    if (check) this.check = check;
    if (this.keeper.newest) dropUnsaved(this.frame.login, this.opened.label);
    this.bar.refresh();
    this.frame.saved?.();
  }
  async #askConflict() {
    this.pause();
    const { newer } = this.keeper;
    const { rubric } = this.opened;
    const answer = await askConflict({ mine: this.editor.sheet, newer, rubric, nameOf: (code) => this.view.nameOf(code) });
    if (answer === 'newer') {
      this.editor = new SheetEditor(rubric, newer);
      this.view.setEditor(this.editor);
      dropUnsaved(this.frame.login, this.opened.label);
      this.keeper.takeNewer();
    } else if (answer === 'mine') {
      this.editor.revision = newer.revision;
      this.keeper.keepMine(() => this.editor.sheet);
    }
    this.bar.edited();
    this.#showHistory();
    this.view.takeFocus();
  }
  #showHistory() {
    const open = !this.sealed || this.bar.amending;
    const { undoable, redoable } = this.editor;
    this.undoButton.disabled = !open || !undoable;
    this.redoButton.disabled = !open || !redoable;
    this.clearButton.disabled = !open;
    this.undoButton.title = undoable ? t('Undo %1 (Ctrl+Z)', stepName(undoable, this.view)) : t('Nothing to undo');
    this.redoButton.title = redoable ? t('Redo %1 (Ctrl+Y)', stepName(redoable, this.view)) : t('Nothing to redo');
  }
  // Watching.
  #played(stretch) {
    this.frame.active();
    if (this.sealed) return;
    this.reporter.played(stretch);
    this.player.setWatched(this.opened.watched, this.reporter.unreported);
  }
  #viewed(answer, unreported) {
    this.opened.watched = answer.watched;
    this.check = answer.check;
    this.player.setWatched(answer.watched, unreported);
    this.bar.refresh();
  }

  // Interface for SubmitBar. Throws Refusal, NoConnection.
  /// Brings `check` up to date before the rater is asked.
  async freshCheck() {
    await this.reporter.report();
    if (!this.opened.live) return;
    await this.keeper.settled();
    this.check = (await api.get(this.path)).check; // how long ago the trainee was called
  }
  async sendSubmit(password) {
    await this.reporter.report();
    await this.keeper.settled();
    if (this.doubtful && (await api.get(this.path)).state === 'submitted') return;
    try {
      this.answer = await api.post(`${this.path}/submit`, { sheet: this.editor.sheet, ...shownPassword(password) });
    } catch (error) {
      this.doubtful = error instanceof NoConnection;
      if (error.status === 409) this.#save(); // the keeper handles the conflict
      throw error;
    }
  }
  submitted() {
    this.keeper.stop();
    this.reporter.stop();
    this.opened.state = 'submitted';
    dropUnsaved(this.frame.login, this.opened.label);
    this.frame.notify(t('Case %1 is submitted and sealed', this.opened.label));
    const next = this.answer?.next;
    this.frame.open(next ? `#case/${encodeURIComponent(next)}` : '#');
  }
  beginAmending() {
    this.view.setReadOnly(false);
    this.#showHistory();
  }
  endAmending() {
    this.editor = new SheetEditor(this.opened.rubric, this.opened.sheet);
    this.view.setEditor(this.editor);
    this.view.setReadOnly(true);
    this.#showHistory();
  }
  sendAmend(reason, password) {
    return api.post(`${this.path}/amend`, { sheet: this.editor.sheet, reason, ...shownPassword(password) });
  }
  amended() {
    this.frame.notify(t('The new version is sealed; the one before is kept'));
    this.frame.open(window.location.hash);
  }

  /// Ignores Ctrl+Enter until the sheet is touched: it may have been meant for the one before.
  waitForTouch() {
    this.awaitsTouch = true;
  }

  // Interface for the frame.
  /// Call when the network is back.
  online() {
    this.keeper?.resume();
  }
  pause() {
    this.player?.pause();
  }
  /// Called before the page is left: saves whatever it can.
  async settle() {
    this.pause();
    await this.reporter?.report();
    await this.keeper?.settled();
  }
  left() {
    if (!this.keeper) return;
    this.pause();
    this.reporter.close();
    if (this.keeper.unsaved) letGoOn(this.path, this.keeper);
  }
  /// Called after signing in again; the case may have another handle.
  async resume() {
    try {
      await this.#follow(this.opened.label);
    } catch (error) {
      this.frame.notify(problemText(error));
    }
    this.keeper.resume();
    this.reporter.report();
    if (this.keeper.state === 'conflict') this.#askConflict();
    this.bar.refresh();
  }
  key(event) {
    if (!this.view) return;
    if (this.awaitsTouch && event.key === 'Enter' && (event.ctrlKey || event.metaKey)) {
      event.preventDefault();
      this.frame.notify(t('This is the next case. Change its sheet first'));
      return;
    }
    pressKey(this, event);
  }
}
