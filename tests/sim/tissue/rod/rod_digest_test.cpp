// SPDX-License-Identifier: GPL-3.0-or-later
// The same bits from every build: this source is linked with the rod as it is shipped and, in programs of
// their own, with the rod compiled by -O2 and for AVX2.
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "sim/core/digest.h"
#include "tests/sim/tissue/rod/rod_scenes.h"

namespace torsio {
namespace {

std::string digestOf(const RodScene& scene) {
  RunningRodScene run(scene);
  Digest digest;
  for (int tick = 0; tick < scene.ticks; ++tick) {
    run.moveHand();
    const RodStepResult step = run.step();
    digest.update(step.load.force_N.x);
    digest.update(step.load.torque_Nm.z);
    for (std::size_t i = 0; tick % 50 == 0 && i < static_cast<std::size_t>(run.pose().count); ++i) {
      const Pose& node = run.pose().nodes[i];
      for (const double value : {node.position_m.x, node.position_m.y, node.position_m.z, node.orientation.w,
                                 node.orientation.x, node.orientation.y, node.orientation.z}) {
        digest.update(value);
      }
    }
  }
  return digest.hex().substr(0, 16);
}

TEST(RodBits, AreTheSameInEveryBuildAndOnEveryProcessor) {
#if defined(TORSIO_ROD_FOR_AVX2)
  if (!__builtin_cpu_supports("avx2") || !__builtin_cpu_supports("fma")) {
    GTEST_SKIP() << "this processor has no AVX2";
  }
#endif
  const std::vector<std::string> stored{"8b66a06f79d4d775", "182ec63a78baa50c", "41fe7c63fce3a32c",
                                        "fb68c7e41a341123", "62bc49884a488f67", "90bac4d0abbb4c0c"};

  const std::vector<RodScene> scenes = rodScenes();

  ASSERT_EQ(stored.size(), scenes.size());
  for (std::size_t k = 0; k < scenes.size(); ++k) {
    EXPECT_EQ(digestOf(scenes[k]), stored[k]) << scenes[k].name;
  }
}

}  // namespace
}  // namespace torsio
