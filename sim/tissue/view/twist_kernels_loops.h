// SPDX-License-Identifier: GPL-3.0-or-later
// The loops behind TwistKernels. Included by one source an instruction set, each inside its own anonymous
// namespace; nothing else may include it. Plain pointers and arithmetic only: an inline function of the
// standard library compiled here with AVX could be the copy that the linker keeps for the whole program.

struct SineCosine {
  float sine;
  float cosine;
};

// Flips the sign of `value` where the lowest bit of `parity` is set.
inline float flipped(float value, unsigned parity) {
  return __builtin_bit_cast(float, __builtin_bit_cast(unsigned, value) ^ (parity << 31));
}

// Cody-Waite reduction to [-pi/2, pi/2] by multiples of pi, which only change the signs, and polynomials of
// least error there, no branches: error below 1.3e-7 for angles of some ten turns. Adding and taking away 1.5
// x 2^23 rounds to the nearest integer, whose lowest bit is that of the sum.
inline SineCosine sineCosine(float x) {
  const float kRound = 12582912.0F;
  const float sum = x * 0.318309886F + kRound;
  const float n = sum - kRound;
  const unsigned parity = __builtin_bit_cast(unsigned, sum);
  const float r = (x - n * 3.140625F) - n * 9.67653590e-4F;
  const float z = r * r;
  const float s =
      r + r * z * (-0.166666571F + z * (8.3330172e-3F + z * (-1.98066084e-4F + z * 2.60003957e-6F)));
  const float c =
      1.0F - 0.5F * z +
      z * z * (0.0416666558F + z * (-1.38885691e-3F + z * (2.47692979e-5F + z * -2.61936817e-7F)));
  return {flipped(s, parity), flipped(c, parity)};
}

// Sine and cosine of pi y; the sine is turned round for `pi` < 0. An angle in half turns is brought to [-1/2,
// 1/2] exactly, by one subtraction: three multiplications less than above; pairs of coefficients side by
// side, because what limits a narrow processor is how long the sum waits for itself. The coefficients above
// times powers of pi; error below 1.8e-7.
inline SineCosine sineCosineOfHalfTurns(float y, float pi) {
  const float kRound = 12582912.0F;
  const float sum = y + kRound;
  const unsigned parity = __builtin_bit_cast(unsigned, sum);
  const float r = y - (sum - kRound);
  const float z = r * r;
  const float zz = z * z;
  const float w = r * pi;
  const float s =
      w + (w * z) * ((-1.64493312F + z * 0.811711631F) + zz * (-0.190418593F + z * 0.0246705561F));
  const float c = (1.0F + z * -4.9348022F) +
                  zz * ((4.05871107F + z * -1.33523202F) + zz * (0.235024251F + z * -0.0245298715F));
  return {flipped(s, parity), flipped(c, parity)};
}

// The same with a term less in each sum, times a factor: error below 1e-6, a tenth of a micrometre at the arm
// of an organ.
inline SineCosine shortSineCosine(float y, float factor) {
  const float kRound = 12582912.0F;
  const float sum = y + kRound;
  const float f = flipped(factor, __builtin_bit_cast(unsigned, sum));
  const float r = y - (sum - kRound);
  const float z = r * r;
  const float zz = z * z;
  const float w = r * 3.14159265F;
  const float s = w + (w * z) * ((-1.64483679F + z * 0.80970003F) + zz * -0.177781807F);
  const float c = (1.0F + z * -4.93479552F) + zz * ((4.05845134F + z * -1.33209385F) + zz * 0.22008062F);
  return {f * s, f * c};
}

inline float smaller(float a, float b) {
  return a < b ? a : b;
}
inline float larger(float a, float b) {
  return a > b ? a : b;
}

// A frame with all that is the same at every vertex multiplied out: angles in half turns, their sign apart.
struct PreparedFrame {
  float nearSlope;
  float farBase;
  float farSlope;
  float pi;  // with the sign of the angles
  // The blend is blendFrom - blendSlope C, C clamped to where it runs from 1 to 0. A clamp of the blend
  // itself to the constants 0 and 1 is taken apart by GCC into three branches, 25 instructions of masks.
  float blendFirst;
  float blendLast;
  float blendFrom;
  float blendSlope;
  float farRate;
  float rise3;  // three and two times nearRate - farRate
  float rise2;
};

