// SPDX-License-Identifier: GPL-3.0-or-later
// Keys of a sheet: selected row, digits, arrows; like the window's SheetPanel. Independent of the page.
import { stepsForDigit } from './sheet_editor.js';

export class SheetKeys {
  #typed = null; // points typed so far in this row

  constructor(editor) {
    this.editor = editor;
    this.current = editor.order()[0];
    this.advancing = false;
  }

  mark(code) {
    if (code !== this.current) this.#typed = null;
    this.current = code;
  }
  /// Selects the next or previous row, wrapping round.
  step(direction) {
    const order = this.editor.order();
    const at = order.indexOf(this.current) + direction;
    this.mark(order[(at + order.length) % order.length]);
  }
  setAdvancing(advancing) {
    this.advancing = advancing;
    this.#typed = null;
  }

  /// The methods below return whether the sheet changed.
  digit(value) {
    if (this.advancing && this.#typed !== null && !this.#longer(this.#typed, value)) {
      this.#advance(); // the previous figure was complete
    }
    const scale = this.editor.scale(this.current);
    const steps = stepsForDigit(scale, value, this.#typed);
    if (steps === null) return false;
    const points = steps / scale.steps_per_point;
    const joins = this.#typed !== null && points > 9;
    this.#typed = points;
    const changed = this.editor.setScore(this.current, steps, joins);
    if (this.advancing && (joins || !this.#longer(points, 0))) this.#advance();
    return changed;
  }
  /// Adjusts by half a point, or the finest step. Only existing scores are adjusted.
  adjust(direction, finest = false) {
    this.#typed = null;
    const scale = this.editor.scale(this.current);
    const { score_steps } = this.editor.answer(this.current);
    if (score_steps === null) return false;
    const wanted = score_steps + direction * (finest ? 1 : scale.arrow_steps);
    return this.editor.setScore(this.current, Math.min(Math.max(wanted, scale.lowest_steps), scale.highest_steps));
  }
  clear() {
    this.#typed = null;
    return this.editor.clear(this.current);
  }
  /// Sets a score by mouse or touch.
  choose(code, steps) {
    this.mark(code);
    this.#typed = null;
    const changed = this.editor.setScore(code, steps);
    if (this.advancing) this.#advance();
    return changed;
  }

  #longer(points, next) {
    const scale = this.editor.scale(this.current);
    const steps = stepsForDigit(scale, next, points);
    return points > 0 && steps !== null && steps / scale.steps_per_point === points * 10 + next;
  }
  /// Selects the next row; stays on the last.
  #advance() {
    if (this.current !== this.editor.order().at(-1)) this.step(+1);
    this.#typed = null;
  }
}
