// SPDX-License-Identifier: GPL-3.0-or-later
// The rater's bookmarks and remarks for the trainee, each at a moment of the recording.
import { NoConnection } from './api.js';
import { button, h, say, show } from './dom.js';
import { clockTenths } from './numbers.js';
import { problemText } from './problem.js';
import { t } from './texts.js';

const kLongestRemark = 400;

export class RemarksView {
  #edited = null; // the remark being edited; null: a new one
  #time_us = 0;
  #last = Promise.resolve();

  /// `store`: add(time_us, text), edit(id, text), read(): promises of the list. `player`: position of the
  /// playhead.
  constructor(remarks, store, player, done) {
    Object.assign(this, { remarks, store, player, done });
    this.bookmark = button(t('Bookmark'), () => this.addBookmark(), { title: t('Bookmarks this moment for yourself (B)') });
    this.remark = button(t('Remark'), () => this.ask(), { title: t('Writes to the trainee at this moment (R)') });
    this.list = h('ul', { class: 'remarks' });
    this.said = h('p', { class: 'caution', role: 'alert' });
    this.input = h('input', {
      maxlength: kLongestRemark, autocomplete: 'off', 'aria-label': t('Remark at this moment'),
      placeholder: t('Remark at this moment, for the trainee. Enter saves it, Esc discards it'),
    });
    this.form = h('form', { class: 'remark-form', onsubmit: (event) => this.#send(event) }, this.input,
      h('button', { type: 'submit' }, t('Store')), button(t('Cancel'), () => this.#close()));
    this.input.addEventListener('keydown', (event) => {
      if (event.key !== 'Escape' || event.isComposing) return;
      event.stopPropagation();
      this.#close();
    });
    this.element = h('section', { class: 'remarks-place', 'aria-label': t('Bookmarks and remarks') },
      h('div', { class: 'actions' }, this.bookmark, this.remark), this.form, this.said, this.list);
    show(this.form, false);
    this.#show();
  }
  /// True if there is unsaved text.
  get unsaved() {
    return !this.form.hidden && this.input.value.trim() !== '';
  }
  addBookmark() {
    const { ready, position_us } = this.player;
    if (ready) this.#store(() => this.store.add(position_us, ''));
  }
  ask() {
    if (!this.player.ready) return;
    this.#open(null, this.player.position_us, '');
  }
  /// Edits the reader's remark nearest to the playhead.
  editNearest() {
    const apart = (one) => Math.abs(one.time_us - this.player.position_us);
    const worded = this.remarks.filter((one) => one.text !== '');
    const nearest = worded.reduce((best, one) => (best && apart(best) <= apart(one) ? best : one), null);
    if (nearest) this.#edit(nearest);
  }

  #edit(one) {
    this.#open(one.id, one.time_us, one.text);
    this.input.select();
  }
  #open(id, time_us, text) {
    this.player.pause();
    this.#edited = id;
    this.#time_us = time_us;
    this.input.value = text;
    show(this.form, true);
    this.input.focus();
  }
  #close() {
    this.input.value = '';
    this.#edited = null;
    show(this.form, false);
    say(this.said, '');
    this.done();
  }
  async #send(event) {
    event.preventDefault();
    const text = this.input.value.trim();
    const same = this.remarks.some((one) => one.id === this.#edited && one.text === text);
    if (text === '' || same) {
      this.#close();
      return;
    }
    const [id, time_us] = [this.#edited, this.#time_us];
    const stored = await this.#store(() => (id === null ? this.store.add(time_us, text) : this.store.edit(id, text)));
    if (stored) this.#close();
  }
  /// Sends one by one: a remark may be typed while a bookmark is being sent.
  #store(send) {
    this.#last = this.#last.then(async () => {
      try {
        this.remarks = await send();
        say(this.said, '');
        this.#show();
        return true;
      } catch (error) {
        say(this.said, error instanceof NoConnection ? t('Not stored: the server does not answer. Try again.') : problemText(error));
        return false;
      }
    });
    return this.#last;
  }
  #show() {
    this.player.setBookmarks(this.remarks.map((one) => one.time_us));
    this.list.replaceChildren(...this.remarks.map((one) => {
      const at = clockTenths(one.time_us);
      const go = button(at, () => this.player.seek(one.time_us), { class: 'time', 'aria-label': t('Go to %1', at) });
      return one.text === ''
        ? h('li', {}, go)
        : h('li', {}, go, h('span', {}, one.edited ? t('%1 (edited)', one.text) : one.text), button(t('Edit'), () => this.#edit(one), { class: 'small', 'aria-label': t('Edit the remark at %1', at) }));
    }));
    if (this.remarks.length === 0) {
      this.list.append(h('li', { class: 'quiet' }, t('Only you see bookmarks; remarks reach the trainee when the marks are released.')));
    }
  }
}
