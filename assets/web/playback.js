// SPDX-License-Identifier: GPL-3.0-or-later
// Position and speed of playback. Independent of page and clock: advance() receives the elapsed time.

/// Longer gaps (a dragged window, a closed lid) do not count as watching.
const kLongestFrame_s = 0.25;
export const kJump_us = 5_000_000;
export const kStep_us = 40_000;

export class Playback {
  position_us = 0;
  playing = false;

  /// `speeds`: allowed ones, ascending; 1 is real time.
  constructor(length_us, speeds) {
    this.length_us = length_us;
    this.speeds = speeds;
    this.speed = Math.min(Math.max(1, speeds[0]), speeds.at(-1));
  }
  /// Advances by `elapsed_s`; returns the interval played, {from_us, to_us, speed}, or null.
  advance(elapsed_s) {
    if (!this.playing) return null;
    const from_us = this.position_us;
    const step_us = Math.round(Math.min(Math.max(elapsed_s, 0), kLongestFrame_s) * this.speed * 1e6);
    this.position_us = Math.min(from_us + step_us, this.length_us);
    if (this.position_us === this.length_us) this.playing = false;
    return { from_us, to_us: this.position_us, speed: this.speed };
  }
  seek(position_us) {
    this.position_us = Math.round(Math.min(Math.max(position_us, 0), this.length_us));
  }
  /// At the end, restarts from the beginning.
  toggle() {
    if (!this.playing && this.position_us === this.length_us) this.position_us = 0;
    this.playing = !this.playing;
  }
  /// Selects the next slower or faster allowed speed.
  changeSpeed(direction) {
    const at = this.speeds.indexOf(this.speed) + direction;
    this.speed = this.speeds[Math.min(Math.max(at, 0), this.speeds.length - 1)];
  }
  get slowest() {
    return this.speed === this.speeds[0];
  }
}

/// Merges intervals [[from, to], ...] into disjoint, ascending ones.
export function joined(stretches) {
  const sorted = stretches.filter(([from, to]) => to > from).sort((a, b) => a[0] - b[0]);
  const all = [];
  for (const [from, to] of sorted) {
    const last = all.at(-1);
    if (last && from <= last[1]) {
      last[1] = Math.max(last[1], to);
    } else {
      all.push([from, to]);
    }
  }
  return all;
}
