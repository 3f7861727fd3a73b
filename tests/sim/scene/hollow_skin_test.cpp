// SPDX-License-Identifier: GPL-3.0-or-later
// A hollow organ as it is drawn: neck and folds.
#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "sim/scene/hollow_map.h"
#include "tests/sim/servo/hollow_bar.h"

namespace torsio {
namespace {

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

}  // namespace
}  // namespace torsio
