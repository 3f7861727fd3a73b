// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers, times and days as the reader writes them.
import { locale } from './texts.js';

/// With so many decimals and a true minus; no minus before a zero.
export function figure(value, decimals = 0) {
  const shown = Math.abs(value) < 0.5 * 10 ** -decimals ? 0 : value;
  return shown
    .toLocaleString(locale(), { minimumFractionDigits: decimals, maximumFractionDigits: decimals })
    .replace('-', '\u2212');
}

/// "7.5", without needless decimals.
export function pointsText(points) {
  const whole = Math.abs(points - Math.round(points)) < 1e-9;
  const tenths = Math.abs(points * 10 - Math.round(points * 10)) < 1e-9;
  return figure(points, whole ? 0 : tenths ? 1 : 2);
}

export function scoreText(steps, scale) {
  return pointsText(steps / scale.steps_per_point);
}

/// "1:05".
export function clockTime(time_us) {
  const seconds = Math.floor(time_us / 1e6);
  return `${Math.floor(seconds / 60)}:${String(seconds % 60).padStart(2, '0')}`;
}

export function dayText(utc_us) {
  return new Date(utc_us / 1000).toLocaleDateString(locale(), { dateStyle: 'medium' });
}
