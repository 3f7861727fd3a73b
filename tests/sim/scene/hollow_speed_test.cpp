// SPDX-License-Identifier: GPL-3.0-or-later
// What a hollow organ costs the processor: a query of the hand, and the set-up of a shipped scene.
#include <algorithm>
#include <array>
#include <ctime>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "sim/scene/hollow_organ.h"
#include "sim/scene/scene.h"
#include "tests/support/allocation_count.h"

namespace torsio {
namespace {

#if defined(__OPTIMIZE__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
constexpr bool kTimed = true;
#else
constexpr bool kTimed = false;  // times of such a build say nothing
#endif
constexpr double kQueryTarget_ns = 300.0;
constexpr double kSetUpTarget_s = 1.0;

/// Of all threads of this process: what a busy machine takes away does not count.
double processor_s() {
  return static_cast<double>(std::clock()) / static_cast<double>(CLOCKS_PER_SEC);
}

Scene shipped(const std::string& id) {
  SceneRequest request;
  request.assets = std::filesystem::path(TORSIO_SOURCE_DIR) / "assets";
  request.id = id;
  request.pattern = "detorse";
  return loadScene(request);
}

class HollowSpeed : public ::testing::TestWithParam<const char*> {};

TEST_P(HollowSpeed, AQueryAllocatesNothingAndTakes300NsOfTheProcessorAtMost) {
  const Scene scene = shipped(GetParam());
  constexpr int kQueries = 4000;
  std::array<double, 31> batches_ns{};
  double sum = 0.0;
  unsigned state = 1;
  const auto allocated = testing::allocationCount();

  for (double& batch_ns : batches_ns) {
    const double begun_s = processor_s();
    for (int k = 0; k < kQueries; ++k) {
      state = state * 1664525U + 1013904223U;  // angles and pressures in no order
      const double share = static_cast<double>(state >> 8U) / 16777216.0;
      const double pressure_Pa = scene.hollow->detorsion().wall.pressure_Pa * (1.0 - share);
      sum += scene.hollow->torque_Nm(8.0 * share - 4.0, pressure_Pa);
    }
    batch_ns = 1e9 * (processor_s() - begun_s) / kQueries;
  }

  EXPECT_EQ(testing::allocationCount(), allocated);
  EXPECT_NE(sum, 0.0);
  std::sort(batches_ns.begin(), batches_ns.end());
  const double median_ns = batches_ns[batches_ns.size() / 2];
  RecordProperty("query_ns", std::to_string(median_ns));
  EXPECT_LE(kTimed ? median_ns : 0.0, kQueryTarget_ns);
}

TEST_P(HollowSpeed, IsSetUpWithinASecondOfTheProcessor) {
  const Scene scene = shipped(GetParam());
  const HollowOrgan::Parts parts{.lattice = &scene.lattice(),
                                 .shearModulus_Pa = scene.model.material().shearModulus_Pa,
                                 .graspArc = scene.pattern.graspArc,
                                 .detorsion = *scene.pattern.detorsion};

  const double begun_s = processor_s();
  const HollowOrgan organ(parts);
  const double taken_s = processor_s() - begun_s;

  RecordProperty("set_up_ms", std::to_string(1e3 * taken_s));
  EXPECT_EQ(organ.basePeak_Nm(), scene.hollow->basePeak_Nm());
  EXPECT_LE(kTimed ? taken_s : 0.0, kSetUpTarget_s);
}

INSTANTIATE_TEST_SUITE_P(ShippedOrgans, HollowSpeed,
                         ::testing::Values("gastric-mesentero-axial", "gastric-organo-axial", "midgut",
                                           "sigmoid", "small-bowel-loop", "testis"));

}  // namespace
}  // namespace torsio
