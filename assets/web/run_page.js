// SPDX-License-Identifier: GPL-3.0-or-later
// Debriefing of one of the reader's runs: the recording, and each twist against its task.
import { api, NoConnection, Refusal } from './api.js';
import { button, h } from './dom.js';
import { clockTenths, dayText, figure, joinedSentences } from './numbers.js';
import { kPatience_ms, verdictTexts } from './own_page.js';
import { Player } from './player.js';
import { problemText } from './problem.js';
import { t } from './texts.js';

const kSpeeds = [0.5, 1, 2];

export class RunPage {
  element = h('div', { class: 'case-page' }, h('p', { class: 'quiet', role: 'status' }, t('Being read…')));

  constructor(frame, handle) {
    this.frame = frame;
    this.path = `/api/own/runs/${encodeURIComponent(handle)}`;
  }
  get title() {
    return this.run ? this.run.title : t('A run');
  }
  async load() {
    this.run = await api.get(this.path, { patience_ms: kPatience_ms });
    const { run } = this;
    this.player = new Player(this.path, { rules: { speeds: kSpeeds } }, { played: () => this.frame.active(), paused: () => {} });
    const facts = [dayText(run.started_utc_us), t('%1 long', clockTenths(1e6 * run.duration_s))];
    if (!run.force_felt) facts.push(t('without felt force'));
    this.element.replaceChildren(
      h('div', { class: 'case-head' }, h('h1', {}, run.title || t('A run')), h('span', { class: 'quiet facts' }, facts.join('  \u00b7  '))),
      h('div', { class: 'halves' }, h('div', { class: 'left' }, this.player.element),
        h('div', { class: 'right scrolls', tabindex: '0' }, this.#debriefing(), this.#twists(), this.#bookmarks(), this.#verdict())));
    this.#openRecording();
  }
  async #openRecording() {
    try {
      await this.player.load();
      this.player.setBookmarks(this.run.bookmarks.map((one) => 1e6 * one.at_s));
    } catch (error) {
      const why = error instanceof NoConnection || error instanceof Refusal ? problemText(error) : '';
      this.player.sentence.replaceChildren(`${joinedSentences([t('The recording could not be opened.'), why])} `,
        button(t('Try again'), () => this.#openRecording()));
    }
  }
  #goTo(at_s) {
    return button(clockTenths(1e6 * at_s), () => this.player.seek(1e6 * at_s), { class: 'small' });
  }
  #twists() {
    const { twists, unfinished, untwisting } = this.run;
    if (untwisting) return null;
    return h('section', { class: 'card wide-table', tabindex: '0' }, h('h2', {}, t('Twists')),
      h('table', {},
        h('thead', {}, h('tr', {}, [t('From'), t('Asked for'), t('Released at'), t('Held'), t('On target')].map((head) => h('th', { scope: 'col' }, head)))),
        h('tbody', {}, twists.map((twist) => h('tr', {},
          h('th', { scope: 'row' }, this.#goTo(twist.from_s)), h('td', {}, `${figure(twist.target_deg, 1)}\u00b0`),
          h('td', {}, `${figure(twist.released_deg, 1)}\u00b0`), h('td', {}, t('%1 s', figure(twist.held_s, 1))),
          h('td', { class: twist.passed ? 'good' : 'caution' }, twist.passed ? t('yes') : t('no')))))),
      unfinished > 0 ? h('p', { class: 'quiet' }, t('%1 {twist was|twists were} not completed.', figure(unfinished))) : null);
  }
  #verdict() {
    const { verdict } = this.run;
    if (!verdict) return null;
    return h('section', { class: 'card stack' }, h('h2', {}, t('By all runs')), verdictTexts()(verdict, ''));
  }

  /// The task, what was good and what to improve, with the window's sentences.
  #debriefing() {
    const { checks, strengths, weaknesses, findings } = this.run.told;
    const { code, sentence, cause, remedy } = this.run.outcome;
    const look = (passed) => (passed ? 'good' : 'caution');
    const advice = (one) => (one.advice ? h('p', { class: 'advice' }, one.advice) : null);
    const moment = (one) => (one.from_s === null ? null : this.#goTo(one.from_s));
    const finding = (one) => h('li', {}, moment(one), ' ', one.text, advice(one));
    const list = (title, lines) => (lines.length === 0 ? null : h('section', { class: 'card' }, h('h2', {}, title), h('ul', { class: 'told' }, lines)));
    const mark = (one) => (one.lost ? '\u2013' : one.passed ? '\u2713' : '\u2717');
    return [
      h('section', { class: 'card' }, h('p', { class: look(code === 'passed') }, sentence),
        cause ? h('p', { class: 'quiet' }, joinedSentences([cause, remedy])) : null),
      list(t('Targets'), checks.map((one) => h('li', {}, h('span', { class: one.lost ? 'quiet' : look(one.passed) }, `${mark(one)} ${one.text}`), ' ', moment(one), advice(one)))),
      list(t('What went well'), strengths.map(finding)),
      list(t('What to work on'), weaknesses.map(finding)),
      list(t('Findings'), findings.map(finding))];
  }
  #bookmarks() {
    const { bookmarks } = this.run;
    if (bookmarks.length === 0) return null;
    return h('section', { class: 'card' }, h('h2', {}, t('Bookmarks')),
      h('ul', {}, bookmarks.map((one) => h('li', {}, this.#goTo(one.at_s), ' ', one.text))));
  }

  async settle() {
    this.player?.pause();
  }
  left() {
    this.player?.pause();
  }
  key(event) {
    if (!this.player || event.ctrlKey || event.altKey || event.metaKey || event.isComposing) return;
    if (['INPUT', 'SELECT', 'BUTTON', 'A'].includes(event.target.tagName)) return;
    if (this.player.key(event)) event.preventDefault();
  }
}
