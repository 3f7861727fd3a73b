// SPDX-License-Identifier: GPL-3.0-or-later
// Invitation links: create, confirm, print, send, revoke. A link is shown once, while this page is open.
import { api } from './api.js';
import { copyText } from './copying.js';
import { button, field, h, say, show } from './dom.js';
import { dayText, figure } from './numbers.js';
import { problemText } from './problem.js';
import { qrPicture } from './svg.js';
import { t } from './texts.js';

const kPatience_ms = 120_000; // a mail server may take its time

export class InvitationsPage {
  element = h('div', { class: 'queue wide' });
  #chosen = new Set();

  constructor(frame) {
    this.frame = frame;
  }
  get title() {
    return t('Invitations');
  }
  async load() {
    this.#draw(await api.get('/api/invitations'));
  }
  resume() {
    this.load().catch(() => {}); // keeps the present content
  }

  #draw({ people, waiting, mail }) {
    this.people = people;
    this.#chosen = new Set([...this.#chosen].filter((one) => people.some((person) => person.user === one)));
    this.cards ??= h('div', { class: 'cards' });
    this.reason = field(t('Reason'), { maxlength: '400', autocomplete: 'off' });
    this.password = field(t('Password of the mail server'), { type: 'password', autocomplete: 'off' });
    this.byMail = field(t('By mail, too: links to their people, and to other administrators that they have to confirm'), { type: 'checkbox' });
    this.byMail.input.addEventListener('change', () => this.#buttons());
    this.note = h('p', { class: 'quiet' });
    this.said = h('p', { class: 'said', role: 'alert' });
    this.invite = button(t('Invite'), () => this.#invite(), { class: 'primary' });
    this.revoke = button(t('Revoke the links'), () => this.#revoke());
    this.byMail.row.classList.add('check-label');
    show(this.byMail.row, mail);
    this.element.replaceChildren(
      h('h1', { class: 'unprinted' }, this.title),
      h('p', { class: 'quiet unprinted' }, t('A personal link to set a password in a browser. It works once and expires after a week; any earlier link stops working.')),
      this.cards,
      ...(waiting.length > 0 ? [this.#waiting(waiting)] : []),
      h('section', { class: 'card stack unprinted' },
        h('div', { class: 'wide-table', tabindex: '0' }, h('table', {},
          h('thead', {}, h('tr', {}, h('td', {}), h('th', { scope: 'col' }, t('Sign-in name')), h('th', { scope: 'col' }, t('Invited until')))),
          h('tbody', {}, people.map((one) => this.#person(one))))),
        this.note, this.reason.row, this.byMail.row, this.password.row, this.said,
        h('div', { class: 'actions' }, this.revoke, this.invite)));
    this.#buttons();
  }
  #person(one) {
    const box = h('input', { type: 'checkbox', 'aria-label': one.login, checked: this.#chosen.has(one.user), onchange: () => {
      if (box.checked) this.#chosen.add(one.user);
      else this.#chosen.delete(one.user);
      this.#buttons();
    } });
    return h('tr', {}, h('td', {}, box), h('th', { scope: 'row' }, one.login),
      h('td', {}, one.until_utc_us === null ? '\u2013' : dayText(one.until_utc_us)));
  }
  #waiting(waiting) {
    return h('section', { class: 'card stack unprinted' }, h('h2', {}, t('To be confirmed')),
      h('p', { class: 'quiet' }, t('Another administrator asks for these invitations and has handed over a code for each. The administrator who confirms one hands over the link.')),
      h('ul', {}, waiting.map((one) => h('li', {}, t('%1, asked for by %2: %3', one.login, one.by, one.reason), ' ',
        one.own
          ? h('span', { class: 'quiet' }, t('somebody else must confirm this'))
          : button(t('Confirm'), () => this.#confirm(one), { class: 'small', 'aria-label': t('Confirm the invitation of %1', one.login) })))));
  }
  /// Enables the buttons that apply to the selected people.
  #buttons() {
    const chosen = this.people.filter((one) => this.#chosen.has(one.user));
    const byTwo = chosen.some((one) => one.by_two);
    const open = chosen.some((one) => one.until_utc_us !== null);
    say(this.note, byTwo
      ? t('This needs two people: you receive a code for each person, and another administrator, who confirms, receives the link.')
      : t('Chosen: %1', figure(chosen.length)));
    show(this.reason.row, byTwo || open);
    show(this.password.row, this.byMail.input.checked);
    this.invite.disabled = chosen.length === 0;
    this.revoke.disabled = !open;
  }
  #order(more) {
    const mail = this.byMail.input.checked ? { mail_password: this.password.input.value } : {};
    return { ...more, ...mail };
  }
  async #try(act) {
    say(this.said, '');
    this.invite.disabled = true;
    try {
      await act();
    } catch (error) {
      if (!error.needsSignIn) say(this.said, problemText(error));
    }
    this.#buttons();
  }
  #users() {
    return [...this.#chosen].map((user) => ({ user }));
  }
  #invite() {
    return this.#try(async () => {
      const answer = await api.post('/api/invitations', this.#order({ users: this.#users(), reason: this.reason.input.value.trim() }), { patience_ms: kPatience_ms });
      this.#chosen.clear();
      await this.load();
      this.#show(answer);
      this.#sayTold(answer.told);
    });
  }
  /// `told`: what the mail server said; null: nobody was told.
  #sayTold(told) {
    if (told === null) return;
    this.frame.notify(told === '' ? t('The other administrators were told by mail') : t('Not sent: %1', told));
  }
  #confirm(one) {
    return this.#try(async () => {
      const answer = await api.post('/api/invitations/confirm', this.#order({ request: one.request }), { patience_ms: kPatience_ms });
      await this.load();
      await this.frame.requestsChanged();
      this.#show(answer);
    });
  }
  #revoke() {
    return this.#try(async () => {
      const answer = await api.post('/api/invitations/revoke', { users: this.#users(), reason: this.reason.input.value.trim() });
      this.#chosen.clear();
      this.#draw(answer);
      this.frame.notify(t('The links no longer work'));
    });
  }

  /// Shows the cards to print and cut, and the text to copy.
  #show({ centre, cards }) {
    const words = cards.map((one) => one.words).join('\n\n');
    const area = field(t('Words for a mail'), { rows: '8', readonly: true }, 'textarea');
    area.input.value = words;
    this.cards.replaceChildren(
      h('section', { class: 'card stack unprinted' },
        h('h2', {}, t('Shown only now')),
        h('p', { class: 'quiet' }, t('Each is for one person. Send each code by a different channel from the link, which another administrator hands over.')),
        area.row,
        h('div', { class: 'actions' },
          button(t('Copy'), () => this.#copy(area)),
          button(t('Print the cards'), () => window.print(), { class: 'primary' }))),
      h('ul', { class: 'handed' }, cards.map((one) => this.#card(centre, one))));
    this.cards.querySelector('textarea').focus();
  }
  #card(centre, one) {
    const line = (name, value, kind) => (value ? h('p', {}, h('span', { class: 'quiet' }, name), ' ', h('span', { class: kind }, value)) : null);
    return h('li', { class: 'card handed-card' }, h('h3', {}, 'Torsio', centre ? ` \u00b7 ${centre}` : ''),
      line(t('Sign-in name'), one.login, 'handed-name'),
      line(t('Link'), one.link, 'handed-link'),
      one.qr.length > 0 ? qrPicture(one.qr, t('The link for a phone')) : null,
      line(t('Code'), one.code, 'handed-link'),
      line(t('Works once, until'), one.until, ''),
      one.mail === null ? null : h('p', { class: `unprinted ${one.mail === '' ? 'good' : 'caution'}` },
        one.mail === '' ? t('Sent by mail') : t('Not sent: %1', one.mail)));
  }
  async #copy(area) {
    if (await copyText(area)) this.frame.notify(t('Copied'));
  }
}
