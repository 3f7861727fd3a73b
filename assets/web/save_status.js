// SPDX-License-Identifier: GPL-3.0-or-later
// Shows whether the draft is saved.
import { h, say } from './dom.js';
import { t } from './texts.js';

export class SaveStatus {
  element = h('span', { class: 'saved' });
  #troubled = false;

  /// Shows another text until the next change.
  say(text) {
    say(this.element, text);
  }
  /// `keeper`: DraftKeeper. Screen readers announce trouble and its end, not every change.
  show({ state, problem }) {
    const troubled = !['idle', 'saving', 'saved'].includes(state);
    this.element.setAttribute('aria-live', troubled || this.#troubled ? 'polite' : 'off');
    this.element.classList.toggle('caution', troubled);
    this.#troubled = troubled;
    const texts = {
      idle: '',
      saving: t('Saving…'),
      saved: t('Saved'),
      waiting: t('Not saved yet, trying again'),
      signed_out: t('Not saved yet: sign in again'),
      conflict: t('Not saved: the sheet was changed elsewhere'),
      refused: t('Not saved: %1', problem?.message ?? ''),
    };
    say(this.element, texts[state]);
  }
}