inline PreparedFrame prepared(const TwistFrame& f) {
  const float sign = f.torque < 0.0F ? -1.0F : 1.0F;
  const float scale = sign * f.torque * 0.318309886F;
  const float half = f.inverseBlend > 0.0F ? 0.5F / f.inverseBlend : 1e30F;
  return {scale * f.nearSlope,
          scale * f.farBase,
          scale * f.farSlope,
          sign * 3.14159265F,
          f.graspCompliance - half,
          f.graspCompliance + half,
          0.5F + f.graspCompliance * f.inverseBlend,
          f.inverseBlend,
          f.farRate,
          3.0F * (f.nearRate - f.farRate),
          2.0F * (f.nearRate - f.farRate)};
}

inline SineCosine turnAt(const PreparedFrame& f, float c) {
  return sineCosineOfHalfTurns(smaller(f.nearSlope * c, f.farBase + f.farSlope * c), f.pi);
}

// tangent x radius, computed here instead of read: memory is the limit, not arithmetic.
struct Across {
  float x;
  float y;
  float z;
};

inline Across tangentCrossRadius(const float* v, int i) {
  return {v[112 + i] * v[80 + i] - v[128 + i] * v[64 + i], v[128 + i] * v[48 + i] - v[96 + i] * v[80 + i],
          v[96 + i] * v[64 + i] - v[112 + i] * v[48 + i]};
}

// A vertex turned about its foot by an angle and moved along the tangent by its warping.
inline void putTurned(const float* __restrict v, const SineCosine& r, float warp, int i,
                      float* __restrict o) {
  const Across a = tangentCrossRadius(v, i);
  o[i] = v[i] + r.cosine * v[48 + i] + r.sine * a.x + warp * v[96 + i];
  o[16 + i] = v[16 + i] + r.cosine * v[64 + i] + r.sine * a.y + warp * v[112 + i];
  o[32 + i] = v[32 + i] + r.cosine * v[80 + i] + r.sine * a.z + warp * v[128 + i];
}

void curvedWarp(const float* __restrict in, int blocks, const TwistFrame& frame, float* __restrict out) {
  const PreparedFrame f = prepared(frame);
  for (int block = 0; block < blocks; ++block) {
    const float* __restrict v = in + static_cast<long long>(block) * (11 * 16);
    float* __restrict o = out + static_cast<long long>(block) * (3 * 16);
    TORSIO_VECTOR_LOOP
    for (int i = 0; i < 16; ++i) {
      const float c = v[144 + i];
      const SineCosine r = turnAt(f, c);
      const float t = f.blendFrom - f.blendSlope * larger(f.blendFirst, smaller(f.blendLast, c));
      const float warp = (f.farRate + t * t * (f.rise3 - f.rise2 * t)) * v[160 + i];
      putTurned(v, r, warp, i, o);
    }
  }
}

void curved(const float* __restrict in, int blocks, const TwistFrame& frame, float* __restrict out) {
  const PreparedFrame f = prepared(frame);
  for (int block = 0; block < blocks; ++block) {
    const float* __restrict v = in + static_cast<long long>(block) * (10 * 16);
    float* __restrict o = out + static_cast<long long>(block) * (3 * 16);
    TORSIO_VECTOR_LOOP
    for (int i = 0; i < 16; ++i) {
      const float c = v[144 + i];
      const SineCosine r = turnAt(f, c);
      const Across a = tangentCrossRadius(v, i);
      o[i] = v[i] + r.cosine * v[48 + i] + r.sine * a.x;
      o[16 + i] = v[16 + i] + r.cosine * v[64 + i] + r.sine * a.y;
      o[32 + i] = v[32 + i] + r.cosine * v[80 + i] + r.sine * a.z;
    }
  }
}

void givenAngles(const float* __restrict in, const float* __restrict anglesAndRates, int blocks,
                 float* __restrict out) {
  for (int block = 0; block < blocks; ++block) {
    const float* __restrict v = in + static_cast<long long>(block) * (11 * 16);
    const float* __restrict given = anglesAndRates + static_cast<long long>(block) * (2 * 16);
    float* __restrict o = out + static_cast<long long>(block) * (3 * 16);
    TORSIO_VECTOR_LOOP
    for (int i = 0; i < 16; ++i) {
      const SineCosine r = sineCosine(given[i]);
      const float warp = given[16 + i] * v[160 + i];
      putTurned(v, r, warp, i, o);
    }
  }
}

