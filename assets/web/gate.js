// SPDX-License-Identifier: GPL-3.0-or-later
// Covers the page when the user is no longer signed in: after idle time, or because the server ended the
// session. The page behind is preserved.
import { button, h, show } from './dom.js';
import { putSignInForm } from './sign_in_form.js';
import { t } from './texts.js';

export class Gate {
  element = h('section', { class: 'gate', 'aria-labelledby': 'gate-title', hidden: true });

  /// `behind`: the element to hide. `onSignOut()`: the user gives up the session.
  constructor(behind, onSignOut) {
    this.behind = behind;
    this.onSignOut = onSignOut;
  }
  get closed() {
    return !this.element.hidden;
  }
  /// `ended`: resolves when the old session has ended. `onSignedIn(answer)`: the same person signed in again.
  close(login, ended, onSignedIn) {
    if (this.closed) return;
    this.focused = document.activeElement;
    document.querySelectorAll('dialog[open]').forEach((dialog) => dialog.close());
    const place = h('div', {});
    this.element.replaceChildren(
      h('div', { class: 'card narrow' },
        h('h1', { id: 'gate-title' }, t('Locked')),
        h('p', {}, t('%1 is signed in here. Nothing was lost; work continues where it was left.', login)),
        place,
        button(t('Sign out'), this.onSignOut),
      ),
    );
    this.behind.inert = true;
    this.behind.classList.add('veiled');
    show(this.element, true);
    putSignInForm(place, {
      login,
      action: t('Unlock'),
      ready: ended,
      onSignedIn: (answer) => {
        this.open();
        onSignedIn(answer);
      },
    });
  }
  open() {
    this.behind.inert = false;
    this.behind.classList.remove('veiled');
    this.element.replaceChildren();
    show(this.element, false);
    this.focused?.focus?.();
  }
}
