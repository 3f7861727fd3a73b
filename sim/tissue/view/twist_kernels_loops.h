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
      const Across a = tangentCrossRadius(v, i);
      o[i] = v[i] + r.cosine * v[48 + i] + r.sine * a.x + warp * v[96 + i];
      o[16 + i] = v[16 + i] + r.cosine * v[64 + i] + r.sine * a.y + warp * v[112 + i];
      o[32 + i] = v[32 + i] + r.cosine * v[80 + i] + r.sine * a.z + warp * v[128 + i];
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
      const Across a = tangentCrossRadius(v, i);
      o[i] = v[i] + r.cosine * v[48 + i] + r.sine * a.x + warp * v[96 + i];
      o[16 + i] = v[16 + i] + r.cosine * v[64 + i] + r.sine * a.y + warp * v[112 + i];
      o[32 + i] = v[32 + i] + r.cosine * v[80 + i] + r.sine * a.z + warp * v[128 + i];
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

inline float along(const KinkedLine& k, float place, float away) {
  return k.middle + (k.slope * place + k.kink * away);
}

inline float magnitude(float value) {
  return __builtin_bit_cast(float, __builtin_bit_cast(unsigned, value) & 0x7fffffffU);
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

inline Folded foldedAt(const HollowCells& b, const Waves& w, float cosine, float sine, float place,
                       float away) {
  const float even = along(b.even, place, away);
  const float odd = along(b.odd, place, away);
  const float up = even * cosine + odd * sine;
  const float aside = even * sine - odd * cosine;
  return {up, aside * (w.second * up - w.inverse)};
}

void hollowOwn(const float* __restrict in, const int* __restrict firstRows, int blocks,
               const HollowFrame& frame, float* __restrict out) {
  const Waves waves = wavesOf(frame);
  const Waves w = {waves.inverse * 0.318309886F, waves.second * 0.318309886F};  // in half turns
  for (int block = 0; block < blocks; ++block) {
    const float* __restrict v = in + static_cast<long long>(block) * (16 * 16);
    float* __restrict o = out + static_cast<long long>(block) * (3 * 16);
    const HollowCells b = frame.cells[firstRows[block]];
    TORSIO_VECTOR_LOOP
    for (int i = 0; i < 16; ++i) {
      const float place = v[240 + i];
      const float away = magnitude(place);
      const Folded fold = foldedAt(b, w, v[208 + i], v[224 + i], place, away);
      const float mean = along(b.radius, place, away);
      const float radius = mean + mean * fold.up;
      const SineCosine turn = shortSineCosine(along(b.turn, place, away) + fold.turn, 1.0F);
      const float ex = v[144 + i];
      const float ey = v[160 + i];
      const float ez = v[176 + i];
      const float x = v[48 + i] + radius * v[96 + i];
      const float y = v[64 + i] + radius * v[112 + i];
      const float z = v[80 + i] + radius * v[128 + i];
      const float lift = radius * v[192 + i];
      o[i] = v[i] + lift * ex + turn.cosine * x + turn.sine * (ey * z - ez * y);
      o[16 + i] = v[16 + i] + lift * ey + turn.cosine * y + turn.sine * (ez * x - ex * z);
      o[32 + i] = v[32 + i] + lift * ez + turn.cosine * z + turn.sine * (ex * y - ey * x);
    }
  }
}

// The fold turns by at most 0.35 rad: short sums, error below 3e-6, a tenth of a micrometre at its radius.
void hollowWound(const float* __restrict in, const int* __restrict firstRows, int blocks,
                 const HollowFrame& frame, float* __restrict out) {
  const HollowFrame f = frame;
  const Waves w = wavesOf(f);
  for (int block = 0; block < blocks; ++block) {
    const float* __restrict v = in + static_cast<long long>(block) * (12 * 16);
    float* __restrict o = out + static_cast<long long>(block) * (3 * 16);
    const HollowCells b = f.cells[firstRows[block]];
    TORSIO_VECTOR_LOOP
    for (int i = 0; i < 16; ++i) {
      const float place = v[176 + i];
      const float away = magnitude(place);
      const Folded fold = foldedAt(b, w, v[144 + i], v[160 + i], place, away);
      const float zz = fold.turn * fold.turn;
      const float radius = 1.0F + fold.up;
      const float aside = radius * (fold.turn + fold.turn * zz * (-0.166666667F + zz * 8.33333333e-3F));
      const float across = radius * (1.0F + zz * (-0.5F + zz * 0.0416666667F));
      const float x = v[i] + across * v[48 + i] + aside * v[96 + i];
      const float y = v[16 + i] + across * v[64 + i] + aside * v[112 + i];
      const float z = v[32 + i] + across * v[80 + i] + aside * v[128 + i];
      const SineCosine turn = shortSineCosine(along(b.turn, place, away), along(b.radius, place, away));
      const float p = turn.cosine * x - turn.sine * y;
      const float q = turn.sine * x + turn.cosine * y;
      o[i] = f.point[0] + f.first[0] * p + f.second[0] * q + f.direction[0] * z;
      o[16 + i] = f.point[1] + f.first[1] * p + f.second[1] * q + f.direction[1] * z;
      o[32 + i] = f.point[2] + f.first[2] * p + f.second[2] * q + f.direction[2] * z;
    }
  }
}

void lattice(const float* __restrict in, int sections, int blocksPerSection, const float* __restrict motions,
             float* __restrict out) {
  for (int j = 0; j < sections; ++j) {
    const float* __restrict m = motions + 12LL * j;
    for (int block = 0; block < blocksPerSection; ++block) {
      const float* __restrict v = in + (static_cast<long long>(j) * blocksPerSection + block) * 48;
      float* __restrict o = out + (static_cast<long long>(j) * blocksPerSection + block) * 48;
      TORSIO_VECTOR_LOOP
      for (int i = 0; i < 16; ++i) {
        o[i] = m[9] + m[0] * v[i] + m[1] * v[16 + i] + m[2] * v[32 + i];
        o[16 + i] = m[10] + m[3] * v[i] + m[4] * v[16 + i] + m[5] * v[32 + i];
        o[32 + i] = m[11] + m[6] * v[i] + m[7] * v[16 + i] + m[8] * v[32 + i];
      }
    }
  }
}

void latticeDouble(const double* __restrict in, int sections, int blocksPerSection,
                   const double* __restrict motions, double* __restrict out) {
  for (int j = 0; j < sections; ++j) {
    const double* __restrict m = motions + 12LL * j;
    for (int block = 0; block < blocksPerSection; ++block) {
      const double* __restrict v = in + (static_cast<long long>(j) * blocksPerSection + block) * 48;
      double* __restrict o = out + (static_cast<long long>(j) * blocksPerSection + block) * 48;
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

const TwistKernels kKernels{curvedWarp, curved,        givenAngles,      paperLinear, hollowOwn, hollowWound,
                            lattice,    latticeDouble, componentKriging, interleave,  triad};
