// SPDX-License-Identifier: GPL-3.0-or-later
// What a query of a hollow organ costs, and what its set-up gives twice; times are those of
// torsio_bench_hollow.
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "sim/scene/hollow_organ.h"
#include "sim/scene/scene.h"
#include "tests/support/allocation_count.h"
#include "tests/support/shipped_scene.h"

namespace torsio {
namespace {

Scene hollowScene(const std::string& id) {
  return testing::shippedScene(id, "detorse");
}

class HollowOrganCost : public ::testing::TestWithParam<const char*> {};

TEST_P(HollowOrganCost, QueriesAllocateNothing) {
  const Scene scene = hollowScene(GetParam());
  double sum = 0.0;
  unsigned state = 1;
  const auto allocated = testing::allocationCount();

  for (int k = 0; k < 4000; ++k) {
    state = state * 1664525U + 1013904223U;  // angles and pressures in no order
    const double share = static_cast<double>(state >> 8U) / 16777216.0;
    const double pressure_Pa = scene.hollow->detorsion().wall.pressure_Pa * (1.0 - share);
    sum += scene.hollow->torque_Nm(8.0 * share - 4.0, pressure_Pa);
  }

  EXPECT_EQ(testing::allocationCount(), allocated);
  EXPECT_NE(sum, 0.0);
}

TEST_P(HollowOrganCost, ASecondSetUpGivesTheSameOrgan) {
  const Scene scene = hollowScene(GetParam());
  const HollowOrgan::Parts parts{.lattice = &scene.lattice(),
                                 .shearModulus_Pa = scene.model.material().shearModulus_Pa,
                                 .graspArc = scene.pattern.graspArc,
                                 .detorsion = *scene.pattern.detorsion};

  const HollowOrgan organ(parts);

  EXPECT_EQ(organ.basePeak_Nm(), scene.hollow->basePeak_Nm());
}

INSTANTIATE_TEST_SUITE_P(ShippedOrgans, HollowOrganCost,
                         ::testing::Values("gastric-mesentero-axial", "gastric-organo-axial", "midgut",
                                           "sigmoid", "small-bowel-loop", "testis"));

}  // namespace
}  // namespace torsio
