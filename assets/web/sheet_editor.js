// SPDX-License-Identifier: GPL-3.0-or-later
// A sheet being edited, with undo and redo; mirrors app/services/review/sheet_editor.h. Independent of the
// page.

/// Code of the overall mark among the rows.
export const kOverallRow = '';

function isOnScale(steps, scale) {
  return Number.isInteger(steps) && steps >= scale.lowest_steps && steps <= scale.highest_steps;
}

/// Interprets a digit on a scale: 7 is seven points; 1 then 0 is ten; a lone 0 is zero, or ten on a scale
/// that begins above zero. `typed`: points typed so far in this row, or null. Null: no such score.
export function stepsForDigit(scale, digit, typed) {
  const within = (points) => {
    const steps = points * scale.steps_per_point;
    return isOnScale(steps, scale) ? steps : null;
  };
  if (typed !== null && typed > 0) {
    const longer = within(typed * 10 + digit);
    if (longer !== null) return longer;
  }
  if (digit === 0 && within(0) === null) return within(10);
  return within(digit);
}

function sameAnswer(a, b) {
  return a.score_steps === b.score_steps && a.not_assessable === b.not_assessable;
}

function given(answer) {
  return answer.score_steps !== null || answer.not_assessable !== '';
}

/// True if two sheets have the same content, whatever their revisions.
export function sameMarks(a, b) {
  const answers = (sheet) => {
    const rows = sheet.rows.map((row) => [row.code, row.score_steps, row.not_assessable]);
    return JSON.stringify([rows.sort(), sheet.overall_steps, sheet.overall_not_assessable ?? '', sheet.comment]);
  };
  return answers(a) === answers(b);
}

export class SheetEditor {
  #states;
  #at = 0;

  /// `rubric`, `start`: as in GET /api/cases/H. Rows missing in `start` are empty, unknown ones dropped. A
  /// rubric without an overall scale has no overall mark.
  constructor(rubric, start) {
    this.rubric = rubric;
    const answers = new Map(start.rows.map((row) => [row.code, row]));
    const rows = rubric.rows.map(({ code }) => ({
      code,
      score_steps: answers.get(code)?.score_steps ?? null,
      not_assessable: answers.get(code)?.not_assessable ?? '',
    }));
    const overall = { score_steps: start.overall_steps ?? null, not_assessable: start.overall_not_assessable ?? '' };
    const state = { rows, overall, comment: start.comment ?? '' };
    this.revision = start.revision;
    this.#states = [{ state, change: null, open: false }];
  }

  /// The sheet in the server's format.
  get sheet() {
    const { rows, overall, comment } = this.#present;
    const sheet = {
      revision: this.revision,
      rows: rows.map((row) => ({ ...row })),
      overall_steps: overall.score_steps,
      comment,
    };
    if (overall.not_assessable) sheet.overall_not_assessable = overall.not_assessable;
    return sheet;
  }
  get comment() {
    return this.#present.comment;
  }
  get #present() {
    return this.#states[this.#at].state;
  }

  /// Codes in scoring order.
  order() {
    const codes = this.rubric.rows.map((row) => row.code);
    return this.rubric.overall ? [...codes, kOverallRow] : codes;
  }
  answer(code) {
    const { rows, overall } = this.#present;
    const { score_steps, not_assessable } = code === kOverallRow ? overall : rows.find((row) => row.code === code);
    return { score_steps, not_assessable };
  }
  scale(code) {
    return code === kOverallRow ? this.rubric.overall : this.rubric.rows.find((row) => row.code === code).scale;
  }
  /// Codes without an answer, in scoring order.
  unanswered() {
    return this.order().filter((code) => !given(this.answer(code)));
  }

  /// These return false without effect if nothing would change or the score is off the scale. `merge`:
  /// continues the previous keystroke ("1", "0" for ten).
  setScore(code, score_steps, merge = false) {
    if (!isOnScale(score_steps, this.scale(code))) return false;
    return this.#put(code, { score_steps, not_assessable: '' }, { kind: 'score', row: code }, merge);
  }
  /// An empty reason clears the answer.
  setNotAssessable(code, reason) {
    if (reason === '') return this.clear(code);
    return this.#put(code, { score_steps: null, not_assessable: reason }, { kind: 'not_assessable', row: code }, true);
  }
  clear(code) {
    return this.#put(code, { score_steps: null, not_assessable: '' }, { kind: 'cleared', row: code }, false);
  }
  clearAll() {
    if (this.comment === '' && !this.order().some((code) => given(this.answer(code)))) return false;
    const empty = { score_steps: null, not_assessable: '' };
    const rows = this.#present.rows.map(({ code }) => ({ code, ...empty }));
    return this.#apply({ rows, overall: empty, comment: '' }, { kind: 'all_cleared', row: kOverallRow }, false);
  }
  setComment(comment) {
    if (comment === this.comment) return false;
    return this.#apply({ ...this.#present, comment }, { kind: 'comment', row: kOverallRow }, true);
  }

  get canUndo() {
    return this.#at > 0;
  }
  get canRedo() {
    return this.#at + 1 < this.#states.length;
  }
  /// The step that undo() or redo() would perform: {kind, row}, or null.
  get undoable() {
    return this.canUndo ? this.#states[this.#at].change : null;
  }
  get redoable() {
    return this.canRedo ? this.#states[this.#at + 1].change : null;
  }
  undo() {
    if (!this.canUndo) return false;
    this.#at -= 1;
    this.#states[this.#at].open = false; // what follows is a separate step
    return true;
  }
  redo() {
    if (!this.canRedo) return false;
    this.#at += 1;
    return true;
  }

  #put(code, answer, change, merge) {
    if (sameAnswer(this.answer(code), answer)) return false;
    const { rows, overall, comment } = this.#present;
    return this.#apply(
      {
        rows: rows.map((row) => (row.code === code ? { code, ...answer } : row)),
        overall: code === kOverallRow ? answer : overall,
        comment,
      },
      change,
      merge,
    );
  }
  #apply(state, change, joins) {
    this.#states.length = this.#at + 1;
    const present = this.#states[this.#at];
    const same = present.change?.kind === change.kind && present.change?.row === change.row;
    if (joins && this.#at > 0 && present.open && same) {
      present.state = state;
      return true;
    }
    const open = change.kind !== 'cleared' && change.kind !== 'all_cleared';
    this.#states.push({ state, change, open });
    this.#at += 1;
    return true;
  }
}
