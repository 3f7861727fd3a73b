// SPDX-License-Identifier: GPL-3.0-or-later
// The reader's severity, compared with the others on the same cases. Nobody else is identified.
import { api } from './api.js';
import { h } from './dom.js';
import { figure } from './numbers.js';
import { t } from './texts.js';

const kNear_points = 0.25;

export class SeverityPage {
  element = h('div', { class: 'queue' }, h('h1', {}, t('My severity')));

  constructor(frame) {
    this.frame = frame;
  }
  get title() {
    return t('My severity');
  }
  async load() {
    const own = await api.get('/api/severity');
    this.element.replaceChildren(h('h1', {}, t('My severity')),
      h('p', { class: 'quiet' }, t('For your eyes only: overall marks of cases that everyone has submitted. The mean of the others does not include your own mark.')),
      this.#figure(own), this.#cases(own),
      own.sealed > 0
        ? h('p', { class: 'quiet' }, t('Cases whose panel waits until you have submitted all your own sheets of the occasion: %1.', figure(own.sealed)))
        : '');
  }
  resume() {
    this.load().catch(() => {}); // keeps the present content
  }
  #figure(own) {
    const off = own.difference_points;
    if (off === null) {
      return h('section', { class: 'card stack' }, h('p', {}, t('Nothing to compare yet.')),
        h('p', { class: 'quiet' }, t('Cases appear here once all physicians have submitted them.')));
    }
    const reading = Math.abs(off) < kNear_points ? t('points from the panel: you judge as the others do.')
      : off < 0 ? t('points from the panel: you are stricter.') : t('points from the panel: you are more lenient.');
    const interval = own.interval_points
      ? t("95 % interval %1 to %2; cases: %3. Your mean is %4, the others' %5.", figure(own.interval_points[0], 1),
        figure(own.interval_points[1], 1), figure(own.cases.length), figure(own.own_mean_points, 1), figure(own.panel_mean_points, 1))
      : t('From one case; an interval needs two at least.');
    return h('section', { class: 'card stack' }, h('h2', {}, t('You and the panel')), h('p', { class: 'figure' }, figure(off, 1)),
      h('p', {}, reading), h('p', { class: 'quiet' }, interval),
      own.waiting > 0 ? h('p', { class: 'quiet' }, t('Your cases that wait for the others: %1.', figure(own.waiting))) : null);
  }
  #cases({ cases }) {
    if (cases.length === 0) return '';
    return h('section', { class: 'card wide-table', tabindex: '0' }, h('table', {},
      h('thead', {}, h('tr', {}, [t('Case'), t('You'), t('Panel'), t('Difference')].map((head) => h('th', { scope: 'col' }, head)))),
      h('tbody', {}, cases.map((one) => h('tr', {}, h('th', { scope: 'row' }, one.label), h('td', {}, figure(one.own, 1)),
        h('td', {}, figure(one.panel, 1)), h('td', {}, figure(one.own - one.panel, 1)))))));
  }
}
