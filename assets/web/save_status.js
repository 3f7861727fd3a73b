// SPDX-License-Identifier: GPL-3.0-or-later
// Shows whether the draft is saved.
import { h, say } from './dom.js';
import { t } from './texts.js';

const kSilent_ms = 5000;

export class SaveStatus {
  element = h('span', { class: 'saved' });
  #troubled = false;
  #timer = null;

  /// Shows another text until the next change.
  say(text) {
    say(this.element, text);
  }
  /// `keeper`: DraftKeeper. Screen readers announce trouble and its end, not every change.
  show({ state, problem }) {
    clearTimeout(this.#timer);
    if (state === 'saving') this.#timer = setTimeout(() => this.#tell(t('The server does not answer; marks are kept here'), true), kSilent_ms);
    const texts = {
      idle: '',
      saving: t('Saving…'),
      saved: t('Saved'),
      waiting: t('Not saved yet, trying again'),
      signed_out: t('Not saved yet: sign in again'),
      conflict: t('Not saved: the sheet was changed elsewhere'),
      refused: t('Not saved: %1', problem?.message ?? ''),
    };
    this.#tell(texts[state], !['idle', 'saving', 'saved'].includes(state));
  }
  #tell(text, troubled) {
    this.element.setAttribute('aria-live', troubled || this.#troubled ? 'polite' : 'off');
    this.element.classList.toggle('caution', troubled);
    this.#troubled = troubled;
    say(this.element, text);
  }
}
