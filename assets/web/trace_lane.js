// SPDX-License-Identifier: GPL-3.0-or-later
// One trace: scale, texts and drawing.
import { figure } from './numbers.js';

const kSmallTorque_Nm = 0.1; // below, an untwisting is shown in mN m
const kRoom = 1.05; // keeps a limit off the edge

function withUnit(size, unit) {
  return unit === '\u00b0' || unit === '' ? size + unit : `${size} ${unit}`;
}

/// Formats "1.8 N" with unit and decimals of a lane or of a load of the task.
export function sizeText({ factor = 1, decimals, unit }, value) {
  return withUnit(figure(value * factor, decimals), unit);
}

/// Formats the range of a lane: "0…185°".
export function scaleText(one) {
  const end = (value) => (Math.abs(value) < 0.5 * 10 ** -one.decimals ? '0' : figure(value, one.decimals));
  return withUnit(`${end(one.bottom * one.factor)}\u2026${end(one.top * one.factor)}`, one.unit);
}

/// Makes a lane: `low`, `high` (extremes per frame), `value` (at the frame), `limit` or null, `band`
/// ({target, tolerance}) or null; `fine`: small values in thousandths; `decimals`: otherwise, null: by
/// magnitude. The range always includes zero; the limit is drawn on the side of the values.
export function lane({ low, high = low, value = low, limit = null, band = null, fine = false, decimals = null, ...rest }) {
  let [least, most] = [0, 0];
  for (const one of low) least = Math.min(least, one);
  for (const one of high) most = Math.max(most, one);
  const sign = -least > most ? -1 : 1;
  const made = { ...rest, lowest: low, highest: high, value, band, least, most, limit: limit === null ? null : sign * limit };
  let [bottom, top] = [least, Math.max(most, least + 1e-3)];
  if (band) {
    for (const target of band.target) {
      bottom = Math.min(bottom, target - kRoom * band.tolerance);
      top = Math.max(top, target + kRoom * band.tolerance);
    }
  }
  if (made.limit !== null) {
    bottom = Math.min(bottom, kRoom * made.limit);
    top = Math.max(top, kRoom * made.limit);
  }
  const small = fine && Math.max(-bottom, top) < kSmallTorque_Nm;
  const factor = small ? 1000 : 1;
  if (small) made.unit = `m${made.unit}`;
  const size = factor * Math.max(-bottom, top);
  return { ...made, bottom, top, factor, decimals: decimals !== null && !small ? decimals : size >= 10 ? 0 : size >= 1 ? 1 : 2 };
}

/// `area`: {left, right, top, height}; `palette`: colours by name.
export function drawLane(paint, one, area, palette) {
  const { left, right, top, height } = area;
  const yOf = (value) => top + height - 1 - ((value - one.bottom) / (one.top - one.bottom)) * (height - 2);
  paint.fillStyle = palette.surface;
  paint.fillRect(left, top, right - left, height);
  const frames = one.lowest.length;
  const columns = Math.max(1, Math.floor(right - left));
  const frameAt = (x) => Math.min(Math.floor((x / columns) * frames), frames - 1);
  if (one.band) drawBand(paint, one.band, { left, columns, frameAt, yOf }, palette);
  paint.fillStyle = palette.line;
  paint.fillRect(left, yOf(0), right - left, 1);
  if (one.limit !== null) {
    paint.strokeStyle = palette.quiet;
    paint.setLineDash([4, 4]);
    paint.beginPath();
    paint.moveTo(left, yOf(one.limit));
    paint.lineTo(right, yOf(one.limit));
    paint.stroke();
    paint.setLineDash([]);
  }
  paint.fillStyle = palette[one.colour];
  for (let x = 0; x < columns; ++x) {
    let [low, high] = [Infinity, -Infinity];
    // Overlap columns by one frame to join them.
    for (let i = Math.max(frameAt(x) - 1, 0); i <= frameAt(x + 1); ++i) {
      low = Math.min(low, one.lowest[i]);
      high = Math.max(high, one.highest[i]);
    }
    paint.fillRect(left + x, yOf(high) - 0.75, 1, yOf(low) - yOf(high) + 1.5);
  }
  paint.textAlign = 'left';
  paint.textBaseline = 'alphabetic';
  paint.fillStyle = palette.text;
  paint.fillText(one.name, 0, top + height / 2 - 3);
  paint.textBaseline = 'top';
  paint.fillStyle = palette.quiet;
  paint.fillText(scaleText(one), 0, top + height / 2 + 2);
}

function drawBand(paint, { target, tolerance }, { left, columns, frameAt, yOf }, palette) {
  paint.fillStyle = palette.good;
  paint.globalAlpha = 0.22;
  for (let x = 0; x < columns; ++x) {
    const middle = target[frameAt(x)];
    paint.fillRect(left + x, yOf(middle + tolerance), 1, yOf(middle - tolerance) - yOf(middle + tolerance));
  }
  paint.globalAlpha = 0.8;
  for (let x = 0; x < columns; x += 6) paint.fillRect(left + x, yOf(target[frameAt(x)]), 3, 1);
  paint.globalAlpha = 1;
}
