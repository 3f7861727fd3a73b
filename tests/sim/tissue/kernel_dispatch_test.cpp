// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "sim/core/portable_math.h"
#include "sim/core/random.h"
#include "sim/tissue/twist/twist_bench.h"
#include "sim/tissue/view/cpu_features.h"
#include "sim/tissue/view/twist_kernels.h"
#include "sim/tissue/view/twist_kernels_buffer.h"

namespace torsio {
namespace {

// Float rounding of a product of two numbers below 1 and of an angle of a turn: "6e-7 of the radius" is the
// promise of twist_kernels.h, for unit radius.
constexpr double kFloatTolerance = 6e-7;
constexpr int kBlocks = 5;
constexpr int kVertices = kBlocks * kKernelBlock;

template <typename T>
using Aligned = KernelBuffer<T>;

template <typename T>
Aligned<T> aligned(int count) {
  return Aligned<T>(static_cast<std::size_t>(count));
}

/// Where stream `which` of a vertex lies in blocks of so many streams.
std::size_t lane(int streams, int vertex, int which) {
  const int index =
      (vertex / kKernelBlock) * streams * kKernelBlock + which * kKernelBlock + vertex % kKernelBlock;
  return static_cast<std::size_t>(index);
}

class KernelDispatch : public ::testing::TestWithParam<Isa> {
 protected:
  const TwistKernels& kernels_ = twistKernels(GetParam());

