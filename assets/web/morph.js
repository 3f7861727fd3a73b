// SPDX-License-Identifier: GPL-3.0-or-later
// The organ at any moment: mean shape plus weighted components, and its normals. Knows no page and no WebGL.

const kFloatsAVertex = 6; // x y z, nx ny nz

export class Morph {
  #weights;

  /// `organ`: {meta, arrays} of GET /api/cases/H/organ.
  constructor({ meta, arrays }) {
    this.meta = meta;
    this.index = arrays.index;
    this.colour = arrays.colour;
    this.rest = arrays.mean;
    this.fed = arrays.fed ?? null;
    this.arrays = arrays;
    this.vertices = new Float32Array(kFloatsAVertex * meta.vertices);
    this.#weights = new Float32Array(meta.components);
  }

  /// Fills `vertices` (x y z in mm, then a normal that is not of unit length yet) with the organ at `time_s`.
  evaluate(time_s) {
    this.#mix(time_s);
    this.#place();
    this.#turnNormals();
    return this.vertices;
  }

  /// The factor on the colour of what is fed through the twist.
  bloodAt(time_s) {
    const { blood } = this.arrays;
    if (!blood) return [1, 1, 1];
    const frame = Math.min(Math.max(Math.round(time_s * this.meta.rate_hz), 0), this.meta.frames - 1);
    return blood.slice(3 * frame, 3 * frame + 3);
  }

  /// Weights at this time, each times its scale: linear between frames.
  #mix(time_s) {
    const { components, frames, rate_hz, scale } = this.meta;
    const at = Math.min(Math.max(time_s * rate_hz, 0), frames - 1);
    const before = Math.min(Math.floor(at), Math.max(frames - 2, 0));
    const after = Math.min(before + 1, frames - 1);
    const share = at - before;
    const { weights } = this.arrays;
    for (let k = 0; k < components; ++k) {
      const a = weights[before * components + k];
      const b = weights[after * components + k];
      this.#weights[k] = scale[k] * (a + (b - a) * share);
    }
  }

  #place() {
    const { mean, basis } = this.arrays;
    const count = mean.length;
    const placed = (this.placed ??= new Float32Array(count));
    placed.set(mean);
    for (let k = 0; k < this.#weights.length; ++k) {
      const weight = this.#weights[k];
      if (weight === 0) continue;
      for (let i = 0, from = k * count; i < count; ++i) placed[i] += weight * basis[from + i];
    }
    const out = this.vertices;
    for (let i = 0, o = 0; i < count; i += 3, o += kFloatsAVertex) {
      out[o] = placed[i];
      out[o + 1] = placed[i + 1];
      out[o + 2] = placed[i + 2];
      out[o + 3] = out[o + 4] = out[o + 5] = 0;
    }
  }

  /// Sums the normals of the triangles, each as long as twice its area.
  #turnNormals() {
    addNormals(this.index, this.vertices);
  }

  /// Centre and radius of a ball round the organ as it is now.
  ball() {
    const low = [Infinity, Infinity, Infinity];
    const high = [-Infinity, -Infinity, -Infinity];
    for (let o = 0; o < this.vertices.length; o += kFloatsAVertex) {
      for (let axis = 0; axis < 3; ++axis) {
        low[axis] = Math.min(low[axis], this.vertices[o + axis]);
        high[axis] = Math.max(high[axis], this.vertices[o + axis]);
      }
    }
    const centre = low.map((value, axis) => 0.5 * (value + high[axis]));
    let radius = 0;
    for (let o = 0; o < this.vertices.length; o += kFloatsAVertex) {
      const [x, y, z] = centre.map((value, axis) => this.vertices[o + axis] - value);
      radius = Math.max(radius, Math.hypot(x, y, z));
    }
    return { centre, radius };
  }
}

/// Adds to `vertices` (x y z nx ny nz each) the normals of the triangles of `index`, weighted by area.
export function addNormals(index, vertices) {
  for (let i = 0; i < index.length; i += 3) {
    const a = kFloatsAVertex * index[i];
    const b = kFloatsAVertex * index[i + 1];
    const c = kFloatsAVertex * index[i + 2];
    const ux = vertices[b] - vertices[a];
    const uy = vertices[b + 1] - vertices[a + 1];
    const uz = vertices[b + 2] - vertices[a + 2];
    const vx = vertices[c] - vertices[a];
    const vy = vertices[c + 1] - vertices[a + 1];
    const vz = vertices[c + 2] - vertices[a + 2];
    const nx = uy * vz - uz * vy;
    const ny = uz * vx - ux * vz;
    const nz = ux * vy - uy * vx;
    for (const at of [a, b, c]) {
      vertices[at + 3] += nx;
      vertices[at + 4] += ny;
      vertices[at + 5] += nz;
    }
  }
}
