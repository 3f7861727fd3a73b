// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers, times and days as the reader writes them.
import { language, locale } from './texts.js';

/// How finely a load is told, of N and of N m (sim/core/load_decimals.h).
export const kForceDecimals = 2;
export const kTorqueDecimals = 3;

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

/// A span that is planned or still to come: "1:05".
export function clockTime(time_us) {
  const seconds = Math.floor(time_us / 1e6);
  return `${Math.floor(seconds / 60)}:${String(seconds % 60).padStart(2, '0')}`;
}

/// A moment of a recording, and the length it is set against, to the nearest tenth: "1:05.4".
export function clockTenths(time_us) {
  const tenths = Math.round(time_us / 1e5);
  return `${clockTime(Math.floor(tenths / 10) * 1e6)}.${tenths % 10}`;
}

/// Sentences one after the other: a blank between them, none after a full stop of Chinese, which has its own.
export function joinedSentences(sentences) {
  return sentences.filter((one) => one !== '').join(' ').replace(/([\u3002\uff01\uff1f]) /g, '$1');
}

/// As the window has it: "5 Jan 2026", in Chinese "2026/1/5".
export function dayText(utc_us) {
  return new Date(utc_us / 1000).toLocaleDateString(locale(), { dateStyle: language() === 'en' ? 'medium' : 'short' });
}
