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

#include "sim/scene/scene.h"

namespace torsio {
namespace {

std::shared_ptr<const Scene> shippedHollow(const std::string& id) {
  SceneRequest request;
  request.assets = std::filesystem::path(TORSIO_SOURCE_DIR) / "assets";
  request.id = id;
  request.pattern = "detorse";
  return std::make_shared<const Scene>(loadScene(request));
}

// Rest, onset, between, closing and beyond, both ways; of a cord some turns.
std::vector<double> anglesOf(const HollowOrgan& organ) {
  double onset_rad = 1.0;
  double closing_rad = 9.0;
  if (organ.tube(0) != nullptr) {
    onset_rad = organ.onset_rad(organ.detorsion().wall.pressure_Pa);
    closing_rad = organ.closing_rad(organ.detorsion().wall.pressure_Pa);
  }
  const double between_rad = 0.5 * (onset_rad + closing_rad);
  return {0.0, onset_rad, between_rad, -between_rad, closing_rad, -closing_rad, 1.3 * closing_rad};
}

double farthest_m(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double most_m = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    most_m = std::max(most_m, norm(a[i] - b[i]));
  }
  return most_m;
}

class HollowViewOf : public ::testing::TestWithParam<std::string> {};
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
      const OrganState state = scene->stateAt(angle_rad);
      scene->deform(state, expected_m);
      view.deform(state, drawn_m);

      EXPECT_LT(farthest_m(drawn_m, expected_m), 1e-6) << static_cast<int>(isa) << " " << angle_rad;
    }
  }
}

TEST_P(HollowViewOf, ZeroAngleAtRestPressureIsTheRestShapeRoundedOnce) {
  const std::shared_ptr<const Scene> scene = shippedHollow(GetParam());
  std::vector<Vec3> drawn_m(scene->mesh.vertices_m.size());
  OrganState state = scene->stateAt(0.0);
  // Three organs begin with more gas than they were drawn with: wider than the mesh, in the double path too.
  state.hollow.reading.pressure_Pa = scene->hollow->detorsion().wall.restPressure_Pa;

  for (const Isa isa : usableIsas()) {
    HollowView(scene, isa).deform(state, drawn_m);

    for (std::size_t i = 0; i < drawn_m.size(); ++i) {
      const Vec3& rest_m = scene->mesh.vertices_m[i];
      const Vec3 rounded_m{static_cast<float>(rest_m.x), static_cast<float>(rest_m.y),
                           static_cast<float>(rest_m.z)};
      ASSERT_EQ(drawn_m[i], rounded_m) << i;
    }
  }
}

// One block of a tube along z; `mirror` -1: the same seen in the plane y = 0, turned the other way.
std::vector<float> tubeBlock(Isa isa, float mirror) {
  constexpr std::size_t kRows = HollowRows::kCount;
  const std::vector<float> turn(kRows, mirror * 1.2F);
  const std::vector<float> radius(kRows, 0.8F);
  const std::vector<float> amplitude(kRows, 0.2F);
  const std::vector<float> crest(kRows, mirror * 0.7F);
  KernelBuffer<float> in(11 * 16);
  KernelBuffer<float> out(3 * 16);
  for (std::size_t i = 0; i < 16; ++i) {
    const float angle = 0.39F * static_cast<float>(i);
    in[i] = in[48 + i] = 0.04F * std::cos(angle);
    in[16 + i] = in[64 + i] = mirror * 0.04F * std::sin(angle);
    in[128 + i] = 1.0F;
    in[144 + i] = 30.5F * static_cast<float>(i);
    in[160 + i] = mirror * angle;
  }
  twistKernels(isa).hollow(
      in.data(), 1, {turn.data(), radius.data(), amplitude.data(), crest.data(), 3.0F, 5.0F}, out.data());
  return {out.data(), out.data() + out.size()};
}

TEST(HollowKernel, AMirroredOrganIsDrawnMirrored) {
  for (const Isa isa : usableIsas()) {
    const std::vector<float> organ = tubeBlock(isa, 1.0F);
    const std::vector<float> mirrored = tubeBlock(isa, -1.0F);

    for (std::size_t i = 0; i < 16; ++i) {
      EXPECT_EQ(mirrored[i], organ[i]) << i;
      EXPECT_EQ(mirrored[16 + i], -organ[16 + i]) << i;
      EXPECT_EQ(mirrored[32 + i], organ[32 + i]) << i;
    }
    EXPECT_GT(std::abs(organ[16]), 0.02F);
  }
}

}  // namespace
}  // namespace torsio
