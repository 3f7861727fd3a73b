// SPDX-License-Identifier: GPL-3.0-or-later
// Rater calibration on reference runs: score first, then compare with the panel.
import { api, NoConnection, Refusal } from './api.js';
import { playedKeys } from './case_keys.js';
import { button, h, say } from './dom.js';
import { figure, joinedSentences, pointsText, scoreText } from './numbers.js';
import { Player } from './player.js';
import { problemText } from './problem.js';
import { kOverallRow, SheetEditor } from './sheet_editor.js';
import { SheetView } from './sheet_view.js';
import { t } from './texts.js';

const kSpeeds = [0.5, 1, 2];
const kNear_points = 0.25; // counts as agreement with the panel

function tenths(points) {
  return pointsText(Math.round(10 * points) / 10);
}

export class CalibrationPage {
  element = h('div', { class: 'case-page' });

  constructor(frame) {
    this.frame = frame;
  }
  get title() {
    return t('Calibration');
  }
  async load() {
    this.calibration = await api.get('/api/calibration');
    const { runs } = this.calibration;
    this.#open((runs.find((run) => run.own_steps === null) ?? runs[0])?.number);
  }
  #run() {
    return this.calibration.runs.find((run) => run.number === this.number);
  }
  #open(number) {
    this.player?.pause();
    this.number = number;
    if (!number) {
      this.element.replaceChildren(h('div', { class: 'queue' }, h('h1', {}, t('Calibration')),
        h('p', {}, t('No reference run has been chosen yet. You may begin with your queue.'))));
      return;
    }
    const { rubric } = this.calibration;
    const only = { rows: [], overall: rubric.overall };
    this.editor = new SheetEditor(only, { revision: 0, rows: [], overall_steps: this.#run().own_steps, comment: '' });
    this.view = new SheetView(only, null, { edited: () => this.#show(), out: () => this.compare.focus() });
    this.view.setEditor(this.editor);
    this.player = new Player(`/api/calibration/${number}`, { rules: { speeds: kSpeeds } }, { played: () => this.frame.active(), paused: () => {} });
    this.result = h('p', { role: 'status' });
    this.compare = button('', () => this.go(), { class: 'primary' });
    this.choices = h('div', { class: 'actions', role: 'group', 'aria-label': t('Reference runs') });
    const anchors = rubric.rows.filter((row) => row.anchors.length > 0).map((row) => h('li', {},
      t('%1: %2', row.label, row.anchors.map((one) => t('%1: %2', scoreText(one.steps, row.scale), one.text)).join('  \u00b7  '))));
    this.element.replaceChildren(
      h('div', { class: 'case-head' }, h('h1', {}, t('Calibration')), h('span', { class: 'quiet facts' },
        t('Score each run before you see what the panel has said. It counts for nothing but yourself.'))),
      this.choices,
      h('div', { class: 'halves' }, h('div', { class: 'left' }, this.player.element),
        h('div', { class: 'right' }, this.view.element, h('ul', { class: 'quiet' }, anchors),
          h('section', { class: 'submit-bar', 'aria-label': t('Comparison') }, this.result, h('div', { class: 'actions' }, this.compare)))));
    this.#show();
    this.view.takeFocus();
    this.#openRecording(this.player);
  }
  async #openRecording(player) {
    try {
      await player.load();
    } catch (error) {
      const why = error instanceof NoConnection || error instanceof Refusal ? problemText(error) : '';
      player.sentence.replaceChildren(`${joinedSentences([t('The recording could not be opened.'), why])} `,
        button(t('Try again'), () => this.#openRecording(player)));
    }
  }
  /// True if the current mark was already compared.
  #compared() {
    const run = this.#run();
    return run.own_steps !== null && run.own_steps === this.editor.answer(kOverallRow).score_steps;
  }
  #next() {
    return this.calibration.runs.find((run) => run.own_steps === null)?.number;
  }
  #show() {
    this.choices.replaceChildren(...this.calibration.runs.map((run) =>
      button(run.own_steps === null ? t('Reference %1', run.number) : t('Reference %1, scored', run.number),
        () => this.#open(run.number), { 'aria-pressed': String(run.number === this.number) })));
    const next = this.#next();
    say(this.compare, !this.#compared() ? t('Compare with the panel') : next ? t('Continue with reference %1', next) : t('On to the queue'));
    this.compare.disabled = this.editor.answer(kOverallRow).score_steps === null;
    say(this.result, this.#resultText());
  }
  #resultText() {
    const run = this.#run();
    if (run.offset_points === null || !this.#compared()) return t("Score first; then the panel's mark is shown.");
    const off = run.offset_points;
    const reading = Math.abs(off) < kNear_points ? t('That is as the panel sees it.')
      : off < 0 ? t('You are stricter by %1.', tenths(-off)) : t('You are milder by %1.', tenths(off));
    const figures = t('You: %1. Panel of %2: %3.', scoreText(run.own_steps, this.calibration.rubric.overall), figure(run.panel_raters), tenths(run.panel_points));
    const { complete, mean_offset_points: mean } = this.calibration;
    const sum = complete && mean !== null
      ? t('Over all reference runs: %1 points from the panel. You may score a run again; every try is kept.', tenths(mean))
      : t('You may score it again, or go on with the next run.');
    return joinedSentences([figures, reading, sum]);
  }
  async go() {
    if (!this.number || this.editor.answer(kOverallRow).score_steps === null) return;
    if (this.#compared()) {
      const next = this.#next();
      if (next) this.#open(next);
      else this.frame.open('#queue');
      return;
    }
    try {
      this.calibration = await api.put(`/api/calibration/${this.number}`, { score_steps: this.editor.answer(kOverallRow).score_steps });
      this.#show();
    } catch (error) {
      say(this.result, problemText(error));
    }
  }

  async settle() {
    this.player?.pause();
  }
  left() {
    this.player?.pause();
  }
  key(event) {
    if (this.number) playedKeys(this, event);
  }
}
