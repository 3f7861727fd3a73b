// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "sim/geometry/mesh/mesh_export.h"
#include "sim/scene/scene.h"
#include "tests/support/procedural_mesh.h"
#include "tests/support/shipped_scene.h"

namespace torsio {
namespace {

SceneRequest withSections(const std::string& id, int sections) {
  SceneRequest request = testing::shippedRequest(id);
  request.sections = sections;
  return request;
}

/// One elastic twist about the centreline of the organ that the request names, held at the fixed end.
TwistModel plainTwist(const SceneRequest& request, int solvedSections) {
  const Scene scene = loadScene(request);
  TwistModelOptions options;
  options.solvedSections = solvedSections;
  return {scene.mesh, scene.lattice(), scene.model.material(), options};
}

/// Largest difference in the compliance of a grasp at a quarter, half, 0.85 and the end of the organ, as a
/// share. The torque of an angle is the angle over the compliance.
double largestDifference(const TwistModel& model, const TwistModel& reference) {
  double most = 0.0;
  for (const double place : {0.25, 0.5, 0.85, 1.0}) {
    const double here = model.graspCompliance(place * model.lattice().length_m());
    const double there = reference.graspCompliance(place * reference.lattice().length_m());
    most = std::max(most, std::abs(here / there - 1.0));
  }
  return most;
}

TEST(SceneSections, TheTorqueOfAShippedOrganDoesNotDependOnTheSectionsOfItsLattice) {
  for (const std::string id : {"stomach", "forearm", "intestine"}) {
    const TwistModel reference = plainTwist(withSections(id, 25), 360);
    for (const int sections : {4, 8, 37, 73}) {
      const TwistModel model = plainTwist(withSections(id, sections), TwistModelOptions{}.solvedSections);

      // Before, the sections of the lattice were the ones solved: 21 times the torque of the stomach at M
      // = 4.
      EXPECT_LT(largestDifference(model, reference), 0.005) << id << " " << sections;
    }
  }
}

TEST(SceneSections, TheTorqueOfATaperFollowsTheClosedFormAtEveryNumberOfSections) {
  const double r0 = 0.03;
  const double r1 = 0.015;
  const double length = 0.24;
  const std::filesystem::path file = std::filesystem::path(::testing::TempDir()) / "sections_taper.obj";
  writeObj(file, testing::prism(testing::circleOutline(r0, 96), length, 48, r1 / r0));
  for (const int sections : {4, 8, 37, 73}) {
    SceneRequest request = withSections("forearm", sections);
    request.organFile = file;

    const TwistModel model = plainTwist(request, TwistModelOptions{}.solvedSections);

    // phi = 2 T L (r0^2 + r0 r1 + r1^2) / (3 pi G r0^3 r1^3), J of the 96-gon 0.99856 of the circle's.
    const double round = 2.0 * length * (r0 * r0 + r0 * r1 + r1 * r1) /
                         (3.0 * 3.14159265358979 * model.material().shearModulus_Pa * std::pow(r0 * r1, 3.0));
    EXPECT_NEAR(model.graspCompliance(length) * 0.99856 / round, 1.0, 1e-4) << sections;
  }
}

}  // namespace
}  // namespace torsio
