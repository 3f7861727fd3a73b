// SPDX-License-Identifier: GPL-3.0-or-later
// What a trainee has done: the trend of each module with what counts as able, and the runs.
import { api } from './api.js';
import { h } from './dom.js';
import { clockTime, dayText, figure } from './numbers.js';
import { t } from './texts.js';
import { trendChart } from './trend_chart.js';

export const kPatience_ms = 120_000; // runs that nobody has measured yet are measured first

/// "3 of 4 on target", or what an untwisting is.
export function runText(run) {
  if (run.interrupted) return t('interrupted');
  return run.untwisting ? t('untwisting') : t('%1 of %2 on target', figure(run.on_target), figure(run.twists));
}

/// A level never stands alone: what counts as able, and how often that is wrong, stand beside it.
export function verdictText(verdict) {
  return h('div', { class: 'verdict' }, h('p', { class: verdict.able ? 'good' : '' }, verdict.level),
    h('p', { class: 'quiet' }, `${verdict.design} ${verdict.errors}`));
}

export class OwnPage {
  element = h('div', { class: 'queue' }, h('h1', {}, t('Your record')), h('p', { class: 'quiet', role: 'status' }, t('Being read…')));

  constructor(frame) {
    this.frame = frame;
  }
  get title() {
    return t('Your record');
  }
  async load() {
    const { code, modules, runs } = await api.get('/api/own', { patience_ms: kPatience_ms });
    this.element.replaceChildren(h('h1', {}, t('Your record')), h('p', { class: 'quiet' }, code),
      ...modules.map((module) => this.#module(module)), this.#runs(runs));
  }
  resume() {
    this.load().catch(() => {}); // what was shown stays
  }

  #module(module) {
    const facts = [t('%1: %2', module.metric, module.last ?? '\u2013')];
    if (module.wanted !== null) facts.push(t('wanted: %1', module.wanted));
    if (module.attempts_left !== null) facts.push(t('tries left: %1', figure(module.attempts_left)));
    return h('section', { class: 'card stack' }, h('h2', {}, module.title), verdictText(module.verdict),
      h('p', {}, facts.join('  \u00b7  ')), trendChart(module));
  }
  #runs(runs) {
    return h('section', { class: 'card wide-table', tabindex: '0' }, h('h2', {}, t('Your runs')),
      runs.length === 0 ? h('p', {}, t('Nothing was recorded yet.')) : h('table', {},
        h('thead', {}, h('tr', {}, [t('When'), t('Exercise'), t('Length'), t('Outcome')].map((head) => h('th', { scope: 'col' }, head)))),
        h('tbody', {}, runs.map((run) => h('tr', {},
          h('th', { scope: 'row' }, h('a', { href: `#run/${encodeURIComponent(run.run)}` }, dayText(run.started_utc_us))),
          h('td', {}, run.title || '\u2013'), h('td', {}, clockTime(1e6 * run.duration_s)), h('td', {}, runText(run)))))));
  }
}
