// SPDX-License-Identifier: GPL-3.0-or-later
// The boards of the day, with calls to the real arm, and of marks, for administrators.
import { api } from './api.js';
import { CallPanel } from './call_panel.js';
import { h, say, show } from './dom.js';
import { clockTime, dayText, figure } from './numbers.js';
import { t } from './texts.js';

const kAgain_ms = 10_000;

function table(heads, rows) {
  return h('table', {},
    h('thead', {}, h('tr', {}, heads.map((head) => h('th', { scope: 'col' }, head)))),
    h('tbody', {}, rows));
}

export class BoardPage {
  element = h('div', { class: 'queue wide' });
  #timer = null;

  /// `scored`: the board of marks; otherwise that of the day.
  constructor(frame, scored) {
    this.frame = frame;
    this.scored = scored;
  }
  get title() {
    return this.scored ? t('Who has scored what') : t("Today's sessions");
  }
  async load() {
    this.gone = false;
    const { cohorts, first } = await api.get('/api/cohorts');
    this.cohorts = cohorts;
    const choice = h('select', {
      'aria-label': t('Cohort'),
      onchange: () => {
        this.cohort = cohorts[choice.selectedIndex].cohort;
        this.#endCalls();
        this.#read().catch(() => {});
      },
    }, cohorts.map((one, i) => h('option', { selected: i === first }, one.name)));
    this.cohort = cohorts[first]?.cohort;
    this.place = h('div', { class: 'stack' });
    this.callPlace = h('div', {});
    this.waiting = h('p', { class: 'caution', role: 'status' });
    this.#showWaiting();
    this.#endCalls();
    show(choice, cohorts.length > 0);
    this.element.replaceChildren(h('div', { class: 'page-head' }, h('h1', {}, this.title), choice), this.waiting, this.callPlace, this.place);
    if (this.cohort) await this.#read();
    else this.place.replaceChildren(h('p', {}, t('There is no cohort yet.')));
  }
  async #read() {
    const path = `/api/cohorts/${encodeURIComponent(this.cohort)}`;
    if (this.scored) {
      this.#showScored(await api.get(`${path}/scored`));
      return;
    }
    clearTimeout(this.#timer);
    try {
      const board = await api.get(`${path}/board`);
      this.#showBoard(board);
      if (!this.element.matches(':hover')) this.#showWaiting(); // moves nothing under the pointer
      await this.#showCalls(path, board.occasions);
    } catch (error) {
      if (error.needsSignIn || error.status === 403) this.gone = true; // the page is loaded again after signing in
      throw error;
    } finally {
      clearTimeout(this.#timer);
      if (!this.gone) this.#timer = setTimeout(() => this.#read().catch(() => {}), kAgain_ms);
    }
  }
  #showWaiting() {
    say(this.waiting, this.frame.requestsWait);
    show(this.waiting, this.frame.requestsWait !== '');
  }
  async #showCalls(path, occasions) {
    if (this.calls) return;
    this.calls = new CallPanel(this.frame, path, occasions, () => this.#read().catch(() => {}));
    this.callPlace.replaceChildren(this.calls.element);
    await this.calls.load();
  }
  #endCalls() {
    this.calls?.left();
    this.calls = null;
  }
  /// A board with an open call is not locked.
  get callsGoOn() {
    return Boolean(this.calls?.goesOn);
  }
  left() {
    this.gone = true;
    clearTimeout(this.#timer);
    this.#endCalls();
  }
  resume() {
    this.load().catch(() => {}); // keeps the present content
  }

  #showBoard({ rows, stations, alerts }) {
    const missing = rows.reduce((sum, row) => sum + row.sheets_missing, 0);
    const state = (row) => (row.withdrawn ? t('withdrew') : row.station ? t('records at %1', row.station) : row.done ? t('all phases done') : row.phase || '\u2013');
    const attention = alerts.length === 0 ? null : h('section', { class: 'card', 'aria-label': t('What needs attention') },
      h('ul', { class: 'alerts' }, alerts.map((one) => h('li', { class: 'caution' }, `\u26a0 ${one}`))));
    this.place.replaceChildren(
      ...(attention ? [attention] : []),
      h('p', {}, t('%1 recording now, %2 of %3 done, sheets due and missing: %4', figure(rows.filter((row) => row.station).length),
        figure(rows.filter((row) => row.done).length), figure(rows.length), figure(missing))),
      h('section', { class: 'card wide-table', tabindex: '0' }, table(
        [t('Trainee'), t('Group'), t('Now at'), t('Time left'), t('Scoring due'), t('Sheets missing'), t('Deviations'), t('Planned')],
        rows.map((row) => h('tr', {}, h('th', { scope: 'row' }, row.trainee), h('td', {}, row.group || '\u2013'), h('td', {}, state(row)),
          h('td', {}, row.done || row.left_us === 0 ? '' : clockTime(row.left_us)), h('td', {}, row.occasion),
          h('td', { class: row.sheets_missing > 0 ? 'caution' : '' }, row.sheets || '\u2013'), h('td', {}, figure(row.deviations)),
          h('td', { class: row.overdue ? 'caution' : '' }, row.planned_utc_us === null ? '' : dayText(row.planned_utc_us)))))),
      h('section', { class: 'card wide-table', tabindex: '0' }, h('h2', {}, t('Stations')), table(
        [t('Station'), t('Trainee'), t('Last seen')],
        stations.map((one) => h('tr', {}, h('th', { scope: 'row' }, one.station), h('td', {}, one.trainee || '\u2013'),
          h('td', { class: one.silent ? 'caution' : '' }, one.silent ? t('does not answer') : t('just now')))))));
  }
  #showScored({ raters, lines }) {
    const marks = { submitted: '\u25cf', draft: '\u25d0', open: '\u25cb', '': '' };
    const words = { submitted: t('submitted'), draft: t('draft'), open: t('open'), '': t('not asked') };
    this.place.replaceChildren(
      h('p', { class: 'quiet' }, t('● submitted, ◐ draft, ○ open. No marks are shown here.')),
      h('section', { class: 'card wide-table', tabindex: '0' }, table([t('Trainee'), t('Occasion'), ...raters.map((rater) => rater.code)],
        [...lines.map((line) => h('tr', {}, h('th', { scope: 'row' }, line.trainee), h('td', {}, line.occasion),
          line.cells.map((cell) => h('td', {}, h('span', { role: 'img', 'aria-label': words[cell] }, marks[cell]))))),
        h('tr', {}, h('th', { scope: 'row' }, t('Still open')), h('td', {}), raters.map((rater) => h('td', {}, figure(rater.open))))])));
  }
}
