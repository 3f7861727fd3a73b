// SPDX-License-Identifier: GPL-3.0-or-later
// Angle, torque and force over time, with watched stretches, bookmarks and playhead. A click seeks.
import { h } from './dom.js';
import { clockTenths, clockTime, figure } from './numbers.js';
import { t } from './texts.js';
import { drawLane, lane, scaleText, sizeText } from './trace_lane.js';

const kLaneGap = 6;
const kWatchedHeight = 4;
const kTicks_s = [1, 2, 5, 10, 30, 60, 120, 300, 600, 1800];

const kLanesOfATwist = 3;

/// Lanes of an untwisting: blood, and lumen if the organ has one; empty for a twist.
function bloodLanes(arrays) {
  if (!arrays.flow_percent) return [];
  const lanes = [
    lane({ name: t('Blood flow'), unit: '%', colour: 'caution', low: arrays.flow_percent }),
    lane({ name: t('Dose'), unit: '', colour: 'text', low: arrays.dose, limit: 1 }),
  ];
  if (!arrays.pressure_mmHg) return lanes;
  return [...lanes,
    lane({ name: t('Lumen'), unit: '%', colour: 'good', low: arrays.patency_percent }),
    lane({ name: t('Pressure'), unit: 'mmHg', colour: 'accent', low: arrays.pressure_mmHg })];
}

function colours() {
  const style = getComputedStyle(document.documentElement);
  const get = (name) => style.getPropertyValue(`--${name}`).trim();
  return Object.fromEntries(
    ['text', 'quiet', 'surface', 'line', 'accent', 'good', 'caution', 'track'].map((name) => [name, get(name)]),
  );
}

export class Traces {
  canvas = h('canvas', {
    class: 'traces', role: 'slider', tabindex: '0', 'aria-label': t('Time in the recording'), 'aria-valuemin': 0,
    'aria-valuemax': 0, 'aria-valuenow': 0,
  });
  #still = document.createElement('canvas');
  #lanes = [];
  #watched = [];
  #bookmarks_us = [];
  #position_us = 0;
  #awaits = false;
  #stale = true;

