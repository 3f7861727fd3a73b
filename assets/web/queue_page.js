// SPDX-License-Identifier: GPL-3.0-or-later
// A rater's cases: open, within ten minutes, done.
import { api } from './api.js';
import { h } from './dom.js';
import { clockTime, dayText, figure } from './numbers.js';
import { t } from './texts.js';

function stateText(line) {
  if (line.state === 'submitted') return t('submitted');
  if (line.overdue) return t('overdue');
  return line.state === 'draft' ? t('draft') : t('waiting');
}

export class QueuePage {
  element = h('div', { class: 'queue' }, h('h1', {}, t('Your queue')));

  constructor(frame) {
    this.frame = frame;
  }
  get title() {
    return t('Your queue');
  }
  async load() {
    const queue = await api.get('/api/queue');
    this.element.replaceChildren(this.#head(queue), ...this.#live(queue), this.#figures(queue), this.#cases(queue));
    this.element.querySelector('.primary')?.focus();
  }
  resume() {
    this.load().catch(() => {}); // keeps the present content; the next click reports the error
  }

  #head({ next, drafts, waiting }) {
    const words = drafts > 0 ? t('Continue the draft') : waiting > 0 ? t('Continue') : t('All scored');
    return h('div', { class: 'page-head' },
      h('div', {},
        h('h1', {}, t('Your queue')),
        h('p', { class: 'quiet' }, t("Cases are blinded and shuffled for you alone. Nobody sees your marks before all have submitted, nor do you see theirs."))),
      next
        ? h('a', { class: 'button primary', href: `#case/${encodeURIComponent(next)}` }, words)
        : h('p', { class: 'good' }, words));
  }

  /// The way to the live sheets, if there are any to come.
  #live({ live_called: called, live_waiting: waiting }) {
    if (called + waiting === 0) return [];
    const words = called > 0
      ? t('On the real arm: %1 called and not submitted, %2 still to be called', figure(called), figure(waiting))
      : t('On the real arm: %1 still to be called; the sheet opens by itself', figure(waiting));
    return [h('section', { class: 'card page-head' }, h('p', { class: called > 0 ? 'caution' : '' }, words),
      h('a', { class: 'button', href: '#live' }, t('Live sheet')))];
  }
  #figures(queue) {
    const card = (title, value, words, caution = false) =>
      h('div', { class: 'card' }, h('h2', {}, title), h('p', { class: 'figure' }, value),
        h('p', { class: caution ? 'caution' : 'quiet' }, words));
    const all = queue.lines.length;
    const done = queue.lines.filter((line) => line.state === 'submitted').length;
    const due = queue.lines.filter((line) => line.due_utc_us !== null && line.state !== 'submitted')
      .map((line) => line.due_utc_us);
    const progress = t('%1 of %2 submitted', figure(done), figure(all));
    const waiting = card(t('Waiting'), figure(queue.waiting), progress);
    if (all > 0) waiting.append(h('progress', { max: all, value: done, 'aria-label': progress }));
    return h('section', { class: 'figures', 'aria-label': t('Progress') },
      waiting,
      card(t('Drafts'), figure(queue.drafts),
        queue.drafts > 0 ? t('in progress, saved automatically') : t('none in progress')),
      card(t('Time needed'), t('%1 min', figure(Math.ceil(queue.minutes))),
        queue.in_ten_minutes > 0
          ? t('%1 {case fits|cases fit} into ten minutes', queue.in_ten_minutes)
          : t('from the length of the recordings')),
      card(t('Next deadline'), due.length > 0 ? dayText(Math.min(...due)) : '\u2013',
        queue.overdue > 0 ? t('%1 overdue', figure(queue.overdue)) : t('nothing is overdue'), queue.overdue > 0));
  }

  #cases({ lines }) {
    const section = h('section', { class: 'card', 'aria-labelledby': 'cases-title' },
      h('h2', { id: 'cases-title' }, t('Your cases')));
    if (lines.length === 0) {
      section.append(h('p', {}, t('No recorded case is assigned to you. New ones appear here by themselves.')));
      return section;
    }
    section.append(h('ul', { class: 'cases' }, lines.map((line) => this.#line(line))));
    return section;
  }
  #line(line) {
    const name = h('span', { class: 'name' }, t('Case %1', line.label));
    const done = line.state === 'submitted';
    return h('li', {}, h('a', { class: `case ${done ? 'done' : ''}`, href: `#case/${encodeURIComponent(line.case)}` },
      name,
      h('span', { class: `state ${line.overdue && !done ? 'caution' : ''}` }, stateText(line)),
      h('span', { class: 'quiet' }, line.due_utc_us && !done ? t('due %1', dayText(line.due_utc_us)) : ''),
      h('span', { class: 'quiet' }, done ? '' : clockTime(Math.round(6e7 * line.estimate_min)))));
  }
}
