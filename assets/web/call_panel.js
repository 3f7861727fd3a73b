// SPDX-License-Identifier: GPL-3.0-or-later
// Calls trainees to the real arm: who is called, whose sheets are missing, reminders and the end of a call.
import { api } from './api.js';
import { copyText } from './copying.js';
import { askReason } from './dialogs.js';
import { button, field, h, say, show } from './dom.js';
import { figure, hourText } from './numbers.js';
import { problemText } from './problem.js';
import { t } from './texts.js';

const kAgain_ms = 2000;
const kSilent_ms = 5000; // a server that takes longer is said to be away
const kRoomKey = 'torsio.room';
const kLongestCode = 100;

function keptRoom() {
  try {
    return localStorage.getItem(kRoomKey) ?? '';
  } catch {
    return '';
  }
}

export class CallPanel {
  element = h('section', { class: 'card stack calls', 'aria-labelledby': 'calls-title' });
  calls = [];
  #timer = null;

  /// `path`: the cohort's address. `occasions`: [{code, label}]. `onChange()`: a call or the number of its sheets has
  /// changed.
  constructor(frame, path, occasions, onChange) {
    Object.assign(this, { frame, path, onChange });
    this.code = field(t('Call to the real arm'), { maxlength: kLongestCode, placeholder: t('code or scan'), autocomplete: 'off', autocapitalize: 'characters', spellcheck: 'false' });
    this.room = field(t('Room'), { maxlength: kLongestCode, value: keptRoom(), autocomplete: 'off' });
    this.occasion = field(t('for'), {}, 'select');
    this.occasion.input.append(h('option', { value: '' }, t('what is due')),
      ...occasions.map((one) => h('option', { value: one.code }, one.label)));
    this.go = h('button', { type: 'submit', class: 'primary' }, t('Call'));
    this.said = h('p', { class: 'said caution', role: 'alert' });
    this.away = h('p', { class: 'caution', role: 'status' });
    this.list = h('ul', { class: 'called' });
    this.reminder = field(t('Copy this into a message to these raters'), { rows: '3', readonly: true }, 'textarea');
    show(this.reminder.row, false);
    this.heard_ms = Date.now();
    this.element.append(
      h('h2', { id: 'calls-title' }, t('Calls to the real arm')),
      h('form', { class: 'call-form', novalidate: true, onsubmit: (event) => this.#call(event) },
        this.code.row, this.room.row, this.occasion.row, this.go),
      this.said, this.away, this.list, this.reminder.row);
  }
  get goesOn() {
    return this.calls.some((one) => one.open);
  }
  async load() {
    await this.#read();
  }
  left() {
    clearTimeout(this.#timer);
    this.gone = true;
  }

  async #read() {
    clearTimeout(this.#timer);
    const silent = setTimeout(() => this.#sayAway(), kSilent_ms);
    try {
      this.#show(await api.get(`${this.path}/calls`));
      this.heard_ms = Date.now();
      say(this.away, '');
    } catch (error) {
      if (error.needsSignIn || error.status === 403) return; // the page is loaded again after signing in
      this.#sayAway();
    } finally {
      clearTimeout(silent);
    }
    if (!this.gone) this.#timer = setTimeout(() => this.#read(), kAgain_ms);
  }
  #sayAway() {
    say(this.away, t('No connection since %1; what you see may be old.', hourText(this.heard_ms)));
  }
  #show({ calls }) {
    this.calls = calls;
    const now = JSON.stringify(calls);
    if (now === this.shown) return; // buttons are not rebuilt under a finger
    const first = this.shown === undefined;
    this.shown = now;
    this.list.replaceChildren(...calls.map((one) => this.#line(one)));
    show(this.list, calls.length > 0);
    if (!calls.some((one) => one.call === this.reminded && one.missing > 0)) show(this.reminder.row, false);
    if (first) return;
    say(this.said, ''); // what was refused may be possible now
    this.onChange();
  }
  #line(one) {
    const called = t('case %1 · %2 · %3 · %4', one.label, one.trainee, one.occasion, one.room);
    const words = [t('%1 of %2 sheets in', figure(one.submitted), figure(one.asked))];
    if (one.missing_text) words.push(one.missing_text);
    const sealed = one.open && !one.may_cancel;
    const why = `why-${one.call}`;
    return h('li', { class: one.open ? '' : 'caution' },
      h('span', {}, h('strong', {}, one.open ? t('● Called: %1', called) : t('! Late: %1', called)), ` ${words.join('; ')}`),
      h('span', { class: 'actions' },
        one.missing > 0 ? button(t('Copy reminder'), () => this.#remind(one)) : null,
        one.open ? button(t('Wrong person…'), () => this.#cancel(one), { class: 'cancel-call', disabled: sealed, 'aria-describedby': sealed ? why : null }) : null,
        one.open ? button(t('End call'), () => this.#act(one, 'end', {}), { class: 'end-call' }) : null),
      sealed ? h('p', { class: 'quiet', id: why }, t('A sheet is in: if it was the wrong person, end the call and report a deviation.')) : null);
  }

  async #call(event) {
    event.preventDefault();
    const given = { code: this.code.input.value.trim(), room: this.room.input.value.trim(), occasion: this.occasion.input.value };
    const missing = [this.code, this.room].find((one) => one.input.value.trim() === '');
    if (missing) {
      missing.input.focus();
      return;
    }
    try {
      localStorage.setItem(kRoomKey, given.room);
    } catch {
      // typed again next time
    }
    this.go.disabled = true;
    say(this.said, '');
    try {
      let answer = await api.post(`${this.path}/calls`, given);
      if (answer.objection) {
        const reason = await askReason(t('Call anyway'),
          t('%1, and "%2" is to be scored. Why now? It is noted as a deviation.', answer.objection, answer.occasion));
        if (!reason) return;
        answer = await api.post(`${this.path}/calls`, { ...given, reason });
      }
      this.code.input.value = '';
      this.#show(answer);
    } catch (error) {
      say(this.said, problemText(error));
    } finally {
      this.go.disabled = false;
      this.code.input.focus();
    }
  }
  async #act(one, act, body) {
    try {
      this.#show(await api.post(`${this.path}/calls/${encodeURIComponent(one.call)}/${act}`, body));
      say(this.said, '');
    } catch (error) {
      say(this.said, problemText(error));
    }
  }
  async #cancel(one) {
    const reason = await askReason(t('Withdraw the call'),
      t('Somebody other than %1 was at the arm: the sheets are closed again; what was typed is kept for the next call.', one.trainee));
    if (reason) await this.#act(one, 'cancel', { reason });
  }
  async #remind(one) {
    try {
      const { text } = await api.post(`${this.path}/calls/${encodeURIComponent(one.call)}/remind`, {});
      this.reminded = one.call;
      this.reminder.input.value = text;
      show(this.reminder.row, false);
      if (await copyText(this.reminder)) this.frame.notify(t('Copied: paste it into a message to these raters.'));
    } catch (error) {
      say(this.said, problemText(error));
    }
  }
}
