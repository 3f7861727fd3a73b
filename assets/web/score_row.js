// SPDX-License-Identifier: GPL-3.0-or-later
// One row of the rubric: name, scale, answer, anchors, and a field for the reason of a missing mark.
import { button, h, say, show } from './dom.js';
import { scoreText } from './numbers.js';
import { t } from './texts.js';

const kMaxCells = 11;
const kLongestReason = 200;
let made = 0;

export class ScoreRow {
  #answer = { score_steps: null, not_assessable: '' };
  #before = null; // the answer when the reason was requested
  #current = false;

  /// `on`: events wanted(), scored(steps), adjusted(direction), reasoned(text), takenBack(answer),
  /// finished(). `reasons`: choices instead of a mark; null: a mark is required.
  constructor({ code, label, description = '', scale, anchors = [], reasons = [] }, on) {
    Object.assign(this, { code, label, scale, anchors, on });
    const id = `row-${++made}`;
    this.value = h('output', { class: 'value', 'aria-hidden': 'true' });
    this.strip = h('div', {
      class: 'strip', role: 'slider', tabindex: '0', 'aria-labelledby': `${id}-name`, 'aria-describedby': `${id}-anchor`,
      'aria-valuemin': scale.lowest_steps / scale.steps_per_point,
      'aria-valuemax': scale.highest_steps / scale.steps_per_point,
      onfocus: () => on.wanted(),
      onclick: (event) => this.#pressed(event),
    }, this.#cells());
    this.anchor = h('p', { class: 'anchor', id: `${id}-anchor` });
    this.reason = h('input', {
      maxlength: kLongestReason, list: `${id}-reasons`, autocomplete: 'off',
      placeholder: t('Why can this not be judged? Enter ends, Esc takes it back'),
      'aria-label': t('Why %1 cannot be judged', label),
      oninput: () => on.reasoned(this.reason.value),
      onfocus: () => this.#reasonBegins(),
      onblur: () => this.#reasonEnds(),
      onkeydown: (event) => this.#reasonKey(event),
    });
    this.reasonPlace = h('div', { class: 'reason' }, this.reason,
      h('datalist', { id: `${id}-reasons` }, (reasons ?? []).map((one) => h('option', { value: one }))));
    this.buttons = [
      button('\u2212', () => on.adjusted(-1), { tabindex: '-1', 'aria-label': t('%1: half a point less', label) }),
      button('+', () => on.adjusted(+1), { tabindex: '-1', 'aria-label': t('%1: half a point more', label) }),
      button(t('Not assessable'), () => this.askReason(), { tabindex: '-1', class: 'small', 'aria-label': t('%1: not assessable', label) }),
    ];
    this.element = h('div', { class: 'row', role: 'group', 'aria-labelledby': `${id}-name` },
      h('div', { class: 'row-head' }, h('span', { class: 'name', id: `${id}-name` }, label), this.value,
        h('span', { class: 'row-buttons' }, this.buttons)),
      this.strip, this.anchor, this.reasonPlace);
    show(this.anchor, anchors.length > 0);
    if (reasons === null) this.buttons.pop().remove();
    if (description) this.element.insertBefore(h('p', { class: 'anchor description' }, description), this.strip);
    this.setAnswer(this.#answer);
  }

  setAnswer(answer) {
    this.#answer = answer;
    const { score_steps: steps, not_assessable: reason } = answer;
    const text = steps !== null ? scoreText(steps, this.scale) : reason ? t('not assessable') : '\u2013';
    say(this.value, text);
    this.strip.setAttribute('aria-valuetext', steps === null && !reason ? t('no mark yet') : text);
    const number = steps ?? this.scale.lowest_steps;
    this.strip.setAttribute('aria-valuenow', number / this.scale.steps_per_point);
    for (const [i, cell] of [...this.strip.children].entries()) {
      const apart = steps === null ? Infinity : Math.abs(steps - this.#stepsOf(i));
      cell.classList.toggle('chosen', apart === 0);
      cell.classList.toggle('beside', apart > 0 && apart < this.scale.steps_per_point);
    }
    if (this.reason.value !== reason) this.reason.value = reason;
    show(this.reasonPlace, reason !== '' || document.activeElement === this.reason);
    this.#showAnchor();
  }
  setCurrent(current) {
    this.#current = current;
    this.element.classList.toggle('current', current);
    this.#showAnchor();
  }
  setReadOnly(readOnly) {
    this.readOnly = readOnly;
    this.reason.readOnly = readOnly;
    this.strip.setAttribute('aria-readonly', String(readOnly));
    this.buttons.forEach((one) => show(one, !readOnly));
  }
  /// Opens and focuses the field for the reason.
  askReason() {
    if (this.readOnly) return;
    this.#before = this.#answer;
    this.on.wanted();
    show(this.reasonPlace, true);
    this.reason.focus();
  }
  takeFocus() {
    this.strip.focus();
  }
  holds(element) {
    return this.element.contains(element);
  }

  #cells() {
    const span = (this.scale.highest_steps - this.scale.lowest_steps) / this.scale.steps_per_point;
    this.count = Math.min(span + 1, kMaxCells);
    return Array.from({ length: this.count }, (_, i) => h('span', { class: 'cell' }, scoreText(this.#stepsOf(i), this.scale)));
  }
  #stepsOf(cell) {
    const span = (this.scale.highest_steps - this.scale.lowest_steps) / this.scale.steps_per_point;
    return this.scale.lowest_steps + Math.floor((span * cell) / Math.max(1, this.count - 1)) * this.scale.steps_per_point;
  }
  #pressed(event) {
    if (this.readOnly) return;
    const cell = [...this.strip.children].indexOf(event.target.closest('.cell'));
    if (cell >= 0) this.on.scored(this.#stepsOf(cell));
  }
  /// Shows all anchors in the active row, otherwise the one of the score.
  #showAnchor() {
    const steps = this.#answer.score_steps;
    const line = (one) => t('%1: %2', scoreText(one.steps, this.scale), one.text);
    if (this.#current || steps === null) {
      say(this.anchor, this.anchors.map(line).join('  \u00b7  '));
      return;
    }
    const apart = (one) => Math.abs(one.steps - steps);
    const nearest = this.anchors.reduce((best, one) => (best && apart(best) <= apart(one) ? best : one), null);
    say(this.anchor, nearest ? line(nearest) : '');
  }

  #reasonBegins() {
    this.#before ??= this.#answer;
    this.on.wanted();
  }
  #reasonEnds() {
    this.#before = null;
    show(this.reasonPlace, this.#answer.not_assessable !== '');
  }
  #reasonKey(event) {
    if (event.isComposing || event.ctrlKey || event.metaKey) return;
    if (event.key === 'Escape') {
      // Reverts only the reason typed since N: an existing score stays.
      this.on.takenBack(this.#before ?? this.#answer);
    } else if (event.key !== 'Enter') {
      return;
    }
    event.preventDefault();
    event.stopPropagation();
    this.on.finished();
  }
}
