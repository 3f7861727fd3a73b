// SPDX-License-Identifier: GPL-3.0-or-later
// A trainee's transcript, printed from the browser.
import { api } from './api.js';
import { button, h } from './dom.js';
import { dayText, figure } from './numbers.js';
import { kPatience_ms, realArmSection, runText, verdictTexts } from './own_page.js';
import { t } from './texts.js';

export class TranscriptPage {
  element = h('div', { class: 'queue transcript' }, h('h1', {}, t('Transcript')));

  constructor(frame) {
    this.frame = frame;
  }
  get title() {
    return t('Transcript');
  }
  /// Requested on demand, because the server logs each request.
  async load() {
    this.element.replaceChildren(h('h1', {}, t('Transcript')),
      h('p', {}, t('Everything that you have done, to print or to keep. That it was made is noted in the audit trail.')),
      button(t('Make the transcript'), () => this.#make(), { class: 'primary' }));
  }
  async #make() {
    const made = await api.get('/api/own/transcript', { patience_ms: kPatience_ms });
    const tell = verdictTexts((rates) => rates); // folded ones would not be printed
    const about = [made.centre, made.name || made.code, made.code, made.cohort, made.arm].filter((one) => one !== '');
    this.element.replaceChildren(
      h('div', { class: 'page-head' }, h('h1', {}, t('Transcript')), button(t('Print'), () => window.print())),
      h('p', {}, about.join('  \u00b7  ')),
      h('p', {}, t('Virtual %1 min, real arm %2 min, rest %3 min', figure(made.virtual_min), figure(made.real_min), figure(made.rest_min))),
      ...made.modules.map((module) => h('section', { class: 'card stack' },
        h('h2', {}, module.mastered ? t('%1: mastered', module.title) : module.title), tell(module.verdict, module.title),
        h('ul', {}, module.attempts.map((run) => h('li', {}, `${dayText(run.started_utc_us)}: ${runText(run)}`))))),
      realArmSection(made.real_arm),
      h('p', { class: 'quiet' }, t('Made on %1 with Torsio %2. A training record, no certificate of clinical competence.', dayText(made.made_utc_us), made.version)),
      made.demonstration ? h('p', { class: 'caution' }, t('Simulated people')) : '');
  }
}