  static Aligned<float> randomBlocks(int streams, std::uint64_t seed) {
    Random random(seed);
    auto blocks = aligned<float>(kVertices * streams);
    for (std::size_t i = 0; i < blocks.size(); ++i) {
      blocks[i] = static_cast<float>(2.0 * random.uniform() - 1.0);
    }
    return blocks;
  }
  static double stream(const Aligned<float>& blocks, int streams, int vertex, int which) {
    return static_cast<double>(blocks[lane(streams, vertex, which)]);
  }
};

/// Coordinate `axis` of foot + cos radius + sin tangent x radius + rate psiRate tangent in blocks of eleven
/// streams.
double curvedPlace(const Aligned<float>& in, int v, int axis, double angle, double rate) {
  const auto at = [&](int which) { return static_cast<double>(in[lane(11, v, which)]); };
  const int next = (axis + 1) % 3;
  const int last = (axis + 2) % 3;
  const double across = at(6 + next) * at(3 + last) - at(6 + last) * at(3 + next);
  return at(axis) + std::cos(angle) * at(3 + axis) + std::sin(angle) * across + rate * at(10) * at(6 + axis);
}

std::string isaTestName(const ::testing::TestParamInfo<Isa>& info) {
  return std::string(isaName(info.param));
}

INSTANTIATE_TEST_SUITE_P(EverySet, KernelDispatch,
                         ::testing::ValuesIn(usableIsas().begin(), usableIsas().end()), isaTestName);

TEST(CpuFeatures, ThePortableSetIsAlwaysUsableAndTheBestIsTheLast) {
  ASSERT_FALSE(usableIsas().empty());
  EXPECT_EQ(usableIsas().front(), Isa::kPortable);
  EXPECT_EQ(bestIsa(), usableIsas().back());
}

TEST_P(KernelDispatch, CurvedWarpIsTheFiniteRotationPlusTheRateTimesWarp) {
  // Given random feet, radii and compliances in [-1, 1], and a twist of up to two turns held in the middle.
  const auto in = randomBlocks(11, 11);
  auto out = aligned<float>(kVertices * 3);
  TwistFrame frame{.torque = 9.0F,
                   .nearSlope = 0.75F,
                   .farBase = 0.3F,
                   .farSlope = -0.25F,
                   .graspCompliance = 0.3F,
                   .inverseBlend = 4.0F,
                   .nearRate = 1.5F,
                   .farRate = -0.5F};

  kernels_.curvedWarp(in.data(), kBlocks, frame, out.data());

  for (int v = 0; v < kVertices; ++v) {
    const double c = stream(in, 11, v, 9);
    const double angle = 9.0 * std::min(0.75 * c, static_cast<double>(0.3F) - 0.25 * c);
    const double t = std::clamp(0.5 + (static_cast<double>(0.3F) - c) * 4.0, 0.0, 1.0);
    const double rate = -0.5 + 2.0 * (t * t * (3.0 - 2.0 * t));
    for (int axis = 0; axis < 3; ++axis) {
      const double expected = curvedPlace(in, v, axis, angle, rate);
      // The angle itself is rounded to float: 9 rad carry an error of 5e-7.
      EXPECT_NEAR(stream(out, 3, v, axis), expected, 3.0 * kFloatTolerance) << "vertex " << v;
    }
  }
}

TEST_P(KernelDispatch, SineAndCosineHoldToTheLastFloatBitsOverAFullTurn) {
  // Given unit radii along x, and compliances that sweep -360..360 degrees in half turns, in which the kernel
  // counts.
  auto in = aligned<float>(kVertices * 10);
  auto out = aligned<float>(kVertices * 3);
  for (int v = 0; v < kVertices; ++v) {
    float* at = in.data() + lane(10, v, 0);
    at[3 * kKernelBlock] = 1.0F;
    at[8 * kKernelBlock] = 1.0F;  // tangent along z: the radius turns from x to y
    at[9 * kKernelBlock] = static_cast<float>(2.0 * (2.0 * v / (kVertices - 1) - 1.0));
  }
  TwistFrame frame{.torque = static_cast<float>(kPi), .farBase = 100.0F};

  kernels_.curved(in.data(), kBlocks, frame, out.data());

  constexpr double kSineError = 1.8e-7;  // three units in the last place of a float below 1
  for (int v = 0; v < kVertices; ++v) {
    const double angle = kPi * stream(in, 10, v, 9);
    EXPECT_NEAR(stream(out, 3, v, 0), std::cos(angle), kSineError) << angle;
    EXPECT_NEAR(stream(out, 3, v, 1), std::sin(angle), kSineError) << angle;
  }
}

TEST_P(KernelDispatch, GivenAnglesAgreeWithTheFormulaPerVertex) {
  const auto in = randomBlocks(11, 12);
  const auto anglesAndRates = randomBlocks(2, 13);
  auto out = aligned<float>(kVertices * 3);

  kernels_.givenAngles(in.data(), anglesAndRates.data(), kBlocks, out.data());

  for (int v = 0; v < kVertices; ++v) {
    const double angle = stream(anglesAndRates, 2, v, 0);
    const double rate = stream(anglesAndRates, 2, v, 1);
    for (int axis = 0; axis < 3; ++axis) {
      const double expected = curvedPlace(in, v, axis, angle, rate);
      EXPECT_NEAR(stream(out, 3, v, axis), expected, kFloatTolerance);
    }
  }
}

TEST_P(KernelDispatch, PaperLinearTurnsRigidlyBeyondTheGraspAndLiftsBelowIt) {
  const auto in = randomBlocks(11, 14);
  auto out = aligned<float>(kVertices * 3);
  PaperFrame frame{.torque = 2.0F, .graspArc = 0.25F, .graspAngle = 0.5F};

  kernels_.paperLinear(in.data(), kBlocks, frame, out.data());

  for (int v = 0; v < kVertices; ++v) {
    const bool near = stream(in, 11, v, 7) <= 0.25;
    const double angle = 2.0 * (near ? stream(in, 11, v, 6) : 0.5);
    for (int axis = 0; axis < 3; ++axis) {
      const double expected = stream(in, 11, v, axis) + angle * stream(in, 11, v, 3 + axis) +
                              (near ? 2.0 * stream(in, 11, v, 8 + axis) : 0.0);
      EXPECT_NEAR(stream(out, 3, v, axis), expected, kFloatTolerance);
    }
  }
}

TEST_P(KernelDispatch, LatticeMovesEverySectionByItsOwnMatrix) {
  constexpr int kSections = kBlocks;
  const auto in = randomBlocks(3, 16);
  Random random(17);
  std::vector<float> motions(12 * kSections);
  for (float& m : motions) {
    m = static_cast<float>(random.uniform());
  }
  auto out = aligned<float>(kVertices * 3);
  auto inDouble = aligned<double>(kVertices * 3);
  auto outDouble = aligned<double>(kVertices * 3);
  std::copy_n(in.data(), kVertices * 3, inDouble.data());
  const std::vector<double> motionsDouble(motions.begin(), motions.end());

  kernels_.lattice(in.data(), kSections, 1, motions.data(), out.data());
  kernels_.latticeDouble(inDouble.data(), kSections, 1, motionsDouble.data(), outDouble.data());

  for (int v = 0; v < kVertices; ++v) {
    const double* m = motionsDouble.data() + 12 * (v / kKernelBlock);
    for (int axis = 0; axis < 3; ++axis) {
      double expected = m[9 + axis];
      for (int k = 0; k < 3; ++k) {
        expected += m[3 * axis + k] * stream(in, 3, v, k);
      }
      const std::size_t at = lane(3, v, axis);
      EXPECT_NEAR(out[at], expected, kFloatTolerance);
      EXPECT_NEAR(outDouble[at], expected, 1e-15);
    }
  }
}

TEST_P(KernelDispatch, ComponentKrigingIsTheWeightedSumOverBothRidges) {
  // Given twenty key points of random displacement and two vertices with random weights.
  Random random(18);
  std::vector<float> weights(16);
  for (float& w : weights) {
    w = static_cast<float>(random.uniform() - 0.4);
  }
  std::vector<float> displacements(4 * 20);
  for (float& d : displacements) {
    d = static_cast<float>(random.uniform());
  }
  const std::vector<int> first{0, 2};
  const std::vector<int> firstNext{10, 12};
  const std::vector<float> share{0.25F, 1.0F};
  const std::vector<float> rest{1, 2, 3, 4, 5, 6};
  KrigedComponents components{.weights = weights.data(),
                              .first = first.data(),
                              .firstNext = firstNext.data(),
                              .share = share.data(),
                              .displacements = displacements.data(),
                              .rest = rest.data()};
  std::vector<float> out(6);

  kernels_.componentKriging(components, 2, out.data());

  for (std::size_t v = 0; v < 2; ++v) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      double expected = rest[3 * v + axis];
      for (std::size_t n = 0; n < 8; ++n) {
        const double here = displacements[4 * (static_cast<std::size_t>(first[v]) + n) + axis];
        const double next = displacements[4 * (static_cast<std::size_t>(firstNext[v]) + n) + axis];
        expected += weights[8 * v + n] * ((1.0 - share[v]) * here + share[v] * next);
      }
      EXPECT_NEAR(out[3 * v + axis], expected, 2.0 * kFloatTolerance);  // sums of up to 8
    }
  }
}

