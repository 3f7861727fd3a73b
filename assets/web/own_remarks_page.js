// SPDX-License-Identifier: GPL-3.0-or-later
// Physicians' remarks on the reader's own runs, with replies.
import { api } from './api.js';
import { button, field, h, say } from './dom.js';
import { clockTenths, dayText } from './numbers.js';
import { problemText } from './problem.js';
import { t } from './texts.js';

const kLongestAnswer = 400;

export class OwnRemarksPage {
  element = h('div', { class: 'queue' }, h('h1', {}, t('Remarks')));
  #typed = new Map(); // unsent replies, by remark

  constructor(frame) {
    this.frame = frame;
  }
  get title() {
    return t('Remarks');
  }
  get unsaved() {
    return [...this.#typed.values()].some((text) => text.trim() !== '');
  }
  async load() {
    this.#draw(await api.get('/api/own/remarks'));
  }
  resume() {
    this.load().catch(() => {}); // keeps what was typed
  }

  #draw({ trials }) {
    const cards = trials.map((trial) => h('section', { class: 'card stack' },
      h('h2', {}, h('a', { href: `#run/${encodeURIComponent(trial.run)}` }, `${trial.title || t('A run')}, ${dayText(trial.started_utc_us)}`)),
      ...trial.remarks.map((remark) => this.#remark(remark))));
    this.element.replaceChildren(h('h1', {}, t('Remarks')),
      h('p', { class: 'quiet' }, t("Physicians' remarks on moments of your runs. Their names are not shown.")),
      ...(cards.length > 0 ? cards : [h('p', {}, t('Nobody has written anything yet. Remarks appear when the marks are released.'))]));
  }
  #words(remark) {
    const about = [remark.own ? t('you') : t('a physician'), dayText(remark.written_utc_us)];
    if (remark.edited) about.push(t('edited'));
    if (!remark.read && !remark.own) about.push(t('new'));
    return h('div', {}, h('p', {}, remark.text || '\u2013'), h('p', { class: 'quiet' }, about.join('  \u00b7  ')));
  }
  #remark(remark) {
    const { row, input } = field(t('Your answer'), {
      rows: '2', maxlength: kLongestAnswer, oninput: () => this.#typed.set(remark.remark, input.value),
    }, 'textarea');
    input.value = this.#typed.get(remark.remark) ?? '';
    const said = h('p', { class: 'said caution', role: 'alert' });
    const send = async (path, body) => {
      try {
        const answer = await api.post(`/api/own/remarks/${encodeURIComponent(remark.remark)}/${path}`, body);
        if (path === 'reply') this.#typed.delete(remark.remark);
        this.#draw(answer);
      } catch (error) {
        say(said, problemText(error));
      }
    };
    return h('article', { class: 'stack remark-thread' },
      h('p', { class: 'quiet' }, t('At %1', clockTenths(1e6 * remark.at_s))), this.#words(remark),
      h('div', { class: 'answers stack' }, remark.replies.map((reply) => this.#words(reply))),
      row, said,
      h('div', { class: 'actions' },
        button(t('Answer'), () => {
          if (input.value.trim() === '') {
            input.focus();
            return;
          }
          send('reply', { text: input.value.trim() });
        }, { class: 'primary' }),
        remark.read || remark.own ? null : button(t('I have read it'), () => send('read', { version: remark.version }))));
  }
}
