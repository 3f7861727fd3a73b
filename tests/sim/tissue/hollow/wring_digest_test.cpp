// SPDX-License-Identifier: GPL-3.0-or-later
// The bits of a wrung organ's table, the same in every build: it is solved again wherever a recording is
// played.
#include <cstdint>
#include <cstring>
#include <vector>

#include <gtest/gtest.h>

#include "sim/tissue/hollow/wrung_organ.h"

namespace torsio {
namespace {

/// FNV-1a over the bytes of what the table answers at 13 pressures and 97 angles of an organ that tapers.
std::uint64_t digestOf(const WrungOrgan& organ) {
  std::uint64_t digest = 14695981039346656037ULL;
  for (int p = 0; p <= 12; ++p) {
    for (int k = -16; k <= 80; ++k) {
      const WrungState state = organ.at(0.05 * k, 100.0 * p);
      for (const double value :
           {state.torque, state.waist, state.waistPlace, state.patency, state.volume, state.length}) {
        unsigned char bytes[sizeof value];
        std::memcpy(bytes, &value, sizeof value);
        for (const unsigned char byte : bytes) {
          digest = (digest ^ byte) * 1099511628211ULL;
        }
      }
    }
  }
  return digest;
}

TEST(WringDigest, IsTheSameInEveryBuild) {
#if defined(TORSIO_HOLLOW_FOR_AVX2)
  if (!__builtin_cpu_supports("avx2") || !__builtin_cpu_supports("fma")) {
    GTEST_SKIP() << "this processor has no AVX2";
  }
#endif
  std::vector<WallPlace> places;
  for (int i = 0; i <= 40; ++i) {
    places.push_back({0.030 + 0.0001 * i, 0.0025 - 0.00001 * i});
  }
  HollowContent content{.shearModulus_Pa = 5e3, .restPressure_Pa = 400.0, .highestPressure_Pa = 1200.0};

  EXPECT_EQ(digestOf(WrungOrgan(places, 0.2, content)), 11340372665126202462ULL);
  content.foldsNeedRoom = false;  // as in recordings from before
  EXPECT_EQ(digestOf(WrungOrgan(places, 0.2, content)), 12987385646362752412ULL);
}

}  // namespace
}  // namespace torsio