  /// `onSeek(position_us)`.
  constructor(onSeek) {
    this.onSeek = onSeek;
    new ResizeObserver(() => this.#redraw(true)).observe(this.canvas);
    window.matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => this.#redraw(true));
    this.canvas.addEventListener('mousedown', (event) => event.preventDefault()); // the sheet keeps the focus
    this.canvas.addEventListener('pointerdown', (event) => {
      this.canvas.setPointerCapture(event.pointerId);
      if (event.pointerType !== 'touch') this.#seekTo(event.clientX); // a finger may be about to scroll
    });
    this.canvas.addEventListener('pointermove', (event) => {
      if (event.buttons & 1) this.#seekTo(event.clientX);
    });
    this.canvas.addEventListener('click', (event) => this.#seekTo(event.clientX));
    this.canvas.addEventListener('keydown', (event) => this.#key(event));
  }

  /// `task`: of the case, with band, and limit, unit and decimals of torque and force.
  setRecording(recording, task) {
    Object.assign(this, { recording, task });
    const { arrays } = recording;
    const band = task.untwisting ? null : { target: arrays.target_deg, tolerance: task.tolerance_deg };
    this.#lanes = [
      lane({ name: t('Angle'), unit: '\u00b0', colour: 'accent', low: arrays.angle_deg, band }),
      lane({
        name: t('Torque'), colour: 'good', low: arrays.torque_Nm, fine: task.untwisting, ...task.torque,
      }),
      lane({
        name: t('Force'), colour: 'caution', low: arrays.force_low_N ?? arrays.force_N,
        high: arrays.force_high_N ?? arrays.force_N, value: arrays.force_N, ...task.force,
      }),
      ...bloodLanes(arrays),
    ];
    this.canvas.classList.toggle('many', this.#lanes.length > kLanesOfATwist);
    this.canvas.setAttribute('aria-valuemax', Math.round(recording.meta.length_us / 1e6));
    this.#describe();
    this.#redraw(true);
  }
  #describe() {
    if (!this.recording) return;
    const { torque } = this.task;
    const peaks = this.#lanes.slice(0, kLanesOfATwist).map((one) => figure(Math.max(-one.least, one.most), one.factor > 1 ? torque.decimals : one.decimals));
    this.canvas.setAttribute(
      'aria-description',
      t('%1 long; greatest angle %2 degrees, torque %3 newton metres, force %4 newtons; bookmarks: %5',
        clockTenths(this.recording.meta.length_us), ...peaks, figure(this.#bookmarks_us.length)),
    );
  }
  setPosition(position_us) {
    this.#position_us = position_us;
    this.canvas.setAttribute('aria-valuenow', Math.round(position_us / 1e6));
    this.canvas.setAttribute('aria-valuetext', clockTenths(position_us));
    this.#redraw();
  }
  setWatched(stretches) {
    this.#watched = stretches;
    this.#redraw();
  }
  setBookmarks(times_us) {
    this.#bookmarks_us = times_us;
    this.#describe();
    this.#redraw();
  }
  /// Returns the values at the playhead, shown beside the lanes.
  readings() {
    if (!this.recording) return [];
    const { rate_hz, frames } = this.recording.meta;
    const at = Math.min(Math.round((this.#position_us * rate_hz) / 1e6), frames - 1);
    return this.#lanes.map((one) => sizeText(one, one.value[at]));
  }

  #seekTo(x_px) {
    if (!this.recording) return;
    const { left, right } = this.#plot();
    const share = (x_px - this.canvas.getBoundingClientRect().left - left) / (right - left);
    this.onSeek(Math.min(Math.max(share, 0), 1) * this.recording.meta.length_us);
  }
  /// Left and right move the playhead here, like a slider; elsewhere they belong to the sheet.
  #key(event) {
    const steps = { ArrowLeft: -1e6, ArrowRight: 1e6, PageDown: -5e6, PageUp: 5e6 };
    if (!(event.key in steps) || event.ctrlKey || event.altKey || event.metaKey) return;
    event.preventDefault();
    event.stopPropagation();
    this.onSeek(this.#position_us + steps[event.key]);
  }
  em_px = 16;
  labels_px = 80;
  readings_px = 80;
  /// Measures the margins for labels on both sides.
  #measure() {
    const style = getComputedStyle(this.canvas);
    this.em_px = parseFloat(style.fontSize);
    this.typeface = style.fontFamily;
    const paint = this.#context(this.#still, 1);
    const widest = (texts) => Math.ceil(Math.max(0, ...texts.map((text) => paint.measureText(text).width)) + this.em_px);
    this.labels_px = widest(this.#lanes.flatMap((one) => [one.name, scaleText(one)]));
    this.readings_px = widest(this.#lanes.flatMap((one) => [one.bottom, one.top].map((value) => sizeText(one, value))));
  }
  #plot() {
    const { em_px } = this;
    const width = this.canvas.clientWidth;
    const narrow = width < 26 * em_px; // too narrow for readings
    return {
      left: this.labels_px, right: Math.round(width - (narrow ? em_px : this.readings_px)), top: 8,
      bottom: Math.round(this.canvas.clientHeight - 1.7 * em_px),
    };
  }
  #xOf(time_us) {
    const { left, right } = this.#plot();
    return left + (time_us / Math.max(this.recording.meta.length_us, 1)) * (right - left);
  }
  #redraw(stale = false) {
    this.#stale ||= stale;
    if (this.#awaits) return;
    this.#awaits = true;
    requestAnimationFrame(() => {
      this.#awaits = false;
      if (this.canvas.clientWidth > 0) this.#draw();
    });
  }

  #draw() {
    const ratio = window.devicePixelRatio || 1;
    const [width, height] = [this.canvas.clientWidth, this.canvas.clientHeight];
    if (this.#stale) {
      this.palette = colours();
      this.#measure();
      for (const canvas of [this.canvas, this.#still]) {
        canvas.width = Math.round(width * ratio);
        canvas.height = Math.round(height * ratio);
      }
      this.#drawStill(this.#context(this.#still, ratio));
      this.#stale = false;
    }
    const paint = this.#context(this.canvas, ratio);
    paint.clearRect(0, 0, width, height);
    paint.drawImage(this.#still, 0, 0, width, height);
    if (this.recording) this.#drawMoving(paint);
  }
  #context(canvas, ratio) {
    const paint = canvas.getContext('2d');
    paint.setTransform(ratio, 0, 0, ratio, 0, 0);
    paint.font = `${0.78 * this.em_px}px ${this.typeface}`;
    return paint;
  }
  #areaOf(i) {
    const { left, right, top, bottom } = this.#plot();
    const height = (bottom - top - kLaneGap * (this.#lanes.length - 1)) / this.#lanes.length;
    return { left, right, top: top + i * (height + kLaneGap), height };
  }
  #drawStill(paint) {
    this.#lanes.forEach((one, i) => drawLane(paint, one, this.#areaOf(i), this.palette));
    if (this.recording) this.#drawAxis(paint);
  }
  #drawAxis(paint) {
    const { left, right, bottom } = this.#plot();
    const length_s = this.recording.meta.length_us / 1e6;
    const step_s = kTicks_s.find((step) => (step / length_s) * (right - left) > 3.5 * this.em_px) ?? kTicks_s.at(-1);
    paint.fillStyle = this.palette.quiet;
    paint.textAlign = 'center';
    paint.textBaseline = 'top';
    for (let time_s = 0; time_s <= length_s; time_s += step_s) {
      paint.fillText(clockTime(time_s * 1e6), this.#xOf(time_s * 1e6), bottom + kWatchedHeight + 6);
    }
  }
  #drawMoving(paint) {
    const { left, right, top, bottom } = this.#plot();
    paint.fillStyle = this.palette.track;
    paint.fillRect(left, bottom + 2, right - left, kWatchedHeight);
    paint.fillStyle = this.palette.good;
    for (const [from, to] of this.#watched) {
      const x = this.#xOf(from);
      paint.fillRect(x, bottom + 2, Math.max(1, this.#xOf(to) - x), kWatchedHeight);
    }
    paint.fillStyle = this.palette.text;
    for (const time_us of this.#bookmarks_us) {
      const x = this.#xOf(time_us);
      paint.fillRect(x - 0.5, top, 1, bottom - top);
      paint.beginPath();
      paint.moveTo(x - 5, top - 5);
      paint.lineTo(x + 5, top - 5);
      paint.lineTo(x, top + 3);
      paint.fill();
    }
    const x = this.#xOf(this.#position_us);
    paint.fillRect(x - 1, top - 2, 2, bottom - top + kWatchedHeight + 6);
    if (this.canvas.clientWidth - right < 2 * this.em_px) return;
    paint.textAlign = 'right';
    paint.textBaseline = 'middle';
    this.readings().forEach((text, i) => {
      const area = this.#areaOf(i);
      paint.fillText(text, this.canvas.clientWidth - 4, area.top + area.height / 2);
    });
  }
}
