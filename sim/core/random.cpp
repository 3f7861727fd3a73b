// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/core/random.h"

#include <cmath>

#include "sim/core/contracts.h"
#include "sim/core/portable_math.h"

namespace torsio {

std::uint64_t Random::bounded(std::uint64_t n) {
  TORSIO_EXPECTS(n >= 1);
  std::uint64_t x = engine_();
  // Values from 2^64 - remainder upwards would favour the small results. The remainder, 2^64 mod n, is below
  // n, so that the division is needed for the largest values only.
  while (x >= 0 - n) {
    const std::uint64_t remainder = (0 - n) % n;
    if (remainder == 0 || x < 0 - remainder) {
      break;
    }
    x = engine_();
  }
  return x % n;
}

double Random::uniform() {
  return static_cast<double>(engine_() >> 11) * 0x1.0p-53;
}

double Random::normal() {
  if (hasSpare_) {
    hasSpare_ = false;
    return spare_;
  }
  for (;;) {
    const double u = 2.0 * uniform() - 1.0;
    const double v = 2.0 * uniform() - 1.0;
    const double s = u * u + v * v;
    if (s >= 1.0 || s == 0.0) {
      continue;
    }
    const double scale = std::sqrt(-2.0 * portableLog(s) / s);
    spare_ = v * scale;
    hasSpare_ = true;
    return u * scale;
  }
}

Random Random::forStream(std::uint64_t seed, std::uint64_t stream) {
  // SplitMix64 finaliser over both numbers, so that neighbouring seeds and streams share nothing.
  std::uint64_t z = seed + 0x9E3779B97F4A7C15ULL * (stream + 1);
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ULL;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBULL;
  return Random(z ^ (z >> 31));
}

}  // namespace torsio
