// SPDX-License-Identifier: GPL-3.0-or-later
// The sheet on the page: one row per line of the rubric, the overall mark, a comment. Tab cycles within it,
// Esc leaves it.
import { field, h } from './dom.js';
import { ScoreRow } from './score_row.js';
import { kOverallRow } from './sheet_editor.js';
import { SheetKeys } from './sheet_keys.js';
import { t } from './texts.js';

const kLongestComment = 10000;

export class SheetView {
  readOnly = false;

  /// `on`: edited(), finish(), out(). `reasons`: null if every row must be scored; the sheet then has no
  /// comment.
  constructor(rubric, reasons, on) {
    this.on = on;
    this.scoresOnly = reasons === null;
    this.names = new Map(rubric.rows.map((row) => [row.code, row.label]));
    this.names.set(kOverallRow, t('Overall'));
    this.rows = rubric.rows.map((line) => this.#row({ ...line, reasons }));
    const overall = rubric.overall
      ? [this.#row({ code: kOverallRow, label: t('Overall'), scale: rubric.overall, reasons })]
      : [];
    this.rows.push(...overall);
    const { row: commentRow, input } = field(t('Comment for the trainee'), {
      id: 'comment', rows: '2', maxlength: kLongestComment, placeholder: t('What would help most next time?'),
      oninput: () => this.#edit(() => this.editor.setComment(this.comment.value)),
    }, 'textarea');
    this.comment = input;
    const wayOut = `Esc: ${t('Out of the sheet, to the button that submits')}`;
    this.element = h('section', { class: 'sheet', 'aria-label': t('Your sheet'), 'aria-description': wayOut },
      h('div', { class: 'rows' }, this.rows.filter((row) => !overall.includes(row)).map((row) => row.element)),
      h('div', { class: 'last-rows' }, overall.map((row) => row.element), this.scoresOnly ? null : commentRow));
    this.element.addEventListener('keydown', (event) => this.#wander(event));
  }
  /// The editor outlives the view.
  setEditor(editor) {
    this.editor = editor;
    const { advancing, current } = this.keys ?? {};
    this.keys = new SheetKeys(editor);
    this.keys.setAdvancing(advancing ?? false);
    if (current !== undefined) this.keys.mark(current);
    this.refresh();
  }
  setReadOnly(readOnly) {
    this.readOnly = readOnly;
    this.rows.forEach((row) => row.setReadOnly(readOnly));
    this.comment.readOnly = readOnly;
  }
  nameOf(code) {
    return this.names.get(code) ?? code;
  }
  /// Call after undo, redo or other outside changes.
  refresh() {
    for (const row of this.rows) {
      row.setAnswer(this.editor.answer(row.code));
      row.setCurrent(row.code === this.keys.current);
    }
    if (this.comment.value !== this.editor.comment) this.comment.value = this.editor.comment;
  }
  mark(code) {
    this.keys.mark(code);
    this.rows.forEach((row) => row.setCurrent(row.code === this.keys.current));
  }
  takeFocus() {
    this.rows.find((row) => row.code === this.keys.current)?.takeFocus();
  }
  undo() {
    if (!this.readOnly && this.editor.undo()) this.#changed();
  }
  redo() {
    if (!this.readOnly && this.editor.redo()) this.#changed();
  }
  setComment(text) {
    this.#edit(() => this.editor.setComment(text));
  }
  clearAll() {
    this.#edit(() => this.editor.clearAll());
  }

  /// Handles digits, arrows, N or X, Backspace, Delete. False: not a key of the sheet.
  key(event) {
    if (event.key === 'ArrowUp' || event.key === 'ArrowDown') {
      this.keys.step(event.key === 'ArrowUp' ? -1 : +1);
      this.takeFocus();
      return true;
    }
    if (this.readOnly) return false;
    if (/^[0-9]$/.test(event.key)) return this.#byKey(() => this.keys.digit(Number(event.key)));
    switch (event.key) {
      case 'ArrowLeft':
        return this.#byKey(() => this.keys.adjust(-1, event.shiftKey));
      case 'ArrowRight':
        return this.#byKey(() => this.keys.adjust(+1, event.shiftKey));
      case 'Backspace':
      case 'Delete':
        return this.#byKey(() => this.keys.clear());
      case 'n':
      case 'N':
      case 'x':
      case 'X':
        if (this.scoresOnly) return false;
        this.rows.find((row) => row.code === this.keys.current).askReason();
        return true;
      default:
        return false;
    }
  }
  #byKey(change) {
    const before = this.keys.current;
    this.#edit(change);
    this.mark(this.keys.current);
    if (before !== this.keys.current) this.takeFocus();
    return true;
  }

  #row(line) {
    const { code } = line;
    return new ScoreRow(line, {
      wanted: () => this.mark(code),
      finished: () => this.takeFocus(),
      scored: (steps) => {
        this.#edit(() => this.keys.choose(code, steps));
        this.mark(this.keys.current);
        this.takeFocus();
      },
      adjusted: (direction) => {
        this.mark(code);
        this.#edit(() => this.keys.adjust(direction));
      },
      reasoned: (reason) => this.#edit(() => this.editor.setNotAssessable(code, reason)),
      takenBack: ({ score_steps: steps, not_assessable: reason }) =>
        this.#edit(() => (steps !== null ? this.editor.setScore(code, steps) : this.editor.setNotAssessable(code, reason))),
    });
  }
  #edit(change) {
    if (!this.readOnly && change()) this.#changed();
  }
  #changed() {
    this.refresh();
    this.on.edited();
  }
  #wander(event) {
    if (event.ctrlKey || event.altKey || event.metaKey || event.isComposing) return;
    if (event.key === 'Escape') {
      event.preventDefault();
      event.stopPropagation();
      if (event.target === this.comment) {
        this.takeFocus();
      } else {
        this.on.out();
      }
      return;
    }
    if (event.key !== 'Tab') return;
    const stops = this.rows.map((row) => row.strip);
    if (!this.scoresOnly) stops.push(this.comment);
    const row = this.rows.find((one) => one.holds(event.target));
    const at = stops.indexOf(row ? row.strip : event.target);
    if (at < 0) return;
    event.preventDefault();
    stops[(at + (event.shiftKey ? stops.length - 1 : 1)) % stops.length].focus();
  }
}
