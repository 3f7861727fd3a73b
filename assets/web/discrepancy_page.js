// SPDX-License-Identifier: GPL-3.0-or-later
// Cases in which all have submitted and the reader's mark differs strongly: keep it, change it with a reason,
// or request another rater.
import { api } from './api.js';
import { button, field, h, say } from './dom.js';
import { figure } from './numbers.js';
import { problemText } from './problem.js';
import { t } from './texts.js';

const kLongestReason = 200;

export class DiscrepancyPage {
  element = h('div', { class: 'queue' }, h('h1', {}, t('Discrepancy review')));
  #typed = new Map(); // unsent reasons, by case

  constructor(frame) {
    this.frame = frame;
  }
  get title() {
    return t('Discrepancy review');
  }
  get unsaved() {
    return [...this.#typed.values()].some((text) => text.trim() !== '');
  }
  async load() {
    this.#draw(await api.get('/api/discrepancies'));
  }
  resume() {
    this.load().catch(() => {}); // keeps what was typed
  }

  #draw({ cases, opens }) {
    this.element.replaceChildren(h('h1', {}, t('Discrepancy review')),
      h('p', { class: 'quiet' }, t("Only cases that everyone has submitted, and only where your mark differs from the others'. Nobody is named.")),
      ...(cases.length > 0 ? cases.map((one) => this.#case(one)) : [h('p', {}, t('No disagreements are waiting for you.'))]),
      h('p', { class: 'quiet' }, opens));
  }
  #decision(one) {
    const words = { keep: t('kept'), move: t('moved'), third: t('adjudicator requested') };
    const decided = one.decision ? words[one.decision] : t('to be decided');
    return one.reason ? t('%1: %2', decided, one.reason) : decided;
  }
  #case(one) {
    const { row, input } = field(t('Reason (needed to move a mark or to ask for an adjudicator)'), {
      maxlength: kLongestReason, autocomplete: 'off', oninput: () => this.#typed.set(one.label, input.value),
    });
    input.value = this.#typed.get(one.label) ?? '';
    const said = h('p', { class: 'said caution', role: 'alert' });
    const decide = async (how, done) => {
      try {
        const answer = await api.post(`/api/discrepancies/${encodeURIComponent(one.case)}/${how}`, { reason: input.value.trim() });
        this.#typed.delete(one.label);
        this.#draw(answer);
        this.frame.notify(done);
      } catch (error) {
        say(said, problemText(error));
        input.focus();
      }
    };
    return h('section', { class: 'card stack' },
      h('div', { class: 'page-head' }, h('h2', {}, t('Case %1', one.label)), h('p', { class: 'quiet' }, this.#decision(one))),
      h('div', { class: 'wide-table', tabindex: '0' }, h('table', {},
        h('thead', {}, h('tr', {}, [t('Criterion'), t('You'), t('Mean of the others'), t('Lowest to highest')].map((head) => h('th', { scope: 'col' }, head)))),
        h('tbody', {}, one.rows.map((line) => h('tr', { class: line.apart ? 'differs' : '' },
          h('th', { scope: 'row' }, line.label || t('Overall')), h('td', {}, figure(line.own, 1)), h('td', {}, figure(line.mean, 1)),
          h('td', {}, `${figure(line.lowest, 1)}\u2026${figure(line.highest, 1)}`)))))),
      row, said,
      h('div', { class: 'actions' },
        button(t('Keep my mark'), () => decide('keep', t('Your mark stays as it is')), { class: 'primary' }),
        h('a', { class: 'button', href: `#case/${encodeURIComponent(one.case)}` }, t('Look at it again, or move the mark')),
        button(t('Ask for an adjudicator'), () => decide('third', t('An adjudicator has been requested')))));
  }
}
