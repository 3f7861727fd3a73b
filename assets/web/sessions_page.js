// SPDX-License-Identifier: GPL-3.0-or-later
// Browser sessions: the reader's own, or everybody's. Each can be ended here.
import { api } from './api.js';
import { button, h } from './dom.js';
import { figure } from './numbers.js';
import { problemText } from './problem.js';
import { t } from './texts.js';

const kMinute_s = 60;

function ago(seconds) {
  return seconds < kMinute_s ? t('just now') : t('%1 min ago', figure(Math.floor(seconds / kMinute_s)));
}

export class SessionsPage {
  element = h('div', { class: 'queue' });

  /// `all`: everybody's sessions, for user managers.
  constructor(frame, all) {
    this.frame = frame;
    this.all = all;
    this.path = all ? '/api/all-sessions' : '/api/sessions';
  }
  get title() {
    return this.all ? t('Signed in now') : t('Your sessions');
  }
  async load() {
    this.#draw(await api.get(this.path));
  }
  resume() {
    this.load().catch(() => {}); // keeps the present content
  }

  #draw({ sessions }) {
    const heads = [t('Browser'), t('Signed in'), t('Last used'), ''];
    if (this.all) heads.unshift(t('Sign-in name'));
    this.element.replaceChildren(
      h('h1', {}, this.title),
      h('p', { class: 'quiet' }, this.all
        ? t('Everybody who is signed in with a browser. Ending a session keeps every draft; the person can sign in again.')
        : t("Where you are signed in with a browser. End any session you don't recognise, then change your password.")),
      ...(this.all ? [] : [h('p', {}, h('a', { href: '#second-factor' }, t('Second factor: a code from your phone at sign-in')))]),
      h('div', { class: 'card wide-table', tabindex: '0' }, h('table', { class: 'sessions' },
        h('thead', {}, h('tr', {}, heads.map((head) => (head ? h('th', { scope: 'col' }, head) : h('td', {}))))),
        h('tbody', {}, sessions.map((one) => this.#line(one))))));
  }
  #line(one) {
    const name = one.browser || t('unknown');
    return h('tr', {},
      this.all ? h('th', { scope: 'row' }, one.login) : null,
      h('td', {}, name),
      h('td', {}, ago(one.begun_s)),
      h('td', {}, ago(one.idle_s)),
      h('td', {}, one.this
        ? h('span', { class: 'quiet' }, t('this one'))
        : button(t('End'), () => this.#end(one), { class: 'small', 'aria-label': t('End the session: %1', this.all ? `${one.login}, ${name}` : name) })));
  }
  async #end(one) {
    try {
      this.#draw(await api.post(`${this.path}/end`, { id: one.id }));
      this.frame.notify(t('The session was ended'));
    } catch (error) {
      if (error.needsSignIn) return;
      this.frame.notify(problemText(error));
      this.resume();
    }
  }
}
