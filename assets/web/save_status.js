// SPDX-License-Identifier: GPL-3.0-or-later
// Says whether what was typed is at the server.
import { h, say } from './dom.js';
import { t } from './texts.js';

export class SaveStatus {
  element = h('span', { class: 'saved' });
  #troubled = false;

  /// Something else, until the next change.
  say(text) {
    say(this.element, text);
  }
  /// `keeper`: DraftKeeper. A screen reader tells of trouble and of its end, not of each key.
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
