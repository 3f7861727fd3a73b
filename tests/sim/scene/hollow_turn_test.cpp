// SPDX-License-Identifier: GPL-3.0-or-later
// How the shipped hollow organs go round: rigidly in the mobile part, nowhere through themselves.
#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "sim/core/angle.h"
#include "sim/scene/hollow_map.h"
#include "sim/scene/hollow_organ.h"
#include "sim/scene/scene_file.h"
#include "sim/tissue/rod/fold_check.h"
#include "tests/support/shipped_hollow_organs.h"

namespace torsio {
namespace {

using testing::smoothAt;
using testing::twistedOrgan;

/// The angles at which the organ is looked at: from rest to its largest twist, both ways.
std::vector<double> wayOf(const Scene& scene, double step_rad) {
  std::vector<double> angles{0.0};
  const double most_rad = scene.hollow->detorsion().start.most_rad;
  for (double angle_rad = step_rad; angle_rad < most_rad + 0.5 * step_rad; angle_rad += step_rad) {
    angles.push_back(std::min(angle_rad, most_rad));
    angles.push_back(-std::min(angle_rad, most_rad));
  }
  return angles;
}

/// Least det F against the square of the section's own narrowing, on the axis and at 0.5 and 0.95 of the way
/// to the surface: how much of their distance neighbouring sections keep.
double leastRoomBetweenSections(const Scene& scene, const OrganState& lies) {
  constexpr double kDifference_m = 1e-7;
  const SectionLattice& lattice = scene.lattice();
  const HollowMap map(lattice, *scene.hollow, lies);
  double least = 1e9;
  const auto look = [&](const Vec3& p) {
    const auto column = [&](const Vec3& step) {
      return (map.forward(p + step) - map.forward(p - step)) / (2.0 * kDifference_m);
    };
    const double determinant = dot(column({kDifference_m, 0, 0}),
                                   cross(column({0, kDifference_m, 0}), column({0, 0, kDifference_m})));
    const double radius = map.section(scene.hollow->turningPlace(lattice.nearestArc_m(p), p)).radius;
    least = std::min(least, determinant / (radius * radius));
  };
  for (int j = 1; j + 1 < lattice.sections(); ++j) {
    const Vec3 centre = lattice.frameAt(lattice.sectionArc_m(j)).centre_m;
    look(centre);
    for (int ridge = 0; ridge < lattice.ridges(); ++ridge) {
      look(centre + 0.5 * (lattice.keyPoint_m(ridge, j) - centre));
      look(centre + 0.95 * (lattice.keyPoint_m(ridge, j) - centre));
    }
  }
  return least;
}

/// The organ's centre line as it lies, with the mean radius of its sections, which shrink with their neck.
struct Strand {
  std::vector<Vec3> centre_m;
  std::vector<double> radius_m;
  std::vector<double> rest_m;  // radius
  double step_m = 0.0;
};

Strand strandOf(const Scene& scene, const OrganState& lies) {
  constexpr int kPlaces = 121;
  const SectionLattice& lattice = scene.lattice();
  const HollowMap map(lattice, *scene.hollow, lies);
  const double length_m = scene.hollow->length_m();
  std::vector<double> radii_m;
  for (int j = 0; j < lattice.sections(); ++j) {
    const Vec3 centre = lattice.frameAt(lattice.sectionArc_m(j)).centre_m;
    double sum_m = 0.0;
    for (int ridge = 0; ridge < lattice.ridges(); ++ridge) {
      sum_m += norm(lattice.keyPoint_m(ridge, j) - centre);
    }
    radii_m.push_back(sum_m / lattice.ridges());
  }
  Strand strand;
  strand.step_m = length_m / (kPlaces - 1);
  for (int i = 0; i < kPlaces; ++i) {
    const double arc_m = strand.step_m * i;
    const double at = arc_m / length_m * (lattice.sections() - 1);
    const auto cell = std::min(static_cast<std::size_t>(at), radii_m.size() - 2);
    const double share = at - static_cast<double>(cell);
    const Vec3 centre = lattice.frameAt(arc_m).centre_m;
    strand.rest_m.push_back((1.0 - share) * radii_m[cell] + share * radii_m[cell + 1]);
    strand.centre_m.push_back(map.forward(centre));
    strand.radius_m.push_back(strand.rest_m.back() *
                              map.section(scene.hollow->turningPlace(arc_m, centre)).radius);
  }
  return strand;
}

/// Least distance of two places that lie farther apart along the line than one and a half times the sum of
/// their radii, against the sum of their radii as they lie.
double nearestOf(const Strand& strand) {
  double nearest = 1e9;
  for (std::size_t i = 0; i < strand.centre_m.size(); ++i) {
    for (std::size_t k = i + 1; k < strand.centre_m.size(); ++k) {
      const double along_m = strand.step_m * static_cast<double>(k - i);
      if (along_m > 1.5 * (strand.rest_m[i] + strand.rest_m[k])) {
        nearest = std::min(nearest, norm(strand.centre_m[i] - strand.centre_m[k]) /
                                        (strand.radius_m[i] + strand.radius_m[k]));
      }
    }
  }
  return nearest;
}

class HollowTurn : public ::testing::TestWithParam<const char*> {};

TEST_P(HollowTurn, FoldsNoTissueHoweverFarItIsTurned) {
  const Scene& scene = twistedOrgan(GetParam());
  const FoldCheck check(scene.mesh, scene.lattice());
  const double most_rad = scene.hollow->detorsion().start.most_rad;

  for (const double angle_rad : {radians(180.0), radians(360.0)}) {
    for (const double way : {1.0, -1.0}) {
      const OrganState lies = scene.stateAt(way * std::min(angle_rad, most_rad));
      const FoldReport report = check.judge(
          smoothAt(scene, lies), [&](const Vec3& rest_m) { return scene.toDeformed_m(rest_m, lies); });

      EXPECT_GT(report.minDeterminant, 0.05) << degrees(angle_rad) * way;  // of a neck that is closed
      EXPECT_EQ(report.crossings, 0U) << degrees(angle_rad) * way;
    }
  }
}

TEST_P(HollowTurn, SectionsKeepAFifthOfTheirDistanceAtLeast) {
  const Scene& scene = twistedOrgan(GetParam());

  for (const double angle_rad : wayOf(scene, radians(30.0))) {
    EXPECT_GE(leastRoomBetweenSections(scene, scene.stateAt(angle_rad)), kLeastDeterminant)
        << degrees(angle_rad);
  }
}

TEST_P(HollowTurn, NoTwoPartsComeNearerThanTheirRadii) {
  const Scene& scene = twistedOrgan(GetParam());

  for (const double angle_rad : wayOf(scene, radians(15.0))) {
    OrganState lies = scene.stateAt(angle_rad);
    EXPECT_GE(nearestOf(strandOf(scene, lies)), 1.0) << degrees(angle_rad);
    lies.hollow.reading.pressure_Pa = scene.hollow->detorsion().wall.ventedPressure_Pa;
    EXPECT_GE(nearestOf(strandOf(scene, lies)), 1.0) << degrees(angle_rad) << " let out";
  }
}

TEST_P(HollowTurn, TheMobilePartKeepsItsShapeAndItsDistanceFromItsLine) {
  const Scene& scene = twistedOrgan(GetParam());
  const OrganState lies = scene.stateAt(radians(130.0));
  const std::vector<Vec3> moved_m = smoothAt(scene, lies);
  const TwistLine& line = scene.hollow->line();
  const auto arm_m = [&](const Vec3& x) { return norm(cross(line.direction, x - line.point_m)); };

  const std::vector<TwistVertex>& vertices = scene.hollow->vertices();
  std::size_t first = vertices.size();
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    if (scene.hollow->turningPlace(vertices[i].arc_m, vertices[i].rest_m).span >= 0) {
      continue;
    }
    first = std::min(first, i);
    const double before_m = norm(vertices[i].rest_m - vertices[first].rest_m);
    EXPECT_NEAR(norm(moved_m[i] - moved_m[first]), before_m, 1e-12) << i;
    EXPECT_NEAR(arm_m(moved_m[i]), arm_m(vertices[i].rest_m), 1e-12) << i;
  }
  EXPECT_LT(first, vertices.size());
}

TEST_P(HollowTurn, FindsItsWayBackFromEveryVertex) {
  const Scene& scene = twistedOrgan(GetParam());
  const OrganState lies = scene.stateAt(radians(150.0));
  const HollowMap map(scene.lattice(), *scene.hollow, lies);

  const std::vector<TwistVertex>& vertices = scene.hollow->vertices();
  // Where a turned place lies between two places of the axis, either way back is one.
  std::size_t ambiguous = 0;
  for (std::size_t i = 0; i < vertices.size(); i += 5) {
    const double astray_m = norm(map.backward(map.forward(vertices[i].rest_m)) - vertices[i].rest_m);
    EXPECT_LT(astray_m, 0.002) << i;
    ambiguous += astray_m < 1e-6 ? 0 : 1;
  }
  EXPECT_LE(ambiguous, vertices.size() / 5 / 1000);
}

TEST_P(HollowTurn, LeavesEveryVertexAtRestUnchanged) {
  const Scene& scene = twistedOrgan(GetParam());
  const TwistVertex& vertex = scene.hollow->vertices().front();
  const HollowOrgan& organ = *scene.hollow;

  for (const double share : {0.0, 0.2, 0.4, 0.6, 0.8, 1.0}) {
    const double arc_m = share * organ.length_m();
    const HollowOrgan::Place place = organ.turningPlace(arc_m, vertex.rest_m);
    EXPECT_EQ(organ.moved(vertex.rest_m, vertex.line, place, {}, {}), vertex.rest_m);
  }
}

INSTANTIATE_TEST_SUITE_P(Shipped, HollowTurn,
                         ::testing::Values("small-bowel-loop", "gastric-organo-axial",
                                           "gastric-mesentero-axial", "sigmoid", "midgut", "testis"),
                         [](const auto& instance) {
                           std::string name = instance.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

TEST(HollowLine, OnlyALoopWithLimbsSideBySideIsWound) {
  EXPECT_TRUE(twistedOrgan("sigmoid").hollow->wound());
  EXPECT_FALSE(twistedOrgan("small-bowel-loop").hollow->wound());
}

}  // namespace
}  // namespace torsio
