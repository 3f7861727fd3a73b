// SPDX-License-Identifier: GPL-3.0-or-later
// The organ at any time: mean shape plus weighted components, with normals. Independent of page and WebGL.

const kFloatsAVertex = 6; // x y z, nx ny nz
const kUnchanged = [1, 1, 1];
const kMoments = 7; // sampled to find the organ's extent

export class Morph {
  #weights;

  /// `organ`: {meta, arrays} of GET /api/cases/H/organ.
  constructor({ meta, arrays }) {
    this.meta = meta;
    this.index = arrays.index;
    this.colour = arrays.colour;
    this.arrays = arrays;
    this.vertices = new Float32Array(kFloatsAVertex * meta.vertices);
    this.#weights = new Float32Array(meta.components);
  }

  /// Fills `vertices` (x y z in mm, then an unnormalised normal) at `time_s`.
  evaluate(time_s) {
    this.weightsAt(time_s);
    this.#place();
    this.#turnNormals();
    return this.vertices;
  }

  /// Returns the colour factor of each vertex, three each, in screen values: blood, then damage, lowest layer
  /// first. Null for an organ of constant colour.
  tintsAt(time_s) {
    const { fed, paint } = this.arrays;
    if (!fed) return null;
    const { blood, paints } = this.coloursAt(time_s);
    const tints = (this.tints ??= new Float32Array(3 * this.meta.vertices));
    mixTints(tints.fill(1), blood, fed);
    for (const { factor, layer } of paints) {
      mixTints(tints, factor, paint.subarray(layer * fed.length, (layer + 1) * fed.length));
    }
    return tints;
  }
  /// Returns the colours at this time: {blood, paints: [{factor, layer}]}.
  coloursAt(time_s) {
    if (!this.arrays.fed) return { blood: kUnchanged, paints: [] };
    const { before, after, share } = this.#between(time_s);
    const frame = share < 0.5 ? before : after;
    const layers = (this.meta.paints ?? []).map((one, layer) => ({ ...one, layer }));
    return {
      blood: this.arrays.blood.subarray(3 * frame, 3 * frame + 3),
      paints: layers.filter(({ from, to }) => frame >= from && frame < to),
    };
  }

  /// Returns the weights at this time, times their scales, interpolated linearly. Valid until the next call.
  weightsAt(time_s) {
    const { components, scale } = this.meta;
    const { before, after, share } = this.#between(time_s);
    const { weights } = this.arrays;
    for (let k = 0; k < components; ++k) {
      const a = weights[before * components + k];
      const b = weights[after * components + k];
      this.#weights[k] = scale[k] * (a + (b - a) * share);
    }
    return this.#weights;
  }
  /// Returns the frames around a time, spaced as the movement requires, and the fraction between them.
  #between(time_s) {
    const times = this.arrays.time_ms;
    const at = 1000 * time_s;
    let before = 0;
    for (let after = times.length - 1; after - before > 1;) {
      const middle = (before + after) >> 1;
      if (times[middle] <= at) before = middle;
      else after = middle;
    }
    const after = Math.min(before + 1, times.length - 1);
    const share = after === before ? 0 : (at - times[before]) / (times[after] - times[before]);
    return { before, after, share: Math.min(Math.max(share, 0), 1) };
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

  /// Sums the normals of the triangles, weighted by twice their area.
  #turnNormals() {
    addNormals(this.index, this.vertices);
  }

  /// Returns centre and radius of a sphere around the organ at some sampled moments.
  ball() {
    if (this.#ball) return this.#ball;
    const low = [Infinity, Infinity, Infinity];
    const high = [-Infinity, -Infinity, -Infinity];
    const moments = Array.from({ length: kMoments }, (_, i) => (i * this.arrays.time_ms.at(-1)) / 1000 / (kMoments - 1));
    const everywhere = (visit) => moments.forEach((time_s) => {
      this.weightsAt(time_s);
      this.#place();
      for (let i = 0; i < this.placed.length; i += 3) visit(this.placed, i);
    });
    everywhere((placed, i) => {
      for (let axis = 0; axis < 3; ++axis) {
        low[axis] = Math.min(low[axis], placed[i + axis]);
        high[axis] = Math.max(high[axis], placed[i + axis]);
      }
    });
    const centre = low.map((value, axis) => 0.5 * (value + high[axis]));
    let radius = 0;
    everywhere((placed, i) => {
      radius = Math.max(radius, Math.hypot(placed[i] - centre[0], placed[i + 1] - centre[1], placed[i + 2] - centre[2]));
    });
    this.#ball = { centre, radius };
    return this.#ball;
  }
  #ball = null;
}

/// Blends each tint towards a factor by its vertex's share of 255.
function mixTints(tints, factor, shares) {
  for (let i = 0, o = 0; i < shares.length; ++i, o += 3) {
    const share = shares[i] / 255;
    if (share === 0) continue;
    for (let k = 0; k < 3; ++k) tints[o + k] += share * (factor[k] - tints[o + k]);
  }
}

/// Triangles around each vertex: from first[v] up to first[v + 1], the other two vertices of each in winding
/// order: others[2 i], others[2 i + 1].
export function fanned(index, vertices) {
  const first = new Uint32Array(vertices + 1);
  for (const vertex of index) first[vertex + 1] += 1;
  for (let v = 0; v < vertices; ++v) first[v + 1] += first[v];
  const next = first.slice();
  const others = new Uint32Array(2 * index.length);
  for (let i = 0; i < index.length; i += 3) {
    for (let k = 0; k < 3; ++k) {
      const at = 2 * next[index[i + k]]++;
      others[at] = index[i + ((k + 1) % 3)];
      others[at + 1] = index[i + ((k + 2) % 3)];
    }
  }
  for (let v = 0; v < vertices; ++v) chain(others, first[v], first[v + 1]);
  return { first, others };
}

/// Orders a fan so that triangles share edges with their predecessor: the shader looks up each vertex once.
function chain(others, begin, end) {
  for (let i = begin; i + 1 < end; ++i) {
    let next = i + 1;
    while (next < end && others[2 * next] !== others[2 * i + 1]) next += 1;
    if (next === end || next === i + 1) continue;
    for (const k of [0, 1]) [others[2 * i + 2 + k], others[2 * next + k]] = [others[2 * next + k], others[2 * i + 2 + k]];
  }
}

/// Adds the area-weighted normals of the triangles of `index` to `vertices` (x y z nx ny nz each).
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
