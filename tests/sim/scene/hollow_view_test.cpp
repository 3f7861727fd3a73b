// SPDX-License-Identifier: GPL-3.0-or-later
// The single-precision view of hollow organs against the double path, by every instruction set.
// A hollow organ as it is drawn: neck and folds.
// How far the pieces of the shipped organs' surfaces reach, at every angle and pressure of a trial, and what
// a query costs; times are those of torsio_bench_hollow.
#include "sim/scene/hollow_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "sim/core/angle.h"
#include "sim/scene/hollow_map.h"
#include "sim/scene/hollow_organ.h"
#include "sim/scene/scene.h"
#include "sim/tissue/view/twist_kernels.h"
#include "tests/sim/servo/bar_scene.h"
#include "tests/support/allocation_count.h"
#include "tests/support/shipped_scene.h"

namespace torsio {
namespace {

std::shared_ptr<const Scene> shippedHollow(const std::string& id) {
  return std::make_shared<const Scene>(testing::shippedScene(id, "detorse"));
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
                         ::testing::Values("gastric-mesentero-axial", "sigmoid", "midgut", "small-bowel-loop",
                                           "testis"),
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

// The pages of the review desk are compared with this view: it draws what the window draws.
TEST(HollowView, AnOrganThatSwingsIsDrawnAsItsRodLies) {
  const std::shared_ptr<const Scene> scene = shippedHollow("gastric-organo-axial");
  ASSERT_NE(scene->hollow->swing(), nullptr);
  std::vector<Vec3> expected_m(scene->mesh.vertices_m.size());
  std::vector<Vec3> drawn_m(expected_m.size());

  HollowView view(scene);
  for (const double angle_rad : anglesOf(*scene->hollow)) {
    const OrganState state = scene->stateAt(angle_rad);
    scene->deform(state, expected_m);
    view.deform(state, drawn_m);

    EXPECT_EQ(drawn_m, expected_m) << degrees(angle_rad);
  }
  view.deform(scene->stateAt(scene->hollow->detorsion().start.most_rad), drawn_m);
  EXPECT_GT(farthest_m(drawn_m, scene->mesh.vertices_m), 0.05);
}

// The table of hollowCells with one cell: its 13 quantities.
std::vector<float> oneCell(const std::array<float, 13>& quantities) {
  std::vector<float> cells(quantities.size() * kHollowRow);
  for (std::size_t k = 0; k < quantities.size(); ++k) {
    cells[k * kHollowRow] = quantities[k];
  }
  return cells;
}

// One block of a tube along z; `mirror` -1: the same seen in the plane y = 0, turned the other way.
std::vector<float> tubeBlock(Isa isa, float mirror, bool wound, float folds, float told) {
  const std::vector<float> cells = oneCell({mirror * 0.4F, mirror * 0.25F, mirror * 0.05F, 0.8F, -0.15F,
                                            -0.05F, folds * 0.2F, folds * 0.1F, 0.0F, folds * mirror * 0.1F,
                                            folds * mirror * 0.05F, folds * mirror * -0.02F, told});
  const HollowFrame frame{
      cells.data(), 3.0F, {0.1F, 0.0F, 0.3F}, {0.6F, 0.0F, 0.8F}, {0.8F, 0.0F, -0.6F}, {0.0F, 1.0F, 0.0F}};
  const std::vector<int> firstRows{0};
  KernelBuffer<float> in(15 * 16);
  KernelBuffer<float> out(3 * 16);
  const std::size_t across = wound ? 3 : 6;
  for (std::size_t i = 0; i < 16; ++i) {
    const float angle = 0.39F * static_cast<float>(i);
    float* lane = &in[i];
    lane[across * 16] = 0.04F * std::cos(angle);
    lane[(across + 1) * 16] = mirror * 0.04F * std::sin(angle);
    lane[(across + 3) * 16] = mirror * -0.04F * std::sin(angle);
    lane[(across + 4) * 16] = 0.04F * std::cos(angle);
    if (wound) {
      lane[0] = lane[across * 16];
      lane[16] = lane[(across + 1) * 16];
    } else {
      lane[3 * 16] = 0.002F;
      lane[5 * 16] = 0.01F;
    }
    lane[(wound ? 9 : 12) * 16] = std::cos(3.0F * angle);
    lane[(wound ? 10 : 13) * 16] = mirror * std::sin(3.0F * angle);
    lane[(wound ? 11 : 14) * 16] = -1.0F + 0.125F * static_cast<float>(i);
  }
  const TwistKernels& kernels = twistKernels(isa);
  (wound ? kernels.hollowWound : kernels.hollowOwn)(in.data(), firstRows.data(), 1, frame, out.data());
  return {out.data(), out.data() + out.size()};
}

TEST(HollowKernel, AMirroredOrganIsDrawnMirrored) {
  for (const Isa isa : usableIsas()) {
    for (const bool wound : {false, true}) {
      const std::vector<float> organ = tubeBlock(isa, 1.0F, wound, 1.0F, 1.0F);
      const std::vector<float> mirrored = tubeBlock(isa, -1.0F, wound, 1.0F, 1.0F);

      for (std::size_t i = 0; i < 16; ++i) {
        EXPECT_EQ(mirrored[i], organ[i]) << i;
        EXPECT_EQ(mirrored[16 + i], -organ[16 + i]) << i;
        EXPECT_EQ(mirrored[32 + i], organ[32 + i]) << i;
      }
      const auto [low, high] = std::minmax_element(organ.begin() + 16, organ.begin() + 32);
      EXPECT_GT(*high - *low, 0.03F);
    }
  }
}

TEST(HollowKernel, WhereNothingIsFoldedTheShortWayIsTheLongOne) {
  for (const Isa isa : usableIsas()) {
    for (const bool wound : {false, true}) {
      const std::vector<float> whole = tubeBlock(isa, 1.0F, wound, 0.0F, 1.0F);
      const std::vector<float> brief = tubeBlock(isa, 1.0F, wound, 0.0F, 0.0F);

      for (std::size_t i = 0; i < whole.size(); ++i) {
        EXPECT_NEAR(brief[i], whole[i], 3e-8F) << isaName(isa) << " " << i;
      }
    }
  }
}

TEST(HollowKernel, ATubeWithoutFoldsOrTurnStaysWhereItIs) {
  for (const Isa isa : usableIsas()) {
    KernelBuffer<float> in(12 * 16);
    KernelBuffer<float> out(3 * 16);
    const std::vector<float> cells = oneCell({0.0F, 0.0F, 0.0F, 1.0F});
    const std::vector<int> firstRows{0};
    for (std::size_t i = 0; i < 16; ++i) {
      in[i] = 0.02F * static_cast<float>(i);
      in[16 + i] = 0.03F;
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

const Scene& wrungBar() {
  static const Scene kScene = hollowScene(twistedTube());
  return kScene;
}

double pressure_Pa() {
  return wrungBar().hollow->detorsion().wall.pressure_Pa;
}

std::vector<Vec3> drawnAt(double angle_rad) {
  std::vector<Vec3> drawn_m(wrungBar().mesh.vertices_m.size());
  wrungBar().deform(wrungBar().stateAt(angle_rad), drawn_m);
  return drawn_m;
}

// Distance of each drawn vertex from the line that it turns about, against that at rest.
std::vector<double> radiiAt(double angle_rad) {
  const std::vector<Vec3> drawn_m = drawnAt(angle_rad);
  std::vector<double> radii;
  for (std::size_t i = 0; i < drawn_m.size(); ++i) {
    const TwistVertex& vertex = wrungBar().hollow->vertices()[i];
    const auto distance = [&](const Vec3& x) {
      return norm(cross(vertex.line.direction, x - vertex.line.point_m));
    };
    radii.push_back(distance(vertex.rest_m) > 0.01 ? distance(drawn_m[i]) / distance(vertex.rest_m) : 1.0);
  }
  return radii;
}

TEST(HollowSkin, LeavesEveryVertexAtRestUnchanged) {
  EXPECT_EQ(drawnAt(0.0), wrungBar().mesh.vertices_m);
}

TEST(HollowSkin, BeforeTheFoldsIsTheSmoothMap) {
  const double angle_rad = 0.3 * wrungBar().hollow->onset_rad(pressure_Pa());
  const std::vector<Vec3> drawn_m = drawnAt(angle_rad);

  const OrganState state = wrungBar().stateAt(angle_rad);
  const HollowMap smooth(wrungBar().lattice(), *wrungBar().hollow, state);
  for (std::size_t i = 0; i < drawn_m.size(); ++i) {
    EXPECT_LT(norm(drawn_m[i] - smooth.vertex(wrungBar().hollow->vertices()[i])), 2e-5) << i;
  }
}

TEST(HollowSkin, HasANeckWithFoldsWhereItIsWrungAlone) {
  const double closing_rad = wrungBar().hollow->closing_rad(pressure_Pa());
  const std::vector<double> radii = radiiAt(0.9 * closing_rad);

  double least = 1.0;
  double most = 0.0;  // in the neck
  for (std::size_t i = 0; i < radii.size(); ++i) {
    least = std::min(least, radii[i]);
    const double arc = wrungBar().hollow->vertices()[i].arc_m / wrungBar().lattice().length_m();
    if (arc > 0.26 && arc < 0.30 && radii[i] < 1.0) {
      most = std::max(most, radii[i]);
    }
    if (arc > 0.57) {
      EXPECT_NEAR(radii[i], 1.0, 1e-9) << i;
    }
  }
  EXPECT_LT(least, 0.4);  // the bottom of a fold; the mean radius there is 0.52
  EXPECT_GT(most, 0.65);  // a crest
}

TEST(HollowSkin, TheOtherWayIsAsNarrow) {
  const double closing_rad = wrungBar().hollow->closing_rad(pressure_Pa());
  const std::vector<double> right = radiiAt(0.9 * closing_rad);
  const std::vector<double> left = radiiAt(-0.9 * closing_rad);

  EXPECT_NEAR(*std::min_element(right.begin(), right.end()), *std::min_element(left.begin(), left.end()),
              0.02);
}

TEST(HollowSkin, TheWallIsShearedMostInItsNeck) {
  const double closing_rad = wrungBar().hollow->closing_rad(pressure_Pa());
  const OrganState state = wrungBar().stateAt(0.7 * closing_rad);
  std::vector<double> shear_Pa(static_cast<std::size_t>(wrungBar().lattice().patches()));

  wrungBar().patchShear(state, shear_Pa);

  // Torque over 2 pi r^2 t with the mean radius of the neck, wall 3 mm.
  const double torque_Nm = wrungBar().hollow->torque_Nm(0.7 * closing_rad, pressure_Pa());
  const double waist_m = wrungBar().hollow->waist_m(0.7 * closing_rad, pressure_Pa());
  const double expected_Pa = torque_Nm / (kTurn * waist_m * waist_m * 0.003);
  EXPECT_NEAR(*std::max_element(shear_Pa.begin(), shear_Pa.end()) / expected_Pa, 1.0, 0.1);
  EXPECT_EQ(wrungBar().peakShear_Pa(state), *std::max_element(shear_Pa.begin(), shear_Pa.end()));
}

Scene shipped(const std::string& id) {
  return testing::shippedScene(id, "detorse");
}

/// The states that are looked at: every 15 degrees both ways up to the largest twist, at four pressures.
std::vector<OrganState> statesOf(const Scene& scene) {
  constexpr double kStep_rad = radians(15.0);
  const double most_rad = scene.hollow->detorsion().start.most_rad;
  std::vector<OrganState> states;
  for (int i = 0; kStep_rad * i <= most_rad; ++i) {
    for (const double way : {1.0, -1.0}) {
      for (const double share : {1.0, 0.5, 0.1, 0.0}) {
        OrganState lies = scene.stateAt(way * kStep_rad * i);
        lies.hollow.reading.pressure_Pa *= share;
        states.push_back(lies);
      }
    }
  }
  return states;
}

class HollowReachOf : public ::testing::TestWithParam<const char*> {};

TEST_P(HollowReachOf, NoVertexLeavesTheBoundOfItsPatch) {
  const Scene scene = shipped(GetParam());
  const SurfacePatches& patches = scene.collision.patches();
  const HollowReach& reach = scene.hollow->reach();
  ASSERT_FALSE(reach.empty());
  std::vector<Vec3> moved_m(scene.mesh.vertices_m.size());
  double told_m = 0.0;
  double true_m = 0.0;

  for (const OrganState& lies : statesOf(scene)) {
    const HollowMap map(scene.lattice(), *scene.hollow, lies);
    std::transform(scene.hollow->vertices().begin(), scene.hollow->vertices().end(), moved_m.begin(),
                   [&map](const TwistVertex& vertex) { return map.vertex(vertex); });
    const auto farthest_m = [&](const SurfacePatches::Patch& patch, std::uint32_t seed) {
      double far_m = 0.0;
      for (const std::uint32_t vertex : patches.vertices(patch)) {
        far_m = std::max(far_m, norm(moved_m[vertex] - moved_m[seed]));
      }
      return far_m;
    };
    for (std::size_t g = 0; g < patches.groups().size(); ++g) {
      const SurfacePatches::Group& group = patches.groups()[g];
      double groupFar_m = 0.0;
      for (std::size_t p = group.firstPatch; p < group.firstPatch + group.patchCount; ++p) {
        const SurfacePatches::Patch& patch = patches.patches()[p];
        const double far_m = farthest_m(patch, patch.seed);
        ASSERT_LE(far_m, reach.patch_m(p, map)) << "patch " << p << " at " << lies.twist.graspAngle_rad;
        told_m += reach.patch_m(p, map);
        true_m += far_m;
        groupFar_m = std::max(groupFar_m, farthest_m(patch, group.seed));
      }
      ASSERT_LE(groupFar_m, reach.group_m(g, map)) << "group " << g << " at " << lies.twist.graspAngle_rad;
    }
  }

  EXPECT_LT(told_m, 1.6 * true_m);  // and the bounds are narrow enough to be of use
}

INSTANTIATE_TEST_SUITE_P(ShippedOrgans, HollowReachOf,
                         ::testing::Values("gastric-mesentero-axial", "midgut", "sigmoid", "small-bowel-loop",
                                           "testis"));

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
                         ::testing::Values("gastric-mesentero-axial", "midgut", "sigmoid", "small-bowel-loop",
                                           "testis"));

}  // namespace
}  // namespace torsio