void paperLinear(const float* __restrict in, int blocks, const PaperFrame& frame, float* __restrict out) {
  const PaperFrame f = frame;
  for (int block = 0; block < blocks; ++block) {
    const float* __restrict v = in + static_cast<long long>(block) * (11 * 16);
    float* __restrict o = out + static_cast<long long>(block) * (3 * 16);
    TORSIO_VECTOR_LOOP
    for (int i = 0; i < 16; ++i) {
      const bool near = v[112 + i] <= f.graspArc;
      const float angle = f.torque * (near ? v[96 + i] : f.graspAngle);
      const float lift = near ? f.torque : 0.0F;
      o[i] = v[i] + angle * v[48 + i] + lift * v[128 + i];
      o[16 + i] = v[16 + i] + angle * v[64 + i] + lift * v[144 + i];
      o[32 + i] = v[32 + i] + angle * v[80 + i] + lift * v[160 + i];
    }
  }
}

inline float magnitude(float value) {
  return __builtin_bit_cast(float, __builtin_bit_cast(unsigned, value) & 0x7fffffffU);
}

// What is missing of a slack wall keeps its digits where 1 - slack^2 would lose them: the depth of the folds
// begins as its root.
void hollowFolds(const HollowMix& m, float* __restrict even, float* __restrict odd) {
  const float* __restrict depths = m.depths;
  const float each = m.depthsEach;
  const float waves = m.waves;
  float at[kHollowRow];
  TORSIO_VECTOR_LOOP
  for (int i = 0; i < kHollowRow; ++i) {
    const float missing = even[i];
    at[i] = smaller(TORSIO_ROOT(missing * (2.0F - missing)) / (1.0F - missing) * each,
                    static_cast<float>(kHollowDepths));
  }
  float depth[kHollowRow];
  TORSIO_VECTOR_LOOP
  for (int i = 0; i < kHollowRow; ++i) {
    const int cell = static_cast<int>(smaller(at[i], static_cast<float>(kHollowDepths - 1)));
    const float low = depths[cell];
    depth[i] = low + (at[i] - static_cast<float>(cell)) * (depths[cell + 1] - low);
  }
  TORSIO_VECTOR_LOOP
  for (int i = 0; i < kHollowRow; ++i) {
    const SineCosine crest = sineCosine(waves * odd[i]);
    even[i] = depth[i] * crest.cosine;
    odd[i] = depth[i] * crest.sine;
  }
}

void hollowPlaces(const HollowMix& mix, float* __restrict out) {
  const float* __restrict a = mix.solved[0];
  const float* __restrict b = mix.solved[1];
  const float* __restrict c = mix.solved[2];
  const float* __restrict d = mix.solved[3];
  const float weights[4] = {mix.weights[0], mix.weights[1], mix.weights[2], mix.weights[3]};
  TORSIO_VECTOR_LOOP
  for (int i = 0; i < 4 * kHollowRow; ++i) {
    out[i] = (weights[0] * a[i] + weights[1] * b[i]) + (weights[2] * c[i] + weights[3] * d[i]);
  }
  const float turn = mix.turn;
  TORSIO_VECTOR_LOOP
  for (int i = 0; i < kHollowRow; ++i) {
    out[i] *= turn;
  }
  float* even = out + 2 * kHollowRow;
  unsigned slack = 0;
  for (int i = 0; i < kHollowRow; ++i) {
    slack |= __builtin_bit_cast(unsigned, even[i]);
  }
  float* odd = even + kHollowRow;
  if (slack != 0) {
    hollowFolds(mix, even, odd);
    return;
  }
  for (int i = 0; i < kHollowRow; ++i) {
    odd[i] = 0.0F;
  }
}

void hollowCells(const float* __restrict places, float* __restrict out) {
  constexpr int kCells = kHollowRow - 16;
  for (int quantity = 0; quantity < 4; ++quantity) {
    const float* __restrict p = places + quantity * kHollowRow;
    float* __restrict o = out + 3 * quantity * kHollowRow;
    TORSIO_VECTOR_LOOP
    for (int i = 0; i < kCells; ++i) {
      const float before = p[i + 1] - p[i];
      const float after = p[i + 2] - p[i + 1];
      o[i] = p[i + 1];
      o[kHollowRow + i] = 0.5F * (before + after);
      o[2 * kHollowRow + i] = 0.5F * (after - before);
    }
  }
  const float* __restrict even = places + 2 * kHollowRow;
  const float* __restrict odd = places + 3 * kHollowRow;
  float* __restrict folds = out + 12 * kHollowRow;
  TORSIO_VECTOR_LOOP
  for (int i = 0; i < kCells; ++i) {
    folds[i] =
        ((magnitude(even[i]) + magnitude(even[i + 1])) + (magnitude(even[i + 2]) + magnitude(odd[i]))) +
        (magnitude(odd[i + 1]) + magnitude(odd[i + 2]));
  }
}

// One quantity along the cell of a block.
struct KinkedLine {
  float middle;
  float slope;
  float kink;
};

