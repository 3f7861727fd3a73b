// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/core/random.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <string>

#include <gtest/gtest.h>

#include "sim/core/contracts.h"
#include "sim/core/error.h"

namespace torsio {
namespace {

// Reference vectors of the allocation algorithms: std::mt19937_64, computed twice (C++ and Python).
constexpr std::uint64_t kReferenceSeed = 20240601;

TEST(Random, GivesTheReferenceOutputs) {
  Random random(kReferenceSeed);

  for (const std::uint64_t expected : {2131363353009838922ULL, 3365856385504734695ULL, 3091805213556246317ULL,
                                       15537990288686237192ULL, 1644841800503174935ULL}) {
    EXPECT_EQ(random.next(), expected);
  }
}

TEST(Random, ShufflesThirtyPlacesLikeTheReference) {
  std::string arms = "111111111122222222223333333333";
  Random random(kReferenceSeed);

  random.shuffle(std::span<char>(arms));

  EXPECT_EQ(arms, "111223221333311211322231233321");
}

TEST(Random, DrawsBoundedNumbersWithoutBias) {
  constexpr std::uint64_t kFaces = 6;
  constexpr int kDraws = 60'000;
  Random random(17);
  std::array<int, kFaces> seen{};
  for (int i = 0; i < kDraws; ++i) {
    const std::uint64_t face = random.bounded(kFaces);
    ASSERT_LT(face, kFaces);
    ++seen[face];
  }

  // Chi square with five degrees of freedom exceeds 20.5 once in a thousand seeds; this seed is fixed.
  double chiSquare = 0.0;
  for (const int count : seen) {
    chiSquare += (count - 10'000.0) * (count - 10'000.0) / 10'000.0;
  }
  EXPECT_LT(chiSquare, 20.5);
  EXPECT_EQ(random.bounded(1), 0U);
}

TEST(Random, DrawsUniformNumbersInTheHalfOpenInterval) {
  Random random(18);
  double sum = 0.0;
  for (int i = 0; i < 100'000; ++i) {
    const double u = random.uniform();
    ASSERT_GE(u, 0.0);
    ASSERT_LT(u, 1.0);
    sum += u;
  }
  EXPECT_NEAR(sum / 100'000.0, 0.5, 0.003);  // standard error 0.0009
}

TEST(Random, DrawsNormalNumbersWithTheRightMoments) {
  Random random(19);
  constexpr int kDraws = 100'000;
  double sum = 0.0;
  double squares = 0.0;
  double fourth = 0.0;
  for (int i = 0; i < kDraws; ++i) {
    const double z = random.normal();
    sum += z;
    squares += z * z;
    fourth += z * z * z * z;
  }
  EXPECT_NEAR(sum / kDraws, 0.0, 0.013);      // four standard errors of 1/sqrt(n)
  EXPECT_NEAR(squares / kDraws, 1.0, 0.018);  // of sqrt(2/n)
  EXPECT_NEAR(fourth / kDraws, 3.0, 0.13);    // of sqrt(96/n)
}

TEST(Random, EachStreamIsIndependentOfEarlierDraws) {
  Random used(5);
  (void)used.next();
  Random a = Random::forStream(5, 1);
  Random again = Random::forStream(5, 1);
  Random otherStream = Random::forStream(5, 2);
  Random otherSeed = Random::forStream(6, 1);

  const std::uint64_t first = a.next();

  EXPECT_EQ(first, again.next());
  EXPECT_NE(first, otherStream.next());
  EXPECT_NE(first, otherSeed.next());
}

TEST(Random, RefusesABoundOfZero) {
  Random random(1);
  EXPECT_THROW((void)random.bounded(0), ContractError);
}

}  // namespace
}  // namespace torsio
