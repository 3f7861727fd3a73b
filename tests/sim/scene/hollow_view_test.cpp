// SPDX-License-Identifier: GPL-3.0-or-later
// The single-precision view of hollow organs against the double path, by every instruction set.
#include "sim/scene/hollow_view.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "sim/base/angle.h"
#include "sim/scene/scene_file.h"

namespace torsio {
namespace {

std::shared_ptr<const Scene> shippedHollow(const std::string& id) {
  SceneRequest request;
  request.assets = std::filesystem::path(TORSIO_SOURCE_DIR) / "assets";
  request.id = id;
  request.pattern = "detorse";
  return std::make_shared<const Scene>(loadScene(request));
}

// Onset and closing (of a cord some turns), half and whole turns, both ways.
std::vector<double> anglesOf(const HollowOrgan& organ) {
  std::vector<double> angles{radians(30.0), radians(180.0), radians(360.0), organ.detorsion().start.most_rad};
  if (organ.tube(0) != nullptr) {
    angles.push_back(organ.onset_rad(organ.detorsion().wall.pressure_Pa));
    angles.push_back(organ.closing_rad(organ.detorsion().wall.pressure_Pa));
  }
  const std::size_t oneWay = angles.size();
  for (std::size_t i = 0; i < oneWay; ++i) {
    angles.push_back(-angles[i]);
  }
  return angles;
}

double farthest_m(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double most_m = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    most_m = std::max(most_m, norm(a[i] - b[i]));
  }
  return most_m;
}

class HollowViewOf : public ::testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(EveryScene, HollowViewOf,
                         ::testing::Values("gastric-organo-axial", "gastric-mesentero-axial", "sigmoid",
                                           "midgut", "small-bowel-loop", "testis"),
                         [](const auto& scene) {
                           std::string name = scene.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

TEST_P(HollowViewOf, EverySetDrawsItWhereTheDoublePathPutsItToAMicrometre) {
  const std::shared_ptr<const Scene> scene = shippedHollow(GetParam());
  std::vector<Vec3> expected_m(scene->mesh.vertices_m.size());
  std::vector<Vec3> drawn_m(expected_m.size());

  for (const Isa isa : usableIsas()) {
    HollowView view(scene, isa);
    for (const double angle_rad : anglesOf(*scene->hollow)) {
      OrganState state = scene->stateAt(angle_rad);
      for (const double pressure : {1.0, 0.3}) {
        state.hollow.reading.pressure_Pa = pressure * scene->hollow->detorsion().wall.pressure_Pa;
        scene->deform(state, expected_m);
        view.deform(state, drawn_m);

        EXPECT_LT(farthest_m(drawn_m, expected_m), 1e-6) << isaName(isa) << " " << degrees(angle_rad);
      }
    }
  }
}

TEST_P(HollowViewOf, AtRestIsTheDoublePathToTheBit) {
  const std::shared_ptr<const Scene> scene = shippedHollow(GetParam());
  OrganState rest = scene->stateAt(0.0);
  rest.hollow.reading.pressure_Pa = scene->hollow->detorsion().wall.restPressure_Pa;
  std::vector<Vec3> drawn_m(scene->mesh.vertices_m.size());

  HollowView view(scene);
  view.deform(scene->stateAt(1.0), drawn_m);
  view.deform(rest, drawn_m);

  std::vector<Vec3> expected_m(drawn_m.size());
  scene->deform(rest, expected_m);
  EXPECT_EQ(drawn_m, expected_m);
  EXPECT_EQ(drawn_m, scene->mesh.vertices_m);
}

// One block of a tube along z; `mirror` -1: the same seen in the plane y = 0, turned the other way.
std::vector<float> tubeBlock(Isa isa, float mirror, bool wound) {
  const std::vector<HollowCells> cells{{{mirror * 0.4F, mirror * 0.25F, mirror * 0.05F},
                                        {0.8F, -0.15F, -0.05F},
                                        {0.2F, 0.1F, 0.0F},
                                        {mirror * 0.1F, mirror * 0.05F, mirror * -0.02F}}};
  const HollowFrame frame{
      cells.data(), 3.0F, {0.1F, 0.0F, 0.3F}, {0.6F, 0.0F, 0.8F}, {0.8F, 0.0F, -0.6F}, {0.0F, 1.0F, 0.0F}};
  const std::vector<int> firstRows{0};
  KernelBuffer<float> in(16 * 16);
  KernelBuffer<float> out(3 * 16);
  const std::size_t across = wound ? 3 : 6;
  for (std::size_t i = 0; i < 16; ++i) {
    const float angle = 0.39F * static_cast<float>(i);
    float* lane = &in[i];
    lane[across * 16] = 0.04F * std::cos(angle);
    lane[(across + 1) * 16] = mirror * 0.04F * std::sin(angle);
    if (wound) {
      lane[6 * 16] = mirror * -0.04F * std::sin(angle);
      lane[7 * 16] = 0.04F * std::cos(angle);
    } else {
      lane[3 * 16] = 0.002F;
      lane[9 * 16] = 0.6F;
      lane[11 * 16] = 0.8F;
      lane[12 * 16] = 0.01F;
    }
    lane[(wound ? 9 : 13) * 16] = std::cos(3.0F * angle);
    lane[(wound ? 10 : 14) * 16] = mirror * std::sin(3.0F * angle);
    lane[(wound ? 11 : 15) * 16] = -1.0F + 0.125F * static_cast<float>(i);
  }
  const TwistKernels& kernels = twistKernels(isa);
  (wound ? kernels.hollowWound : kernels.hollowOwn)(in.data(), firstRows.data(), 1, frame, out.data());
  return {out.data(), out.data() + out.size()};
}

TEST(HollowKernel, AMirroredOrganIsDrawnMirrored) {
  for (const Isa isa : usableIsas()) {
    for (const bool wound : {false, true}) {
      const std::vector<float> organ = tubeBlock(isa, 1.0F, wound);
      const std::vector<float> mirrored = tubeBlock(isa, -1.0F, wound);

      for (std::size_t i = 0; i < 16; ++i) {
        EXPECT_EQ(mirrored[i], organ[i]) << i;
        EXPECT_EQ(mirrored[16 + i], -organ[16 + i]) << i;
        EXPECT_EQ(mirrored[32 + i], organ[32 + i]) << i;
      }
      EXPECT_GT(std::abs(organ[16]), 0.01F);
    }
  }
}

TEST(HollowKernel, ATubeWithoutFoldsOrTurnStaysWhereItIs) {
  for (const Isa isa : usableIsas()) {
    KernelBuffer<float> in(12 * 16);
    KernelBuffer<float> out(3 * 16);
    const std::vector<HollowCells> cells{{{}, {1.0F, 0.0F, 0.0F}, {}, {}}};
    const std::vector<int> firstRows{0};
    for (std::size_t i = 0; i < 16; ++i) {
      in[i] = 0.02F * static_cast<float>(i);
      in[4 * 16 + i] = 0.03F;
      in[6 * 16 + i] = -0.03F;
      in[9 * 16 + i] = 1.0F;
    }

    twistKernels(isa).hollowWound(
        in.data(), firstRows.data(), 1,
        {cells.data(), 3.0F, {}, {0.0F, 0.0F, 1.0F}, {1.0F, 0.0F, 0.0F}, {0.0F, 1.0F, 0.0F}}, out.data());

    for (std::size_t i = 0; i < 16; ++i) {
      EXPECT_EQ(out[i], in[i]) << i;
      EXPECT_EQ(out[16 + i], 0.03F) << i;
    }
  }
}

}  // namespace
}  // namespace torsio