inline KinkedLine lineOf(const float* cell, int quantity) {
  return {cell[3 * quantity * kHollowRow], cell[(3 * quantity + 1) * kHollowRow],
          cell[(3 * quantity + 2) * kHollowRow]};
}

inline bool folded(const float* cell) {
  return cell[12 * kHollowRow] != 0.0F;
}

inline float along(const KinkedLine& k, float place, float away) {
  return (k.middle + k.slope * place) + k.kink * away;
}

// What the number of folds says, the same in a whole frame.
struct Waves {
  float inverse;
  float second;  // of the second-order sway, over the count
};

inline Waves wavesOf(const HollowFrame& f) {
  return {1.0F / f.waves, (0.5F + 0.25F * f.waves * f.waves) / f.waves};
}

// Where a point of a folded section lies: how far out, against 1, and by what angle round.
struct Folded {
  float up;
  float turn;
};

inline Folded foldedAt(const KinkedLine& evens, const KinkedLine& odds, const Waves& w, float cosine,
                       float sine, float place, float away) {
  const float even = along(evens, place, away);
  const float odd = along(odds, place, away);
  const float up = even * cosine + odd * sine;
  const float aside = even * sine - odd * cosine;
  return {up, aside * (w.second * up - w.inverse)};
}

// A vertex of a section that turns about its own axis; `turn` holds the radius as well.
inline void putOwn(const float* __restrict v, const SineCosine& turn, float radius, int i,
                   float* __restrict o) {
  o[i] = v[i] + radius * v[48 + i] + turn.cosine * v[96 + i] + turn.sine * v[144 + i];
  o[16 + i] = v[16 + i] + radius * v[64 + i] + turn.cosine * v[112 + i] + turn.sine * v[160 + i];
  o[32 + i] = v[32 + i] + radius * v[80 + i] + turn.cosine * v[128 + i] + turn.sine * v[176 + i];
}

void hollowOwn(const float* __restrict in, const int* __restrict firstRows, int blocks,
               const HollowFrame& frame, float* __restrict out) {
  const Waves waves = wavesOf(frame);
  const Waves w = {waves.inverse * 0.318309886F, waves.second * 0.318309886F};  // in half turns
  for (int block = 0; block < blocks; ++block) {
    const float* __restrict v = in + static_cast<long long>(block) * (15 * 16);
    float* __restrict o = out + static_cast<long long>(block) * (3 * 16);
    const float* __restrict cell = frame.cells + firstRows[block];
    const KinkedLine turns = lineOf(cell, 0);
    const KinkedLine radii = lineOf(cell, 1);
    if (!folded(cell)) {
      TORSIO_VECTOR_LOOP
      for (int i = 0; i < 16; ++i) {
        const float place = v[224 + i];
        const float away = magnitude(place);
        const float radius = along(radii, place, away);
        putOwn(v, shortSineCosine(along(turns, place, away), radius), radius, i, o);
      }
      continue;
    }
    const KinkedLine evens = lineOf(cell, 2);
    const KinkedLine odds = lineOf(cell, 3);
    TORSIO_VECTOR_LOOP
    for (int i = 0; i < 16; ++i) {
      const float place = v[224 + i];
      const float away = magnitude(place);
      const Folded fold = foldedAt(evens, odds, w, v[192 + i], v[208 + i], place, away);
      const float mean = along(radii, place, away);
      const float radius = mean + mean * fold.up;
      putOwn(v, shortSineCosine(along(turns, place, away) + fold.turn, radius), radius, i, o);
    }
  }
}

// A vertex of wound limbs, x, y, z of the frame, turned about its line and put where the line is.
inline void putWound(const HollowFrame& f, const SineCosine& turn, float x, float y, float z, int i,
                     float* __restrict o) {
  const float p = turn.cosine * x - turn.sine * y;
  const float q = turn.sine * x + turn.cosine * y;
  o[i] = f.point[0] + f.first[0] * p + f.second[0] * q + f.direction[0] * z;
  o[16 + i] = f.point[1] + f.first[1] * p + f.second[1] * q + f.direction[1] * z;
  o[32 + i] = f.point[2] + f.first[2] * p + f.second[2] * q + f.direction[2] * z;
}