TEST_P(KernelDispatch, InterleaveWritesEveryVertexAtItsStrideAndNothingBetween) {
  const auto in = randomBlocks(3, 19);
  constexpr int kWritten = kVertices - 3;  // the last block is not full
  std::vector<float> out(8 * kWritten, -7.0F);

  kernels_.interleave(in.data(), kWritten, out.data(), 8);

  for (int v = 0; v < kWritten; ++v) {
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_EQ(out[static_cast<std::size_t>(8 * v + axis)], static_cast<float>(stream(in, 3, v, axis)));
    }
    EXPECT_EQ(out[static_cast<std::size_t>(8 * v + 3)], -7.0F);
  }
}

TEST_P(KernelDispatch, TriadIsOneProductAndOneSum) {
  const std::vector<float> a{1.0F, 2.0F, 3.0F};
  const std::vector<float> b{10.0F, 20.0F, 30.0F};
  std::vector<float> out(3);

  kernels_.triad(a.data(), b.data(), 0.5F, 3, out.data());

  EXPECT_EQ(out, (std::vector<float>{6.0F, 12.0F, 18.0F}));
}

TEST(TissueBench, MeasuresEveryTargetOfTheModelInOneRun) {
  // A small run: what is checked is that everything is measured, not how fast this machine is just now.
  TissueBenchOptions options{.repeats = 3, .vertices = 4000, .ridges = 36, .sections = 20};

  const TissueBenchResult result = runTissueBench(options);

  EXPECT_EQ(result.isa, isaName(bestIsa()));
  for (const char* name : {"lattice_over_triad", "double_lattice_over_triad", "vertices_over_triad",
                           "vertices_portable_over_triad", "precomputed_over_live_kriging", "haptic_query",
                           "haptic_query_p999", "set_up_cpu"}) {
    const auto row = std::find_if(result.rows.begin(), result.rows.end(),
                                  [&](const TissueBenchRow& r) { return r.name == name; });
    ASSERT_NE(row, result.rows.end()) << name;
    EXPECT_TRUE(std::isfinite(row->value) && row->value > 0.0) << name;
    EXPECT_GT(row->target, 0.0) << name;
  }
}

TEST(TissueBench, ATargetIsMetFromTheRightSide) {
  EXPECT_TRUE((TissueBenchRow{"ratio", 0.8, "1", 0.8}).met());
  EXPECT_FALSE((TissueBenchRow{"ratio", 0.79, "1", 0.8}).met());
  EXPECT_TRUE((TissueBenchRow{"time", 90.0, "ns", 100.0, false}).met());
  EXPECT_FALSE((TissueBenchRow{"time", 110.0, "ns", 100.0, false}).met());
  EXPECT_TRUE((TissueBenchRow{"told", 110.0, "us"}).met());
}

}  // namespace
}  // namespace torsio
