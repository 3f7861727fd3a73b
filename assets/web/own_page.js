// SPDX-License-Identifier: GPL-3.0-or-later
// A trainee's own record: the trend of each module with the criterion of competence, and the runs.
import { api } from './api.js';
import { h } from './dom.js';
import { clockTenths, dayText, figure, joinedSentences } from './numbers.js';
import { t } from './texts.js';
import { trendChart } from './trend_chart.js';

export const kPatience_ms = 120_000; // runs without metrics are measured first

/// "3 of 4 on target · passed", in the words of the window.
export function runText(run) {
  return run.result === '' ? t('running') : `${run.result}  \u00b7  ${run.outcome.word}`;
}

function unfolding(rates) {
  return h('details', { class: 'unfolds' }, h('summary', {}, t('How often is this wrong?')), rates);
}

/// A level is never shown alone, but with the criterion of competence and how often chance decides. Returns a
/// function for the verdicts of successive modules; the criterion that several share is stated with the first
/// of them. `showRates`: how the error rates are shown; they unfold on demand.
export function verdictTexts(showRates = unfolding) {
  const said = new Map();
  return (verdict, title) => {
    const how = joinedSentences([verdict.design, verdict.chance]);
    const told = said.has(how) ? t('Competence is judged as in “%1”.', said.get(how)) : how;
    const shared = said.has(how) ? [] : [verdict.errors];
    if (!said.has(how)) said.set(how, title);
    return h('div', { class: 'verdict' }, h('p', { class: verdict.able ? 'good' : '' }, verdict.level),
      h('p', { class: 'quiet' }, told), showRates(h('p', { class: 'quiet' }, joinedSentences([...shared, verdict.made]))));
  };
}

/// What a tracker recorded on the real arm; nothing if it recorded nothing.
export function realArmSection(runs) {
  return runs.length === 0 ? '' : h('section', { class: 'card stack' }, h('h2', {}, t('Movements recorded outside the simulator')),
    h('ul', {}, runs.map((run) => h('li', {}, `${dayText(run.started_utc_us)}, ${clockTenths(1e6 * run.duration_s)}: ${joinedSentences(run.told)}`))));
}

export class OwnPage {
  element = h('div', { class: 'queue' }, h('h1', {}, t('Your record')), h('p', { class: 'quiet', role: 'status' }, t('Being read…')));

  constructor(frame) {
    this.frame = frame;
  }
  get title() {
    return t('Your record');
  }
  async load() {
    const { code, modules, real_arm: realArm, runs } = await api.get('/api/own', { patience_ms: kPatience_ms });
    const tell = verdictTexts();
    this.element.replaceChildren(h('h1', {}, t('Your record')), h('p', { class: 'quiet' }, code),
      ...modules.map((module) => this.#module(module, tell)), realArmSection(realArm), this.#runs(runs));
  }
  resume() {
    this.load().catch(() => {}); // keeps the present content
  }

  #module(module, tell) {
    const facts = [t('%1: %2', module.metric, module.last ?? '\u2013')];
    if (module.wanted !== null) facts.push(t('wanted: %1', module.wanted));
    if (module.attempts_left !== null) facts.push(t('tries left: %1', figure(module.attempts_left)));
    return h('section', { class: 'card stack' }, h('h2', {}, module.title), tell(module.verdict, module.title),
      h('p', {}, facts.join('  \u00b7  ')), trendChart(module));
  }
  #runs(runs) {
    return h('section', { class: 'card wide-table', tabindex: '0' }, h('h2', {}, t('Your runs')),
      runs.length === 0 ? h('p', {}, t('Nothing was recorded yet.')) : h('table', {},
        h('thead', {}, h('tr', {}, [t('When'), t('Exercise'), t('Length'), t('Outcome')].map((head) => h('th', { scope: 'col' }, head)))),
        h('tbody', {}, runs.map((run) => h('tr', {},
          h('th', { scope: 'row' }, h('a', { href: `#run/${encodeURIComponent(run.run)}` }, dayText(run.started_utc_us))),
          h('td', {}, run.title || '\u2013'), h('td', {}, clockTenths(1e6 * run.duration_s)), h('td', {}, runText(run)))))));
  }
}
