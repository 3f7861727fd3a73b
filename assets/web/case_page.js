// SPDX-License-Identifier: GPL-3.0-or-later
// One case: the recording at the left, the sheet at the right, each keystroke on its way to the server.
import { api, NoConnection } from './api.js';
import { askConflict } from './dialogs.js';
import { DraftKeeper } from './draft_keeper.js';
import { button, h, say, show } from './dom.js';
import { keysHelp } from './keys_help.js';
import { clockTime, dayText } from './numbers.js';
import { Player } from './player.js';
import { problemText } from './problem.js';
import { RemarksView } from './remarks_view.js';
import { SheetEditor } from './sheet_editor.js';
import { SheetView } from './sheet_view.js';
import { SubmitBar } from './submit_bar.js';
import { t } from './texts.js';
import { dropUnsaved, keepUnsaved, unsavedSheet } from './unsaved.js';
import { ViewingReporter } from './viewing_reporter.js';

/// Drafts of cases that were left and are still on their way: path -> keeper.
const underway = new Map();

export class CasePage {
  element = h('div', { class: 'case-page' });

  constructor(frame, handle) {
    this.frame = frame;
    this.path = `/api/cases/${encodeURIComponent(handle)}`;
  }
  get title() {
    return this.opened ? t('Case %1', this.opened.label) : t('Case');
  }
  get sealed() {
    return this.opened.state === 'submitted';
  }
  get unsaved() {
    return Boolean(this.opened) && (this.keeper.unsaved || this.remarks.unsaved || this.bar.amending);
  }

  async load() {
    await underway.get(this.path)?.stop();
    underway.delete(this.path);
    this.opened = await api.get(this.path);
    this.check = this.opened.check;
    const kept = this.sealed ? null : unsavedSheet(this.frame.login, this.opened.label);
    this.editor = new SheetEditor(this.opened.rubric, kept ?? this.opened.sheet);
    this.#build();
    if (kept) this.#save();
    this.view.takeFocus();
    await this.#openRecording();
  }

  #build() {
    const { opened } = this;
    this.keeper = new DraftKeeper({
      put: (sheet) => api.put(`${this.path}/sheet`, sheet),
      onSaved: (answer) => this.#saved(answer),
      onChange: () => this.#showSaved(),
    });
    this.reporter = new ViewingReporter({
      post: (body, options) => api.post(`${this.path}/viewing`, body, options),
      onAnswer: (answer, unheard) => this.#viewed(answer, unheard),
    });
    this.view = new SheetView(opened.rubric, opened.reasons, {
      edited: () => this.#edited(),
      out: () => this.bar.cancel() || this.bar.takeFocus(),
    });
    this.view.setEditor(this.editor);
    this.view.setReadOnly(this.sealed);
    this.player = new Player(this.path, opened, {
      played: (stretch) => this.#played(stretch),
      paused: () => this.reporter.report(),
    });
    this.remarks = new RemarksView(opened.remarks, this.#remarkStore(), this.player, () => this.view.takeFocus());
    this.bar = new SubmitBar(this);
    const right = h('div', { class: 'right' }, this.view.element, this.bar.element);
    const left = h('div', { class: 'left' }, this.player.element, this.remarks.element);
    this.element.replaceChildren(this.#head(), h('div', { class: 'halves' }, left, right), keysHelp());
    this.#showHistory();
    if (opened.state === 'draft') say(this.savedText, t('Draft found and opened'));
  }
  #head() {
    const { opened } = this;
    const facts = [];
    if (!opened.live) facts.push(t('%1 long', clockTime(opened.length_us)));
    if (this.sealed) facts.push(t('submitted and sealed'));
    if (opened.versions.length > 1) facts.push(t('version %1', opened.versions.at(-1).version));
    this.savedText = h('span', { class: 'saved', role: 'status' });
    this.undoButton = button(t('Undo'), () => this.view.undo(), { class: 'undo' });
    this.redoButton = button(t('Redo'), () => this.view.redo(), { class: 'redo' });
    this.clearButton = button(t('Clear'), () => this.view.clearAll(), {
      title: t('Takes every mark, reason and comment away; Undo brings them back'),
    });
    const advance = h('input', { type: 'checkbox', onchange: () => this.view.keys.setAdvancing(advance.checked) });
    return h('div', { class: 'case-head' },
      h('h1', {}, t('Case %1', opened.label)),
      h('span', { class: 'quiet facts', title: versionsText(opened.versions) }, facts.join('  \u00b7  ')),
      this.savedText,
      h('div', { class: 'actions' },
        h('label', { class: 'check-label', title: t('After each figure the next row is marked by itself') }, advance, t('Auto-advance')),
        this.undoButton, this.redoButton, this.clearButton));
  }
  async #openRecording() {
    if (this.opened.live) {
      say(this.player.sentence, t('This case is scored live; there is no recording.'));
      return;
    }
    try {
      await this.player.load();
      this.player.setWatched(this.opened.watched, []);
      this.player.setBookmarks(this.remarks.remarks.map((one) => one.time_us));
    } catch (error) {
      const again = button(t('Try again'), () => this.#openRecording());
      this.player.sentence.replaceChildren(`${t('The recording could not be opened.')} ${problemText(error)} `, again);
    }
  }

