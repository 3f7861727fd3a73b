// SPDX-License-Identifier: GPL-3.0-or-later
// The second factor: typing its code, and setting it up with an authenticator app.
import { button, field, h, say } from './dom.js';
import { problemText } from './problem.js';
import { qrPicture } from './svg.js';
import { t } from './texts.js';

const kLettersOfAGroup = 4;

/// A field for six digits or a recovery code.
export function codeField(label) {
  return field(label, { name: 'code', autocomplete: 'one-time-code', autocapitalize: 'none', spellcheck: 'false', required: true });
}

/// Asks in `place` for the code. `send(code)`: rejects if it is not right. `onBack()`: none: no way back.
export function putCodeForm(place, { action, send, onBack }) {
  const code = codeField(t('Code from your app, or a recovery code'));
  const said = h('p', { class: 'said caution', role: 'alert' });
  const go = h('button', { class: 'primary', type: 'submit' }, action);
  place.replaceChildren(h('form', { class: 'stack', novalidate: true, onsubmit: check },
    h('h2', {}, t('Second factor')),
    h('p', {}, t('Your password is right. Type the six digits that your authenticator app shows now.')),
    code.row, said, go, onBack ? button(t('Back'), onBack) : null));
  code.input.focus();

  async function check(event) {
    event.preventDefault();
    if (go.disabled) return;
    if (code.input.value.trim() === '') {
      code.input.focus();
      return;
    }
    go.disabled = true;
    say(said, '');
    try {
      await send(code.input.value.trim());
    } catch (error) {
      say(said, problemText(error));
      code.input.select();
      code.input.focus();
    } finally {
      go.disabled = false;
    }
  }
}

function inGroups(secret) {
  return secret.replace(new RegExp(`(.{${kLettersOfAGroup}})(?=.)`, 'g'), '$1 ');
}

/// Sets the second factor up in `place`. `offer`: of the server. `why`: a sentence. `password`: asked for if
/// empty. `send({login, password, secret, code})` returns the server's answer, with ten recovery codes;
/// `onDone(answer)` once they were taken down. `onBack()`: none: no way back.
export function putSetUp(place, { offer, why, password = '', send, onDone, onBack }) {
  const typed = field(t('Password'), { name: 'password', type: 'password', autocomplete: 'current-password', required: true });
  const code = codeField(t('The six digits that the app shows now'));
  const said = h('p', { class: 'said caution', role: 'alert' });
  const go = h('button', { class: 'primary', type: 'submit' }, t('Switch on'));
  place.replaceChildren(h('form', { class: 'stack', novalidate: true, onsubmit: switchOn },
    h('h2', {}, t('Set up the second factor')),
    h('p', {}, why),
    h('p', {}, t('Scan this picture with an authenticator app on your phone, or type the secret into it.')),
    qrPicture(offer.qr, t('QR code of the secret')),
    h('p', { class: 'secret' }, inGroups(offer.secret)),
    h('p', {}, h('a', { href: offer.uri }, t('Open an app on this device'))),
    password === '' ? typed.row : null,
    code.row, said, go, onBack ? button(t('Back'), onBack) : null));
  (password === '' ? typed : code).input.focus();

  async function switchOn(event) {
    event.preventDefault();
    if (go.disabled) return;
    const given = { login: offer.login, password: password || typed.input.value, secret: offer.secret, code: code.input.value.trim() };
    if (given.password === '' || given.code === '') {
      (given.password === '' ? typed : code).input.focus();
      return;
    }
    go.disabled = true;
    say(said, '');
    try {
      const answer = await send(given);
      putRecoveryCodes(place, answer.recovery_codes, () => onDone(answer));
    } catch (error) {
      say(said, problemText(error));
      code.input.select();
      code.input.focus();
      go.disabled = false;
    }
  }
}

/// Shows the recovery codes, once.
function putRecoveryCodes(place, codes, onTaken) {
  // Not the button is focused: an Enter that is held too long must not put them away.
  const heading = h('h2', { tabindex: '-1' }, t('Recovery codes'));
  place.replaceChildren(h('div', { class: 'stack' },
    heading,
    h('p', {}, t('The second factor is on. Without your phone, each of these codes signs you in once. They are shown only now: print them or write them down, and keep them away from this computer.')),
    h('ul', { class: 'recovery' }, codes.map((code) => h('li', {}, code))),
    button(t('I have taken them down'), onTaken, { class: 'primary' })));
  heading.focus();
}