// The fold turns by at most 0.35 rad: short sums, error below 3e-6, a tenth of a micrometre at its radius.
void hollowWound(const float* __restrict in, const int* __restrict firstRows, int blocks,
                 const HollowFrame& frame, float* __restrict out) {
  const HollowFrame f = frame;
  const Waves w = wavesOf(f);
  for (int block = 0; block < blocks; ++block) {
    const float* __restrict v = in + static_cast<long long>(block) * (12 * 16);
    float* __restrict o = out + static_cast<long long>(block) * (3 * 16);
    const float* __restrict cell = f.cells + firstRows[block];
    const KinkedLine turns = lineOf(cell, 0);
    const KinkedLine radii = lineOf(cell, 1);
    if (!folded(cell)) {
      TORSIO_VECTOR_LOOP
      for (int i = 0; i < 16; ++i) {
        const float place = v[176 + i];
        const float away = magnitude(place);
        const SineCosine turn = shortSineCosine(along(turns, place, away), along(radii, place, away));
        putWound(f, turn, v[i], v[16 + i], v[32 + i], i, o);
      }
      continue;
    }
    const KinkedLine evens = lineOf(cell, 2);
    const KinkedLine odds = lineOf(cell, 3);
    TORSIO_VECTOR_LOOP
    for (int i = 0; i < 16; ++i) {
      const float place = v[176 + i];
      const float away = magnitude(place);
      const Folded fold = foldedAt(evens, odds, w, v[144 + i], v[160 + i], place, away);
      const float zz = fold.turn * fold.turn;
      const float radius = 1.0F + fold.up;
      const float aside = radius * (fold.turn + fold.turn * zz * (-0.166666667F + zz * 8.33333333e-3F));
      const float across = fold.up + radius * (zz * (-0.5F + zz * 0.0416666667F));
      const float x = v[i] + across * v[48 + i] + aside * v[96 + i];
      const float y = v[16 + i] + across * v[64 + i] + aside * v[112 + i];
      const float z = v[32 + i] + across * v[80 + i] + aside * v[128 + i];
      putWound(f, shortSineCosine(along(turns, place, away), along(radii, place, away)), x, y, z, i, o);
    }
  }
}

template <typename Real>
void latticeOf(const Real* __restrict in, int sections, int blocksPerSection, const Real* __restrict motions,
               Real* __restrict out) {
  for (int j = 0; j < sections; ++j) {
    const Real* __restrict m = motions + 12LL * j;
    for (int block = 0; block < blocksPerSection; ++block) {
      const Real* __restrict v = in + (static_cast<long long>(j) * blocksPerSection + block) * 48;
      Real* __restrict o = out + (static_cast<long long>(j) * blocksPerSection + block) * 48;
      TORSIO_VECTOR_LOOP
      for (int i = 0; i < 16; ++i) {
        o[i] = m[9] + m[0] * v[i] + m[1] * v[16 + i] + m[2] * v[32 + i];
        o[16 + i] = m[10] + m[3] * v[i] + m[4] * v[16 + i] + m[5] * v[32 + i];
        o[32 + i] = m[11] + m[6] * v[i] + m[7] * v[16 + i] + m[8] * v[32 + i];
      }
    }
  }
}

void componentKriging(const KrigedComponents& components, int vertices, float* __restrict out) {
  const KrigedComponents k = components;
  for (int v = 0; v < vertices; ++v) {
    const float* w = k.weights + 8LL * v;
    const float* a = k.displacements + 4LL * k.first[v];
    const float* b = k.displacements + 4LL * k.firstNext[v];
    const float share = k.share[v];
    float d[4] = {0.0F, 0.0F, 0.0F, 0.0F};
    for (int n = 0; n < 8; ++n) {
      const float wa = w[n] * (1.0F - share);
      const float wb = w[n] * share;
      for (int c = 0; c < 4; ++c) {
        d[c] += wa * a[4 * n + c] + wb * b[4 * n + c];
      }
    }
    for (int c = 0; c < 3; ++c) {
      out[3LL * v + c] = k.rest[3LL * v + c] + d[c];
    }
  }
}

void interleave(const float* __restrict in, int vertices, float* __restrict out, int stride) {
  for (int v = 0; v < vertices; ++v) {
    const float* p = in + static_cast<long long>(v / 16) * 48 + v % 16;
    float* o = out + static_cast<long long>(v) * stride;
    o[0] = p[0];
    o[1] = p[16];
    o[2] = p[32];
  }
}

void triad(const float* __restrict a, const float* __restrict b, float factor, int count,
           float* __restrict out) {
  TORSIO_VECTOR_LOOP
  for (int i = 0; i < count; ++i) {
    out[i] = a[i] + factor * b[i];
  }
}

const TwistKernels kKernels{curvedWarp,       curved,     givenAngles, paperLinear,      hollowPlaces,
                            hollowCells,      hollowOwn,  hollowWound, latticeOf<float>, latticeOf<double>,
                            componentKriging, interleave, triad};
