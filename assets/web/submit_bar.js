// SPDX-License-Identifier: GPL-3.0-or-later
// Submitting and amending: missing answers, confirmation, signature.
import { NoConnection } from './api.js';
import { button, h, say, show } from './dom.js';
import { figure, joinedSentences } from './numbers.js';
import { problemText } from './problem.js';
import { signed } from './signing.js';
import { t } from './texts.js';

const kRounding = 0.1; // percent: the last tick of a recording has no duration
const kLongestReason = 200;

export class SubmitBar {
  #asking = false;
  #amending = false;
  #busy = false;

  /// `page`: what to submit (CasePage). Its case may already be submitted.
  constructor(page) {
    this.page = page;
    this.text = h('p', { class: 'check' });
    this.problem = h('p', { class: 'caution', role: 'alert' });
    this.reason = h('input', {
      maxlength: kLongestReason, placeholder: t('Why are you changing the mark?'), 'aria-label': t('Why are you changing the mark?'),
      autocomplete: 'off',
    });
    this.submit = button(t('Submit'), () => this.go(), { class: 'primary submit', title: t('Checks the sheet and asks once more (Ctrl+Enter)') });
    this.amend = button(page.opened.panel_open ? t('Move with a reason…') : t('Amend…'), () => this.#startAmending(), { class: 'amend' });
    this.back = button(t('Back to the sheet'), () => this.cancel());
    this.element = h('section', { class: 'submit-bar', 'aria-label': t('Submit') }, this.text, this.problem, this.reason,
      h('div', { class: 'actions' }, this.submit, this.amend, this.back));
    this.refresh();
  }
  get amending() {
    return this.#amending;
  }
  /// Call after a change of the sheet.
  edited() {
    this.#asking = false;
    this.refresh();
  }
  takeFocus() {
    (this.submit.hidden ? this.amend : this.submit).focus();
  }
  /// Asks for confirmation, then submits (button or Ctrl+Enter).
  async go() {
    if (this.#busy) return;
    if (this.#amending) {
      await this.#seal(() => this.#amendOnce());
    } else if (!this.page.sealed) {
      if (!this.#asking) {
        this.#ask();
      } else {
        await this.#answer();
      }
    }
  }
  /// Waits for the last viewing report, so that a quick answer is not rejected for it.
  async #answer() {
    if (this.#waits) return;
    this.#waits = true;
    await this.#heard;
    this.#waits = false;
    if (!this.#asking || this.#busy) return; // cancelled meanwhile
    if (this.#ready()) await this.#seal(() => this.#submitOnce());
    else this.#lead();
  }
  #heard = Promise.resolve();
  #waits = false;
  /// Cancels the confirmation; true if there was one.
  cancel() {
    if (!this.#asking && !this.#amending) return false;
    this.#asking = false;
    if (this.#amending) this.page.endAmending();
    this.#amending = false;
    say(this.problem, '');
    this.refresh();
    this.page.view.takeFocus();
    return true;
  }
  refresh() {
    const { sealed } = this.page;
    say(this.submit, this.#amending ? t('Seal the new version') : this.#asking ? t('Submit and seal (Ctrl+Enter)') : t('Submit'));
    show(this.submit, !sealed || this.#amending);
    show(this.amend, sealed && !this.#amending);
    show(this.back, this.#asking || this.#amending);
    show(this.reason, this.#amending);
    this.submit.disabled = this.#busy;
    const text = this.#amending ? this.#amendText() : sealed ? t('submitted and sealed') : this.#checkText();
    this.text.setAttribute('aria-live', this.#asking ? 'polite' : 'off'); // do not announce every second watched
    say(this.text, text);
    this.text.classList.toggle('caution', this.#asking && !this.#ready());
  }

  #ready() {
    const { check } = this.page;
    const guards = this.page.opened.live || (!check.watched_too_little && !check.speed_not_allowed);
    return this.page.editor.unanswered().length === 0 && guards;
  }
  #ask() {
    this.#asking = true;
    this.page.pause();
    this.refresh();
    if (!this.#ready()) this.#lead();
    this.#heard = this.page.freshCheck().then(() => this.refresh(), () => {});
  }
  /// Goes to what is missing.
  #lead() {
    const [first] = this.page.editor.unanswered();
    if (first !== undefined) this.page.view.mark(first);
    if (first === undefined && this.page.check.watched_too_little) {
      this.page.player.play.focus();
    } else {
      this.page.view.takeFocus();
    }
  }
  #checkText() {
    const { check, editor, view, opened } = this.page;
    const parts = [];
    const open = editor.unanswered();
    if (open.length > 0) parts.push(t('Still open: %1.', open.map((code) => view.nameOf(code)).join(t(', '))));
    if (!opened.live) {
      const share = t('%1 %', figure(Math.floor(100 * check.watched_share + kRounding)));
      const least = t('%1 %', figure(Math.round(100 * opened.rules.minimum_watched)));
      parts.push(check.watched_too_little ? t('Watched %1 so far; at least %2 is asked.', share, least) : t('Watched %1.', share));
    }
    if (check.speed_not_allowed) parts.push(t('It was played at a speed that is not allowed.'));
    if (check.soon_after_call_s !== null && this.#asking) parts.push(t('The trainee was called only %1 s ago. Is that intended?', figure(check.soon_after_call_s)));
    if (check.all_the_same) parts.push(t('All rows have the same mark. Is that intended?'));
    if (check.far_apart) parts.push(t('The rows lie far apart. Is that intended?'));
    if (check.overall_outside) parts.push(t("The overall mark is outside the rows' range. Is that intended?"));
    if (this.#asking && this.#ready()) parts.push(t('Submitting seals the sheet.'));
    return joinedSentences(parts);
  }
  #amendText() {
    return this.page.opened.panel_open
      ? t("The panel's marks are open: you move your mark with a reason, and it is flagged as moved after them. Both versions are kept.")
      : t('Change what must be changed, give the reason, seal the new version. Both versions are kept.');
  }
  #startAmending() {
    this.#amending = true;
    this.page.beginAmending();
    this.refresh();
    this.page.view.takeFocus();
  }

  async #seal(send) {
    this.#busy = true;
    this.page.view.setReadOnly(true); // later changes would not be part of the seal
    say(this.problem, '');
    this.refresh();
    try {
      await send();
    } catch (error) {
      say(this.problem, error instanceof NoConnection
        ? t('The server does not answer; nothing is lost. Try again: a sheet is never sealed twice.')
        : problemText(error));
      if (this.#amending) this.reason.focus();
    } finally {
      this.#busy = false;
      this.page.view.setReadOnly(this.page.sealed && !this.#amending);
      this.refresh();
    }
  }
  async #submitOnce() {
    const done = await signed((password) => this.page.sendSubmit(password), this.page.frame.login);
    if (done) this.page.submitted();
  }
  async #amendOnce() {
    const reason = this.reason.value.trim();
    if (reason === '') {
      say(this.problem, t('Say why the mark is changed.'));
      this.reason.focus();
      return;
    }
    const done = await signed((password) => this.page.sendAmend(reason, password), this.page.frame.login);
    if (!done) return;
    this.reason.value = '';
    this.#amending = false;
    this.page.amended();
  }
}
