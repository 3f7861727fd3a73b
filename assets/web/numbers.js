// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers, times and dates in the reader's format.
import { language, locale } from './texts.js';

/// Formats with these decimals and a true minus; never "−0".
export function figure(value, decimals = 0) {
  const shown = Math.abs(value) < 0.5 * 10 ** -decimals ? 0 : value;
  return shown
    .toLocaleString(locale(), { minimumFractionDigits: decimals, maximumFractionDigits: decimals })
    .replace('-', '\u2212');
}

/// Formats "7.5", without trailing zeros.
export function pointsText(points) {
  const whole = Math.abs(points - Math.round(points)) < 1e-9;
  const tenths = Math.abs(points * 10 - Math.round(points * 10)) < 1e-9;
  return figure(points, whole ? 0 : tenths ? 1 : 2);
}

export function scoreText(steps, scale) {
  return pointsText(steps / scale.steps_per_point);
}

/// Formats a planned or remaining time: "1:05".
export function clockTime(time_us) {
  const seconds = Math.floor(time_us / 1e6);
  return `${Math.floor(seconds / 60)}:${String(seconds % 60).padStart(2, '0')}`;
}

/// Formats a position or length of a recording to the nearest tenth: "1:05.4".
export function clockTenths(time_us) {
  const tenths = Math.round(time_us / 1e5);
  return `${clockTime(Math.floor(tenths / 10) * 1e6)}.${tenths % 10}`;
}

/// Joins sentences with a blank, except after a Chinese full stop.
export function joinedSentences(sentences) {
  return sentences.filter((one) => one !== '').join(' ').replace(/([\u3002\uff01\uff1f]) /g, '$1');
}

/// Formats the time of day: "10:32".
export function hourText(time_ms) {
  return new Date(time_ms).toLocaleTimeString(locale(), { timeStyle: 'short' });
}

/// Formats a date as in the window: "5 Jan 2026", in Chinese "2026/1/5".
export function dayText(utc_us) {
  return new Date(utc_us / 1000).toLocaleDateString(locale(), { dateStyle: language() === 'en' ? 'medium' : 'short' });
}
