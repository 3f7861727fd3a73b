// SPDX-License-Identifier: GPL-3.0-or-later
// The reader's own second factor: whether it is on; switching it on or off.
import { api } from './api.js';
import { button, field, h, say } from './dom.js';
import { figure } from './numbers.js';
import { problemText } from './problem.js';
import { codeField, putSetUp } from './second_factor.js';
import { t } from './texts.js';

const kPatience_ms = 60_000; // passwords are checked one after the other

export class SecondFactorPage {
  element = h('div', { class: 'queue' });

  constructor(frame) {
    this.frame = frame;
  }
  get title() {
    return t('Second factor');
  }
  async load() {
    this.#draw(await api.get('/api/second-factor'));
  }

  #draw(state) {
    const place = h('div', {});
    this.element.replaceChildren(h('h1', {}, this.title), h('div', { class: 'card narrow' }, place));
    if (state.on) {
      this.#putState(place, state);
      return;
    }
    putSetUp(place, {
      offer: state.offer,
      why: t('With it, your password alone opens nothing: signing in also asks for a code from your phone.'),
      send: (given) => api.post('/api/second-factor', given, { quiet: true, patience_ms: kPatience_ms }),
      onDone: (answer) => {
        this.frame.entered(answer);
        this.frame.notify(t('The second factor is on'));
        this.frame.open('#sessions');
      },
    });
  }
  #putState(place, state) {
    const typed = field(t('Password'), { name: 'password', type: 'password', autocomplete: 'current-password', required: true });
    const code = codeField(t('Code from your app, or a recovery code'));
    const said = h('p', { class: 'said caution', role: 'alert' });
    const off = h('button', { type: 'submit' }, t('Switch off'));
    const form = h('form', { class: 'stack', novalidate: true },
      h('p', {}, t('It is on. Recovery codes not used yet: %1.', figure(state.recovery_codes_left))),
      h('p', {}, state.asked
        ? t('The centre asks you for it: after switching it off, the next sign-in sets it up again, on another phone for example.')
        : t('For another phone, or for new recovery codes, switch it off and on again.')),
      typed.row, code.row, said, off, button(t('Back'), () => this.frame.open('#sessions')));
    form.addEventListener('submit', async (event) => {
      event.preventDefault();
      const missing = [typed, code].find((one) => one.input.value.trim() === '');
      if (missing) {
        missing.input.focus();
        return;
      }
      off.disabled = true;
      try {
        this.#draw(await api.post('/api/second-factor/off', { password: typed.input.value, code: code.input.value.trim() }, { patience_ms: kPatience_ms }));
        this.frame.notify(t('The second factor is off'));
      } catch (error) {
        off.disabled = false;
        if (error.needsSignIn) return;
        say(said, problemText(error));
        code.input.select();
      }
    });
    place.replaceChildren(form);
  }
}