  // The draft.
  #edited() {
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
  }
  #showSaved() {
    const { state, problem } = this.keeper;
    const texts = {
      idle: '',
      saving: t('Saving \u2026'),
      saved: t('Saved'),
      waiting: t('Not saved yet, trying again'),
      signed_out: t('Not saved yet: sign in again'),
      conflict: t('Not saved: the sheet was changed elsewhere'),
      refused: t('Not saved: %1', problem ? problem.message : ''),
    };
    say(this.savedText, texts[state]);
    this.savedText.classList.toggle('caution', !['idle', 'saving', 'saved'].includes(state));
    if (state === 'conflict') this.#askConflict();
  }
  async #askConflict() {
    this.player.pause();
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
    this.undoButton.title = undoable ? t('Undo %1 (Ctrl+Z)', this.#stepName(undoable)) : t('Nothing to undo');
    this.redoButton.title = redoable ? t('Redo %1 (Ctrl+Y)', this.#stepName(redoable)) : t('Nothing to redo');
  }
  #stepName({ kind, row }) {
    const name = this.view.nameOf(row);
    switch (kind) {
      case 'score':
        return t('mark of %1', name);
      case 'cleared':
        return t('clearing of %1', name);
      case 'not_assessable':
        return t('reason for %1', name);
      case 'comment':
        return t('comment');
      default:
        return t('clearing of the sheet');
    }
  }

  // Watching.
  #played(stretch) {
    this.frame.active();
    if (this.sealed) return;
    this.reporter.played(stretch);
    this.player.setWatched(this.opened.watched, this.reporter.unheard);
  }
  #viewed(answer, unheard) {
    this.opened.watched = answer.watched;
    this.check = answer.check;
    this.player.setWatched(answer.watched, unheard);
    this.bar.refresh();
  }

  /// Remarks at the server. A new one whose answer got lost is looked for before it is sent again.
  #remarkStore() {
    let doubtful = false;
    return {
      add: async (time_us, text) => {
        if (doubtful) {
          const { remarks } = await api.get(this.path);
          doubtful = false;
          if (remarks.some((one) => one.time_us === time_us && one.text === text)) return remarks;
        }
        try {
          return (await api.post(`${this.path}/remarks`, { time_us, text })).remarks;
        } catch (error) {
          doubtful = error instanceof NoConnection;
          throw error;
        }
      },
      edit: async (id, text) => (await api.put(`${this.path}/remarks/${encodeURIComponent(id)}`, { text })).remarks,
    };
  }

  // What SubmitBar asks of its page.
  /// Throws Refusal, NoConnection.
  async sendSubmit(password) {
    await this.reporter.report();
    await this.keeper.settled();
    if (this.doubtful && (await api.get(this.path)).state === 'submitted') return;
    try {
      this.answer = await api.post(`${this.path}/submit`, { sheet: this.editor.sheet, password });
    } catch (error) {
      this.doubtful = error instanceof NoConnection;
      if (error.status === 409 && error.body.sheet) this.#save(); // the keeper finds out and asks
      throw error;
    }
  }
  async submitted() {
    this.keeper.stop();
    this.reporter.stop();
    this.opened.state = 'submitted';
    dropUnsaved(this.frame.login, this.opened.label);
    this.frame.notify(t('Case %1 is submitted and sealed', this.opened.label));
    const next = this.answer ? this.answer.next : (await api.get('/api/queue')).next;
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
    return api.post(`${this.path}/amend`, { sheet: this.editor.sheet, reason, password });
  }
  amended() {
    this.frame.notify(t('The new version is sealed; the one before is kept'));
    this.frame.open(window.location.hash);
  }

  // What the frame asks of its page.
  pause() {
    this.player?.pause();
  }
  /// Before the page is left: what can be brought to the server is.
  async settle() {
    this.pause();
    await this.reporter?.report();
    await this.keeper?.settled();
  }
  left() {
    if (!this.opened) return;
    this.pause();
    this.reporter.close();
    if (this.keeper.unsaved) underway.set(this.path, this.keeper);
  }
  /// Somebody signed in again; the case may have another handle in the new session.
  async resume() {
    try {
      const { lines } = await api.get('/api/queue');
      const line = lines.find((one) => one.label === this.opened?.label);
      if (line) {
        this.path = `/api/cases/${encodeURIComponent(line.case)}`;
        this.player.path = this.path;
        window.history.replaceState(null, '', `#case/${encodeURIComponent(line.case)}`);
      }
    } catch (error) {
      this.frame.notify(problemText(error));
    }
    this.keeper.resume();
    this.reporter.report();
    if (this.keeper.state === 'conflict') this.#askConflict();
    this.bar.refresh();
  }
  key(event) {
    if (!this.view || event.isComposing || event.defaultPrevented) return;
    const typing = ['INPUT', 'TEXTAREA', 'SELECT'].includes(event.target.tagName) && event.target.type !== 'checkbox';
    if (this.#command(event) || (!typing && this.#plainKey(event))) event.preventDefault();
  }
  #command(event) {
    if (!(event.ctrlKey || event.metaKey) || event.altKey) return false;
    const key = event.key.toLowerCase();
    if (key === 'enter') {
      this.bar.go();
      return true;
    }
    // One history for the whole sheet; a remark keeps its own.
    if (event.target.tagName === 'INPUT' && !this.view.element.contains(event.target)) return false;
    if (key === 'z' && !event.shiftKey) {
      this.view.undo();
    } else if (key === 'y' || (key === 'z' && event.shiftKey)) {
      this.view.redo();
    } else {
      return false;
    }
    return true;
  }
  #plainKey(event) {
    if (event.ctrlKey || event.altKey || event.metaKey) return false;
    if (event.key === 'Escape') return this.bar.cancel();
    const pressesButton = event.target.closest('button, a, summary, [type=checkbox]') && event.key === ' ';
    if (pressesButton) return false;
    switch (event.key) {
      case 'b':
      case 'B':
        this.remarks.addBookmark();
        return true;
      case 'r':
        this.remarks.ask();
        return true;
      case 'R':
        this.remarks.editNearest();
        return true;
      default:
        return this.player.key(event) || this.view.key(event);
    }
  }
}

function versionsText(versions) {
  const line = ({ version, submitted_utc_us: day, reason }) =>
    reason ? t('Version %1, %2: %3', version, dayText(day), reason) : t('Version %1, %2', version, dayText(day));
  return versions.map(line).join('\n');
}
