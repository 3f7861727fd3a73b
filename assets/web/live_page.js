// SPDX-License-Identifier: GPL-3.0-or-later
// Live sheets: the called trainees in the order of the calls, and the sheet of one of them.
import { api, NoConnection } from './api.js';
import { CasePage } from './case_page.js';
import { bringIntoView, button, h, say, show } from './dom.js';
import { hourText, joinedSentences } from './numbers.js';
import { problemText } from './problem.js';
import { Stopwatch } from './stopwatch.js';
import { t } from './texts.js';

function stateText(line) {
  if (line.state === 'submitted') return t('submitted');
  if (line.state === 'draft') return line.open ? t('draft, called now') : t('draft, late');
  return line.open ? t('called now') : t('late, not begun');
}

function lineText(line) {
  return `${t('Case %1', line.label)} · ${stateText(line)}`;
}

export class LivePage {
  element = h('div', { class: 'live-page' });
  sheet = null; // CasePage of the open sheet
  #followed = '';
  #older = false;
  #told = ''; // about a call
  #away = ''; // about the server

  constructor(frame) {
    this.frame = frame;
    this.order = h('ol', { class: 'order' });
    this.olderButton = button('', () => {
      this.#older = !this.#older;
      this.#showLines();
    });
    this.notice = h('p', { class: 'caution other-call', role: 'status' });
    this.watch = new Stopwatch();
    this.place = h('div', { class: 'live-sheet' });
    this.element.append(
      h('div', { class: 'live-left' }, h('h1', {}, t('Live sheet')), this.order, this.olderButton, this.notice),
      h('div', { class: 'live-right' }, this.place));
  }
  get title() {
    return this.sheet?.opened ? t('Case %1', this.sheet.opened.label) : t('Live sheet');
  }
  get unsaved() {
    return Boolean(this.sheet?.unsaved);
  }
  /// True if the page may not leave the open sheet by itself.
  get #busy() {
    return this.unsaved || this.watch.running;
  }

  async load() {
    this.live = await api.get('/api/live');
    this.#showLines();
    this.#nobody();
    await this.#follow();
  }
  /// Called with each change of the calls.
  async callsChanged(live) {
    this.live = live;
    this.#showLines();
    if (!this.sheet) this.#nobody();
    await this.#follow();
  }
  /// Called when the server has stopped answering; null: it answers again.
  callsAway(since_ms) {
    this.#away = since_ms === null ? '' : t('No connection since %1; what you see may be old.', hourText(since_ms));
    this.#notify(this.#told);
  }
  #notify(told) {
    this.#told = told;
    say(this.notice, joinedSentences([this.#away, told]));
  }
  async #follow() {
    const shown = this.sheet?.handle ?? '';
    try {
      const guide = await api.post('/api/live/follow', { shown, busy: this.#busy ? 1 : 0, followed: this.#followed });
      if (guide.called && guide.opens && !this.#busy && shown === (this.sheet?.handle ?? '')) {
        this.#followed = guide.called.case;
        await this.#open(guide.called.case);
        return;
      }
      this.#notify(this.#noticeOf(guide));
    } catch (error) {
      if (!error.needsSignIn && !(error instanceof NoConnection)) this.#notify(problemText(error)); // callsAway() says the other
    }
  }
  #noticeOf({ called, other_room: otherRoom }) {
    if (!called) return '';
    return otherRoom
      ? t('Case %1 is called to %2: if you are there, choose it from the list.', called.label, called.room)
      : t('Case %1 is called now. What you have begun here is kept: submit it, or choose the case from the list and come back later.', called.label);
  }

  /// A late sheet is opened by hand alone: whoever waits for the next trainee must not score into it.
  #nobody() {
    const late = this.live.lines.filter((line) => line.state !== 'submitted' && !line.open);
    const called = this.live.lines.some((line) => line.open);
    const now = JSON.stringify([called, late]);
    if (this.place.firstChild === this.waiting && now === this.waitingFor) return; // nor are these buttons
    this.waitingFor = now;
    this.waiting = h('div', { class: 'card stack' }, h('h2', {}, called ? t('Nobody else is called now') : t('Nobody is called now')),
      h('p', {}, t('The sheet opens by itself when an administrator calls a case.')),
      ...(late.length === 0 ? [] : [
        h('p', { class: 'caution' }, t('These sheets are late. Choose one to fill it in:')),
        h('div', { class: 'actions late' }, late.map((line) => button(lineText(line), () => this.#choose(line.case)))),
      ]));
    this.place.replaceChildren(this.waiting);
  }
  #showLines() {
    const lines = this.live.lines.filter((line) => this.#older || !line.older);
    const hidden = this.live.lines.filter((line) => line.older).length;
    const shown = this.sheet?.handle;
    const texts = lines.map(lineText);
    const now = JSON.stringify([texts, shown]);
    if (now !== this.listed) { // buttons are not rebuilt under a finger
      this.listed = now;
      this.order.replaceChildren(...lines.map((line, i) => h('li', {},
        button(texts[i], () => this.#choose(line.case), { 'aria-current': line.case === shown ? 'true' : null }))));
      const wanted = lines.findLastIndex((line) => line.open && line.state !== 'submitted');
      const line = this.order.children[wanted] ?? this.order.querySelector('[aria-current]');
      if (line) bringIntoView(line, this.order);
    }
    show(this.olderButton, hidden > 0);
    say(this.olderButton, this.#older ? t('Hide earlier ones') : t('Show earlier ones (%1)', hidden));
  }
  async #choose(handle) {
    if (this.watch.running) {
      this.frame.notify(t('The timer is running. Stop it first'));
      return;
    }
    if (handle !== this.sheet?.handle) await this.#open(handle);
    await this.#follow();
  }
  async #open(handle) {
    this.sheet?.left();
    const sheet = new CasePage(this.#frameOf(), handle, { watch: this.watch });
    this.sheet = sheet;
    this.watch.reset();
    try {
      await sheet.load();
    } catch (error) {
      if (this.sheet !== sheet) return;
      this.sheet = null;
      if (error.needsSignIn) throw error;
      this.place.replaceChildren(h('p', { class: 'caution', role: 'alert' }, problemText(error)));
      return;
    }
    if (this.sheet !== sheet) return;
    this.place.replaceChildren(sheet.element);
    sheet.view.takeFocus();
    this.#notify('');
    this.#showLines();
  }
  /// The frame as the sheet sees it: what follows a sealed sheet is decided here.
  #frameOf() {
    return Object.assign(Object.create(this.frame), {
      open: () => this.#sealed(),
      saved: () => this.#refresh(),
    });
  }
  async #sealed() {
    const before = this.sheet;
    this.sheet = null;
    this.#followed = '';
    before?.left();
    this.watch.reset();
    try {
      await this.load();
      this.sheet?.waitForTouch();
    } catch (error) {
      if (!error.needsSignIn) this.frame.notify(problemText(error));
    }
  }
  async #refresh() {
    const line = this.live.lines.find((one) => one.case === this.sheet?.handle);
    if (line && line.state === 'open') {
      line.state = 'draft';
      this.#showLines();
    }
  }

  // Interface for the frame.
  settle() {
    return this.sheet?.settle();
  }
  left() {
    this.watch.reset();
    this.sheet?.left();
  }
  async resume() {
    await this.sheet?.resume();
    this.live = await api.get('/api/live').catch(() => this.live);
    this.#showLines();
  }
  online() {
    this.sheet?.online();
  }
  key(event) {
    this.sheet?.key(event);
  }
}
