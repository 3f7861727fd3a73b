// SPDX-License-Identifier: GPL-3.0-or-later
// Script counterpart of organ_sum.js, for renderers whose vertex shaders are slower than the browser's
// scripts.
import { kCorner_B } from './gl.js';

const kFloatsACorner = kCorner_B / 4;

export class ScriptSum {
  /// Like OrganSum; `buffer` has the same corners.
  constructor(gl, morph, corner = null) {
    Object.assign(this, { gl, morph });
    this.corner = corner ?? Uint32Array.from({ length: morph.meta.vertices }, (_, i) => i);
    this.corners = new Float32Array(kFloatsACorner * this.corner.length).fill(1);
    this.buffer = gl.createBuffer();
    this.#send();
  }

  /// Fills `buffer` for this time.
  move(time_s) {
    const { morph, corner, corners } = this;
    const vertices = morph.evaluate(time_s);
    const tints = morph.tintsAt(time_s);
    for (let i = 0, to = 0; i < corner.length; ++i, to += kFloatsACorner) {
      const from = 6 * corner[i];
      for (let k = 0; k < 6; ++k) corners[to + k] = vertices[from + k];
      if (tints) for (let k = 0; k < 3; ++k) corners[to + 6 + k] = tints[3 * corner[i] + k];
    }
    this.#send();
  }
  #send() {
    const { gl } = this;
    gl.bindBuffer(gl.ARRAY_BUFFER, this.buffer);
    gl.bufferData(gl.ARRAY_BUFFER, this.corners, gl.STREAM_DRAW);
    gl.bindBuffer(gl.ARRAY_BUFFER, null);
  }
}
