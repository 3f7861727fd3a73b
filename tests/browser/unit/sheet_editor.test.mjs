// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { sameMarks, SheetEditor, stepsForDigit } from '../../../assets/web/sheet_editor.js';
import { SheetKeys } from '../../../assets/web/sheet_keys.js';

const kTens = { lowest_steps: 10, highest_steps: 100, steps_per_point: 10, arrow_steps: 5 };
const kFives = { lowest_steps: 0, highest_steps: 5, steps_per_point: 1, arrow_steps: 1 };
const kRubric = {
  rows: [{ code: 'a', label: 'A', scale: kTens }, { code: 'b', label: 'B', scale: kFives }],
  overall: kTens,
};
const kEmpty = { revision: 3, rows: [{ code: 'old', score_steps: 40, not_assessable: '' }], overall_steps: null, comment: '' };

function fresh() {
  return new SheetEditor(kRubric, kEmpty);
}

test('a digit is points; 1 then 0 is ten; a lone 0 is zero, or ten if the scale has no zero', () => {
  const cases = [
    [kTens, 7, null, 70], [kTens, 1, null, 10], [kTens, 0, 1, 100], [kTens, 0, null, 100], [kTens, 1, 1, 10],
    [kTens, 5, 7, 50], [kFives, 0, null, 0], [kFives, 6, null, null], [kFives, 3, 1, 3],
  ];
  for (const [scale, digit, typed, steps] of cases) {
    assert.equal(stepsForDigit(scale, digit, typed), steps, `${digit} after ${typed}`);
  }
});

test('rows unknown to the rubric are dropped, missing ones are empty', () => {
  assert.deepEqual(fresh().sheet.rows.map((row) => row.code), ['a', 'b']);
  assert.deepEqual(fresh().unanswered(), ['a', 'b', '']);
  assert.equal(fresh().sheet.revision, 3);
});

test('a score off the scale, or the same score, changes nothing', () => {
  const editor = fresh();
  assert.equal(editor.setScore('a', 105), false);
  assert.equal(editor.setScore('a', 70), true);
  assert.equal(editor.setScore('a', 70), false);
  assert.equal(editor.undo(), true);
  assert.equal(editor.canUndo, false);
});

test('undo and redo cover all marks; a new mark clears the redo', () => {
  const editor = fresh();
  editor.setScore('a', 70);
  editor.setScore('', 80);
  assert.deepEqual(editor.undoable, { kind: 'score', row: '' });
  editor.undo();
  assert.equal(editor.sheet.overall_steps, null);
  assert.deepEqual(editor.redoable, { kind: 'score', row: '' });
  editor.redo();
  assert.equal(editor.sheet.overall_steps, 80);
  editor.undo();
  editor.setScore('b', 2);
  assert.equal(editor.canRedo, false);
});

test('keystrokes in one text are one step; after an undo a new step begins', () => {
  const editor = fresh();
  for (const text of ['n', 'no', 'not seen']) editor.setNotAssessable('b', text);
  editor.undo();
  assert.deepEqual(editor.answer('b'), { score_steps: null, not_assessable: '' });
  editor.redo();
  assert.equal(editor.answer('b').not_assessable, 'not seen');
  for (const text of ['w', 'we', 'well']) editor.setComment(text);
  editor.undo();
  assert.equal(editor.comment, '');
  assert.equal(editor.answer('b').not_assessable, 'not seen');
});

test('a reason replaces a score, and an empty one clears it', () => {
  const editor = fresh();
  editor.setScore('a', 70);
  editor.setNotAssessable('a', 'hidden');
  assert.deepEqual(editor.answer('a'), { score_steps: null, not_assessable: 'hidden' });
  editor.setNotAssessable('a', '');
  assert.deepEqual(editor.unanswered(), ['a', 'b', '']);
  editor.setNotAssessable('', 'broken off');
  assert.equal(editor.sheet.overall_not_assessable, 'broken off');
});

test('clearing all is a single step, and none if the sheet is empty', () => {
  const editor = fresh();
  assert.equal(editor.clearAll(), false);
  editor.setScore('a', 70);
  editor.setComment('fine');
  assert.equal(editor.clearAll(), true);
  assert.deepEqual(editor.unanswered(), ['a', 'b', '']);
  editor.undo();
  assert.equal(editor.answer('a').score_steps, 70);
  assert.equal(editor.comment, 'fine');
});

test('sheets are compared by content, not by revision', () => {
  const one = fresh().sheet;
  assert.equal(sameMarks(one, { ...one, revision: 9 }), true);
  assert.equal(sameMarks(one, { ...one, comment: 'x' }), false);
});

test('ten is typed as one step', () => {
  const keys = new SheetKeys(fresh());
  keys.digit(1);
  keys.digit(0);
  assert.equal(keys.editor.answer('a').score_steps, 100);
  keys.editor.undo();
  assert.equal(keys.editor.answer('a').score_steps, null);
});

test('arrows adjust existing scores by half a point or the finest step, within the scale', () => {
  const keys = new SheetKeys(fresh());
  assert.equal(keys.adjust(+1), false);
  keys.digit(9);
  keys.adjust(+1);
  assert.equal(keys.editor.answer('a').score_steps, 95);
  keys.adjust(+1);
  assert.equal(keys.adjust(+1), false);
  keys.adjust(-1, true);
  assert.equal(keys.editor.answer('a').score_steps, 99);
});

test('rows wrap round in both directions', () => {
  const keys = new SheetKeys(fresh());
  keys.step(-1);
  assert.equal(keys.current, '');
  keys.step(+1);
  assert.equal(keys.current, 'a');
});

test('advancing waits after a 1 that may become 10', () => {
  const keys = new SheetKeys(fresh());
  keys.setAdvancing(true);
  keys.digit(1);
  assert.equal(keys.current, 'a');
  keys.digit(0);
  assert.equal(keys.current, 'b');
  keys.digit(4);
  assert.equal(keys.current, '');
  keys.digit(1);
  keys.digit(7);
  assert.equal(keys.current, '');
  assert.deepEqual(['a', 'b', ''].map((code) => keys.editor.answer(code).score_steps), [100, 4, 70]);
});

test('a mark by mouse selects its row and advances', () => {
  const keys = new SheetKeys(fresh());
  keys.choose('b', 3);
  assert.equal(keys.current, 'b');
  keys.setAdvancing(true);
  keys.choose('a', 60);
  assert.equal(keys.current, 'b');
});
