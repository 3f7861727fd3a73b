// SPDX-License-Identifier: GPL-3.0-or-later
// The organ at any time, evaluated by the vertex shaders of organ_shaders.js: the displacements are uploaded
// once, and each picture needs only their weights. The first shader writes vertex positions to a buffer
// (transform feedback), the second position, normal and colour factor of each corner, which are then drawn.
import { attribute, kCorner_B, makeFeedback, tableTexture } from './gl.js';
import { fanned } from './morph.js';
import { kCornerShader, kMaxComponents, kMaxPaints, kPlaceShader, kRow } from './organ_shaders.js';

const kPlace_B = 16;

export class OrganSum {
  /// `morph`: the organ; `corner`: vertex of each drawn corner, null: one corner per vertex. `buffer`
  /// receives the corners, `places` the vertices, four floats each. Throws RangeError if there are too many
  /// displacements, Error if the shaders do not compile.
  constructor(gl, morph, corner = null) {
    const { meta, arrays } = morph;
    if (meta.components > kMaxComponents) throw new RangeError('too many components');
    Object.assign(this, { gl, morph });
    this.rows = Math.ceil(meta.vertices / kRow);
    this.placing = makeFeedback(gl, kPlaceShader, ['placed']);
    this.lighting = makeFeedback(gl, kCornerShader, ['position', 'normal', 'factor']);
    const corners = corner ?? Uint32Array.from({ length: meta.vertices }, (_, i) => i);
    this.corners = corners.length;
    const fans = fanned(arrays.index, meta.vertices);
    this.places = this.#room(kPlace_B * kRow * this.rows);
    this.buffer = this.#room(kCorner_B * this.corners);
    this.placeArray = this.#array(() => attribute(gl, 0, arrays.mean, 3));
    this.cornerArray = this.#array(() => {
      attribute(gl, 0, cornerFans(corners, fans), 3);
      if (arrays.fed) attribute(gl, 1, Uint8Array.from(corners, (vertex) => arrays.fed[vertex]), 1, { normalised: true });
    });
    const texels = kRow * this.rows;
    this.textures = {
      steps: this.#layers(gl.RGBA16I, gl.RGBA_INTEGER, gl.SHORT, inTexels(arrays.basis, 3, meta.vertices, texels), meta.components),
      places: this.#layers(gl.RGBA32F, gl.RGBA, gl.FLOAT, null, 1),
      fans: this.#fanTexture(fans),
      paints: this.#layers(gl.R8, gl.RED, gl.UNSIGNED_BYTE, inTexels(arrays.paint ?? new Uint8Array(), 1, meta.vertices, texels),
        meta.paints?.length ?? 0),
    };
  }

  #room(size_B) {
    const { gl } = this;
    const buffer = gl.createBuffer();
    gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
    gl.bufferData(gl.ARRAY_BUFFER, size_B, gl.DYNAMIC_COPY);
    gl.bindBuffer(gl.ARRAY_BUFFER, null);
    return buffer;
  }
  #array(fill) {
    const { gl } = this;
    const array = gl.createVertexArray();
    gl.bindVertexArray(array);
    fill();
    gl.bindVertexArray(null);
    gl.bindBuffer(gl.ARRAY_BUFFER, null);
    return array;
  }
  #layers(format, external, type, values, count) {
    const { gl, rows } = this;
    return tableTexture(gl, gl.TEXTURE_2D_ARRAY, () => {
      gl.texStorage3D(gl.TEXTURE_2D_ARRAY, 1, format, kRow, rows, Math.max(count, 1));
      if (count && values) gl.texSubImage3D(gl.TEXTURE_2D_ARRAY, 0, 0, 0, 0, kRow, rows, count, external, type, values);
    });
  }
  #fanTexture({ others }) {
    const { gl } = this;
    const rows = Math.ceil(others.length / 2 / kRow);
    const filled = new Uint32Array(2 * kRow * rows);
    filled.set(others);
    return tableTexture(gl, gl.TEXTURE_2D, () => {
      gl.texImage2D(gl.TEXTURE_2D, 0, gl.RG32UI, kRow, rows, 0, gl.RG_INTEGER, gl.UNSIGNED_INT, filled);
    });
  }

  /// Fills `places` and `buffer` for this time.
  move(time_s) {
    const { gl, morph, placing, lighting } = this;
    gl.enable(gl.RASTERIZER_DISCARD);
    placing.use();
    this.#bind(placing, { steps: gl.TEXTURE_2D_ARRAY });
    this.#weigh(time_s);
    gl.bindVertexArray(this.placeArray);
    placing.write(this.places, morph.meta.vertices);
    // The shader needs the positions of neighbours: copy them to a texture on the card.
    gl.bindBuffer(gl.PIXEL_UNPACK_BUFFER, this.places);
    gl.bindTexture(gl.TEXTURE_2D_ARRAY, this.textures.places);
    gl.texSubImage3D(gl.TEXTURE_2D_ARRAY, 0, 0, 0, 0, kRow, this.rows, 1, gl.RGBA, gl.FLOAT, 0);
    gl.bindBuffer(gl.PIXEL_UNPACK_BUFFER, null);
    lighting.use();
    this.#bind(lighting, { paints: gl.TEXTURE_2D_ARRAY, fans: gl.TEXTURE_2D, places: gl.TEXTURE_2D_ARRAY });
    this.#tint(time_s);
    gl.bindVertexArray(this.cornerArray);
    if (!morph.arrays.fed) gl.vertexAttrib1f(1, 0);
    lighting.write(this.buffer, this.corners);
    gl.bindVertexArray(null);
    gl.disable(gl.RASTERIZER_DISCARD);
  }
  #weigh(time_s) {
    const weights = this.morph.weightsAt(time_s);
    const layers = [...weights.keys()].filter((k) => weights[k] !== 0);
    this.placing.setWhole('count', layers.length);
    if (layers.length === 0) return;
    this.placing.setWhole('layers', layers);
    this.placing.setEach('weights', layers.map((k) => weights[k]));
  }
  #tint(time_s) {
    const { blood, paints } = this.morph.coloursAt(time_s);
    const shown = paints.slice(-kMaxPaints);
    this.lighting.set('blood', blood);
    this.lighting.setWhole('paintCount', shown.length);
    if (shown.length === 0) return;
    this.lighting.setWhole('paintLayers', shown.map(({ layer }) => layer));
    this.lighting.set('paintFactors', shown.flatMap(({ factor }) => factor));
  }
  /// Binds the last texture to the first unit, which the caller's own textures use.
  #bind(program, kinds) {
    const { gl } = this;
    const names = Object.keys(kinds);
    names.forEach((name, i) => {
      const unit = names.length - 1 - i;
      gl.activeTexture(gl.TEXTURE0 + unit);
      gl.bindTexture(kinds[name], this.textures[name]);
      program.setWhole(name, unit);
    });
  }
}

/// Vertex, its first triangle in the fans, number of triangles: three per corner.
function cornerFans(corners, { first }) {
  const data = new Uint32Array(3 * corners.length);
  corners.forEach((vertex, i) => data.set([vertex, first[vertex], first[vertex + 1] - first[vertex]], 3 * i));
  return data;
}

/// Packs `width` numbers per vertex layer by layer, four channels per vertex (one if width is 1), padding
/// each layer to `texels`.
function inTexels(values, width, vertices, texels) {
  const channels = width === 1 ? 1 : 4;
  const layers = values.length / width / vertices;
  const filled = new values.constructor(channels * texels * layers);
  for (let layer = 0; layer < layers; ++layer) {
    let from = layer * vertices * width;
    let to = layer * texels * channels;
    for (let i = 0; i < vertices; ++i, from += width, to += channels) {
      for (let k = 0; k < width; ++k) filled[to + k] = values[from + k];
    }
  }
  return filled;
}
