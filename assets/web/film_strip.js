// SPDX-License-Identifier: GPL-3.0-or-later
// Thumbnails of a recording for browsers without WebGL. A click seeks.
import { h } from './dom.js';
import { addNormals, Morph } from './morph.js';
import { clockTenths } from './numbers.js';
import { OrbitCamera } from './orbit.js';
import { rasterPicture } from './raster.js';
import { t } from './texts.js';
import { poseMatrix } from './tool_pose.js';

const kMoments = 8;
const kWidth = 200;
const kHeight = 130;
const kSteel = [178, 183, 188];

export class FilmStrip {
  element = h('ol', { class: 'film' });
  #moments = [];

  /// `recording`, `organ`: containers. `onSeek(position_us)`.
  constructor(recording, organ, onSeek) {
    this.element.setAttribute('aria-label', t('Film strip'));
    Object.assign(this, { recording, morph: new Morph(organ), onSeek });
    const { tool_index: index, tool_mean: mean } = organ.arrays;
    this.tool = { index, vertices: new Float32Array(2 * mean.length), colour: kSteel };
    for (let i = 0; i < mean.length; ++i) this.tool.vertices[6 * Math.floor(i / 3) + (i % 3)] = mean[i];
    addNormals(index, this.tool.vertices);
    const { length_us } = recording.meta;
    for (let i = 0; i < kMoments; ++i) this.#add((i * length_us) / (kMoments - 1));
    this.#drawFrom(0);
  }
  /// Highlights the last moment before the playhead.
  setPosition(position_us) {
    const present = this.#moments.findLast((one) => one.at_us <= position_us + 1);
    for (const one of this.#moments) {
      if (one === present) one.button.setAttribute('aria-current', 'true');
      else one.button.removeAttribute('aria-current');
    }
  }

  #add(at_us) {
    const canvas = h('canvas', { width: kWidth, height: kHeight });
    const button = h('button', { type: 'button', class: 'moment', 'aria-label': t('Moment %1', clockTenths(at_us)), onclick: () => this.onSeek(at_us),
      onmousedown: (event) => event.preventDefault() }, // the sheet keeps the focus
      canvas, h('span', { 'aria-hidden': 'true' }, clockTenths(at_us)));
    this.#moments.push({ at_us, canvas, button });
    this.element.append(h('li', {}, button));
  }
  /// Draws one by one, so that the page stays responsive.
  #drawFrom(number) {
    if (number >= this.#moments.length) return;
    const { at_us, canvas } = this.#moments[number];
    const time_s = at_us / 1e6;
    const { morph } = this;
    const vertices = morph.evaluate(time_s);
    this.camera ??= new OrbitCamera();
    this.camera.frame(morph.ball(), kWidth / kHeight);
    const bytes = rasterPicture([{ index: morph.index, vertices, colour: tinted(morph.colour, morph.tintsAt(time_s)) },
      { ...this.tool, model: poseMatrix(this.recording, time_s) }], this.camera, kWidth, kHeight);
    canvas.getContext('2d').putImageData(new ImageData(bytes, kWidth, kHeight), 0, 0);
    setTimeout(() => this.#drawFrom(number + 1));
  }
}

function tinted(colour, tints) {
  return tints ? colour.map((byte, i) => Math.min(byte * tints[i], 255)) : colour;
}
