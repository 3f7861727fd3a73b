// SPDX-License-Identifier: GPL-3.0-or-later
// Evaluation of tissue models: nine marks per model. Models are labelled by letters, in the reader's own
// order.
import { api, NoConnection, Refusal } from './api.js';
import { playedKeys } from './case_keys.js';
import { button, h, say, show } from './dom.js';
import { DraftKeeper } from './draft_keeper.js';
import { figure, joinedSentences } from './numbers.js';
import { Player } from './player.js';
import { problemText } from './problem.js';
import { SaveStatus } from './save_status.js';
import { SheetEditor } from './sheet_editor.js';
import { SheetView } from './sheet_view.js';
import { shownPassword, signed } from './signing.js';
import { t } from './texts.js';
import { ViewingReporter } from './viewing_reporter.js';

function percent(share) {
  return t('%1 %', figure(Math.floor(100 * share + 0.1)));
}

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
  #take({ forms, rules }) {
    this.forms = forms;
    this.rules = rules;
    this.form = forms.find((one) => one.form === this.form?.form) ?? null;
  }
  #openFirst() {
    const models = this.form?.models ?? [];
    this.#open(models.find((one) => !one.submitted) ?? models.at(-1));
  }

  async #open(model) {
    await this.keeper?.settled();
    this.player?.pause();
    this.reporter?.close();
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
      onSaved: ({ check }) => this.#checked(check),
      onChange: (keeper) => this.status.show(keeper),
    });
    this.check = model.check;
    this.reporter = new ViewingReporter({
      post: (body, options) => api.post(`${this.path}/viewing`, body, options),
      onAnswer: (answer, unreported) => this.#viewed(answer, unreported),
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
      ? new Player(this.path, { rules: this.rules, watched: model.watched }, {
        played: (stretch) => this.#played(stretch),
        paused: () => this.reporter.report(),
      })
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
    let check = null;
    for (const { code, score_steps } of sheet.rows) {
      if (stored.get(code) === score_steps) continue;
      ({ check } = await api.put(path, { index: Number(code), score_steps }));
      stored.set(code, score_steps);
    }
    model.sheet = sheet;
    return { revision: 0, check };
  }
  #played(stretch) {
    this.frame.active();
    if (this.model.submitted) return;
    this.reporter.played(stretch);
    this.player.setWatched(this.model.watched, this.reporter.unreported);
  }
  #viewed({ watched, check }, unreported) {
    this.model.watched = watched;
    this.player.setWatched(watched, unreported);
    this.#checked(check);
  }
  #checked(check) {
    if (check) this.check = check;
    this.#refresh();
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
      : this.check.watched_too_little ? t('Watched %1 so far; at least %2 is asked.', percent(this.check.watched_share), percent(this.rules.minimum_watched))
      : this.check.speed_not_allowed ? t('It was played at a speed that is not allowed.')
      : this.#asking ? joinedSentences([
        this.check.all_the_same ? t('All rows have the same mark. Is that intended?') : '',
        t('All are scored. Press again to seal them; sealed marks stay as they are.')]) : '';
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
      await this.reporter.report();
      await this.keeper.settled();
      this.#asking = !this.check.watched_too_little && !this.check.speed_not_allowed;
      if (!this.#asking) this.player?.play.focus();
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
    await this.reporter?.report();
    await this.keeper?.settled();
  }
  left() {
    this.player?.pause();
    this.reporter?.close();
  }
  resume() {
    if (this.keeper) this.keeper.resume();
    else this.load().catch(() => {});
  }
  key(event) {
    if (this.model) playedKeys(this, event);
  }
}
