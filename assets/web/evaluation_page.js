// SPDX-License-Identifier: GPL-3.0-or-later
// Evaluation of tissue models: nine marks per model. Models are labelled by letters, in the reader's own
// order.
import { api, NoConnection, Refusal } from './api.js';
import { playedKeys } from './case_keys.js';
import { button, h, say, show } from './dom.js';
import { DraftKeeper } from './draft_keeper.js';
import { joinedSentences } from './numbers.js';
import { Player } from './player.js';
import { problemText } from './problem.js';
import { SaveStatus } from './save_status.js';
import { SheetEditor } from './sheet_editor.js';
import { SheetView } from './sheet_view.js';
import { shownPassword, signed } from './signing.js';
import { t } from './texts.js';

const kSpeeds = [0.5, 1, 2];

export class EvaluationPage {
  element = h('div', { class: 'case-page' });
  status = new SaveStatus();
  #asking = false;
  #busy = false;

  constructor(frame) {
    this.frame = frame;
  }
  get title() {
    return t('Evaluation');
  }
  get unsaved() {
    return Boolean(this.keeper?.unsaved);
  }
  async load() {
    this.#take(await api.get('/api/evaluation'));
    this.form = this.forms.find((one) => !one.complete) ?? this.forms.at(-1);
    this.#openFirst();
  }
  #take({ forms }) {
    this.forms = forms;
    this.form = forms.find((one) => one.form === this.form?.form) ?? null;
  }
  #openFirst() {
    const models = this.form?.models ?? [];
    this.#open(models.find((one) => !one.submitted) ?? models.at(-1));
  }

  async #open(model) {
    await this.keeper?.settled();
    this.player?.pause();
    this.model = model;
    this.#asking = false;
    this.status = new SaveStatus();
    if (!model) {
      this.element.replaceChildren(h('div', { class: 'queue' }, h('h1', {}, t('Evaluation')),
        h('p', {}, t('No evaluation is waiting for you at present.'))));
      return;
    }
    this.path = `/api/evaluation/${encodeURIComponent(this.form.form)}/${encodeURIComponent(model.label)}`;
    this.stored = new Map(model.sheet.rows.map((row) => [row.code, row.score_steps]));
    this.editor = new SheetEditor(this.form.rubric, model.sheet);
    this.keeper = new DraftKeeper({
      put: (sheet) => this.#put(sheet),
      onSaved: () => {},
      onChange: (keeper) => this.status.show(keeper),
    });
    this.view = new SheetView(this.form.rubric, null, { edited: () => this.#edited(), out: () => this.submit.focus() });
    this.view.setEditor(this.editor);
    this.view.setReadOnly(model.submitted);
    this.#build();
    this.view.takeFocus();
    if (this.player) this.#openRecording(this.player);
  }
  #build() {
    const { form, model } = this;
    const choice = h('select', {
      'aria-label': t('Evaluation'),
      onchange: () => {
        this.form = this.forms[choice.selectedIndex];
        this.#openFirst();
      },
    }, this.forms.map((one) => h('option', { selected: one === form }, one.title)));
    show(choice, this.forms.length > 1);
    const models = h('div', { class: 'actions', role: 'group', 'aria-label': t('Models') }, form.models.map((one, i) =>
      button(one.submitted ? t('%1. Model %2, submitted', i + 1, one.label) : t('%1. Model %2', i + 1, one.label),
        () => this.#open(one), { 'aria-pressed': String(one === model) })));
    this.player = model.recorded
      ? new Player(this.path, { rules: { speeds: kSpeeds } }, { played: () => this.frame.active(), paused: () => {} })
      : null;
    const left = this.player?.element ?? h('p', { class: 'sentence' },
      t('There is no recording of this model here: score what you experienced at the station.'));
    this.text = h('p', { class: 'check', 'aria-live': 'polite' });
    this.problem = h('p', { class: 'caution', role: 'alert' });
    this.submit = button(t('Submit this model'), () => this.go(), { class: 'primary submit', title: t('Checks the sheet and asks once more (Ctrl+Enter)') });
    show(this.submit, !model.submitted);
    const bar = h('section', { class: 'submit-bar', 'aria-label': t('Submit') }, this.text, this.problem, h('div', { class: 'actions' }, this.submit));
    this.element.replaceChildren(
      h('div', { class: 'case-head' }, h('h1', {}, t('Evaluation')), choice,
        h('span', { class: 'quiet facts' }, t('Nine indices for each model. The letters hide the models; the order is drawn for you alone.')),
        this.status.element),
      models,
      h('div', { class: 'halves' }, h('div', { class: 'left' }, left), h('div', { class: 'right' }, this.view.element, bar)));
    this.#refresh();
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

  /// Saves the changed marks one by one.
  async #put(sheet) {
    const { path, stored, model } = this;
    for (const { code, score_steps } of sheet.rows) {
      if (stored.get(code) === score_steps) continue;
      await api.put(path, { index: Number(code), score_steps });
      stored.set(code, score_steps);
    }
    model.sheet = sheet;
    return { revision: 0, check: null };
  }
  #edited() {
    this.#asking = false;
    this.keeper.change(() => this.editor.sheet);
    this.#refresh();
  }
  #refresh() {
    const open = this.editor.unanswered();
    const { submitted } = this.model;
    const words = submitted
      ? this.form.complete ? t('All models are submitted. Thank you.') : t('submitted and sealed')
      : open.length > 0 ? t('Still open: %1.', open.map((code) => this.view.nameOf(code)).join(t(', ')))
      : this.#asking ? t('All are scored. Press again to seal them; sealed marks stay as they are.') : '';
    say(this.text, words);
    this.submit.disabled = this.#busy;
  }
  /// Asks for confirmation, then submits (button or Ctrl+Enter).
  async go() {
    if (this.#busy || !this.model || this.model.submitted) return;
    const [first] = this.editor.unanswered();
    if (first !== undefined) {
      this.view.mark(first);
      this.view.takeFocus();
      this.#refresh();
      return;
    }
    if (!this.#asking) {
      this.#asking = true;
      this.#refresh();
      return;
    }
    this.#busy = true;
    say(this.problem, '');
    this.#refresh();
    try {
      await this.keeper.settled();
      let answer = null;
      const done = await signed(async (password) => {
        answer = await api.post(`${this.path}/submit`, shownPassword(password));
      }, this.frame.login);
      if (done) {
        this.frame.notify(t('Model %1 is submitted and sealed', this.model.label));
        this.#take(answer);
        this.#openFirst();
      }
    } catch (error) {
      say(this.problem, problemText(error));
    } finally {
      this.#busy = false;
      this.#refresh();
    }
  }

  async settle() {
    this.player?.pause();
    await this.keeper?.settled();
  }
  left() {
    this.player?.pause();
  }
  resume() {
    if (this.keeper) this.keeper.resume();
    else this.load().catch(() => {});
  }
  key(event) {
    if (this.model) playedKeys(this, event);
  }
}
